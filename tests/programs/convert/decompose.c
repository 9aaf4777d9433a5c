// Decomposition: cut, take hulls, merge, mend, check.
#include "decompose.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cuts.h"

enum {
  EXACT_NOTCHES = 96,
  PARTS_MAX = 1024,
  MEND_ROUNDS = 24,
  QUICK_CELLS = 3000,
  CAREFUL_CELLS = 10000,
  ROUNDED_EXCESS = 16,
  CUT_TWICE = 1024  // triangles
};

typedef struct part_list {
  part *item;
  size_t count, room;
} part_list;

static void add_part(part_list *list, part p) {
  if (list->count == list->room) {
    list->item = solid_grow(list->item, &list->room, sizeof list->item[0]);
  }
  list->item[list->count++] = p;
}

static void free_parts(part_list *list) {
  for (size_t i = 0; i < list->count; i++) {
    part_free(&list->item[i]);
  }
  free(list->item);
  memset(list, 0, sizeof *list);
}

static bool hull_of_piece(const piece *p, const piece_pool *pool, part *out) {
  size_t points;
  int32_t(*point)[3] = cuts_points(p, pool, false, &points);
  const bool built = part_build(out, point, points);
  free(point);
  return built;
}

static void add_hulls(const piece_list *pieces, const piece_pool *pool, part_list *out) {
  for (size_t i = 0; i < pieces->count; i++) {
    part p;
    if (hull_of_piece(&pieces->item[i], pool, &p)) {
      add_part(out, p);
    }
  }
}

static bool join(const part *a, const part *b, part *out) {
  const size_t points = (size_t)a->points + b->points;
  int32_t(*point)[3] = solid_allocate(points, sizeof point[0]);
  memcpy(point, a->point, a->points * sizeof point[0]);
  memcpy(point + a->points, b->point, b->points * sizeof point[0]);
  const bool built = part_build(out, point, points);
  free(point);
  return built;
}

static bool is_apart(const part *a, const part *b) {
  for (int j = 0; j < 3; j++) {
    if (a->low[j] > b->high[j] + 1 || b->low[j] > a->high[j] + 1) {
      return true;
    }
  }
  return false;
}

// Six times the volume that two parts share.
static long double common_volume6(const part *a, const part *b) {
  piece_pool pool;
  const piece p =
      piece_from_faces((const int32_t(*)[3])a->point, a->points, a->corner, a->end, a->plane, a->faces, &pool);
  const long double common = piece_volume6_behind(p, b->plane, b->faces, &pool);
  free(pool.at);
  return common;
}

// The volume that a hull of two parts adds to their sum; of the union, if 'exact': that is 0 where the union is convex.
// INFINITY: they are not merged.
static long double cost_of_joining(const part *a, const part *b, bool far, bool exact) {
  part both;
  if ((is_apart(a, b) && !far) || !join(a, b, &both)) {
    return INFINITY;
  }
  long double more = (long double)(both.volume6 - a->volume6 - b->volume6);
  const long double common = exact && !is_apart(a, b) ? common_volume6(a, b) : 0;
  if (common > 0) {  // rounded: so little counts as nothing, and is_exact proves what comes of it
    more = fabsl(more + common) <= (long double)both.volume6 * 0x1p-40L ? 0 : more + common;
  }
  part_free(&both);
  return more;
}

// Is what a hull adds to two parts a layer of a few LSB, or little of it? If not, it reaches through other parts, and has them
// in it once more.
static bool is_layer(const part *hull, long double more) {
  const long double a = hull->high[0] - hull->low[0], b = hull->high[1] - hull->low[1],
                    c = hull->high[2] - hull->low[2];
  return more <= fmaxl((long double)hull->volume6 / 64, 6 * 2 * 2 * (a * b + b * c + c * a));
}

// Merges pairs, the cheapest first, as long as the excess stays within the budget and, beyond that, until there are no more
// than 'most'. budget 0: only pairs whose union is convex. budget below 0: only until there are no more than 'most'.
// layers: only what is_layer allows.
static void merge_pairs(const nearest_tree *tree, part_list *list, long double budget, size_t most, bool layers) {
  const size_t n = list->count;
  long double *cost = solid_allocate(n * n, sizeof cost[0]);
  const bool far = most > 0 && most < n;
  for (size_t i = 0; i < n; i++) {
    for (size_t j = i + 1; j < n; j++) {
      cost[i * n + j] = cost_of_joining(&list->item[i], &list->item[j], far, budget == 0);
    }
  }
  size_t left = n;
  for (;;) {
    size_t a = n, b = n;
    long double least = INFINITY;
    for (size_t i = 0; i < n; i++) {
      for (size_t j = i + 1; j < n; j++) {
        if (cost[i * n + j] < least) {
          least = cost[i * n + j];
          a = i;
          b = j;
        }
      }
    }
    const bool must = most > 0 && left > most;
    part both;
    if (a == n || (!must && (budget < 0 || (budget == 0 && least > 0)))) {
      break;
    }
    const bool built = join(&list->item[a], &list->item[b], &both);
    if (!built || (!must && layers && !is_layer(&both, least)) ||
        (!must && budget > 0 && excess_of(tree, &both, budget / 16, budget, QUICK_CELLS).at_most > budget)) {
      if (built) {
        part_free(&both);
      }
      cost[a * n + b] = INFINITY;
      continue;
    }
    part_free(&list->item[a]);
    part_free(&list->item[b]);
    list->item[a] = both;
    left--;
    for (size_t i = 0; i < n; i++) {
      cost[i < b ? i * n + b : b * n + i] = INFINITY;
      if (i != a && list->item[i].points > 0) {
        cost[i < a ? i * n + a : a * n + i] = cost_of_joining(&list->item[i], &both, far, budget == 0);
      }
    }
  }
  size_t kept = 0;
  for (size_t i = 0; i < n; i++) {
    if (list->item[i].points > 0) {
      list->item[kept++] = list->item[i];
    }
  }
  list->count = kept;
  free(cost);
}

static void merge(const nearest_tree *tree, part_list *list, long double budget, size_t most) {
  merge_pairs(tree, list, budget, most, false);
}

// Leaves out parts that are within one other.
static void drop_covered(part_list *list) {
  for (size_t i = 0; i < list->count;) {
    bool covered = false;
    for (size_t j = 0; j < list->count && !covered; j++) {
      covered = j != i;
      for (unsigned n = 0; n < list->item[i].points && covered; n++) {
        covered = part_has(&list->item[j], list->item[i].point[n]);
      }
    }
    if (covered) {
      part_free(&list->item[i]);
      memmove(&list->item[i], &list->item[i + 1], (--list->count - i) * sizeof list->item[0]);
    } else {
      i++;
    }
  }
}

// How far a gap is beyond a part.
static long double beyond(const part *p, const enclose_gap *gap) {
  long double most = 0;
  for (unsigned i = 0; i < gap->corners; i++) {
    for (unsigned f = 0; f < p->faces; f++) {
      const long double n[3] = {(long double)p->plane[f].n[0], (long double)p->plane[f].n[1],
                                (long double)p->plane[f].n[2]};
      const long double *x = gap->corner[i];
      const long double h = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - (long double)p->plane[f].d;
      most = fmaxl(most, h / sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
    }
  }
  return most;
}

// Adds a gap's corners, rounded outwards, to that part which they are least beyond. more: LSB wider.
static void fill(part_list *list, const enclose_gap *gap, long double more) {
  size_t best = list->count;
  long double least = INFINITY;
  for (size_t i = 0; i < list->count; i++) {
    const long double far = gap->part == (long)i ? INFINITY : beyond(&list->item[i], gap);
    if (far < least) {
      least = far;
      best = i;
    }
  }
  if (best == list->count) {
    return;
  }
  part *p = &list->item[best], grown;
  const size_t room = p->points + 8 * (size_t)gap->corners;
  int32_t(*point)[3] = solid_allocate(room, sizeof point[0]);
  size_t points = p->points;
  memcpy(point, p->point, points * sizeof point[0]);
  for (unsigned i = 0; i < gap->corners; i++) {
    for (int n = 0; n < 8; n++, points++) {
      for (int j = 0; j < 3; j++) {
        const long double x = gap->corner[i][j];
        const bool is_whole = more == 0 && fabsl(x - rintl(x)) < 0x1p-24L;
        point[points][j] = (int32_t)(is_whole ? rintl(x) : n >> j & 1 ? ceill(x + more) : floorl(x - more));
      }
    }
  }
  if (part_build(&grown, point, points)) {
    part_free(p);
    *p = grown;
  }
  free(point);
}

// Checks and mends until all is enclosed; false: it is not. problem: what is wrong.
static bool check_and_mend(const solid *s, part_list *list, char problem[ENCLOSE_PROBLEM]) {
  enclose_report *report = solid_allocate(1, sizeof *report);
  bool enclosed = false;
  for (int round = 0; round < MEND_ROUNDS; round++) {
    enclosed = enclose_check(s, list->item, list->count, report);
    memcpy(problem, report->problem, sizeof report->problem);
    if (enclosed || round + 1 == MEND_ROUNDS) {
      break;
    }
    for (unsigned i = 0; i < report->gaps; i++) {
      fill(list, &report->gap[i], round < 4 ? 0 : round - 3);
    }
    enclose_free(report);
  }
  enclose_free(report);
  free(report);
  return enclosed;
}

static void measure(const solid *s, const nearest_tree *tree, const part_list *list, decomposition *out) {
  const long double widest = fmaxl(s->high[0], fmaxl(s->high[1], s->high[2]));
  out->excess.at_least = out->excess.at_most = 0;
  for (size_t i = 0; i < list->count; i++) {
    if (!enclose_is_inside(s, &list->item[i])) {
      // A rough look first: how finely the part is cut follows from what is found. If that takes too many cells, less finely.
      excess_bounds one = excess_of(tree, &list->item[i], widest / 1024, INFINITY, QUICK_CELLS);
      for (long double fine = fmaxl(0.125L, one.at_least / 64); fine < widest / 1024; fine *= 8) {
        const excess_bounds again = excess_of(tree, &list->item[i], fine, INFINITY, CAREFUL_CELLS);
        one.at_least = fmaxl(one.at_least, again.at_least);
        one.at_most = fminl(one.at_most, again.at_most);
        if (one.at_most - one.at_least <= 2 * fine) {
          break;
        }
      }
      if (one.at_least < 64 && one.at_most > one.at_least + 1) {
        one.at_most = fminl(one.at_most, excess_by_shrinking(s, &list->item[i]));
      }
      out->excess.at_least = fmaxl(out->excess.at_least, one.at_least);
      out->excess.at_most = fmaxl(out->excess.at_most, one.at_most);
    }
  }
}

// Parts by cuts at notches alone.
static bool at_notches(const solid *s, const nearest_tree *tree, cuts_manner manner, part_list *out) {
  piece_pool pool;
  piece_list pieces = {NULL, 0, 0};
  piece whole = piece_from(s);
  piece_pool_from(&pool, s);
  const bool done = cuts_at_notches(&whole, &pool, &manner, 4 * EXACT_NOTCHES, &pieces);
  if (done) {
    add_hulls(&pieces, &pool, out);
    merge(tree, out, 0, 0);
    drop_covered(out);
  }
  piece_list_free(&pieces);
  piece_free(&whole);
  free(pool.at);
  return done && out->count > 0;
}

static solid_wide volume_of(const part_list *list) {
  solid_wide sum = 0;
  for (size_t i = 0; i < list->count; i++) {
    sum += list->item[i].volume6;
  }
  return sum;
}

// Do the parts make up the solid? They enclose it, so they do where their volumes add up to its volume, or where each is in it.
// The latter matters where the surface winds around more than once: that counts in the solid's volume, not in the union's.
static bool is_exact(const solid *s, const part_list *list) {
  if (volume_of(list) == s->volume6) {
    return true;
  }
  for (size_t i = 0; i < list->count; i++) {
    if (!enclose_is_inside(s, &list->item[i])) {
      return false;
    }
  }
  return true;
}

static long double rough_excess(const solid *s, const nearest_tree *tree, const part_list *list) {
  const long double widest = fmaxl(s->high[0], fmaxl(s->high[1], s->high[2]));
  long double most = 0;
  for (size_t i = 0; i < list->count; i++) {
    most = fmaxl(most, excess_of(tree, &list->item[i], widest / 256, INFINITY, QUICK_CELLS).at_least);
  }
  return most;
}

// Few notches: cut at them, exactly if that gives integers. Else what is no notch but by rounding may be left, and parts are
// merged that make little of a difference: not more than 'most'. Of exact parts by planes to corners a quarter more are taken.
// Where faces are bent by rounding such planes follow each bend, and parts that reach a few LSB beyond are far fewer.
static bool by_notches(const solid *s, const nearest_tree *tree, long double most, part_list *out) {
  static const cuts_manner manners[] = {{0x1p-10L, true, false}, {0x1p-10L, false, false}, {3, true, false},
                                        {24, true, false},       {3, true, true},          {0x1p-10L, true, true}};
  long double least = INFINITY;
  char problem[ENCLOSE_PROBLEM];
  for (size_t i = 0; i < sizeof manners / sizeof manners[0]; i++) {
    part_list list = {NULL, 0, 0};
    bool done = at_notches(s, tree, manners[i], &list);
    bool exact = done && is_exact(s, &list);
    long double excess = 0;
    if (done && !exact) {
      merge_pairs(tree, &list, fminl(ROUNDED_EXCESS, most / 4), 0, true);
    }
    if (done) {  // slack may leave gaps, whose filling is to be judged, too
      done = check_and_mend(s, &list, problem);
      exact = exact && is_exact(s, &list);
    }
    if (done && !exact) {
      excess = rough_excess(s, tree, &list);
      done = excess <= fminl(4 * ROUNDED_EXCESS, most);
    }
    const bool corners = manners[i].corners;
    const bool fewer = out->count == 0 || list.count < out->count || (list.count == out->count && excess < least);
    if (done && (fewer || (exact && (!corners || 4 * list.count <= 5 * out->count)))) {
      free_parts(out);
      *out = list;
      least = excess;
    } else {
      free_parts(&list);
    }
    if (exact && !corners) {
      break;
    }
  }
  return out->count > 0;
}

// A piece, its hull, and how much larger that is.
typedef struct job {
  piece p;
  part hull;
  long double more;
  bool done;
} job;

static job job_of(piece p, const piece_pool *pool) {
  job j = {p, {0}, 0, false};
  if (hull_of_piece(&p, pool, &j.hull)) {
    j.more = (long double)j.hull.volume6 - piece_volume6(&p, pool);
  }
  return j;
}

// Cuts the piece whose hull adds most, until all hulls are within the budget, or there are 'most'.
static void by_concavity(const solid *s, const nearest_tree *tree, long double budget, size_t most, part_list *out) {
  piece_pool pool;
  piece_list pieces = {NULL, 0, 0};
  piece whole = piece_from(s);
  job *work = solid_allocate(PARTS_MAX, sizeof work[0]);
  size_t jobs = 0;
  piece_pool_from(&pool, s);
  piece_part(&whole, &pool, &pieces);
  piece_free(&whole);
  for (;;) {
    for (size_t i = 0; i < pieces.count; i++) {
      if (jobs < PARTS_MAX) {
        work[jobs++] = job_of(pieces.item[i], &pool);
      } else {
        piece_free(&pieces.item[i]);
      }
    }
    free(pieces.item);
    memset(&pieces, 0, sizeof pieces);
    size_t next = jobs;
    for (size_t i = 0; i < jobs; i++) {
      next = !work[i].done && (next == jobs || work[i].more > work[next].more) ? i : next;
    }
    if (next == jobs || (most > 0 && jobs >= most) || jobs + 64 > PARTS_MAX) {
      break;
    }
    job *j = &work[next];
    if (j->hull.points == 0 || (j->more <= 0 && budget <= 0) ||
        (budget > 0 && excess_of(tree, &j->hull, budget / 16, budget, QUICK_CELLS).at_most <= budget) ||
        !cuts_once(&j->p, (long double)j->hull.volume6, &pool, &pieces)) {
      j->done = true;
      continue;
    }
    piece_free(&j->p);
    part_free(&j->hull);
    *j = work[--jobs];
  }
  for (size_t i = 0; i < jobs; i++) {
    if (work[i].hull.points > 0) {
      add_part(out, work[i].hull);
    }
    piece_free(&work[i].p);
  }
  free(work);
  free(pool.at);
}

// So many parts: by as many cuts, by twice as many and merging, or by excess. The best one counts.
static void to_number(const solid *s, const nearest_tree *tree, unsigned parts, part_list *out) {
  part_list merged = {NULL, 0, 0};
  by_concavity(s, tree, -1, parts, out);
  merge(tree, out, -1, parts);
  by_concavity(s, tree, -1, 2 * (size_t)parts + 2, &merged);
  merge(tree, &merged, -1, parts);
  const bool better = rough_excess(s, tree, &merged) < rough_excess(s, tree, out);
  free_parts(better ? out : &merged);
  if (better) {
    *out = merged;
  }
  // A lesser excess asked for may come out with no more parts.
  static const long double factors[] = {1, 0.9L, 0.75L};
  long double least = rough_excess(s, tree, out);
  for (size_t i = 0; i < sizeof factors / sizeof factors[0] && least > 4; i++) {
    part_list other = {NULL, 0, 0};
    by_concavity(s, tree, factors[i] * least, 0, &other);
    merge(tree, &other, factors[i] * least, 0);
    const long double excess = other.count <= parts ? rough_excess(s, tree, &other) : INFINITY;
    if (excess < least) {
      free_parts(out);
      *out = other;
      least = excess;
    } else {
      free_parts(&other);
    }
  }
}

// To an excess: pieces cut to that, and to a little less, and merged. Which leaves the fewest parts is up to chance, so that
// one counts. Large solids are cut once.
static void to_excess(const solid *s, const nearest_tree *tree, long double excess, unsigned parts, part_list *out) {
  by_concavity(s, tree, excess, 0, out);
  merge(tree, out, excess, parts);
  if (s->triangles <= CUT_TWICE) {
    part_list other = {NULL, 0, 0};
    by_concavity(s, tree, 0.9L * excess, 0, &other);
    merge(tree, &other, excess, parts);
    const bool better = other.count < out->count;
    free_parts(better ? out : &other);
    if (better) {
      *out = other;
    }
  }
}

static void whole_hull(const solid *s, part_list *out) {
  part p;
  if (part_build(&p, s->point, s->points)) {
    add_part(out, p);
  }
}

void decompose(const solid *s, const decompose_options *options, decomposition *out) {
  part_list list = {NULL, 0, 0};
  nearest_tree tree;
  piece_pool pool;
  piece whole = piece_from(s);
  memset(out, 0, sizeof *out);
  nearest_build(&tree, s);
  piece_pool_from(&pool, s);
  free(piece_notches(&whole, &pool, 0x1p-10L, &out->notches));
  piece_free(&whole);
  free(pool.at);

  int32_t longest = 0;
  for (int j = 0; j < 3; j++) {
    longest = s->high[j] > longest ? s->high[j] : longest;
  }
  const long double usual = longest / 64 > 4 ? longest / 64 : 4;
  const long double budget = options->excess >= 0 ? options->excess : usual;
  out->wanted = budget;
  bool done = out->notches <= EXACT_NOTCHES && by_notches(s, &tree, usual, &list);
  const bool few = done && (options->parts == 0 || list.count <= options->parts);
  if (done && options->excess > 0) {
    merge(&tree, &list, budget, options->parts);
  } else if (done && !few) {
    merge(&tree, &list, -1, options->parts);
  } else if (!done) {
    free_parts(&list);
    if (options->parts > 0 && options->excess < 0) {
      to_number(s, &tree, options->parts, &list);
    } else {
      to_excess(s, &tree, fmaxl(budget, 4), options->parts, &list);
    }
  }
  drop_covered(&list);
  out->enclosed = check_and_mend(s, &list, out->problem);
  if (!out->enclosed) {  // not expected: the hull of all is a part that encloses any solid
    free_parts(&list);
    whole_hull(s, &list);
    out->enclosed = check_and_mend(s, &list, out->problem);
  }
  measure(s, &tree, &list, out);
  out->part = list.item;
  out->parts = list.count;
  nearest_free(&tree);
}

void decompose_free(decomposition *d) {
  part_list list = {d->part, d->parts, d->parts};
  free_parts(&list);
  memset(d, 0, sizeof *d);
}
