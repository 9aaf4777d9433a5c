// Reports of casts.
#ifndef GJK_SRC_CAST_REPORT_H
#define GJK_SRC_CAST_REPORT_H

#include "gjk_portal.h"

// Writes a hit at the start; iterations stay.
void gjk_cast_report_start(const gjk_collider *a, const gjk_collider *b, gjk_cast_result *out);

// Writes a hit across the portal's plane; iterations stay. Pre: n . t < 0, and the plane is met on the way.
void gjk_cast_report_entry(const gjk_portal *p, const gjk_way *way, gjk_cast_result *out);

// Names the corners of a plane, so that (w_1 - w_0) x (w_2 - w_0) points along n. For fewer than three, direction is n.
void gjk_cast_name_plane(const gjk_portal *p, gjk_cast_certificate *out);

#endif
