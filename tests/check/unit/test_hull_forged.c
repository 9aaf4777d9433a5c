// gjk_hull_check on damaged hulls: each kind of damage, at random places, and two of them at once, of which the first in the
// order of faults is reported, with its place.
#include "hull_points.h"

static hull_points p;
static hull_output out;

// Faces that are damaged, and what the check should say of them.
typedef struct forgery {
  uint16_t corner[8 * HULL_POINTS], end[2 * HULL_POINTS];
  uint16_t faces;
} forgery;

static forgery forged;

static uint16_t begin_of(uint16_t face) {
  return face == 0 ? 0 : forged.end[face - 1];
}

static uint16_t corners_of(uint16_t face) {
  return (uint16_t)(forged.end[face] - begin_of(face));
}

static void forge_nothing(void) {
  forged.faces = out.faces.count;
  memcpy(forged.end, out.end, forged.faces * sizeof forged.end[0]);
  memcpy(forged.corner, out.corner, forged.end[forged.faces - 1] * sizeof forged.corner[0]);
}

static int64_t height_over(uint16_t face, uint16_t vertex) {
  const uint16_t *c = forged.corner + begin_of(face);
  const gjk_vec3 a = out.vertex[c[0]], b = out.vertex[c[1]], d = out.vertex[c[2]], q = out.vertex[vertex];
  const int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = d.x - a.x, vy = d.y - a.y, vz = d.z - a.z;
  return (uy * vz - uz * vy) * (q.x - a.x) + (uz * vx - ux * vz) * (q.y - a.y) + (ux * vy - uy * vx) * (q.z - a.z);
}

static void remove_corner(uint16_t face) {
  const uint16_t last = (uint16_t)(forged.end[face] - 1);
  memmove(forged.corner + last, forged.corner + last + 1,
          (forged.end[forged.faces - 1] - (last + 1u)) * sizeof forged.corner[0]);
  for (uint16_t f = face; f < forged.faces; f++) {
    forged.end[f]--;
  }
}

static void remove_face(uint16_t face) {
  while (corners_of(face) > 0) {
    remove_corner(face);
  }
  memmove(forged.end + face, forged.end + face + 1, (forged.faces - (face + 1u)) * sizeof forged.end[0]);
  forged.faces--;
}

// Is there an edge from b to a?
static bool has_edge(uint16_t b, uint16_t a) {
  for (uint16_t f = 0; f < forged.faces; f++) {
    for (uint16_t i = 0; i < corners_of(f); i++) {
      const uint16_t *c = forged.corner + begin_of(f);
      if (c[i] == b && c[(i + 1) % corners_of(f)] == a) {
        return true;
      }
    }
  }
  return false;
}

// Damages a face so that its first fault is of that kind. False: this face cannot have it. *report: what is to be said.
static bool damage(random_state *random, gjk_hull_fault kind, uint16_t face, gjk_hull_report *report) {
  uint16_t *c = forged.corner + begin_of(face);
  const uint16_t corners = corners_of(face);
  memset(report, 0, sizeof *report);
  report->fault = (uint8_t)kind;
  report->face = face;
  if (kind == GJK_HULL_FEW) {
    while (corners_of(face) > 2 || (corners_of(face) > 0 && random_below(random, 2) == 0)) {
      remove_corner(face);
    }
  } else if (kind == GJK_HULL_NUMBER) {
    report->corner = (uint16_t)random_below(random, corners);
    c[report->corner] = (uint16_t)(out.hull.vertices + random_below(random, 65536u - out.hull.vertices));
  } else if (kind == GJK_HULL_BENT) {
    if (corners < 4) {
      return false;
    }
    report->corner = (uint16_t)(3 + random_below(random, corners - 3u));
    for (uint32_t i = random_below(random, out.hull.vertices);; i = (i + 1) % out.hull.vertices) {
      if (height_over(face, (uint16_t)i) != 0) {  // some vertex is not in the plane
        c[report->corner] = (uint16_t)i;
        break;
      }
    }
  } else if (kind == GJK_HULL_TURN) {
    // A corner twice: it has no turn. The plane of the first three corners stays, or there is none.
    report->corner = (uint16_t)random_below(random, corners);
    c[report->corner] = c[(report->corner + 1) % corners];
    report->corner = 0;
  } else if (kind == GJK_HULL_BEYOND) {
    for (uint16_t i = 0; i < corners / 2; i++) {
      const uint16_t swapped = c[i];
      c[i] = c[corners - 1 - i];
      c[corners - 1 - i] = swapped;
    }
    while (height_over(face, report->vertex) <= 0) {
      report->vertex++;
    }
  } else if (kind == GJK_HULL_OPEN) {
    remove_face(face);
    for (uint16_t f = 0; f < forged.faces; f++) {
      for (uint16_t i = 0; i < corners_of(f); i++) {
        const uint16_t *d = forged.corner + begin_of(f);
        if (!has_edge(d[(i + 1) % corners_of(f)], d[i])) {
          report->face = f;
          report->corner = i;
          return true;
        }
      }
    }
    return false;
  } else {  // DOUBLED: the face again at the end
    for (uint16_t i = 0; i < corners; i++) {
      forged.corner[forged.end[forged.faces - 1] + i] = c[i];
    }
    forged.end[forged.faces] = (uint16_t)(forged.end[forged.faces - 1] + corners);
    forged.faces++;
  }
  return true;
}

static void check_report(const gjk_hull_report *wanted) {
  const gjk_hull_faces faces = {forged.corner, forged.end, forged.faces};
  gjk_hull_report report;
  memset(&report, 0xA5, sizeof report);
  CHECK(gjk_hull_check(out.vertex, out.hull.vertices, &faces, &report) == GJK_OK);
  const bool placed = wanted->fault == GJK_HULL_TURN || report.corner == wanted->corner;
  CHECK_MSG(report.fault == wanted->fault && report.face == wanted->face && placed && report.vertex == wanted->vertex,
            "fault %d of face %u, corner %u, vertex %u; not %d, %u, %u, %u", report.fault, report.face, report.corner,
            report.vertex, wanted->fault, wanted->face, wanted->corner, wanted->vertex);
}

static void make_points(random_state *random) {
  const int32_t size = random_below(random, 2) == 0 ? 3 : 100000;
  do {
    p.count = 0;
    for (uint32_t n = 8 + random_below(random, 25); p.count < n;) {
      hull_points_add(&p, random_range(random, 0, size), random_range(random, 0, size), random_range(random, 0, size));
    }
    hull_output_make(&p, &out);
  } while (out.hull.dimension < 3);
}

int main(void) {
  random_state random = random_seed(check_seed(1234567));
  unsigned long of_kind[GJK_HULL_LAYERS + 1] = {0}, of_two = 0;
  for (unsigned long trial = 0; trial < check_trials(20000); trial++) {
    gjk_hull_report first, second;
    check_trial(trial, hull_points_print, &p);
    if (trial % 8 == 0) {
      make_points(&random);
      const gjk_hull_report sound = {GJK_HULL_SOUND, 0, 0, 0};
      forge_nothing();
      check_report(&sound);
    }
    const gjk_hull_fault kind = (gjk_hull_fault)(GJK_HULL_FEW + random_below(&random, GJK_HULL_LAYERS - GJK_HULL_FEW));
    const uint16_t face = (uint16_t)random_below(&random, out.faces.count);
    forge_nothing();
    if (!damage(&random, kind, face, &first)) {
      continue;
    }
    of_kind[kind]++;
    check_report(&first);
    // Another face's damage, of those that leave the numbers of faces as they are.
    const gjk_hull_fault more =
        (gjk_hull_fault)(GJK_HULL_NUMBER + random_below(&random, GJK_HULL_OPEN - GJK_HULL_NUMBER));
    const uint16_t other = (uint16_t)random_below(&random, out.faces.count);
    if (other != face && kind <= GJK_HULL_BEYOND && more != kind && kind != GJK_HULL_FEW &&
        damage(&random, more, other, &second)) {
      of_two++;
      check_report(kind < more ? &first : &second);
    }
  }
  for (unsigned kind = GJK_HULL_FEW; kind < GJK_HULL_LAYERS; kind++) {
    CHECK_MSG(of_kind[kind] > check_trials(20000) / 100, "fault %u: %lu", kind, of_kind[kind]);
  }
  CHECK(of_two > check_trials(20000) / 10);
  return check_done("hull forged");
}
