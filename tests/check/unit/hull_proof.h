// The proof of a hull by integers of 128 bits that share nothing with the library: no point is beyond a face, faces are plane,
// strictly convex and closed, and no two beside each other are in one plane.
#ifndef HULL_PROOF_H
#define HULL_PROOF_H

#include "hull_points.h"

__extension__ typedef __int128 wide;

typedef struct vec {
  int64_t x, y, z;
} vec;

static inline vec minus(gjk_vec3 a, gjk_vec3 b) {
  return (vec){(int64_t)a.x - b.x, (int64_t)a.y - b.y, (int64_t)a.z - b.z};
}

// Below 2^59 for differences of points.
static inline vec cross(vec a, vec b) {
  return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline wide dot(vec a, vec b) {
  return (wide)a.x * b.x + (wide)a.y * b.y + (wide)a.z * b.z;
}

// A face of output: its corners, and its plane.
typedef struct face {
  const uint16_t *corner;
  unsigned corners;
  gjk_vec3 at;
  vec n;
} face;

static inline face face_of(const hull_output *o, unsigned f) {
  const unsigned begin = f == 0 ? 0 : o->end[f - 1];
  const gjk_vec3 *v = o->vertex;
  const uint16_t *c = o->corner + begin;
  return (face){c, o->end[f] - begin, v[c[0]], cross(minus(v[c[1]], v[c[0]]), minus(v[c[2]], v[c[0]]))};
}

// The face that has the edge from b to a. -1: none or several.
static inline int face_across(const hull_output *o, uint16_t a, uint16_t b) {
  int found = -1;
  for (unsigned f = 0, begin = 0; f < o->faces.count; begin = o->end[f++]) {
    for (unsigned i = begin; i < o->end[f]; i++) {
      if (o->corner[i] == b && o->corner[i + 1 < o->end[f] ? i + 1 : begin] == a) {
        if (found >= 0) {
          return -1;
        }
        found = (int)f;
      }
    }
  }
  return found;
}

// Proves the output the hull of the points. Has a face more than three corners? Faces of more corners than shapes may have are cut: their parts are in one plane.
static inline bool hull_certify(const hull_points *points, const hull_output *o) {
  unsigned beyond = 0, bent = 0, open = 0, merged = 0, flat = 0;
  for (unsigned f = 0; f < o->faces.count; f++) {
    const face own = face_of(o, f);
    for (unsigned i = 0; i < points->count; i++) {
      beyond += dot(own.n, minus(points->point[i], own.at)) > 0;
    }
    for (unsigned i = 0; i < own.corners; i++) {
      const uint16_t a = own.corner[i], b = own.corner[(i + 1) % own.corners], c = own.corner[(i + 2) % own.corners];
      const int other = face_across(o, a, b);
      bent += dot(own.n, minus(o->vertex[a], own.at)) != 0;
      bent += dot(own.n, cross(minus(o->vertex[b], o->vertex[a]), minus(o->vertex[c], o->vertex[b]))) <= 0;
      open += other < 0;
      if (other >= 0) {
        const face next = face_of(o, (unsigned)other);
        bool same = dot(own.n, next.n) > 0;
        for (unsigned k = 0; k < next.corners; k++) {
          same = same && dot(own.n, minus(o->vertex[next.corner[k]], own.at)) == 0;
        }
        merged += same;
      }
      flat += own.corners > 3;
    }
  }
  CHECK_MSG(beyond == 0 && bent == 0 && open == 0, "%u beyond, %u bent, %u open", beyond, bent, open);
  // Each cut leaves two edges, one of either part.
  CHECK_MSG(o->faces.count == o->hull.faces + merged / 2, "%u faces of %u, %u edges within", o->faces.count,
            (unsigned)o->hull.faces, merged);
  CHECK(o->hull.vertices + o->hull.faces == o->hull.edges + 2 && o->hull.corners == 2 * o->hull.edges);
  for (unsigned i = 0; i < o->hull.vertices; i++) {
    bool given = false;
    for (unsigned j = 0; j < points->count && !given; j++) {
      given = memcmp(&points->point[j], &o->vertex[i], sizeof o->vertex[i]) == 0;
    }
    CHECK(given);
  }
  wide six = 0;
  for (unsigned f = 0; f < o->faces.count; f++) {
    const face own = face_of(o, f);
    for (unsigned i = 1; i + 1 < own.corners; i++) {
      six += dot(cross(minus(o->vertex[own.corner[i]], own.at), minus(o->vertex[own.corner[i + 1]], own.at)),
                 minus(own.at, o->vertex[0]));
    }
  }
  CHECK((uint64_t)six == o->volume.low && (uint64_t)(six >> 64) == o->volume.high);
  return flat > 0;
}

#endif
