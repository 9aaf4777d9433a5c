// Machines as a line, as C, as a case.
#include "write_arm.h"

#include <stdio.h>
#include <string.h>

static unsigned count_pairs(const machine *m, const uint32_t *pairs) {
  unsigned count = 0;
  for (unsigned i = 0; i < m->links; i++) {
    for (unsigned k = 0; k < m->links; k++) {
      count += pairs[i] >> k & 1u;
    }
  }
  return count;
}

void write_arm_info(const machine *m) {
  printf("links=%u values=%u parts=%u vertices=%zu never=%u\n", m->links, m->values, m->parts, m->vertices,
         count_pairs(m, m->never));
}

static const robot_joint *joint_of(const machine *m, unsigned link) {
  const int joint = m->from->link[m->number[link]].joint;
  return joint != ROBOT_ROOT ? &m->from->joint[joint] : NULL;
}

static const char *kind_of(const machine *m, unsigned link) {
  static const char *const kinds[] = {"fixed", "revolute", "prismatic"};
  return kinds[m->link[link].kind];
}

// A comment's line: its sign, then pairs of links by name.
static void print_pairs(const machine *m, const uint32_t *pairs, const char *begin, const char *end) {
  for (unsigned i = 0; i < m->links; i++) {
    for (unsigned k = 0; k < m->links; k++) {
      if ((pairs[i] >> k & 1u) != 0) {
        printf("%s%s %s%s", begin, m->name[i], m->name[k], end);
      }
    }
  }
}

// What it is, its values, and where the pairs come from that are never tested.
static void print_head(const machine *m, const char *sign) {
  char word[ROBOT_NAME];
  machine_word(m->from->name, word, sizeof word);
  printf(
      "%s Made by gjk-convert of robot '%s': a metre is %.9g LSB, an angle Q16.16 radians. In its link's frame each\n",
      sign, word, m->how->scale);
  printf("%s shape encloses that of the robot; joints are rounded to the nearest LSB.\n", sign);
  unsigned value = 0;
  for (unsigned i = 0; i < m->links; i++) {
    const robot_joint *j = joint_of(m, i);
    if (m->link[i].kind != GJK_ARM_FIXED) {
      machine_word(j->name, word, sizeof word);
      printf("%s Value %u: joint %s, %s, of link %s%s\n", sign, value++, word, kind_of(m, i), m->name[i],
             j->mimics ? "; it mimics another one, and is free here" : "");
    }
  }
  if (!m->sampled) {
    printf("%s Never tested, besides links with a joint between them: what the robot's SRDF disables.\n", sign);
    return;
  }
  printf(
      "%s Without SRDF, by %d samples and not proven: links that touched in each of them are never tested, nor are\n",
      sign, MACHINE_SAMPLES);
  printf("%s those with a joint, or links without shapes, between them.\n", sign);
  if (count_pairs(m, m->apart) > 0) {
    printf("%s No sample touched of these, which are tested all the same:\n", sign);
    char begin[16];
    snprintf(begin, sizeof begin, "%s   ", sign);
    print_pairs(m, m->apart, begin, "\n");
  }
}

static void print_case_pose(char body, const gjk_pose *pose) {
  const gjk_vec3 *p = &pose->position;
  const gjk_quat *q = &pose->rotation;
  if ((p->x | p->y | p->z) != 0) {
    printf("%c at %ld %ld %ld\n", body, (long)p->x, (long)p->y, (long)p->z);
  }
  if ((q->x | q->y | q->z) != 0 || q->w != GJK_Q30_ONE) {
    printf("%c turn %ld %ld %ld %ld\n", body, (long)q->x, (long)q->y, (long)q->z, (long)q->w);
  }
}

static void print_case_link(const machine *m, unsigned i) {
  const gjk_arm_link *link = &m->link[i];
  printf("link %s %s %s\n", m->name[i], link->parent == GJK_ARM_BASE ? "base" : m->name[link->parent], kind_of(m, i));
  print_case_pose('L', &link->fixed);
  if (link->kind != GJK_ARM_FIXED) {
    printf("L axis %ld %ld %ld\n", (long)link->axis.x, (long)link->axis.y, (long)link->axis.z);
  }
  if (link->lower != INT32_MIN || link->upper != INT32_MAX) {
    printf("L limits %ld %ld\n", (long)link->lower, (long)link->upper);
  }
}

static void print_case_part(const machine *m, unsigned i) {
  const gjk_shape *s = &m->shape[i];
  printf("part %s\n", m->name[m->part[i].link]);
  switch (m->geometry[i]) {
    case ROBOT_BOX: printf("P box %ld %ld %ld\n", (long)s->size.x, (long)s->size.y, (long)s->size.z); break;
    case ROBOT_SPHERE: printf("P sphere %ld\n", (long)s->convex_radius); break;
    case ROBOT_CYLINDER: printf("P cylinder %ld %ld\n", (long)s->size.x, (long)s->size.z); break;
    default:
      printf("P hull %u\n", s->count);
      for (unsigned n = 0; n < s->count; n++) {
        printf("%ld %ld %ld\n", (long)s->vertices[n].x, (long)s->vertices[n].y, (long)s->vertices[n].z);
      }
      if (s->convex_radius > 0) {
        printf("P round %ld\n", (long)s->convex_radius);
      }
  }
  print_case_pose('P', &m->part[i].pose);
}

void write_arm_case(const machine *m) {
  print_head(m, "#");
  for (unsigned i = 0; i < m->links; i++) {
    print_case_link(m, i);
  }
  for (unsigned i = 0; i < m->parts; i++) {
    print_case_part(m, i);
  }
  print_pairs(m, m->never, "never ", "\n");
}

static void print_pose(const gjk_pose *pose) {
  const gjk_vec3 *p = &pose->position;
  const gjk_quat *q = &pose->rotation;
  printf("{{%ld, %ld, %ld}, {%ld, %ld, %ld, %ld}}", (long)p->x, (long)p->y, (long)p->z, (long)q->x, (long)q->y,
         (long)q->z, (long)q->w);
}

static void print_shape(const machine *m, unsigned i, const char *name) {
  const gjk_shape *s = &m->shape[i];
  switch (m->geometry[i]) {
    case ROBOT_BOX: printf("    GJK_BOX(%ld, %ld, %ld),\n", (long)s->size.x, (long)s->size.y, (long)s->size.z); break;
    case ROBOT_SPHERE: printf("    GJK_SPHERE(%ld),\n", (long)s->convex_radius); break;
    case ROBOT_CYLINDER: printf("    GJK_CYLINDER(%ld, %ld),\n", (long)s->size.x, (long)s->size.z); break;
    default: printf("    GJK_ROUNDED_HULL(%s_%u_vertices, %u, %ld),\n", name, i, s->count, (long)s->convex_radius);
  }
}

static void print_parts(const machine *m, const char *name) {
  for (unsigned i = 0; i < m->parts; i++) {
    const gjk_shape *s = &m->shape[i];
    if (m->geometry[i] == ROBOT_MESH) {
      printf("static const gjk_vec3 %s_%u_vertices[%u] = {\n", name, i, s->count);
      for (unsigned n = 0; n < s->count; n++) {
        printf("    {%ld, %ld, %ld},\n", (long)s->vertices[n].x, (long)s->vertices[n].y, (long)s->vertices[n].z);
      }
      printf("};\n");
    }
  }
  printf("static const gjk_shape %s_shapes[%u] = {\n", name, m->parts);
  for (unsigned i = 0; i < m->parts; i++) {
    print_shape(m, i, name);
  }
  printf("};\nstatic const gjk_arm_part %s_parts[%u] = {\n", name, m->parts);
  for (unsigned i = 0; i < m->parts; i++) {
    printf("    {&%s_shapes[%u], ", name, i);
    print_pose(&m->part[i].pose);
    printf(", %u},  // of %s\n", m->part[i].link, m->name[m->part[i].link]);
  }
  printf("};\n");
}

// INT32_MIN is no literal in C.
static void print_limit(int32_t limit) {
  if (limit == INT32_MIN) {
    printf("INT32_MIN");
  } else {
    printf("%ld", (long)limit);
  }
}

static void print_links(const machine *m, const char *name) {
  static const char *const kinds[] = {"GJK_ARM_FIXED", "GJK_ARM_REVOLUTE", "GJK_ARM_PRISMATIC"};
  printf("static const gjk_arm_link %s_links[%u] = {\n", name, m->links);
  for (unsigned i = 0; i < m->links; i++) {
    const gjk_arm_link *link = &m->link[i];
    printf("    {");
    if (link->parent == GJK_ARM_BASE) {
      printf("GJK_ARM_BASE");
    } else {
      printf("%u", link->parent);
    }
    printf(", %s, ", kinds[link->kind]);
    print_pose(&link->fixed);
    printf(", {%ld, %ld, %ld}, ", (long)link->axis.x, (long)link->axis.y, (long)link->axis.z);
    print_limit(link->lower);
    printf(", ");
    print_limit(link->upper);
    printf("},  // %u %s\n", i, m->name[i]);
  }
  printf("};\nstatic const uint32_t %s_never[%u] = {", name, m->links);
  for (unsigned i = 0; i < m->links; i++) {
    printf("%s0x%lx", i == 0 ? "" : ", ", (unsigned long)m->never[i]);
  }
  printf("};\n");
}

void write_arm_source(const machine *m, const char *name) {
  print_head(m, "//");
  if (count_pairs(m, m->never) > 0) {
    printf("// Never tested by the list below:\n");
    print_pairs(m, m->never, "//   ", "\n");
  }
  printf("#include \"gjk/arm.h\"\n\n");
  if (m->parts > 0) {
    print_parts(m, name);
  }
  print_links(m, name);
  printf("const gjk_arm_model %s = {%s_links, %s%s, %s_never, %u, %u};\n", name, name, m->parts > 0 ? name : "0",
         m->parts > 0 ? "_parts" : "", name, m->links, m->parts);
}
