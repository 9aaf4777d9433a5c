// Makes machines of robots.
#include "machine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void machine_word(const char *text, char *out, size_t room) {
  size_t length = 0;
  for (; *text != '\0' && length + 1 < room; text++) {
    const char c = *text;
    const bool kept =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || strchr("_-+.", c) != NULL;
    out[length++] = (char)(kept ? c : '_');
  }
  out[length] = '\0';
}

void machine_matrix(const double rpy[3], double out[3][3]) {
  const double sr = sin(rpy[0]), cr = cos(rpy[0]), sp = sin(rpy[1]), cp = cos(rpy[1]), sy = sin(rpy[2]),
               cy = cos(rpy[2]);
  out[0][0] = cy * cp;
  out[0][1] = cy * sp * sr - sy * cr;
  out[0][2] = cy * sp * cr + sy * sr;
  out[1][0] = sy * cp;
  out[1][1] = sy * sp * sr + cy * cr;
  out[1][2] = sy * sp * cr - cy * sr;
  out[2][0] = -sp;
  out[2][1] = cp * sr;
  out[2][2] = cp * cr;
}

// *far: how far the position is from the real one, LSB. False: it leaves int32.
static bool round_pose(const robot_pose *from, double scale, gjk_pose *out, double *far) {
  const double *rpy = from->rpy;
  const double sr = sin(rpy[0] / 2), cr = cos(rpy[0] / 2), sp = sin(rpy[1] / 2), cp = cos(rpy[1] / 2),
               sy = sin(rpy[2] / 2), cy = cos(rpy[2] / 2);
  int32_t at[3];
  double square = 0;
  for (int i = 0; i < 3; i++) {
    const double exact = from->xyz[i] * scale, rounded = rint(exact);
    if (!(fabs(rounded) <= INT32_MAX)) {
      return false;
    }
    at[i] = (int32_t)rounded;
    square += (exact - rounded) * (exact - rounded);
  }
  *far = sqrt(square);
  const double unit = GJK_Q30_ONE;
  const gjk_pose pose = {
      {at[0], at[1], at[2]},
      {(gjk_q30)rint((sr * cp * cy - cr * sp * sy) * unit), (gjk_q30)rint((cr * sp * cy + sr * cp * sy) * unit),
       (gjk_q30)rint((cr * cp * sy - sr * sp * cy) * unit), (gjk_q30)rint((cr * cp * cy + sr * sp * sy) * unit)}};
  *out = pose;
  return true;
}

// Beyond int32 there is no limit.
static int32_t round_limit(double limit) {
  return (int32_t)fmin(INT32_MAX, fmax(INT32_MIN, rint(limit)));
}

static bool round_joint(machine *m, const robot_joint *j, gjk_arm_link *link) {
  double far;
  const double largest = fmax(fabs(j->axis[0]), fmax(fabs(j->axis[1]), fabs(j->axis[2])));
  const double x = j->axis[0] / largest, y = j->axis[1] / largest, z = j->axis[2] / largest,
               length = sqrt(x * x + y * y + z * z);
  const double worth = j->kind == ROBOT_PRISMATIC ? m->how->scale : 65536;
  if (!round_pose(&j->origin, m->how->scale, &link->fixed, &far)) {
    return xml_fail(m->r, j->line, "joint '%s' is beyond Q16.16", j->name);
  }
  link->kind = (uint8_t)(j->kind == ROBOT_FIXED       ? GJK_ARM_FIXED
                         : j->kind == ROBOT_PRISMATIC ? GJK_ARM_PRISMATIC
                                                      : GJK_ARM_REVOLUTE);
  if (j->kind != ROBOT_FIXED) {
    link->axis.x = (int32_t)rint(x / length * GJK_Q30_ONE);
    link->axis.y = (int32_t)rint(y / length * GJK_Q30_ONE);
    link->axis.z = (int32_t)rint(z / length * GJK_Q30_ONE);
    m->values++;
  }
  if (j->kind == ROBOT_REVOLUTE || j->kind == ROBOT_PRISMATIC) {
    link->lower = round_limit(j->lower * worth);
    link->upper = round_limit(j->upper * worth);
  }
  return true;
}

static bool is_taken(const machine *m, unsigned count, const char *name) {
  bool taken = strcmp(name, "base") == 0;  // a word of cases
  for (unsigned i = 0; i < count; i++) {
    taken = taken || strcmp(m->name[i], name) == 0;
  }
  return taken;
}

// Names that differ in signs alone are told apart by up to three strokes, or are a number instead.
static bool name_link(machine *m, unsigned link, const robot_link *from) {
  machine_word(from->name, m->name[link], ROBOT_NAME);
  for (unsigned stroke = 0; stroke < 3 && is_taken(m, link, m->name[link]); stroke++) {
    strcat(m->name[link], "_");
  }
  if (is_taken(m, link, m->name[link])) {
    snprintf(m->name[link], sizeof m->name[link], "link_%u", link);
  }
  return !is_taken(m, link, m->name[link]) ||
         xml_fail(m->r, from->line, "too many links with names like '%s'", from->name);
}

static bool add_links(machine *m) {
  const gjk_arm_link plain = {GJK_ARM_BASE,        GJK_ARM_FIXED, GJK_POSE_IDENTITY,
                              {0, 0, GJK_Q30_ONE}, INT32_MIN,     INT32_MAX};
  unsigned place[ROBOT_LINKS_MAX] = {0};
  for (unsigned i = 0; i < m->from->ordered; i++) {
    const unsigned number = m->from->order[i];
    const robot_link *from = &m->from->link[number];
    m->number[i] = number;
    m->link[i] = plain;
    place[number] = i;
    if (!name_link(m, i, from)) {
      return false;
    }
    if (from->joint != ROBOT_ROOT) {
      m->link[i].parent = (uint8_t)place[robot_parent(m->from, number)];
      if (!round_joint(m, &m->from->joint[from->joint], &m->link[i])) {
        return false;
      }
    }
    m->links++;
  }
  return true;
}

bool machine_add_part(machine *m, const robot_shape *s, unsigned link, const gjk_shape *shape, const gjk_pose *pose) {
  if (m->parts == GJK_ARM_PARTS_MAX) {
    return xml_fail(m->r, s->line, "too many parts: more than %d", GJK_ARM_PARTS_MAX);
  }
  gjk_collider collider;
  memset(&collider, 0, sizeof collider);
  if (gjk_collider_init(&collider, shape, NULL, 0) != GJK_OK || gjk_collider_pose(&collider, pose) != GJK_OK) {
    return xml_fail(m->r, s->line, "a shape of link '%s' is wider than 4095 units, or too far away",
                    m->from->link[s->link].name);
  }
  m->shape[m->parts] = *shape;
  m->geometry[m->parts] = s->geometry;
  m->part[m->parts].shape = &m->shape[m->parts];
  m->part[m->parts].pose = *pose;
  m->part[m->parts].link = (uint8_t)link;
  m->vertices += s->geometry == ROBOT_MESH ? shape->count : 0;
  m->parts++;
  return true;
}

// A length, rounded up; more than any shape may have where it is too large.
static gjk_q16 up(double length) {
  return length < INT32_MAX ? (gjk_q16)ceil(length) : INT32_MAX;
}

static bool add_primitive(machine *m, const robot_shape *s, unsigned link) {
  const double scale = m->how->scale, *size = s->size;
  gjk_pose pose;
  double far;
  if (!round_pose(&s->origin, scale, &pose, &far)) {
    return xml_fail(m->r, s->line, "a shape of link '%s' is beyond Q16.16", m->from->link[s->link].name);
  }
  const bool turned = s->origin.rpy[0] != 0 || s->origin.rpy[1] != 0 || s->origin.rpy[2] != 0;
  if (s->geometry == ROBOT_SPHERE) {
    const gjk_quat identity = {0, 0, 0, GJK_Q30_ONE};
    const gjk_shape sphere = GJK_SPHERE(up(size[0] * scale + far));
    pose.rotation = identity;
    return machine_add_part(m, s, link, &sphere, &pose);
  }
  // Of a rounded quaternion a point at distance r is turned by less than 2^-28 r.
  if (s->geometry == ROBOT_BOX) {
    const double half[3] = {size[0] / 2 * scale, size[1] / 2 * scale, size[2] / 2 * scale};
    const double more = far + (turned ? ldexp(half[0] + half[1] + half[2], -28) : 0);
    const gjk_shape box = GJK_BOX(up(half[0] + more), up(half[1] + more), up(half[2] + more));
    return machine_add_part(m, s, link, &box, &pose);
  }
  const double radius = size[0] * scale, half = size[1] / 2 * scale;
  const double more = far + (turned ? ldexp(radius + half, -28) : 0);
  const gjk_shape cylinder = GJK_CYLINDER(up(radius + more), up(half + more));
  return machine_add_part(m, s, link, &cylinder, &pose);
}

static bool add_parts(machine *m) {
  for (unsigned i = 0; i < m->links; i++) {
    for (unsigned k = 0; k < m->from->shapes; k++) {
      const robot_shape *s = &m->from->shape[k];
      if (s->link == m->number[i] &&
          !(s->geometry == ROBOT_MESH ? machine_add_mesh(m, s, i) : add_primitive(m, s, i))) {
        return false;
      }
    }
  }
  return true;
}

// Does the library take it? Its reach is the only thing that is left to refuse.
static bool check(machine *m) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const uint32_t pairs = GJK_ARM_PAIRS(m->parts, 0u);
  const gjk_arm_model model = machine_model(m);
  const gjk_arm_memory memory = {solid_allocate(m->links, sizeof(gjk_arm_link_room)),
                                 solid_allocate(m->parts, sizeof(gjk_arm_part_room)),
                                 solid_allocate(pairs, sizeof(gjk_arm_pair)), pairs};
  int32_t values[GJK_ARM_LINKS_MAX] = {0};
  gjk_pose poses[GJK_ARM_LINKS_MAX];
  gjk_arm arm;
  memset(&arm, 0, sizeof arm);
  gjk_status status = gjk_arm_init(&arm, &model, &identity, &memory);
  status = status == GJK_OK ? gjk_arm_poses(&arm, values, poses) : status;
  free(memory.links);
  free(memory.parts);
  free(memory.pairs);
  return status == GJK_OK ||
         xml_fail(m->r, 1, "the machine reaches farther than 2048 units: %s; see --scale", gjk_status_name(status));
}

bool machine_make(machine *m, robot *b, bool pairs, const machine_options *how, xml_reader *r) {
  memset(m, 0, sizeof *m);
  m->from = b;
  m->how = how;
  m->r = r;
  robot_leave_out(b, GJK_ARM_LINKS_MAX);
  if (b->ordered > GJK_ARM_LINKS_MAX) {
    return xml_fail(r, b->link[b->order[GJK_ARM_LINKS_MAX]].line, "too many links: %u, and a machine has at most %d",
                    b->ordered, GJK_ARM_LINKS_MAX);
  }
  if (!add_links(m) || !add_parts(m) || !check(m)) {
    return false;
  }
  for (unsigned i = 0; i < m->links && pairs; i++) {
    for (unsigned k = 0; k < m->links; k++) {
      m->never[i] |= i < k && b->never[m->number[i]][m->number[k]] ? UINT32_C(1) << k : 0;
    }
  }
  if (!pairs) {
    machine_sample(m);
  }
  return true;
}

gjk_arm_model machine_model(const machine *m) {
  const gjk_arm_model model = {m->link, m->part, m->never, (uint8_t)m->links, (uint16_t)m->parts};
  return model;
}

void machine_free(machine *m) {
  for (unsigned i = 0; i < m->parts; i++) {
    if (m->geometry[i] == ROBOT_MESH) {
      free((void *)(uintptr_t)m->shape[i].vertices);
    }
  }
}
