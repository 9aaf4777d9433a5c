// Where does a line enter A - B? The exact search of casts, for polytopes. gjk_portal.c has the steps.
#ifndef GJK_SRC_PORTAL_H
#define GJK_SRC_PORTAL_H

#include "gjk_portal_frame.h"

typedef enum gjk_passage {
  GJK_PASSAGE_BESIDE,  // the line passes A - B: all of it lies behind the plane through the line across n
  GJK_PASSAGE_SHORT,   // all of A - B lies behind the planes across n through both ends of the way
  GJK_PASSAGE_INSIDE,  // the origin lies in A - B
  GJK_PASSAGE_FACET,   // the way enters A - B across the plane of the corners, whose outward normal is n
  GJK_PASSAGE_LIMIT    // open: the ceiling on iterations is reached
} gjk_passage;

// Searches. Pre: the bounding spheres of the cores meet on the way, as gjk_spheres_part has it; both are polytopes.
gjk_passage gjk_portal_find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

// Sets n to the normal of the corners' plane, n . t < 0, or n . t > 0 if the search looks for the exit.
void gjk_portal_set_plane(gjk_portal *p);

// Rounds n to the direction of support scans. Components of n beyond 2^62 are halved first.
void gjk_portal_set_direction(gjk_portal *p);

// The portal that a certificate names (gjk_portal_claim.c): sets corners, n and its direction. False: one of the vertices
// does not exist. Pre: started; count <= 3; the certificate's direction is at most 2^30 long.
bool gjk_portal_load(gjk_portal *p, const gjk_cast_certificate *certificate);

// Does the way pass through the corners after its start, towards the back of their plane across n? count >= 1. Sets axis.
bool gjk_portal_is_entry(gjk_portal *p);

#endif
