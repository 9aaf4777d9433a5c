// Contacts of convex bodies with meshes: each normal is one that the surface has at the contact, and none is missing: bodies
// apart have the least distance among their contacts, bodies that overlap have a contact.
#include "mesh_contacts.h"

#include "generate/surface.h"
#include "gjk/intersect.h"
#include "placed.h"
#include "reference/random_shape.h"

#define SEED UINT64_C(0x436F6E74)
#define TRIALS 120
#define BODIES 60
#define CELLS 4000

static struct { unsigned long bodies, apart, together, manifolds, of_faces, of_ridges, in_front, behind, rough; } tally;

typedef struct trial {
  surface ground;
  gjk_parts parts;
  case_shape source;
  case_collider body;
  gjk_q16 margin;
} trial;

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  const gjk_quat *q = &t->source.pose.rotation;
  printf("  %s, %lu triangles, two_sided %d, margin %d, body kind %d at (%d, %d, %d) turned (%d, %d, %d, %d)\n",
         surface_names[t->ground.kind], (unsigned long)t->ground.triangle_count, t->ground.mesh.two_sided,
         (int)t->margin, (int)t->source.kind, (int)t->source.pose.position.x, (int)t->source.pose.position.y,
         (int)t->source.pose.position.z, (int)q->x, (int)q->y, (int)q->z, (int)q->w);
}

// A body whose surface is near a random triangle's front: pushed off along its normal until it is about gap away.
static void place_body(random_state *random, trial *t, int32_t step) {
  static const case_kind kinds[] = {CASE_BOX, CASE_POINT, CASE_SEGMENT, CASE_HULL, CASE_BOX, CASE_CYLINDER};
  const case_kind kind = kinds[random_below(random, 6)];
  const gjk_q16 reach = (gjk_q16)(step * pow(8, random_unit(random)) / 2) + 3;
  random_shape(random, kind, reach, &t->source);
  if (kind == CASE_POINT) {
    t->source.convex_radius = reach;
  }
  t->source.pose.rotation = random_below(random, 3) == 0 ? (gjk_quat){0, 0, 0, GJK_Q30_ONE} : random_rotation(random);
  gjk_parts_room room;
  gjk_collider triangle;
  const uint32_t number = random_below(random, t->ground.triangle_count);
  CHECK(gjk_parts_place(&t->parts, number, &room, &triangle) == GJK_OK);
  const dvec a = of_vec3(&room.vertices[0]), b = of_vec3(&room.vertices[1]), c = of_vec3(&room.vertices[2]);
  const dvec n = cross_of(minus(b, a), minus(c, a));
  const double u = random_unit(random), v = random_unit(random) * (1 - u);
  dvec at = add_scaled(add_scaled(add_scaled((dvec){0, 0, 0}, 1 - u - v, a), u, b), v, c);
  const double side = t->ground.mesh.two_sided && random_below(random, 2) == 0 ? -1 : 1;
  const double away = side * (reach + random_unit(random) * reach) / length_of(n);
  at = add_scaled(at, away, n);
  t->source.pose.position = (gjk_vec3){(int32_t)at.x, (int32_t)at.y, (int32_t)at.z};
  case_collider_free(&t->body);
  CHECK(case_collider_build(&t->body, &t->source, random_below(random, 2) == 0) == GJK_OK);
  // Down onto the triangle, by the distance less what it is to sink in.
  gjk_distance_result d;
  if (gjk_distance(&triangle, &t->body.collider, NULL, &d) == GJK_OK && !d.intersecting) {
    const double sink =
        random_below(random, 2) == 0 ? random_range(random, -20, 20) : random_range(random, -step / 8, step / 8);
    const dvec normal = {ldexp(d.normal.x, -30), ldexp(d.normal.y, -30), ldexp(d.normal.z, -30)};
    at = add_scaled(at, -(d.distance - sink), normal);
    const gjk_vec3 to = {(int32_t)at.x, (int32_t)at.y, (int32_t)at.z};
    t->source.pose.position = to;
    CHECK(gjk_collider_move(&t->body.collider, &to) == GJK_OK);
  }
}

// Is less than half of the body's height, along the triangle's normal, behind the plane? By the numbers of gjk/surface.h.
static bool is_in_front(const gjk_collider *body, const near_triangle *t) {
  const gjk_shape_class *type = body->shape->type;
  const gjk_vec3 up = {(int32_t)ldexp(t->normal.x, 30), (int32_t)ldexp(t->normal.y, 30),
                       (int32_t)ldexp(t->normal.z, 30)};
  const gjk_vec3 down = {-up.x, -up.y, -up.z};
  gjk_support top, bottom;
  if (length_of(t->normal) == 0) {
    return false;  // corners in a line
  }
  type->support(body, &up, &top);
  type->support(body, &down, &bottom);
  const dvec sum = {(double)top.offset.x + bottom.offset.x, (double)top.offset.y + bottom.offset.y,
                    (double)top.offset.z + bottom.offset.z};
  const dvec from = minus(add_scaled(of_vec3(&body->centre), 0.5, sum), of_vec3(&t->world[0]));
  return dot_of(from, t->normal) > 4;
}

// The distance along its reported normal, finer than an LSB.
static double gap_along(const gjk_collider *body, const near_triangle *t, const gjk_distance_result *d) {
  const gjk_vec3 down = {-d->normal.x, -d->normal.y, -d->normal.z};
  const dvec n = {ldexp(d->normal.x, -30), ldexp(d->normal.y, -30), ldexp(d->normal.z, -30)};
  gjk_support bottom;
  body->shape->type->support(body, &down, &bottom);
  const dvec from = add_scaled(of_vec3(&body->centre), 1, of_vec3(&bottom.offset));
  double gap = 1e300;
  for (int k = 0; k < 3; k++) {
    gap = fmin(gap, dot_of(n, minus(from, of_vec3(&t->world[k]))));
  }
  return gap - body->shape->convex_radius;
}

static void check_body(trial *t) {
  static found_contacts found;
  static near_surface near;
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  const gjk_collider *body = &t->body.collider;
  CHECK(gjk_surface_contacts(&t->parts, body, t->margin, 4, &workspace, found.contact, FOUND_MAX, &found.count) ==
        GJK_OK);
  find_near(&t->parts, body, t->margin, &near);
  CHECK(found.count < FOUND_MAX && near.count < NEAR_MAX);
  tally.bodies++;
  // The rounding of both; with curved bodies two edges may be off by 1/1024 along each axis.
  const double own_angle = gjk_is_curved(body->shape) ? 0.004 : 1e-8;
  gjk_q16 least = INT32_MAX;
  for (unsigned i = 0; i < found.count; i++) {
    const gjk_manifold *m = &found.contact[i].manifold;
    const dvec n = {ldexp(m->normal.x, -30), ldexp(m->normal.y, -30), ldexp(m->normal.z, -30)};
    tally.manifolds++;
    bool of_face = false;
    for (unsigned k = 0; k < near.count; k++) {
      of_face = of_face || (near.triangle[k].number == found.contact[i].triangle &&
                            is_normal_of(&near.triangle[k], n, t->ground.mesh.two_sided, own_angle));
    }
    tally.of_faces += of_face ? 1 : 0;
    tally.of_ridges += of_face ? 0 : 1;
    bool any = false;
    for (unsigned k = 0; k < m->count; k++) {
      least = m->contact[k].distance < least ? m->contact[k].distance : least;
      any = any || surface_has_near(&near, found.contact[i].triangle, of_vec3(&m->contact[k].point_a), n,
                                    t->ground.mesh.two_sided, gjk_is_curved(body->shape) ? 0.004 : 1e-6);
      CHECK(m->contact[k].distance <= t->margin);
    }
    CHECK_MSG(any || of_face, "triangle %lu: normal (%d, %d, %d), %u points, distance %d",
              (unsigned long)found.contact[i].triangle, (int)m->normal.x, (int)m->normal.y, (int)m->normal.z, m->count,
              (int)m->contact[0].distance);
  }
  // What is missing.
  bool together = false, in_front = false;
  gjk_q16 nearest = INT32_MAX;
  double least_in_front = 1e300, least_behind = 1e300;
  for (unsigned k = 0; k < near.count; k++) {
    gjk_parts_room room;
    gjk_collider triangle;
    gjk_distance_result d;
    CHECK(gjk_parts_place(&t->parts, near.triangle[k].number, &room, &triangle) == GJK_OK);
    if (gjk_distance(&triangle, body, NULL, &d) != GJK_OK) {
      continue;
    }
    together = together || d.intersecting;
    in_front = in_front || (d.intersecting && is_in_front(body, &near.triangle[k]));
    if (!d.intersecting) {
      const dvec n = {d.normal.x, d.normal.y, d.normal.z};
      const double gap = gap_along(body, &near.triangle[k], &d);
      const bool behind =
          dot_of(n, near.triangle[k].normal) < 1e-3 * length_of(n) || !is_in_front(body, &near.triangle[k]);
      nearest = d.distance < nearest ? d.distance : nearest;
      if (behind && !t->ground.mesh.two_sided) {
        least_behind = fmin(least_behind, gap);
      } else {
        least_in_front = fmin(least_in_front, gap);
      }
    }
  }
  if (together) {
    tally.together++;
    tally.in_front += in_front ? 1 : 0;
    CHECK(found.count > 0 || !in_front);
  } else if (nearest <= t->margin - 4) {
    if (least_behind < least_in_front - 0.001) {  // it is behind the nearest triangle
      tally.behind++;
      return;
    }
    tally.apart++;
    // Contact points are within 4 LSB of the shapes, distances of curved ones within 2.
    const gjk_q16 off = gjk_is_curved(body->shape) ? 6 : 4;
    // Now and then the nearest triangle leaves the contact to another one.
    const bool is_rough = found.count > 0 && least > nearest + off;
    tally.rough += is_rough ? 1 : 0;
    CHECK_MSG(is_rough || (least <= nearest + off && least >= nearest - off), "distance %d, nearest contact %d",
              (int)nearest, (int)least);
  }
}

// Balls over the edges of a level ground that is turned: rounding its corners tilts small triangles, so a ball may lie over
// neither of two. It has its contact all the same, at the distance of the ground.
static void check_turned_level(random_state *random) {
  static found_contacts found;
  trial t = {0};
  unsigned long apart = 0, together = 0;
  for (int k = 0; k < 60; k++) {
    surface_make(random, SURFACE_FLAT, 200, 1 << random_range(random, 5, 9), false, &t.ground);
    t.parts = (gjk_parts)GJK_PARTS_OF_MESH(&t.ground.mesh);
    t.parts.pose.rotation = random_rotation(random);
    t.margin = 1000;
    for (int i = 0; i < 60; i++) {
      const gjk_shape ball = GJK_SPHERE(1 + (gjk_q16)random_below(random, 3000));
      const double gap = i % 3 == 0 ? 4 * random_unit(random) - 2 : 2 + 990 * random_unit(random);
      gjk_parts_room room;
      gjk_collider triangle;
      gjk_distance_result d;
      CHECK(gjk_parts_place(&t.parts, random_below(random, t.ground.triangle_count), &room, &triangle) == GJK_OK);
      const dvec a = of_vec3(&room.vertices[0]), b = of_vec3(&room.vertices[1]), c = of_vec3(&room.vertices[2]);
      const dvec n = cross_of(minus(b, a), minus(c, a));
      const dvec at =
          add_scaled(add_scaled(a, random_unit(random), minus(c, a)), (ball.convex_radius + gap) / length_of(n), n);
      const gjk_pose pose = {{(int32_t)floor(at.x + 0.5), (int32_t)floor(at.y + 0.5), (int32_t)floor(at.z + 0.5)},
                             {0, 0, 0, GJK_Q30_ONE}};
      const gjk_collider body = posed(&ball, &pose);
      CHECK(gjk_parts_distance(&t.parts, &body, NULL, &d) == GJK_OK);
      CHECK(gjk_surface_contacts(&t.parts, &body, t.margin, 4, NULL, found.contact, FOUND_MAX, &found.count) == GJK_OK);
      gjk_q16 least = INT32_MAX;
      for (unsigned j = 0; j < found.count; j++) {
        const gjk_q16 distance = found.contact[j].manifold.contact[0].distance;
        least = distance < least ? distance : least;
      }
      CHECK_MSG(d.intersecting || d.distance > t.margin || (least <= d.distance + 4 && least >= d.distance - 4),
                "%u manifolds, at %ld not %ld", found.count, (long)least, (long)d.distance);
      CHECK(!d.intersecting || found.count > 0);
      apart += !d.intersecting;
      together += d.intersecting;
    }
    surface_free(&t.ground);
  }
  CHECK(apart > 2000 && together > 200);
}

// A ball above the ridge of a roof of two sides touches it along the normal of the ridge: seen from in front as from behind,
// whichever of their edges it is.
static void check_ridge(void) {
  static const gjk_vec3 corners[4] = {{0, -60000, 0}, {0, 60000, 0}, {60000, 0, -60000}, {-60000, 0, -60000}};
  static const uint32_t around[2][3] = {{0, 2, 1}, {1, 3, 0}};
  static const gjk_shape ball = GJK_SPHERE(30000);
  const gjk_pose above = {{0, 0, 30100}, {0, 0, 0, GJK_Q30_ONE}};
  found_contacts found;
  const gjk_collider body = posed(&ball, &above);
  for (unsigned k = 0; k < 6; k++) {
    gjk_mesh_triangle roof[2];
    gjk_mesh_node node;
    gjk_mesh mesh;
    for (unsigned i = 0; i < 6; i++) {
      roof[i / 3].corner[i % 3] = around[i / 3][(k < 3 ? k + i : k + 5 - i % 3) % 3];
    }
    CHECK(gjk_mesh_build(corners, 4, roof, 2, true, &node, 1, &mesh) == GJK_OK);
    const gjk_parts parts = GJK_PARTS_OF_MESH(&mesh);
    CHECK(gjk_surface_contacts(&parts, &body, 200, 4, NULL, found.contact, FOUND_MAX, &found.count) == GJK_OK);
    CHECK_MSG(found.count == 2, "%u: %u manifolds", k, found.count);
    for (unsigned i = 0; i < found.count; i++) {
      const gjk_manifold *m = &found.contact[i].manifold;
      CHECK(m->count == 1 && m->contact[0].distance == 100 && m->normal.z > GJK_Q30_ONE - 8);
    }
  }
}

int main(void) {
  static trial t;
  check_ridge();
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state random = random_seed(seed + i);
    const int32_t step = 1 << random_range(&random, 8, 18);
    surface_make(&random, (surface_kind)(i % SURFACE_SOUP), 20 + random_below(&random, 2000), step,
                 random_below(&random, 4) == 0, &t.ground);
    t.parts = (gjk_parts)GJK_PARTS_OF_MESH(&t.ground.mesh);
    t.parts.pose.position = random_vector(&random, 1000000);
    if (random_below(&random, 2) == 0) {
      t.parts.pose.rotation = random_rotation(&random);
    }
    t.margin = random_below(&random, 2) == 0 ? 40 : step / 4;
    check_trial(i, show, &t);
    for (unsigned k = 0; k < BODIES; k++) {
      place_body(&random, &t, step);
      check_trial(i, show, &t);
      check_body(&t);
    }
    surface_free(&t.ground);
  }
  random_state level = random_seed(seed);
  check_turned_level(&level);
  case_collider_free(&t.body);
  case_shape_free(&t.source);
  printf(
      "%lu bodies, %lu apart, %lu from behind, %lu together, %lu of them in front of one; %lu "
      "manifolds, %lu along "
      "normals "
      "of triangles, %lu of edges and corners\n",
      tally.bodies, tally.apart, tally.behind, tally.together, tally.in_front, tally.manifolds, tally.of_faces,
      tally.of_ridges);
  CHECK(tally.apart > tally.bodies / 8 && tally.together > tally.bodies / 8 && tally.in_front > tally.together / 2);
  CHECK(tally.rough * 1000 <= tally.apart);
  CHECK(tally.of_ridges > 100 && tally.of_faces > 1000);
  return check_done("mesh_contacts");
}
