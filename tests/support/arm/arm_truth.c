// Forward kinematics in double, and sure verdicts: a gap changes no faster than the bound of the speed allows.
#include "arm_truth.h"

#include <math.h>

#include "gjk/distance.h"

static void multiply(const double a[4], const double b[4], double out[4]) {
  const double r[4] = {
      a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
      a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
  for (unsigned i = 0; i < 4; i++) {
    out[i] = r[i];
  }
}

void arm_truth_turn(const double q[4], const double v[3], double out[3]) {
  const double point[4] = {v[0], v[1], v[2], 0}, back[4] = {-q[0], -q[1], -q[2], q[3]};
  double r[4];
  multiply(q, point, r);
  multiply(r, back, r);
  for (unsigned i = 0; i < 3; i++) {
    out[i] = r[i];
  }
}

static arm_truth_frame real_of(const gjk_pose *pose) {
  const gjk_quat *q = &pose->rotation;
  const double n = sqrt((double)q->x * q->x + (double)q->y * q->y + (double)q->z * q->z + (double)q->w * q->w);
  const arm_truth_frame r = {{q->x / n, q->y / n, q->z / n, q->w / n},
                             {pose->position.x, pose->position.y, pose->position.z}};
  return r;
}

// First b, then a.
static arm_truth_frame composed(const arm_truth_frame *a, const arm_truth_frame *b) {
  arm_truth_frame r;
  arm_truth_turn(a->q, b->p, r.p);
  for (unsigned i = 0; i < 3; i++) {
    r.p[i] += a->p[i];
  }
  multiply(a->q, b->q, r.q);
  return r;
}

void arm_truth_frames(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction,
                      arm_truth_frame out[GJK_ARM_LINKS_MAX]) {
  const arm_truth_frame base = real_of(&arm->base);
  unsigned value = 0;
  for (unsigned i = 0; i < arm->model->link_count; i++) {
    const gjk_arm_link *link = &arm->model->links[i];
    const arm_truth_frame fixed = real_of(&link->fixed);
    const double axis[3] = {link->axis.x, link->axis.y, link->axis.z};
    const double n = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    arm_truth_frame own = {{0, 0, 0, 1}, {0, 0, 0}};
    if (link->kind != GJK_ARM_FIXED) {
      const double v = from[value] + ((double)to[value] - from[value]) * fraction, half = v / 131072;
      for (unsigned k = 0; k < 3; k++) {
        own.q[k] = link->kind == GJK_ARM_REVOLUTE ? axis[k] / n * sin(half) : 0;
        own.p[k] = link->kind == GJK_ARM_PRISMATIC ? axis[k] / n * v : 0;
      }
      own.q[3] = link->kind == GJK_ARM_REVOLUTE ? cos(half) : 1;
      value++;
    }
    out[i] = composed(link->parent == GJK_ARM_BASE ? &base : &out[link->parent], &fixed);
    out[i] = composed(&out[i], &own);
  }
}

static gjk_pose rounded(const arm_truth_frame *r) {
  const gjk_pose pose = {{(gjk_q16)lround(r->p[0]), (gjk_q16)lround(r->p[1]), (gjk_q16)lround(r->p[2])},
                         {(gjk_q30)lround(r->q[0] * 1073741824), (gjk_q30)lround(r->q[1] * 1073741824),
                          (gjk_q30)lround(r->q[2] * 1073741824), (gjk_q30)lround(r->q[3] * 1073741824)}};
  return pose;
}

void arm_truth_pose(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction, unsigned link,
                    gjk_pose *out) {
  arm_truth_frame poses[GJK_ARM_LINKS_MAX];
  arm_truth_frames(arm, from, to, fraction, poses);
  *out = rounded(&poses[link]);
}

static bool place(const gjk_arm *arm, const arm_truth_frame *poses, unsigned number, gjk_collider *out) {
  const gjk_arm_part *part = &arm->model->parts[number];
  const arm_truth_frame own = real_of(&part->pose), r = composed(&poses[part->link], &own);
  const gjk_pose pose = rounded(&r);
  *out = (gjk_collider){0};
  return gjk_collider_init(out, part->shape, NULL, 0) == GJK_OK && gjk_collider_pose(out, &pose) == GJK_OK;
}

static double gap_of(const gjk_arm *arm, const arm_truth_frame *poses, const gjk_arm_names *names, double most) {
  gjk_collider part, other_part;
  const gjk_collider *other = &other_part;
  gjk_distance_result result;
  if (!place(arm, poses, names->part, &part)) {
    return -1;
  }
  if (names->obstacle) {
    other = &arm->obstacles[names->other];
  } else if (!place(arm, poses, names->other, &other_part)) {
    return -1;
  }
  const double x = (double)part.centre.x - other->centre.x, y = (double)part.centre.y - other->centre.y;
  const double z = (double)part.centre.z - other->centre.z;
  if (sqrt(x * x + y * y + z * z) - part.radius - other->radius > most) {
    return most;
  }
  return gjk_distance(&part, other, NULL, &result) == GJK_OK ? result.distance : result.lower;
}

double arm_truth_pair(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction,
                      const gjk_arm_names *names) {
  arm_truth_frame poses[GJK_ARM_LINKS_MAX];
  arm_truth_frames(arm, from, to, fraction, poses);
  return gap_of(arm, poses, names, 1e30);
}

// Does some joint move one link against the other, no joint connects them, and are they not left out?
static bool tested(const gjk_arm *arm, unsigned a, unsigned b) {
  const gjk_arm_model *m = arm->model;
  bool moves = false, above[2][GJK_ARM_LINKS_MAX] = {{false}};
  for (unsigned i = a;; i = m->links[i].parent) {
    above[0][i] = true;
    if (m->links[i].parent == GJK_ARM_BASE) {
      break;
    }
  }
  for (unsigned i = b; b != GJK_ARM_BASE; i = m->links[i].parent) {
    above[1][i] = true;
    if (m->links[i].parent == GJK_ARM_BASE) {
      break;
    }
  }
  for (unsigned i = 0; i < m->link_count; i++) {
    moves = moves || (above[0][i] != above[1][i] && m->links[i].kind != GJK_ARM_FIXED);
  }
  if (b == GJK_ARM_BASE || !moves) {
    return moves;
  }
  return m->links[a].parent != b && m->links[b].parent != a &&
         (m->never == NULL || ((m->never[a] >> b & 1u) == 0 && (m->never[b] >> a & 1u) == 0));
}

double arm_truth_gap(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction, double most) {
  arm_truth_frame poses[GJK_ARM_LINKS_MAX];
  const gjk_arm_model *m = arm->model;
  double least = most;
  arm_truth_frames(arm, from, to, fraction, poses);
  for (unsigned i = 0; i < m->part_count; i++) {
    for (unsigned k = 0; k < arm->obstacle_count; k++) {
      const gjk_arm_names names = {(uint16_t)i, (uint16_t)k, true, GJK_PARTS_NONE};
      if (tested(arm, m->parts[i].link, GJK_ARM_BASE)) {
        least = fmin(least, gap_of(arm, poses, &names, least));
      }
    }
    for (unsigned k = 0; k < i; k++) {
      const gjk_arm_names names = {(uint16_t)i, (uint16_t)k, false, GJK_PARTS_NONE};
      if (m->parts[i].link != m->parts[k].link && tested(arm, m->parts[i].link, m->parts[k].link)) {
        least = fmin(least, gap_of(arm, poses, &names, least));
      }
    }
  }
  return least;
}

// A bound of how fast a gap of two parts changes, LSB over the edge: twice the fastest point's speed in the world.
static double speed_bound(const gjk_arm *arm, const int32_t *from, const int32_t *to) {
  const gjk_arm_model *m = arm->model;
  double fastest = 0;
  for (unsigned i = 0; i < m->part_count; i++) {
    double reach = arm->memory.parts[i].reach, speed = 0;
    for (unsigned link = m->parts[i].link;; link = m->links[link].parent) {
      unsigned value = 0;
      for (unsigned k = 0; k < link; k++) {
        value += m->links[k].kind != GJK_ARM_FIXED;
      }
      const gjk_vec3 *o = &m->links[link].fixed.position;
      if (m->links[link].kind != GJK_ARM_FIXED) {
        const double change = fabs((double)to[value] - from[value]);
        const double size = fmax(fabs((double)to[value]), fabs((double)from[value]));
        speed += m->links[link].kind == GJK_ARM_REVOLUTE ? change / 65536 * reach : change;
        reach += m->links[link].kind == GJK_ARM_PRISMATIC ? size : 0;
      }
      reach += sqrt((double)o->x * o->x + (double)o->y * o->y + (double)o->z * o->z) + 1;
      if (m->links[link].parent == GJK_ARM_BASE) {
        break;
      }
    }
    fastest = fmax(fastest, speed);
  }
  return 2 * fastest;
}

static arm_truth look(const gjk_arm *arm, const int32_t *from, const int32_t *to, double start, double end,
                      double least, double speed, unsigned depth, unsigned *samples) {
  const double middle = (start + end) / 2, half = (end - start) / 2 * speed;
  const double gap = arm_truth_gap(arm, from, to, middle, least + half + 1e4);
  (*samples)++;
  if (gap < least - ARM_TRUTH_ERROR) {
    return ARM_TRUTH_TOUCH;
  }
  if (gap - half > least + ARM_TRUTH_ERROR) {
    return ARM_TRUTH_FREE;
  }
  if (depth == 0) {
    return ARM_TRUTH_OPEN;
  }
  const arm_truth left = look(arm, from, to, start, middle, least, speed, depth - 1, samples);
  if (left != ARM_TRUTH_FREE) {
    return left;
  }
  return look(arm, from, to, middle, end, least, speed, depth - 1, samples);
}

arm_truth arm_truth_edge(const gjk_arm *arm, const int32_t *from, const int32_t *to, double start, double end,
                         double least, unsigned *samples) {
  *samples = 0;
  return look(arm, from, to, start, end, least, speed_bound(arm, from, to), 24, samples);
}
