// The library for JavaScript: memory, and queries with flat arguments. gjk.js is its other half.
#include "gjk_wasm.h"

#include "../gjk_allocate.h"
#include "gjk_wasm_shape.h"

// Blocks are powers of two from 2^4 on, so that a released one fits the next of its class. The class of a block stands
// in the 8 bytes in front of it.
enum { SMALLEST = 4, CLASSES = 31, PAGE = 65536 };

typedef union block {
  union block *next;  // while it is free
  int64_t size_class;
} block;

extern unsigned char __heap_base;

static block *released[CLASSES];
static uintptr_t unused, end;  // of the memory that no block has had yet

// Moves the end of the memory so far that bytes fit. False: there is no more.
static bool grow(uintptr_t bytes) {
  if (unused == 0) {
    unused = ((uintptr_t)&__heap_base + 15) & ~(uintptr_t)15;
    end = (uintptr_t)__builtin_wasm_memory_size(0) * PAGE;
  }
  if (bytes <= end - unused) {
    return true;
  }
  const uintptr_t pages = (bytes - (end - unused) + PAGE - 1) / PAGE;
  if (__builtin_wasm_memory_grow(0, pages) == (size_t)-1) {
    return false;
  }
  end += pages * PAGE;
  return bytes <= end - unused;
}

void *gjk_port_allocate(size_t bytes) {
  unsigned size_class = SMALLEST;
  if (bytes == 0 || bytes > (size_t)1 << (CLASSES - 2)) {
    return NULL;
  }
  while (((size_t)1 << size_class) < bytes) {
    size_class++;
  }
  block *found = released[size_class];
  if (found != NULL) {
    released[size_class] = found->next;
  } else {
    const uintptr_t size = 16 + ((uintptr_t)1 << size_class);
    if (!grow(size)) {
      return NULL;
    }
    found = (block *)(unused + 8);
    unused += size;
  }
  found->size_class = (int64_t)size_class;
  return found + 1;
}

void gjk_port_release(void *memory) {
  if (memory != NULL) {
    block *freed = (block *)memory - 1;
    const unsigned size_class = (unsigned)freed->size_class;
    freed->next = released[size_class];
    released[size_class] = freed;
  }
}

// Cells enough for polytopes of so many vertices together, and for curved shapes.
enum { VERTICES = 1000 };

static gjk_epa_cell cells[GJK_EPA_CELLS(VERTICES) + VERTICES];
const gjk_workspace gjk_wasm_workspace = {cells, GJK_EPA_CELLS(VERTICES) + VERTICES};
static int32_t report[GJK_WASM_REPORT];
static unsigned reported;  // at most GJK_WASM_REPORT

const int32_t *gjk_wasm_report(void) {
  return report;
}

void gjk_wasm_begin(void) {
  reported = 0;
}

void gjk_wasm_put(int32_t value) {
  report[reported++] = value;
}

void gjk_wasm_put_vector(int32_t x, int32_t y, int32_t z) {
  gjk_wasm_put(x);
  gjk_wasm_put(y);
  gjk_wasm_put(z);
}

void *gjk_wasm_fails(gjk_status status) {
  report[0] = status;
  return NULL;
}

gjk_collider *gjk_wasm_collider(int kind, int32_t x, int32_t y, int32_t z, int32_t convex_radius,
                                const int32_t *vertices, unsigned count) {
  static const gjk_shape kinds[] = {GJK_POINT,      GJK_SEGMENT(0),     GJK_BOX(0, 0, 0), GJK_TRIANGLE(0),
                                    GJK_HULL(0, 0), GJK_CYLINDER(0, 0), GJK_CONE(0, 0),   GJK_ELLIPSOID(0, 0, 0)};
  if (kind < 0 || (unsigned)kind >= sizeof kinds / sizeof kinds[0] || count > GJK_HULL_VERTICES_MAX) {
    return gjk_wasm_fails(GJK_ERROR_RANGE);
  }
  gjk_wasm_shape *made = gjk_port_allocate(sizeof *made + 2 * count * sizeof(gjk_vec3));
  if (made == NULL) {
    return gjk_wasm_fails(GJK_ERROR_CAPACITY);
  }
  made->shape = kinds[kind];
  made->shape.size.x = x;
  made->shape.size.y = y;
  made->shape.size.z = z;
  made->shape.convex_radius = convex_radius;
  if (vertices != NULL) {
    made->shape.vertices = made->vertices;
    made->shape.count = (uint16_t)count;
  }
  for (unsigned i = 0; vertices != NULL && i < count; i++) {
    made->vertices[i].x = vertices[3 * i];
    made->vertices[i].y = vertices[3 * i + 1];
    made->vertices[i].z = vertices[3 * i + 2];
  }
  return gjk_wasm_finish(made);
}

gjk_collider *gjk_wasm_finish(gjk_wasm_shape *made) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const uint16_t count = made->shape.count;
  made->users = 1;
  gjk_status status =
      gjk_collider_init(&made->collider, &made->shape, count > 0 ? made->vertices + count : NULL, count);
  status = status == GJK_OK ? gjk_collider_pose(&made->collider, &identity) : status;
  if (status != GJK_OK) {
    gjk_port_release(made);
    return gjk_wasm_fails(status);
  }
  return &made->collider;
}

void gjk_wasm_release(gjk_collider *collider) {
  gjk_wasm_shape *shape = (gjk_wasm_shape *)collider;
  if (shape != NULL && --shape->users == 0) {
    gjk_port_release(shape);
  }
}

int gjk_wasm_pose(gjk_collider *collider, int32_t x, int32_t y, int32_t z, int32_t i, int32_t j, int32_t k, int32_t w) {
  const gjk_pose pose = {{x, y, z}, {i, j, k, w}};
  return gjk_collider_pose(collider, &pose);
}

int gjk_wasm_intersect(const gjk_collider *a, const gjk_collider *b) {
  gjk_decision found;
  const gjk_status status = gjk_intersect(a, b, NULL, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(found.yes);
    gjk_wasm_put(found.iterations);
  }
  return status;
}

int gjk_wasm_distance(const gjk_collider *a, const gjk_collider *b) {
  gjk_distance_result found = {0};
  const gjk_status status = gjk_distance(a, b, NULL, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(found.intersecting);
    gjk_wasm_put(found.distance);
    gjk_wasm_put_vector(found.point_a.x, found.point_a.y, found.point_a.z);
    gjk_wasm_put_vector(found.point_b.x, found.point_b.y, found.point_b.z);
    gjk_wasm_put_vector(found.normal.x, found.normal.y, found.normal.z);
    gjk_wasm_put(found.iterations);
    gjk_wasm_put(gjk_check_distance(a, b, &found) == GJK_OK);
  }
  return status;
}

int gjk_wasm_penetration(const gjk_collider *a, const gjk_collider *b) {
  gjk_penetration_result found = {0};
  const gjk_status status = gjk_penetration(a, b, NULL, &gjk_wasm_workspace, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(found.intersecting);
    gjk_wasm_put(found.depth);
    gjk_wasm_put_vector(found.point_a.x, found.point_a.y, found.point_a.z);
    gjk_wasm_put_vector(found.point_b.x, found.point_b.y, found.point_b.z);
    gjk_wasm_put_vector(found.normal.x, found.normal.y, found.normal.z);
    gjk_wasm_put(found.iterations);
    gjk_wasm_put(gjk_check_penetration(a, b, &found) == GJK_OK);
  }
  return status;
}

void gjk_wasm_put_manifold(const gjk_manifold *m) {
  const gjk_unit3 none = {0, 0, 0}, normal = m->count > 0 ? m->normal : none;
  gjk_wasm_put(m->count);
  gjk_wasm_put_vector(normal.x, normal.y, normal.z);
  gjk_wasm_put(m->count > 0 ? m->feature_a : 0);
  gjk_wasm_put(m->count > 0 ? m->feature_b : 0);
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_contact *c = &m->contact[i];
    gjk_wasm_put_vector(c->point_a.x, c->point_a.y, c->point_a.z);
    gjk_wasm_put_vector(c->point_b.x, c->point_b.y, c->point_b.z);
    gjk_wasm_put(c->distance);
    gjk_wasm_put(c->id);
  }
}

int gjk_wasm_contacts(const gjk_collider *a, const gjk_collider *b, int32_t margin) {
  gjk_manifold found;
  const gjk_status status = gjk_contacts(a, b, margin, GJK_CONTACTS_MAX, NULL, &gjk_wasm_workspace, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put_manifold(&found);
  }
  return status;
}

int gjk_wasm_cast(const gjk_collider *a, const gjk_collider *b, int32_t x, int32_t y, int32_t z, int32_t margin) {
  const gjk_vec3 to = {x, y, z};
  const gjk_cast_path path = {.to_a = NULL, .to_b = &to, .margin = margin};
  gjk_cast_result found = {0};
  const gjk_status status = gjk_cast(a, b, &path, &found);
  if (status == GJK_OK) {
    gjk_wasm_begin();
    gjk_wasm_put(found.hit);
    gjk_wasm_put(found.fraction);
    gjk_wasm_put_vector(found.point_a.x, found.point_a.y, found.point_a.z);
    gjk_wasm_put_vector(found.point_b.x, found.point_b.y, found.point_b.z);
    gjk_wasm_put_vector(found.normal.x, found.normal.y, found.normal.z);
    gjk_wasm_put_vector(found.rest_b.x, found.rest_b.y, found.rest_b.z);
    gjk_wasm_put(found.iterations);
  }
  return status;
}
