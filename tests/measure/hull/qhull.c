// Qhull with its default options, which merge facets within its tolerance.
#include <stdio.h>
#include <stdlib.h>

#include "peer.h"

#include <libqhull_r/libqhull_r.h>

void hull_by_qhull(const gjk_vec3 *points, unsigned count, hull_count *out) {
  qhT state, *qh = &state;
  char options[] = "qhull";
  FILE *errors = fopen("/dev/null", "w");
  double *at = (double *)malloc(count * 3 * sizeof *at);
  int unfreed, blocks;
  for (unsigned i = 0; i < count; i++) {
    at[3 * i] = points[i].x;
    at[3 * i + 1] = points[i].y;
    at[3 * i + 2] = points[i].z;
  }
  qh_zero(qh, errors);
  out->vertices = out->faces = 0;
  if (qh_new_qhull(qh, 3, (int)count, at, False, options, NULL, errors) == 0) {
    out->vertices = (unsigned)qh->num_vertices;
    out->faces = (unsigned)qh->num_facets;
  }
  qh_freeqhull(qh, !qh_ALL);
  qh_memfreeshort(qh, &blocks, &unfreed);
  fclose(errors);
  free(at);
}
