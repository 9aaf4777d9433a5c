// Reads robots.
#include "robot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Reads a name, which must be there.
static bool read_name(xml_reader *r, const char *attribute, char out[ROBOT_NAME]) {
  const bool there = xml_value(r, attribute, out, ROBOT_NAME);
  return (there && out[0] != '\0') || xml_fail(r, xml_line(r), "a name is missing: attribute '%s'", attribute);
}

// Reads so many numbers between blanks. False: there are others; none where the attribute is missing and not needed.
static bool read_numbers(xml_reader *r, const char *attribute, bool needed, unsigned count, double *out) {
  char text[256];
  const char *at = text;
  if (!xml_value(r, attribute, text, sizeof text)) {
    return !needed && r->problem[0] == '\0' ? true : xml_fail(r, xml_line(r), "attribute '%s' is missing", attribute);
  }
  for (unsigned i = 0; i < count; i++) {
    at += strspn(at, " ");
    char *end;
    const size_t length = strspn(at, "0123456789+-.eE");  // neither hexadecimal nor names of numbers
    const double number = strtod(at, &end);
    if (length == 0 || end != at + length || (*end != ' ' && *end != '\0') || !isfinite(number)) {
      return xml_fail(r, xml_line(r), "attribute '%s' is not %u number%s: '%.60s'", attribute, count,
                      count == 1 ? "" : "s", text);
    }
    out[i] = number;
    at = end;
  }
  return at[strspn(at, " ")] == '\0' || xml_fail(r, xml_line(r), "attribute '%s' is not %u number%s: '%.60s'",
                                                 attribute, count, count == 1 ? "" : "s", text);
}

static bool read_origin(xml_reader *r, robot_pose *out) {
  return read_numbers(r, "xyz", false, 3, out->xyz) && read_numbers(r, "rpy", false, 3, out->rpy);
}

// Reads the element of a shape that has just begun.
static bool read_kind(xml_reader *r, robot_shape *s) {
  bool fine = true;
  unsigned sizes = 0;
  if (xml_is(r, "box")) {
    s->geometry = ROBOT_BOX;
    sizes = 3;
    fine = read_numbers(r, "size", true, 3, s->size);
  } else if (xml_is(r, "sphere")) {
    s->geometry = ROBOT_SPHERE;
    sizes = 1;
    fine = read_numbers(r, "radius", true, 1, s->size);
  } else if (xml_is(r, "cylinder")) {
    s->geometry = ROBOT_CYLINDER;
    sizes = 2;
    fine = read_numbers(r, "radius", true, 1, &s->size[0]) && read_numbers(r, "length", true, 1, &s->size[1]);
  } else if (xml_is(r, "mesh")) {
    s->geometry = ROBOT_MESH;
    s->size[0] = s->size[1] = s->size[2] = 1;
    fine = (xml_value(r, "filename", s->file, ROBOT_FILE) && s->file[0] != '\0') ||
           xml_fail(r, xml_line(r), "attribute 'filename' is missing");
    fine = fine && read_numbers(r, "scale", false, 3, s->size);
  } else {
    return xml_fail(r, xml_line(r), "a shape that is neither box, sphere, cylinder nor mesh");
  }
  for (unsigned i = 0; fine && i < sizes; i++) {
    fine = s->size[i] >= 0 || xml_fail(r, xml_line(r), "a shape's size is negative");
  }
  return fine;
}

static bool read_geometry(xml_reader *r, robot_shape *s) {
  const unsigned depth = r->depth;
  const unsigned long line = xml_line(r);
  unsigned count = 0;
  while (xml_next_child(r, depth)) {
    if (count++ > 0 || !read_kind(r, s)) {
      return xml_fail(r, xml_line(r), "a second shape in one geometry");
    }
  }
  return count == 1 || xml_fail(r, line, "a geometry without a shape");
}

static bool read_collision(robot *b, xml_reader *r, unsigned link) {
  const unsigned depth = r->depth;
  const unsigned long line = xml_line(r);
  if (b->shapes == ROBOT_SHAPES_MAX) {
    return xml_fail(r, line, "more than %d shapes", ROBOT_SHAPES_MAX);
  }
  robot_shape *s = &b->shape[b->shapes++];
  bool has_geometry = false;
  s->link = link;
  s->line = line;
  while (xml_next_child(r, depth)) {
    if (xml_is(r, "origin") && !read_origin(r, &s->origin)) {
      return false;
    }
    if (xml_is(r, "geometry")) {
      if (has_geometry) {
        return xml_fail(r, xml_line(r), "a second geometry in one collision");
      }
      has_geometry = true;
      if (!read_geometry(r, s)) {
        return false;
      }
    }
  }
  return has_geometry || xml_fail(r, line, "a collision without a geometry");
}

bool robot_find(const robot *b, const char *name, unsigned *link) {
  for (*link = 0; *link < b->links; (*link)++) {
    if (strcmp(b->link[*link].name, name) == 0) {
      return true;
    }
  }
  return false;
}

static bool read_link(robot *b, xml_reader *r) {
  const unsigned depth = r->depth;
  char name[ROBOT_NAME];
  unsigned other;
  if (!read_name(r, "name", name)) {
    return false;
  }
  if (robot_find(b, name, &other)) {
    return xml_fail(r, xml_line(r), "link '%s' is there twice", name);
  }
  if (b->links == ROBOT_LINKS_MAX) {
    return xml_fail(r, xml_line(r), "too many links: more than %d", ROBOT_LINKS_MAX);
  }
  const unsigned number = b->links++;
  memcpy(b->link[number].name, name, ROBOT_NAME);
  b->link[number].line = xml_line(r);
  b->link[number].joint = ROBOT_ROOT;
  while (xml_next_child(r, depth)) {
    if (xml_is(r, "collision") && !read_collision(b, r, number)) {
      return false;
    }
  }
  return true;
}

static bool read_joint_kind(xml_reader *r, robot_joint *j) {
  static const char *const kinds[] = {"fixed", "revolute", "continuous", "prismatic"};
  char kind[ROBOT_NAME];
  if (!xml_value(r, "type", kind, sizeof kind)) {
    return xml_fail(r, xml_line(r), "joint '%s' has no type", j->name);
  }
  for (unsigned i = 0; i < 4; i++) {
    if (strcmp(kind, kinds[i]) == 0) {
      j->kind = (robot_kind)i;
      return true;
    }
  }
  return xml_fail(r, xml_line(r), "joint '%s' is of type '%s': revolute, continuous, prismatic and fixed are known",
                  j->name, kind);
}

// Reads what is in a joint.
static bool read_joint_child(xml_reader *r, robot_joint *j, bool *limited) {
  if (xml_is(r, "origin")) {
    return read_origin(r, &j->origin);
  }
  if (xml_is(r, "parent") || xml_is(r, "child")) {
    return read_name(r, "link", xml_is(r, "parent") ? j->parent : j->child);
  }
  if (xml_is(r, "axis")) {
    return read_numbers(r, "xyz", true, 3, j->axis);
  }
  if (xml_is(r, "limit")) {
    *limited = true;
    return read_numbers(r, "lower", false, 1, &j->lower) && read_numbers(r, "upper", false, 1, &j->upper);
  }
  j->mimics = j->mimics || xml_is(r, "mimic");
  return true;
}

static bool check_joint(xml_reader *r, const robot_joint *j, bool limited) {
  if (j->parent[0] == '\0' || j->child[0] == '\0') {
    return xml_fail(r, j->line, "joint '%s' has no %s", j->name, j->parent[0] == '\0' ? "parent" : "child");
  }
  if (j->kind == ROBOT_FIXED) {
    return true;
  }
  if (fabs(j->axis[0]) + fabs(j->axis[1]) + fabs(j->axis[2]) < 1e-100) {
    return xml_fail(r, j->line, "joint '%s' has an axis of length 0", j->name);
  }
  if (j->kind != ROBOT_CONTINUOUS && (!limited || j->lower > j->upper)) {
    return xml_fail(r, j->line, "joint '%s' has %s", j->name,
                    limited ? "a lower limit above the upper one" : "no limit");
  }
  return true;
}

static bool read_joint(robot *b, xml_reader *r) {
  const unsigned depth = r->depth;
  bool limited = false;
  if (b->joints == ROBOT_LINKS_MAX) {
    return xml_fail(r, xml_line(r), "too many joints: more than %d", ROBOT_LINKS_MAX);
  }
  robot_joint *j = &b->joint[b->joints];
  memset(j, 0, sizeof *j);
  j->axis[0] = 1;
  j->line = xml_line(r);
  if (!read_name(r, "name", j->name) || !read_joint_kind(r, j)) {
    return false;
  }
  for (unsigned i = 0; i < b->joints; i++) {
    if (strcmp(b->joint[i].name, j->name) == 0) {
      return xml_fail(r, j->line, "joint '%s' is there twice", j->name);
    }
  }
  while (xml_next_child(r, depth)) {
    if (!read_joint_child(r, j, &limited)) {
      return false;
    }
  }
  b->joints++;
  return r->problem[0] == '\0' && check_joint(r, j, limited);
}

// Hangs the links on their joints.
static bool connect(robot *b, xml_reader *r) {
  for (unsigned i = 0; i < b->joints; i++) {
    const robot_joint *j = &b->joint[i];
    unsigned parent, child;
    if (!robot_find(b, j->parent, &parent) || !robot_find(b, j->child, &child)) {
      return xml_fail(r, j->line, "joint '%s' is of link '%s', which is not there", j->name,
                      robot_find(b, j->parent, &parent) ? j->child : j->parent);
    }
    if (b->link[child].joint != ROBOT_ROOT) {
      return xml_fail(r, j->line, "link '%s' hangs on joint '%s' and on '%s'", j->child,
                      b->joint[b->link[child].joint].name, j->name);
    }
    b->link[child].joint = (int)i;
  }
  return true;
}

unsigned robot_parent(const robot *b, unsigned link) {
  unsigned parent = 0;
  (void)robot_find(b, b->joint[b->link[link].joint].parent, &parent);
  return parent;
}

// Orders the links.
static bool order(robot *b, xml_reader *r) {
  bool placed[ROBOT_LINKS_MAX] = {false};
  for (unsigned i = 0; i < b->links; i++) {
    if (b->link[i].joint == ROBOT_ROOT && b->ordered > 0) {
      return xml_fail(r, b->link[i].line, "link '%s' hangs on no joint, as '%s'", b->link[i].name,
                      b->link[b->order[0]].name);
    }
    if (b->link[i].joint == ROBOT_ROOT) {
      b->order[b->ordered++] = i;
      placed[i] = true;
    }
  }
  bool more = b->ordered > 0;
  while (more) {
    more = false;
    for (unsigned i = 0; i < b->joints && !more; i++) {
      unsigned parent, child;
      if (robot_find(b, b->joint[i].parent, &parent) && robot_find(b, b->joint[i].child, &child) && placed[parent] &&
          !placed[child]) {
        b->order[b->ordered++] = child;
        placed[child] = more = true;
      }
    }
  }
  for (unsigned i = 0; i < b->joints; i++) {
    unsigned child;
    if (robot_find(b, b->joint[i].child, &child) && !placed[child]) {
      return xml_fail(r, b->joint[i].line, "joint '%s' is one of joints in a circle", b->joint[i].name);
    }
  }
  return true;
}

bool robot_read(robot *b, xml_reader *r) {
  memset(b, 0, sizeof *b);
  if (!xml_next_child(r, 0)) {
    return false;
  }
  const unsigned depth = r->depth;
  if (!xml_is(r, "robot")) {
    return xml_fail(r, xml_line(r), "the document's element is not 'robot'");
  }
  if (!xml_value(r, "name", b->name, ROBOT_NAME) && r->problem[0] != '\0') {
    return false;
  }
  while (xml_next_child(r, depth)) {
    if ((xml_is(r, "link") && !read_link(b, r)) || (xml_is(r, "joint") && !read_joint(b, r))) {
      return false;
    }
  }
  if (xml_next_child(r, 0) || r->problem[0] != '\0') {
    return false;
  }
  return (b->links > 0 || xml_fail(r, r->line, "no links")) && connect(b, r) && order(b, r);
}

// Reads the two links of a pair.
static bool read_pair(const robot *b, xml_reader *r, unsigned pair[2]) {
  static const char *const attributes[] = {"link1", "link2"};
  for (unsigned i = 0; i < 2; i++) {
    char name[ROBOT_NAME];
    if (!read_name(r, attributes[i], name)) {
      return false;
    }
    if (!robot_find(b, name, &pair[i])) {
      return xml_fail(r, xml_line(r), "link '%s' is not of the robot", name);
    }
  }
  return true;
}

static void set_pair(robot *b, unsigned one, unsigned other, bool never) {
  b->never[one][other] = b->never[other][one] = never;
}

bool robot_read_pairs(robot *b, xml_reader *r) {
  memset(b->never, 0, sizeof b->never);
  if (!xml_next_child(r, 0)) {
    return false;
  }
  const unsigned depth = r->depth;
  if (!xml_is(r, "robot")) {
    return xml_fail(r, xml_line(r), "the document's element is not 'robot'");
  }
  while (xml_next_child(r, depth)) {
    unsigned pair[2];
    if (xml_is(r, "disable_collisions")) {
      if (!read_pair(b, r, pair)) {
        return false;
      }
      set_pair(b, pair[0], pair[1], true);
    }
  }
  (void)xml_next_child(r, 0);
  return r->problem[0] == '\0';
}

// Does a link carry shapes, or other links of the order?
static bool carries(const robot *b, unsigned link) {
  for (unsigned i = 0; i < b->shapes; i++) {
    if (b->shape[i].link == link) {
      return true;
    }
  }
  for (unsigned i = 1; i < b->ordered; i++) {
    if (robot_parent(b, b->order[i]) == link) {
      return true;
    }
  }
  return false;
}

void robot_leave_out(robot *b, unsigned most) {
  for (unsigned i = b->ordered; i-- > 1 && b->ordered > most;) {  // children before their parents
    const unsigned link = b->order[i];
    if (b->joint[b->link[link].joint].kind == ROBOT_FIXED && !carries(b, link)) {
      memmove(&b->order[i], &b->order[i + 1], (b->ordered - i - 1) * sizeof b->order[0]);
      b->ordered--;
    }
  }
}
