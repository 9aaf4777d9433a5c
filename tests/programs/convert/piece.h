// Pieces of a solid between cuts.
//
// A piece is a bag of directed edges for each of its faces. A face's edges close, and each edge has its opposite in some other
// face; both hold after any cut, whatever is rounded, since what a cut opens is closed again by counting. Corners are
// rounded to long double. Nothing here proves anything: enclose.h does.
#ifndef PIECE_H
#define PIECE_H

#include "solid.h"

typedef struct piece_edge {
  uint32_t from, to, face;
} piece_edge;

// Corners of all pieces; the first ones are the solid's points.
typedef struct piece_pool {
  long double (*at)[3];
  size_t count, room;
} piece_pool;

typedef struct piece {
  piece_edge *edge;   // in order of their faces
  solid_plane *face;  // outwards; n = 0: on a line
  size_t edges, faces;
} piece;

typedef struct piece_list {
  piece *item;
  size_t count, room;
} piece_list;

void piece_pool_from(piece_pool *pool, const solid *s);

piece piece_from(const solid *s);

// A convex piece by its corners and faces, as a part has them: corner and face_end as in gjk_hull_faces. pool is new.
piece piece_from_faces(const int32_t (*point)[3], unsigned points, const uint16_t *corner, const uint16_t *face_end,
                       const solid_plane *plane, unsigned faces, piece_pool *pool);

// Six times the volume of what a convex piece has behind planes: not beyond any. The piece is freed.
long double piece_volume6_behind(piece p, const solid_plane *plane, unsigned planes, piece_pool *pool);

// Cuts a piece: the connected parts beyond the plane and behind it are added to out. A corner within slack of the plane counts
// as on it.
void piece_cut(const piece *p, const solid_plane *plane, long double slack, piece_pool *pool, piece_list *out);

// Adds what is connected of a piece, each as a piece of its own.
void piece_part(const piece *p, const piece_pool *pool, piece_list *out);

void piece_free(piece *p);
void piece_list_free(piece_list *list);
void piece_list_add(piece_list *list, piece p);

// How far a point is beyond a plane.
long double piece_height(const solid_plane *plane, const long double x[3]);

// Six times the volume.
long double piece_volume6(const piece *p, const piece_pool *pool);

// The corners, each once, for free.
uint32_t *piece_corners(const piece *p, size_t *count);

// An edge where the piece is not convex.
typedef struct piece_notch {
  uint32_t from, to;
  solid_plane plane[2];
  long double depth;  // how far one face reaches beyond the other's plane, the lesser of both
} piece_notch;

// The notches deeper than slack, for free.
piece_notch *piece_notches(const piece *p, const piece_pool *pool, long double slack, size_t *count);

#endif
