// What meets without a search in the plane, beside the general search: the same bits. Points, segments and boxes are asked
// again with classes that name no shortcut, and boxes as polygons of their posed corners.
#include <string.h>

#include "check.h"
#include "generate/shape2.h"
#include "gjk2/gjk2.h"
#include "placed2.h"
#include "plane_same.h"
#include "src/plane/gjk2_class.h"

#define PAIRS check_trials(40000)
#define SEED 9600

static gjk2_shape_class general_classes[3];

// The same kind without a shortcut.
static const gjk2_shape_class *general_class(const gjk2_shape_class *type) {
  const gjk2_shape_class *const kinds[3] = {&gjk2_class_point, &gjk2_class_segment, &gjk2_class_box};
  for (int i = 0; i < 3; i++) {
    if (type == kinds[i]) {
      general_classes[i] = *type;
      general_classes[i].touch = NULL;
      return &general_classes[i];
    }
  }
  return type;
}

// A shape and its collider; polygon: that of a box's corners.
typedef struct body {
  gjk2_shape shape, general_shape, polygon_shape;
  gjk2_vec corners[4], buffer[4];
  gjk2_collider own, general, polygon;
  bool is_polygon;
} body;

static gjk_q16 any_length(random_state *random, gjk_q16 size) {
  switch (random_below(random, 5)) {
    case 0: return 0;
    case 1: return 1;
    case 2: return size;
    default: return random_range(random, 0, size);
  }
}

static void make_body(random_state *random, gjk_q16 size, body *out) {
  const gjk_q16 x = any_length(random, size), y = any_length(random, size);
  const gjk_q16 radius = random_below(random, 3) == 0 ? 0 : any_length(random, size);
  const gjk2_shape kinds[5] = {GJK2_ROUNDED_POINT(radius), GJK2_ROUNDED_SEGMENT(x, radius),
                               GJK2_ROUNDED_SEGMENT(x, radius), GJK2_BOX(x, y), GJK2_ROUNDED_BOX(x, y, radius)};
  memset(out, 0, sizeof *out);
  out->shape = kinds[random_below(random, 5)];
  out->general_shape = out->shape;
  out->general_shape.type = general_class(out->shape.type);
}

static void place_body(body *b, const gjk2_pose *pose) {
  b->own = posed2(&b->shape, pose);
  b->general = posed2(&b->general_shape, pose);
  b->is_polygon = b->own.count == 4;
  for (uint16_t i = 0; i < 4 && b->is_polygon; i++) {
    static const uint16_t counterclockwise[4] = {3, 2, 0, 1};
    (void)b->own.shape->type->vertex(&b->own, counterclockwise[i], &b->corners[i]);
  }
  if (b->is_polygon) {
    const gjk2_shape polygon = GJK2_ROUNDED_POLYGON(b->corners, 4, b->shape.convex_radius);
    gjk2_pose still = GJK2_POSE_IDENTITY;
    still.position = pose->position;
    b->polygon_shape = polygon;
    CHECK(gjk2_collider_init(&b->polygon, &b->polygon_shape, b->buffer, 4) == GJK_OK);
    CHECK(gjk2_collider_pose(&b->polygon, &still) == GJK_OK);
  }
}

static gjk2_pose any_pose(random_state *random, bool aligned) {
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  const gjk2_rotation turns[4] = {{GJK_Q30_ONE, 0}, {0, GJK_Q30_ONE}, {-GJK_Q30_ONE, 0}, {0, -GJK_Q30_ONE}};
  pose.rotation = turns[random_below(random, 4)];
  if (!aligned) {
    (void)gjk2_rotation_from_angle(random_range(random, -205887, 205887), &pose.rotation);
  }
  return pose;
}

static gjk_q16 limited(int64_t x) {
  return x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : (gjk_q16)x;
}

// Moves B along the normal until its gap from A is about `gap`.
static void bring_near(const body *a, body *b, gjk2_pose *pose, gjk_q16 gap) {
  for (int i = 0; i < 4; i++) {
    gjk2_distance_result out;
    if (gjk2_signed_distance(&a->general, &b->general, NULL, &out) != GJK_OK) {
      return;
    }
    const int64_t way = (int64_t)out.distance - gap;
    pose->position.x = limited(pose->position.x - out.normal.x * way / GJK_Q30_ONE);
    pose->position.y = limited(pose->position.y - out.normal.y * way / GJK_Q30_ONE);
    place_body(b, pose);
  }
}

typedef struct answers {
  gjk_status status[5];
  gjk2_decision within;
  gjk2_distance_result gap, apart;
  gjk2_penetration_result depth;
  gjk2_manifold contacts;
} answers;

static void ask(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, gjk2_cache *cache, answers *out) {
  memset(out, 0, sizeof *out);
  out->status[0] = gjk2_within(a, b, margin, cache, &out->within);
  out->status[1] = gjk2_distance(a, b, cache, &out->gap);
  out->status[2] = gjk2_penetration(a, b, cache, &out->depth);
  out->status[3] = gjk2_signed_distance(a, b, cache, &out->apart);
  out->status[4] = gjk2_contacts(a, b, margin, 2, cache, &out->contacts);
}

static void compare(const answers *p, const answers *q, bool with_contacts) {
  for (int i = 0; i < 5; i++) {
    CHECK(p->status[i] == GJK_OK && q->status[i] == GJK_OK);
  }
  CHECK(p->within.yes == q->within.yes);
  CHECK(same_gap(&p->gap, &q->gap));
  CHECK(same_gap(&p->apart, &q->apart));
  CHECK(same_depth(&p->depth, &q->depth));
  CHECK(!with_contacts || same_manifold(&p->contacts, &q->contacts));
}

// Centres more than 2^30 apart: there is no exact proof.
static bool is_far(const body *a, const body *b) {
  const double x = (double)a->own.centre.x - b->own.centre.x, y = (double)a->own.centre.y - b->own.centre.y;
  return x * x + y * y > 1152921504606846976.0;
}

static void check_proofs(const body *a, const body *b, const answers *x) {
  const gjk_status proof = is_far(a, b) ? GJK_ERROR_UNSUPPORTED : GJK_OK;
  CHECK(gjk2_check_distance(&a->own, &b->own, &x->gap) == proof);
  const gjk_status deep = gjk2_check_penetration(&a->own, &b->own, &x->depth);
  CHECK(deep == GJK_OK || (deep == GJK_ERROR_UNSUPPORTED && !x->depth.intersecting));
  CHECK(x->apart.intersecting || gjk2_check_distance(&a->own, &b->own, &x->apart) == proof);
}

int main(void) {
  static body a, b;
  unsigned deep = 0, shallow = 0, apart = 0, far = 0;
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + i);
    check_trial(i, NULL, NULL);
    const bool aligned = i % 3 == 0;
    const gjk_q16 size = generate2_reach(&random) / 2 + 1,
                  other = random_below(&random, 2) == 0 ? size : generate2_reach(&random) / 2 + 1;
    gjk2_pose at = any_pose(&random, aligned), to = any_pose(&random, aligned);
    make_body(&random, size, &a);
    make_body(&random, other, &b);
    if (random_below(&random, 8) == 0) {  // at an end of the world
      at.position.x = random_below(&random, 2) == 0 ? INT32_MAX - 2 : INT32_MIN + 2;
      at.position.y = random_range(&random, -3, 3);
    }
    if (random_below(&random, 3) == 0) {
      to.rotation = at.rotation;
    }
    const int64_t reach = 2 * ((int64_t)size + other);
    const uint32_t place = random_below(&random, 8);
    const int64_t step = aligned ? size / 2 + 1 : 1, x = random_range(&random, (int32_t)-reach, (int32_t)reach),
                  y = random_range(&random, (int32_t)-reach, (int32_t)reach);
    to.position.x = limited(at.position.x + (place == 0 ? 0 : place == 1 ? 8 * x : x / step * step));
    to.position.y = limited(at.position.y + (place == 0 ? 0 : place == 1 ? 8 * y : y / step * step));
    place_body(&a, &at);
    place_body(&b, &to);
    if (place > 3) {
      bring_near(&a, &b, &to, random_range(&random, -3, 3));
    }
    const gjk_q16 margin = random_below(&random, 2) == 0 ? 0 : any_length(&random, size);
    gjk2_cache cache = {0};
    answers own, again, general, polygons;
    ask(&a.own, &b.own, margin, NULL, &own);
    ask(&a.general, &b.general, margin, NULL, &general);
    compare(&own, &general, true);
    ask(&a.own, &b.own, margin, &cache, &again);
    compare(&own, &again, true);
    check_proofs(&a, &b, &own);
    ask(a.is_polygon ? &a.polygon : &a.own, b.is_polygon ? &b.polygon : &b.own, margin, NULL, &polygons);
    compare(&own, &polygons, false);
    deep += own.apart.distance < -size / 4;
    shallow += own.apart.intersecting && own.apart.distance >= -3;
    apart += !own.apart.intersecting;
    far += own.apart.distance > INT32_C(1) << 29;
  }
  printf("deep %u, shallow %u, apart %u, far %u\n", deep, shallow, apart, far);
  CHECK(deep > PAIRS / 20);
  CHECK(shallow > PAIRS / 20);
  CHECK(apart > PAIRS / 5);
  CHECK(far > 0);
  return check_done("plane close");
}
