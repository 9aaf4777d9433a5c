// The arm of seven joints, written as URDF, SRDF and OBJ files and read again, is the same machine: bit by bit, and so in
// all answers. Shapes of other machines enclose what their files describe.
#include <math.h>
#include <string.h>

#include "arm/arm_truth.h"
#include "arm/seven.h"
#include "check.h"
#include "tests/programs/convert/machine.h"
#include "tests/programs/convert/read.h"

#define EDGES 400
#define SHAPES 300

static char folder[200];  // this program's own

// A file beside this program.
static const char *path(const char *name) {
  static char out[300];
  snprintf(out, sizeof out, "%s%s", folder, name);
  return out;
}

static const char *const kinds[] = {"fixed", "revolute", "prismatic"};

// Writes a link, and of its hulls a mesh each. A unit is a metre; all numbers are written in full.
static void write_link(FILE *file, const seven *s, unsigned link) {
  fprintf(file, "<link name='l%u'>", link);
  for (unsigned i = 0; i < SEVEN_PARTS; i++) {
    if (s->parts[i].link == link) {
      char name[40];
      snprintf(name, sizeof name, "test_urdf_%u.obj", i);
      FILE *points = fopen(path(name), "w");
      for (unsigned k = 0; k < SEVEN_POINTS && points != NULL; k++) {
        const gjk_vec3 *p = &s->points[i][k];
        fprintf(points, "v %.17g %.17g %.17g\n", p->x / 65536.0, p->y / 65536.0, p->z / 65536.0);
      }
      CHECK(points != NULL && fclose(points) == 0);
      fprintf(file, "<collision><geometry><mesh filename='%s'/></geometry></collision>", name);
    }
  }
  fprintf(file, "</link>\n");
}

static void write_joint(FILE *file, const seven *s, unsigned link, const char *parent) {
  const gjk_arm_link *l = &s->links[link];
  const gjk_vec3 *p = &l->fixed.position;
  const double turn = 2 * atan2(l->fixed.rotation.x, l->fixed.rotation.w);  // about x alone
  fprintf(file, "<joint name='j%u' type='%s'><parent link='%s'/><child link='l%u'/>", link, kinds[l->kind], parent,
          link);
  fprintf(file, "<origin xyz='%.17g %.17g %.17g' rpy='%.17g 0 0'/><axis xyz='0 0 1'/>", p->x / 65536.0, p->y / 65536.0,
          p->z / 65536.0, turn);
  fprintf(file, "<limit lower='%.17g' upper='%.17g'/></joint>\n", l->lower / 65536.0, l->upper / 65536.0);
}

static void write_robot(const seven *s) {
  FILE *file = fopen(path("test_urdf.urdf"), "w"), *pairs = fopen(path("test_urdf.srdf"), "w");
  CHECK(file != NULL && pairs != NULL);
  fprintf(file, "<robot><link name='world'/>\n");
  fprintf(pairs, "<robot>\n");
  for (unsigned i = 0; i < SEVEN_LINKS; i++) {
    char parent[20] = "world";
    if (i > 0) {
      snprintf(parent, sizeof parent, "l%u", i - 1);
    }
    write_link(file, s, i);
    write_joint(file, s, i, parent);
    for (unsigned k = 0; k < SEVEN_LINKS; k++) {
      if ((s->never[i] >> k & 1u) != 0) {
        fprintf(pairs, "<disable_collisions link1='l%u' link2='l%u'/>\n", i, k);
      }
    }
  }
  fprintf(file, "</robot>\n");
  fprintf(pairs, "</robot>\n");
  CHECK(fclose(file) == 0 && fclose(pairs) == 0);
}

static const machine_options exact = {65536, -1, false, {-1, 0}};

// Reads what write_robot has written.
static bool read_robot(robot *b, machine *m, xml_reader *r) {
  static char name[300];
  size_t bytes, more;
  char *text = read_whole(strcpy(name, path("test_urdf.urdf")), &bytes),
       *pairs = read_whole(path("test_urdf.srdf"), &more);
  xml_reader other;
  xml_open(&other, "srdf", pairs, pairs != NULL ? more : 0);
  xml_open(r, name, text, text != NULL ? bytes : 0);
  const bool read = robot_read(b, r) && robot_read_pairs(b, &other) && machine_make(m, b, true, &exact, r);
  printf("%s%s", r->problem, other.problem);
  free(text);
  free(pairs);
  return read;
}

static void compare_links(const seven *s, const machine *m) {
  CHECK(m->links == SEVEN_LINKS + 1 && m->values == SEVEN_JOINTS && m->parts == SEVEN_PARTS);
  for (unsigned i = 0; i < SEVEN_LINKS; i++) {
    const gjk_arm_link *a = &s->links[i], *b = &m->link[i + 1];
    CHECK(a->kind == b->kind && b->parent == i);
    CHECK(memcmp(&a->fixed, &b->fixed, sizeof a->fixed) == 0);
    CHECK(a->kind == GJK_ARM_FIXED || (a->lower == b->lower && a->upper == b->upper));
    for (unsigned k = 0; k < SEVEN_LINKS; k++) {
      const uint32_t never = (s->never[i] >> k & 1u) | (s->never[k] >> i & 1u);
      CHECK(((m->never[i + 1] >> (k + 1) & 1u) | (m->never[k + 1] >> (i + 1) & 1u)) == never);
    }
  }
}

static seven first, second;
static robot read;
static machine made;
static xml_reader reader;

// The second arm becomes the converted machine; the first one with its obstacles stays.
static bool adopt(void) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  static gjk_arm_link_room links[SEVEN_LINKS + 1];
  static gjk_arm_model model;
  model = machine_model(&made);
  second.memory = first.memory;
  second.memory.links = links;
  second.memory.parts = second.part_room;
  second.memory.pairs = second.pairs;
  return gjk_arm_init(&second.arm, &model, &identity, &second.memory) == GJK_OK &&
         gjk_arm_obstacles(&second.arm, first.obstacles, SEVEN_OBSTACLES) == GJK_OK;
}

static void test_seven(void) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_arm_setup setup = {0, 100, GJK_Q30_ONE / 1024};
  random_state random = random_seed(check_seed(20));
  unsigned answers[3] = {0, 0, 0};
  CHECK(seven_make(&first, &identity) && seven_surround(&first, &random, SEVEN_OBSTACLES));
  write_robot(&first);
  CHECK(read_robot(&read, &made, &reader) && adopt());
  compare_links(&first, &made);
  for (unsigned i = 0; i < EDGES; i++) {
    int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];
    gjk_arm_edge_result a = {0}, b = {0};
    check_trial(i, NULL, NULL);
    seven_any(&random, from);
    seven_beside(&random, from, 65536, to);
    CHECK(gjk_arm_edge_start(&first.arm, from, to, &setup, NULL, NULL) == GJK_OK &&
          gjk_arm_edge_start(&second.arm, from, to, &setup, NULL, NULL) == GJK_OK);
    CHECK(gjk_arm_edge_run(&first.arm, UINT32_MAX, &a) == gjk_arm_edge_run(&second.arm, UINT32_MAX, &b));
    CHECK(a.answer == b.answer && a.lower == b.lower && a.upper == b.upper && a.outside == b.outside);
    CHECK(a.answer != GJK_ARM_FREE || a.gap == b.gap);
    CHECK(a.answer != GJK_ARM_TOUCH || memcmp(&a.pair, &b.pair, sizeof a.pair) == 0);
    answers[a.answer]++;
  }
  CHECK(answers[GJK_ARM_FREE] > EDGES / 10 && answers[GJK_ARM_TOUCH] > EDGES / 10);
  machine_free(&made);
}

// A random shape in a random place, as it is written and as it is.
typedef struct sample_shape {
  unsigned kind;  // box, sphere, cylinder, mesh
  double size[3], xyz[3], rpy[3], point[12][3];
  bool simple;  // it is not turned, and whole
} sample_shape;

static double any(random_state *random, double most) {
  return most * (random_range(random, -1000000, 1000000) / 1e6);
}

static sample_shape any_sample(random_state *random) {
  sample_shape s = {.kind = random_below(random, 4), .simple = random_below(random, 4) == 0};
  for (unsigned i = 0; i < 3; i++) {
    s.size[i] = s.simple ? random_range(random, 1, 9) / 16.0 : fabs(any(random, 1)) + 0.001;
    s.xyz[i] = s.simple ? random_range(random, -9, 9) / 8.0 : any(random, 2);
    s.rpy[i] = s.simple ? 0 : any(random, 4);
  }
  for (unsigned i = 0; i < 12; i++) {
    for (unsigned k = 0; k < 3; k++) {
      s.point[i][k] = s.simple ? random_range(random, -99, 99) / 64.0 : any(random, 1);
    }
  }
  return s;
}

static bool convert_sample(const sample_shape *s) {
  static char text[2000], name[300];
  int at =
      snprintf(text, sizeof text,
               "<robot><link name='l'><collision><origin xyz='%.17g %.17g %.17g' rpy='%.17g %.17g %.17g'/><geometry><",
               s->xyz[0], s->xyz[1], s->xyz[2], s->rpy[0], s->rpy[1], s->rpy[2]);
  switch (s->kind) {
    case 0: at += snprintf(text + at, 300, "box size='%.17g %.17g %.17g'", s->size[0], s->size[1], s->size[2]); break;
    case 1: at += snprintf(text + at, 300, "sphere radius='%.17g'", s->size[0]); break;
    case 2: at += snprintf(text + at, 300, "cylinder radius='%.17g' length='%.17g'", s->size[0], s->size[1]); break;
    default:
      at += snprintf(text + at, 300, "mesh filename='test_urdf_any.obj' scale='%.17g %.17g %.17g'", s->size[0],
                     s->size[1], s->size[2]);
  }
  snprintf(text + at, 100, "/></geometry></collision></link></robot>");
  FILE *points = fopen(path("test_urdf_any.obj"), "w");
  for (unsigned i = 0; i < 12 && points != NULL; i++) {
    fprintf(points, "v %.17g %.17g %.17g\n", s->point[i][0], s->point[i][1], s->point[i][2]);
  }
  CHECK(points != NULL && fclose(points) == 0);
  xml_open(&reader, strcpy(name, path("any.urdf")), text, strlen(text));
  const bool done = robot_read(&read, &reader) && machine_make(&made, &read, true, &exact, &reader);
  printf("%s", reader.problem);
  return done;
}

// How far the converted shape reaches along d, LSB.
static double reach_of(const double d[3]) {
  const gjk_shape *shape = &made.shape[0];
  const gjk_pose *pose = &made.part[0].pose;
  const arm_truth_frame frame = {{pose->rotation.x / 1073741824.0, pose->rotation.y / 1073741824.0,
                                  pose->rotation.z / 1073741824.0, pose->rotation.w / 1073741824.0},
                                 {0, 0, 0}};
  const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double *q = frame.q, size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double back[4] = {-q[0] / size, -q[1] / size, -q[2] / size, q[3] / size};
  double local[3], most = -1e300;
  arm_truth_turn(back, d, local);
  const double half[3] = {shape->size.x, shape->size.y, shape->size.z};
  switch (made.geometry[0]) {
    case ROBOT_BOX: most = fabs(local[0]) * half[0] + fabs(local[1]) * half[1] + fabs(local[2]) * half[2]; break;
    case ROBOT_SPHERE: most = 0; break;
    case ROBOT_CYLINDER: most = hypot(local[0], local[1]) * half[0] + fabs(local[2]) * half[2]; break;
    default:
      for (unsigned i = 0; i < shape->count; i++) {
        const gjk_vec3 *v = &shape->vertices[i];
        most = fmax(most, v->x * local[0] + v->y * local[1] + v->z * local[2]);
      }
  }
  const gjk_vec3 *p = &pose->position;
  return most + p->x * d[0] + p->y * d[1] + p->z * d[2] + shape->convex_radius * length;
}

// How far the shape as it is written does.
static double true_reach(const sample_shape *s, const double d[3]) {
  double turn[3][3], local[3], most = -1e300;
  machine_matrix(s->rpy, turn);
  for (unsigned k = 0; k < 3; k++) {
    local[k] = turn[0][k] * d[0] + turn[1][k] * d[1] + turn[2][k] * d[2];
  }
  const double *size = s->size;
  switch (s->kind) {
    case 0: most = (fabs(local[0]) * size[0] + fabs(local[1]) * size[1] + fabs(local[2]) * size[2]) / 2; break;
    case 1: most = size[0] * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); break;
    case 2: most = hypot(local[0], local[1]) * size[0] + fabs(local[2]) * size[1] / 2; break;
    default:
      for (unsigned i = 0; i < 12; i++) {
        const double *p = s->point[i];
        most = fmax(most, p[0] * size[0] * local[0] + p[1] * size[1] * local[1] + p[2] * size[2] * local[2]);
      }
  }
  return 65536 * (most + s->xyz[0] * d[0] + s->xyz[1] * d[1] + s->xyz[2] * d[2]);
}

// Along many directions a converted shape reaches as far as the real one at least, and few LSB farther at most. Where
// nothing is to be rounded it reaches as far.
static void test_enclosed(void) {
  random_state random = random_seed(check_seed(20));
  unsigned simple = 0;
  for (unsigned i = 0; i < SHAPES; i++) {
    const sample_shape s = any_sample(&random);
    check_trial(i, NULL, NULL);
    CHECK(convert_sample(&s) && made.parts == 1);
    simple += s.simple ? 1u : 0u;
    for (unsigned k = 0; k < 60; k++) {
      double d[3] = {any(&random, 1), any(&random, 1), any(&random, 1)};
      const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) + 1e-9;
      for (unsigned j = 0; j < 3; j++) {
        d[j] = k < 6 ? (k % 3 == j ? (k < 3 ? 1 : -1) : 0) : d[j] / length;
      }
      const double more = reach_of(d) - true_reach(&s, d);
      CHECK(more > -1e-7 && more < 6);
      CHECK(!s.simple || more < 1e-7);
    }
    machine_free(&made);
  }
  CHECK(simple > SHAPES / 10);
}

int main(int argc, char **argv) {
  const char *slash = argc > 0 ? strrchr(argv[0], '/') : NULL;
  snprintf(folder, sizeof folder, "%.*s", slash != NULL ? (int)(slash - argv[0]) + 1 : 0, argc > 0 ? argv[0] : "");
  test_seven();
  test_enclosed();
  return check_done("urdf");
}
