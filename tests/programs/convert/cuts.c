// The choice of cuts.
#include "cuts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int32_t (*cuts_points(const piece *p, const piece_pool *pool, bool nearest, size_t *count))[3] {
  size_t corners;
  uint32_t *corner = piece_corners(p, &corners);
  int32_t(*out)[3] = solid_allocate(8 * corners, sizeof out[0]);
  *count = 0;
  for (size_t i = 0; i < corners; i++) {
    const long double *x = pool->at[corner[i]];
    int32_t low[3], high[3];
    for (int j = 0; j < 3; j++) {
      low[j] = (int32_t)(nearest ? rintl(x[j]) : floorl(x[j]));
      high[j] = (int32_t)(nearest ? rintl(x[j]) : ceill(x[j]));
    }
    for (int n = 0; n < 8; n++) {
      const bool again =
          ((n & 1) && low[0] == high[0]) || ((n & 2) && low[1] == high[1]) || ((n & 4) && low[2] == high[2]);
      if (!again) {
        out[*count][0] = n & 1 ? high[0] : low[0];
        out[*count][1] = n & 2 ? high[1] : low[1];
        out[*count][2] = n & 4 ? high[2] : low[2];
        ++*count;
      }
    }
  }
  free(corner);
  return out;
}

// The sine of an angle that is none but for rounding.
#define NEARLY_ALONG 0x1p-8L

// Planes to try.
typedef struct choice {
  solid_plane plane;
  long double score;
} choice;

typedef struct choices {
  choice *item;
  size_t count, room;
} choices;

static bool is_same_plane(const solid_plane *a, const solid_plane *b) {
  const int sign = a->n[0] == b->n[0] && a->n[1] == b->n[1] && a->n[2] == b->n[2] ? 1 : -1;
  return a->n[0] == sign * b->n[0] && a->n[1] == sign * b->n[1] && a->n[2] == sign * b->n[2] && a->d == sign * b->d;
}

static void add_choice(choices *list, const solid_plane *plane) {
  if (plane->n[0] == 0 && plane->n[1] == 0 && plane->n[2] == 0) {
    return;
  }
  for (size_t i = 0; i < list->count; i++) {
    if (is_same_plane(&list->item[i].plane, plane)) {
      return;
    }
  }
  if (list->count == list->room) {
    list->item = solid_grow(list->item, &list->room, sizeof list->item[0]);
  }
  list->item[list->count].plane = *plane;
  list->item[list->count++].score = 0;
}

static int best_first(const void *a, const void *b) {
  const choice *x = a, *y = b;
  return (x->score < y->score) - (x->score > y->score);
}

static bool whole(const long double x[3], int32_t out[3]) {
  for (int j = 0; j < 3; j++) {
    out[j] = (int32_t)rintl(x[j]);
    if (x[j] != rintl(x[j])) {
      return false;
    }
  }
  return true;
}

static bool is_cutting(const piece *p, const piece_pool *pool, const solid_plane *plane, long double slack) {
  bool beyond = false, behind = false;
  for (size_t i = 0; i < p->edges && !(beyond && behind); i++) {
    const long double h = piece_height(plane, pool->at[p->edge[i].from]);
    beyond = beyond || h > slack;
    behind = behind || h < -slack;
  }
  return beyond && behind;
}

// Does a plane through a notch leave no notch there? Its way into the solid leads beyond neither face.
static bool is_resolving(const piece_pool *pool, const piece_notch *notch, const solid_plane *plane) {
  long double n[3], e[3], way[3], slope[2] = {0, 0}, size[2] = {0, 0};
  for (int j = 0; j < 3; j++) {
    n[j] = (long double)plane->n[j];
    e[j] = pool->at[notch->to][j] - pool->at[notch->from][j];
  }
  for (int j = 0; j < 3; j++) {
    way[j] = n[(j + 1) % 3] * e[(j + 2) % 3] - n[(j + 2) % 3] * e[(j + 1) % 3];
  }
  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 3; j++) {
      const long double a = (long double)notch->plane[i].n[j];
      slope[i] += a * way[j];
      size[i] += a * a;
    }
    size[i] = sqrtl(size[i] * (way[0] * way[0] + way[1] * way[1] + way[2] * way[2]));
    slope[i] = fabsl(slope[i]) <= NEARLY_ALONG * size[i] ? 0 : slope[i];
  }
  return (slope[0] <= 0 && slope[1] <= 0) || (slope[0] >= 0 && slope[1] >= 0);
}

// Notches that the plane resolves less those that it crosses; what it adds as corners that are no integers counts a little.
static long double score_of(const piece *p, const piece_pool *pool, const piece_notch *notch, size_t notches,
                            const solid_plane *plane, long double slack) {
  long double score = 0;
  const long double near = fmaxl(slack, 0x1p-8L);
  for (size_t i = 0; i < notches; i++) {
    const long double a = piece_height(plane, pool->at[notch[i].from]), b = piece_height(plane, pool->at[notch[i].to]);
    if (fabsl(a) <= near && fabsl(b) <= near) {
      score += is_resolving(pool, &notch[i], plane) ? 1 : 0;
    } else if ((a > near && b < -near) || (a < -near && b > near)) {
      score -= 1;
    }
  }
  for (size_t i = 0; i < p->edges; i++) {
    const uint32_t from = p->edge[i].from, to = p->edge[i].to;
    const long double a = piece_height(plane, pool->at[from]), b = piece_height(plane, pool->at[to]);
    if (from < to && ((a > slack && b < -slack) || (a < -slack && b > slack))) {
      bool integral = true;
      for (int j = 0; j < 3; j++) {
        const long double x = pool->at[from][j] + a / (a - b) * (pool->at[to][j] - pool->at[from][j]);
        integral = integral && fabsl(x - rintl(x)) < 0x1p-16L;
      }
      score -= integral ? 0 : 0x1p-8L;
    }
  }
  return score;
}

// The planes through a notch and a corner that is an integer, for those corners that lie beyond neither of its faces.
static void add_to_corners(choices *list, const piece *p, const piece_pool *pool, const piece_notch *notch) {
  int32_t a[3], b[3], c[3];
  if (!whole(pool->at[notch->from], a) || !whole(pool->at[notch->to], b)) {
    return;
  }
  size_t corners;
  uint32_t *corner = piece_corners(p, &corners);
  for (size_t i = 0; i < corners; i++) {
    const long double *x = pool->at[corner[i]];
    if (whole(x, c) && piece_height(&notch->plane[0], x) < 0 && piece_height(&notch->plane[1], x) < 0) {
      const solid_plane plane = solid_plane_of(a, b, c);
      add_choice(list, &plane);
    }
  }
  free(corner);
}

// The planes of the faces at notches, and those through two notches, or one and a corner; the best ones first.
static choices at_notches(const piece *p, const piece_pool *pool, const piece_notch *notch, size_t notches,
                          const cuts_manner *manner) {
  const long double slack = manner->slack;
  choices list = {NULL, 0, 0};
  for (size_t i = 0; i < notches; i++) {
    add_choice(&list, &notch[i].plane[0]);
    add_choice(&list, &notch[i].plane[1]);
  }
  for (size_t i = 0; i < notches && notches <= 24 && manner->pairs; i++) {
    for (size_t j = i + 1; j < notches; j++) {
      int32_t a[3], b[3], c[3], d[3];
      if (whole(pool->at[notch[i].from], a) && whole(pool->at[notch[i].to], b) && whole(pool->at[notch[j].from], c) &&
          whole(pool->at[notch[j].to], d)) {
        const solid_plane plane = solid_plane_of(a, b, c);
        if (fabsl(piece_height(&plane, pool->at[notch[j].to])) <= slack) {
          add_choice(&list, &plane);
        }
      }
    }
  }
  for (size_t i = 0; i < notches && notches <= 24 && manner->corners; i++) {
    add_to_corners(&list, p, pool, &notch[i]);
  }
  size_t kept = 0;
  for (size_t i = 0; i < list.count; i++) {
    if (is_cutting(p, pool, &list.item[i].plane, slack)) {
      list.item[kept] = list.item[i];
      list.item[kept].score =
          score_of(p, pool, notch, notches, &list.item[kept].plane, slack) - (long double)kept * 0x1p-20L;
      kept++;
    }
  }
  list.count = kept;
  if (kept > 0) {
    qsort(list.item, kept, sizeof list.item[0], best_first);
  }
  return list;
}

// What a piece without notches costs: more, if it has corners that are no integers.
static unsigned cost_of(const piece *p, const piece_pool *pool) {
  for (size_t i = 0; i < p->edges; i++) {
    int32_t x[3];
    if (!whole(pool->at[p->edge[i].from], x)) {
      return 5;
    }
  }
  return 4;
}

// Cuts greedily until there are no notches. Returns the cost.
static unsigned finish(const piece *p, piece_pool *pool, const cuts_manner *manner, unsigned limit) {
  piece_list work = {NULL, 0, 0};
  unsigned cost = 0;
  piece copy = {solid_allocate(p->edges, sizeof copy.edge[0]), solid_allocate(p->faces, sizeof copy.face[0]), p->edges,
                p->faces};
  memcpy(copy.edge, p->edge, p->edges * sizeof copy.edge[0]);
  memcpy(copy.face, p->face, p->faces * sizeof copy.face[0]);
  piece_list_add(&work, copy);
  while (work.count > 0 && cost < limit) {
    piece one = work.item[--work.count];
    size_t notches;
    piece_notch *notch = piece_notches(&one, pool, manner->slack, &notches);
    choices list = at_notches(&one, pool, notch, notches, manner);
    if (notches > 0 && list.count > 0) {
      piece_cut(&one, &list.item[0].plane, manner->slack, pool, &work);
      piece_free(&one);
    } else {
      cost += cost_of(&one, pool);
      piece_free(&one);
    }
    free(list.item);
    free(notch);
  }
  const bool done = work.count == 0;
  piece_list_free(&work);
  return done ? cost : limit;
}

// The first cut of a piece whose greedy continuation is the cheapest.
static size_t look_ahead(const piece *p, const choices *list, size_t tries, piece_pool *pool, const cuts_manner *manner,
                         unsigned limit) {
  unsigned least = limit;
  size_t best = 0;
  for (size_t i = 0; i < list->count && i < tries; i++) {
    const size_t known = pool->count;
    piece_list half = {NULL, 0, 0};
    unsigned cost = 0;
    piece_cut(p, &list->item[i].plane, manner->slack, pool, &half);
    for (size_t j = 0; j < half.count && cost < least; j++) {
      cost += finish(&half.item[j], pool, manner, least);
    }
    if (cost < least) {
      least = cost;
      best = i;
    }
    piece_list_free(&half);
    pool->count = known;
  }
  return best;
}

bool cuts_at_notches(const piece *p, piece_pool *pool, const cuts_manner *manner, size_t limit, piece_list *out) {
  piece_list work = {NULL, 0, 0};
  piece_part(p, pool, &work);
  while (work.count > 0 && out->count + work.count <= limit) {
    piece one = work.item[--work.count];
    size_t notches;
    piece_notch *notch = piece_notches(&one, pool, manner->slack, &notches);
    choices list = at_notches(&one, pool, notch, notches, manner);
    if (notches > 0 && list.count > 0) {
      const size_t tries = notches == 1 ? 2 : notches <= 8 ? 24 : notches <= 16 ? 8 : notches <= 32 ? 3 : 1;
      const size_t best = tries == 1 ? 0 : look_ahead(&one, &list, tries, pool, manner, 4 * (unsigned)limit);
      piece_cut(&one, &list.item[best].plane, manner->slack, pool, &work);
      piece_free(&one);
    } else {
      piece_list_add(out, one);
    }
    free(list.item);
    free(notch);
  }
  const bool done = work.count == 0;
  piece_list_free(&work);
  return done;
}

// The plane through a notch and that corner of the piece which is nearest to the plane that halves the notch.
static void add_bisector(choices *list, const piece *p, const piece_pool *pool, const piece_notch *notch) {
  int32_t a[3], b[3], best[3] = {0, 0, 0};
  long double way[3], length[2] = {0, 0}, normal[3], e[3], least = INFINITY, most = 0;
  if (!whole(pool->at[notch->from], a) || !whole(pool->at[notch->to], b)) {
    return;
  }
  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 3; j++) {
      length[i] += (long double)notch->plane[i].n[j] * (long double)notch->plane[i].n[j];
    }
    length[i] = sqrtl(length[i]);
  }
  for (int j = 0; j < 3; j++) {
    way[j] = (long double)notch->plane[0].n[j] / length[0] + (long double)notch->plane[1].n[j] / length[1];
    e[j] = b[j] - a[j];
    most += e[j] * e[j];
  }
  for (int j = 0; j < 3; j++) {
    normal[j] = (e[(j + 1) % 3] * way[(j + 2) % 3] - e[(j + 2) % 3] * way[(j + 1) % 3]) / sqrtl(most);
  }
  most = sqrtl(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (size_t i = 0; i < p->edges; i++) {
    const long double *x = pool->at[p->edge[i].from];
    int32_t at[3];
    long double height = 0, aside = 0, along = 0;
    if (!whole(x, at)) {
      continue;
    }
    for (int j = 0; j < 3; j++) {
      const long double from = x[j] - a[j];
      height += normal[j] / most * from;
      along += e[j] * from;
      aside += from * from;
    }
    aside -= along * along / (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    const long double slope = aside > 1 ? fabsl(height) / sqrtl(aside) : INFINITY;
    if (slope < least - 0x1p-30L) {
      least = slope;
      memcpy(best, at, sizeof best);
    }
  }
  if (isfinite(least)) {
    const solid_plane plane = solid_plane_of(a, b, best);
    add_choice(list, &plane);
  }
}

static int deepest_first(const void *a, const void *b) {
  const piece_notch *x = a, *y = b;
  return x->depth != y->depth ? (x->depth < y->depth) - (x->depth > y->depth)
         : x->from != y->from ? (x->from > y->from) - (x->from < y->from)
                              : (x->to > y->to) - (x->to < y->to);
}

static int by_coordinate(const void *a, const void *b) {
  const long double x = *(const long double *)a, y = *(const long double *)b;
  return (x > y) - (x < y);
}

// Planes across each axis, at corners of the piece.
static void add_across(choices *list, const piece *p, const piece_pool *pool, int count) {
  long double *at = solid_allocate(p->edges, sizeof at[0]);
  for (int axis = 0; axis < 3; axis++) {
    for (size_t i = 0; i < p->edges; i++) {
      at[i] = pool->at[p->edge[i].from][axis];
    }
    qsort(at, p->edges, sizeof at[0], by_coordinate);
    const long double low = at[0], high = at[p->edges - 1];
    for (int i = 1; i <= count; i++) {
      const long double wanted = low + (high - low) * i / (count + 1);
      long double best = rintl(wanted);
      for (size_t n = 0; n < p->edges; n++) {
        if (fabsl(at[n] - wanted) < (high - low) / (4 * (count + 1)) &&
            (best == rintl(wanted) || fabsl(at[n] - wanted) < fabsl(best - wanted))) {
          best = rintl(at[n]);
        }
      }
      solid_plane plane = {{0, 0, 0}, (solid_wide)best};
      plane.n[axis] = 1;
      add_choice(list, &plane);
    }
  }
  free(at);
}

// The area of a piece's faces that lie in a plane.
static long double area_in(const piece *p, const piece_pool *pool, const solid_plane *plane) {
  long double sum[3] = {0, 0, 0};
  for (size_t i = 0, first = 0; i < p->edges; i++) {
    first = p->edge[i].face == p->edge[first].face ? first : i;
    if (is_same_plane(&p->face[p->edge[i].face], plane)) {
      const long double *o = pool->at[p->edge[first].from], *a = pool->at[p->edge[i].from],
                        *b = pool->at[p->edge[i].to];
      for (int j = 0; j < 3; j++) {
        const int k = (j + 1) % 3, l = (j + 2) % 3;
        sum[j] += (a[k] - o[k]) * (b[l] - o[l]) - (a[l] - o[l]) * (b[k] - o[k]);
      }
    }
  }
  return sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / 2;
}

// What a cut costs: six times the volume of the hulls, and the area of the cut times half a length of the hull. Volume alone
// would not do: half a ring's hull has half the volume of the ring's, yet that cut makes the next ones good.
// A side of less than a tenth of the volume doubles the cost.
static long double cost_of_cut(const piece_list *half, const piece_pool *pool, const solid_plane *plane,
                               long double volume6, long double length) {
  long double sum = 0, area = 0, least = INFINITY;
  for (size_t i = 0; i < half->count; i++) {
    size_t points;
    int32_t(*point)[3] = cuts_points(&half->item[i], pool, true, &points);
    part hull;
    if (part_build(&hull, point, points)) {
      sum += (long double)hull.volume6;
      part_free(&hull);
    }
    least = fminl(least, piece_volume6(&half->item[i], pool));
    area += area_in(&half->item[i], pool, plane) / 2;  // each side has it
    free(point);
  }
  return (sum + 3 * area * length) * (least < volume6 / 10 ? 2 : 1);
}

bool cuts_once(const piece *p, long double hull_volume6, piece_pool *pool, piece_list *out) {
  choices list = {NULL, 0, 0};
  size_t notches;
  const long double slack = 0x1p-10L;
  piece_notch *notch = piece_notches(p, pool, 1, &notches);
  const size_t tries = p->edges < 3000 ? 24 : p->edges < 20000 ? 12 : 6;
  if (notches > 0) {
    qsort(notch, notches, sizeof notch[0], deepest_first);
  }
  // Half of them the deepest ones, half spread over the rest.
  for (size_t i = 0; i < tries && i < notches; i++) {
    const size_t n = i < tries / 2 || notches <= tries ? i : i * (notches - 1) / (tries - 1);
    add_choice(&list, &notch[n].plane[0]);
    add_choice(&list, &notch[n].plane[1]);
    add_bisector(&list, p, pool, &notch[n]);
  }
  add_across(&list, p, pool, p->edges < 3000 ? 7 : 5);
  long double least = INFINITY;
  solid_plane best = {{0, 0, 0}, 0};
  const long double volume6 = piece_volume6(p, pool);
  const long double length = cbrtl(hull_volume6 / 6);
  for (size_t i = 0; i < list.count; i++) {
    if (is_cutting(p, pool, &list.item[i].plane, slack)) {
      const size_t known = pool->count;
      piece_list half = {NULL, 0, 0};
      piece_cut(p, &list.item[i].plane, slack, pool, &half);
      const long double cost =
          half.count > 1 ? cost_of_cut(&half, pool, &list.item[i].plane, volume6, length) : INFINITY;
      if (cost < least) {
        least = cost;
        best = list.item[i].plane;
      }
      piece_list_free(&half);
      pool->count = known;
    }
  }
  if (isfinite(least)) {
    piece_cut(p, &best, slack, pool, out);
  }
  free(list.item);
  free(notch);
  return isfinite(least);
}
