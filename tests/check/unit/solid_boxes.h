// Solids made of cells of a grid, for tests of decomposition.
#ifndef SOLID_BOXES_H
#define SOLID_BOXES_H

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"
#include "tests/programs/convert/decompose.h"

enum { BOXES = 6, BOXES_CELLS = BOXES * BOXES * BOXES };

// Cell x, y, z is full; planes[axis][i] is where its i-th side lies.
typedef struct boxes {
  int n[3];
  bool full[BOXES][BOXES][BOXES];
  int32_t at[3][BOXES + 1];
  int32_t turn[3][3];  // rows: an orthogonal matrix times a number
} boxes;

static void boxes_print(const void *subject) {
  const boxes *b = (const boxes *)subject;
  for (int z = 0; z < b->n[2]; z++) {
    for (int y = 0; y < b->n[1]; y++) {
      for (int x = 0; x < b->n[0]; x++) {
        putchar(b->full[x][y][z] ? '#' : '.');
      }
      putchar(y + 1 < b->n[1] ? '/' : '\n');
    }
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j <= b->n[i]; j++) {
      printf("%ld%c", (long)b->at[i][j], j < b->n[i] ? ' ' : '\n');
    }
  }
  for (int i = 0; i < 3; i++) {
    printf("%ld %ld %ld\n", (long)b->turn[i][0], (long)b->turn[i][1], (long)b->turn[i][2]);
  }
}

// The solid of a text: rows from y = 0 up, separated by '/', layers by ' '. Cells are 'size' wide.
static boxes boxes_of(const char *text, int32_t size) {
  boxes b = {0};
  int x = 0, y = 0, z = 0;
  for (; *text != '\0'; text++) {
    if (*text == '/' || *text == ' ') {
      z += *text == ' ' ? 1 : 0;
      y = *text == '/' ? y + 1 : 0;
      x = 0;
    } else {
      b.full[x++][y][z] = *text == '#';
    }
    b.n[0] = x > b.n[0] ? x : b.n[0];
    b.n[1] = y + 1 > b.n[1] ? y + 1 : b.n[1];
    b.n[2] = z + 1 > b.n[2] ? z + 1 : b.n[2];
  }
  for (int i = 0; i < 3; i++) {
    b.turn[i][i] = 1;
    for (int j = 0; j <= BOXES; j++) {
      b.at[i][j] = j * size;
    }
  }
  return b;
}

static bool boxes_is_full(const boxes *b, int x, int y, int z) {
  return x >= 0 && y >= 0 && z >= 0 && x < b->n[0] && y < b->n[1] && z < b->n[2] && b->full[x][y][z];
}

static gjk_vec3 boxes_corner(const boxes *b, const int at[3]) {
  int32_t x[3], out[3] = {0, 0, 0};
  for (int i = 0; i < 3; i++) {
    x[i] = b->at[i][at[i]];
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      out[i] += b->turn[i][j] * x[j];
    }
  }
  return (gjk_vec3){out[0], out[1], out[2]};
}

static void boxes_add_side(const boxes *b, mesh *m, int axis, bool high, const int cell[3]) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (int i = 0; i < 4; i++) {
    const int around = high ? i : 3 - i;
    int at[3] = {cell[0], cell[1], cell[2]};
    at[axis] += high ? 1 : 0;
    at[u] += around == 1 || around == 2 ? 1 : 0;
    at[v] += around >= 2 ? 1 : 0;
    m->point[m->points++] = boxes_corner(b, at);
  }
  const uint32_t first = (uint32_t)m->points - 4;
  const uint32_t corners[2][3] = {{first, first + 1, first + 2}, {first, first + 2, first + 3}};
  memcpy(m->triangle[m->triangles], corners, sizeof corners);
  m->triangles += 2;
}

// The surface: two triangles for each side of a full cell beside an empty one. To be freed.
static mesh boxes_mesh(const boxes *b) {
  mesh m = {NULL, NULL, NULL, 0, 0, 0, 0, 0, 0};
  m.point = malloc(24 * BOXES_CELLS * sizeof m.point[0]);
  m.triangle = malloc(12 * BOXES_CELLS * sizeof m.triangle[0]);
  for (int x = 0; x < b->n[0]; x++) {
    for (int y = 0; y < b->n[1]; y++) {
      for (int z = 0; z < b->n[2]; z++) {
        const int cell[3] = {x, y, z};
        for (int axis = 0; axis < 3 && b->full[x][y][z]; axis++) {
          for (int high = 0; high < 2; high++) {
            int beside[3] = {x, y, z};
            beside[axis] += high ? 1 : -1;
            if (!boxes_is_full(b, beside[0], beside[1], beside[2])) {
              boxes_add_side(b, &m, axis, high == 1, cell);
            }
          }
        }
      }
    }
  }
  mesh_weld(&m);
  return m;
}

static solid boxes_solid(const boxes *b) {
  char problem[200] = "";
  solid s;
  mesh m = boxes_mesh(b);
  CHECK_MSG(solid_from_mesh(&s, &m, problem, sizeof problem), "%s", problem);
  mesh_free(&m);
  return s;
}

// A box as a part, between two corners.
static inline part boxes_part(const int32_t low[3], const int32_t high[3]) {
  int32_t point[8][3];
  part p;
  for (int i = 0; i < 8; i++) {
    for (int j = 0; j < 3; j++) {
      point[i][j] = i >> j & 1 ? high[j] : low[j];
    }
  }
  CHECK(part_build(&p, point, 8));
  return p;
}

// Unions of a few boxes of cells, or cells at random; most are connected.
static boxes boxes_random(random_state *random, int most, bool turned) {
  boxes b;
  memset(&b, 0, sizeof b);
  for (int i = 0; i < 3; i++) {
    b.n[i] = random_range(random, i == 2 ? 1 : 2, most);
    b.turn[i][i] = 1;
    for (int j = 1; j <= b.n[i]; j++) {
      b.at[i][j] = b.at[i][j - 1] + (random_below(random, 4) == 0 ? 1 : random_range(random, 1, 300));
    }
  }
  const uint32_t count = 1 + random_below(random, 4);
  for (uint32_t k = 0; k < count; k++) {
    int low[3], high[3];
    for (int i = 0; i < 3; i++) {
      low[i] = random_range(random, 0, b.n[i] - 1);
      high[i] = random_range(random, low[i], b.n[i] - 1);
    }
    for (int x = low[0]; x <= high[0]; x++) {
      for (int y = low[1]; y <= high[1]; y++) {
        for (int z = low[2]; z <= high[2]; z++) {
          b.full[x][y][z] = k < 3;  // the fourth one is a hole
        }
      }
    }
  }
  b.full[0][0][0] = true;
  if (turned) {  // the matrix of a quaternion of small integers, times its squared length
    const int32_t w = random_range(random, 1, 6), i = random_range(random, -5, 5), j = random_range(random, -5, 5),
                  k = random_range(random, -5, 5);
    const int32_t rows[3][3] = {{w * w + i * i - j * j - k * k, 2 * (i * j - w * k), 2 * (i * k + w * j)},
                                {2 * (i * j + w * k), w * w - i * i + j * j - k * k, 2 * (j * k - w * i)},
                                {2 * (i * k - w * j), 2 * (j * k + w * i), w * w - i * i - j * j + k * k}};
    memcpy(b.turn, rows, sizeof rows);
  }
  return b;
}

#endif
