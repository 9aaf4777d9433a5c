// Draws single bodies as SVG.
#include "draw.h"

#include <math.h>

#define PI 3.14159265358979323846

// The light on a surface: ambient, and from the lamp.
#define AMBIENT 0.52
#define LAMP 0.55

view view_make(double azimuth, double elevation) {
  view v = {{cos(azimuth), sin(azimuth), 0}, {0, 0, 0}, {0, 0, 0}, {-0.45, -0.5, 0.95}, 1, 0, 0};
  v.toward.x = sin(azimuth) * cos(elevation);
  v.toward.y = -cos(azimuth) * cos(elevation);
  v.toward.z = sin(elevation);
  v.up = real_cross(v.toward, v.right);
  v.light = real_unit(v.light);
  return v;
}

point2 view_project(const view *v, real3 point) {
  point2 out = {v->left + v->scale * real_dot(point, v->right), v->top - v->scale * real_dot(point, v->up)};
  return out;
}

void draw_outline(const view *v, const case_shape *shape, point2 outline[OUTLINE_POINTS]) {
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    double angle = 2 * PI * (i + 0.25) / OUTLINE_POINTS;
    real3 direction = real_add(real_scale(cos(angle), v->right), real_scale(sin(angle), v->up));
    outline[i] = view_project(v, geometry_support(shape, direction));
  }
}

void draw_shadow_outline(const view *v, const case_shape *shape, double height, point2 outline[OUTLINE_POINTS]) {
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    double angle = 2 * PI * (i + 0.25) / OUTLINE_POINTS;
    real3 direction = {cos(angle), sin(angle), 0};
    direction.z = -(direction.x * v->light.x + direction.y * v->light.y) / v->light.z;
    real3 edge = geometry_support(shape, direction);
    outline[i] = view_project(v, real_sub(edge, real_scale((edge.z - height) / v->light.z, v->light)));
  }
}

static double clamp(double value) {
  return value < 0 ? 0 : value > 1 ? 1 : value;
}

static double brightness(const view *v, real3 normal) {
  double lamp = real_dot(normal, v->light);
  return AMBIENT + (lamp > 0 ? LAMP * lamp : 0);
}

// Writes a colour; brightness above 1 goes towards white.
static void put_colour(FILE *file, colour base, double bright) {
  const double part[3] = {base.red, base.green, base.blue};
  fputc('#', file);
  for (int i = 0; i < 3; i++) {
    double value = bright <= 1 ? part[i] * bright : part[i] + (1 - part[i]) * (bright - 1) * 2;
    fprintf(file, "%02x", (unsigned)lround(255 * clamp(value)));
  }
}

static void put_polygon(FILE *file, const point2 *point, size_t count, colour base, double bright) {
  fprintf(file, "<polygon points=\"");
  svg_points(file, point, count);
  fprintf(file, "\" fill=\"");
  put_colour(file, base, bright);
  fprintf(file, "\" stroke=\"");
  put_colour(file, base, bright);
  fprintf(file, "\" stroke-width=\"0.6\" stroke-linejoin=\"round\"/>\n");
}

static void put_outline(FILE *file, const view *v, const case_shape *shape, size_t id) {
  point2 outline[OUTLINE_POINTS];
  draw_outline(v, shape, outline);
  fprintf(file, "<polygon points=\"");
  svg_points(file, outline, OUTLINE_POINTS);
  fprintf(file, "\" fill=\"url(#g%lu)\"/>\n", (unsigned long)id);
}

static void put_stop(FILE *file, double offset, colour base, double bright) {
  fprintf(file, "<stop offset=\"%.3f\" stop-color=\"", offset);
  put_colour(file, base, bright);
  fprintf(file, "\"/>");
}

// Spheres and ellipsoids: the gradient of the unit circle, brightest where the surface faces the lamp, under the map
// that takes the circle to the outline. part: the columns of an affine map from the unit sphere to the body.
static void put_ball_gradient(FILE *file, const view *v, const real3 part[3], real3 centre, colour base, size_t id) {
  double xx = 0, xy = 0, yy = 0;
  for (int i = 0; i < 3; i++) {
    double x = v->scale * real_dot(part[i], v->right), y = -v->scale * real_dot(part[i], v->up);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  // The outline is the image of the circle under the Cholesky root of the sum.
  double a = sqrt(xx), b = xy / a, d = sqrt(yy - b * b);
  point2 c = view_project(v, centre);
  double fx = real_dot(v->light, v->right), fy = -real_dot(v->light, v->up);
  fprintf(file,
          "<radialGradient id=\"g%lu\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1.02\" "
          "fx=\"%.3f\" fy=\"%.3f\" gradientTransform=\"matrix(%.3f %.3f 0 %.3f %.2f %.2f)\">",
          (unsigned long)id, 0.75 * fx, 0.75 * fy, a, b, d, c.x, c.y);
  for (int i = 0; i <= 4; i++) {
    double t = i / 4.0;
    put_stop(file, t, base, AMBIENT + LAMP * (1.12 * (1 - t * t) + 0.1 * t));
  }
  fprintf(file, "</radialGradient>\n");
}

// Capsules and cylinders: a gradient across the axis. Each stop is as bright as the surface there.
static void put_tube_gradient(FILE *file, const view *v, real3 axis, real3 centre, double radius, colour base,
                              size_t id) {
  real3 side = real_unit(real_cross(axis, v->toward));
  real3 front = real_unit(real_cross(side, axis));
  front = real_dot(front, v->toward) < 0 ? real_scale(-1, front) : front;
  point2 from = view_project(v, real_sub(centre, real_scale(radius, side)));
  point2 to = view_project(v, real_add(centre, real_scale(radius, side)));
  fprintf(file,
          "<linearGradient id=\"g%lu\" gradientUnits=\"userSpaceOnUse\" x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" "
          "y2=\"%.2f\">",
          (unsigned long)id, from.x, from.y, to.x, to.y);
  for (int i = 0; i <= 8; i++) {
    double t = -1 + i / 4.0;
    real3 normal = real_add(real_scale(t, side), real_scale(sqrt(1 - t * t), front));
    put_stop(file, i / 8.0, base, brightness(v, normal));
  }
  fprintf(file, "</linearGradient>\n");
}

// The base of a cylinder or cone at local height z, with its outward normal along sign z, if it is seen.
static void put_disc(FILE *file, const view *v, const case_shape *shape, double sign, colour base) {
  real3 z = {0, 0, sign}, normal = geometry_turn(shape, z);
  point2 rim[OUTLINE_POINTS];
  if (real_dot(normal, v->toward) <= 0) {
    return;
  }
  double radius = shape->size.x / 65536.0, height = sign * (shape->size.z + shape->convex_radius) / 65536.0;
  for (int i = 0; i < OUTLINE_POINTS; i++) {
    double angle = 2 * PI * i / OUTLINE_POINTS;
    real3 local = {radius * cos(angle), radius * sin(angle), height};
    rim[i] = view_project(v, real_add(real_from_q16(shape->pose.position), geometry_turn(shape, local)));
  }
  put_polygon(file, rim, OUTLINE_POINTS, base, brightness(v, normal));
}

// The side of a cone, in strips from its apex.
static void put_cone(FILE *file, const view *v, const case_shape *shape, colour base) {
  enum { STRIPS = 48 };
  double radius = shape->size.x / 65536.0, half = shape->size.z / 65536.0;
  real3 centre = real_from_q16(shape->pose.position);
  for (int i = 0; i < STRIPS; i++) {
    double angle = 2 * PI * i / STRIPS, next = angle + 2 * PI / STRIPS, middle = angle + PI / STRIPS;
    real3 local[3] = {{0, 0, half},
                      {radius * cos(angle), radius * sin(angle), -half},
                      {radius * cos(next), radius * sin(next), -half}};
    real3 outward = {2 * half * cos(middle), 2 * half * sin(middle), radius};
    real3 normal = real_unit(geometry_turn(shape, outward));
    point2 corner[3];
    if (real_dot(normal, v->toward) > 0) {
      for (int k = 0; k < 3; k++) {
        corner[k] = view_project(v, real_add(centre, geometry_turn(shape, local[k])));
      }
      put_polygon(file, corner, 3, base, brightness(v, normal));
    }
  }
  put_disc(file, v, shape, -1, base);
}

static void put_faces(FILE *file, const view *v, const case_shape *shape, colour base) {
  real_face faces[FACES_MAX];
  size_t count = geometry_faces(shape, faces);
  for (size_t i = 0; i < count; i++) {
    point2 corner[FACE_VERTICES_MAX];
    if (real_dot(faces[i].normal, v->toward) > 0) {
      for (size_t k = 0; k < faces[i].count; k++) {
        corner[k] = view_project(v, faces[i].vertex[k]);
      }
      put_polygon(file, corner, faces[i].count, base, brightness(v, faces[i].normal));
    }
  }
}

static void draw_ball(FILE *file, const view *v, const case_shape *shape, colour base, size_t id) {
  double r = shape->convex_radius / 65536.0;
  real3 s = real_from_q16(shape->size);
  real3 local[3] = {{s.x + r, 0, 0}, {0, s.y + r, 0}, {0, 0, s.z + r}}, part[3];
  for (int i = 0; i < 3; i++) {
    part[i] = geometry_turn(shape, local[i]);
  }
  put_ball_gradient(file, v, part, real_from_q16(shape->pose.position), base, id);
  put_outline(file, v, shape, id);
}

static void draw_tube(FILE *file, const view *v, const case_shape *shape, colour base, size_t id) {
  const real3 z = {0, 0, 1};
  real3 axis = geometry_turn(shape, z);
  put_tube_gradient(file, v, axis, real_from_q16(shape->pose.position),
                    (shape->size.x + shape->convex_radius) / 65536.0, base, id);
  put_outline(file, v, shape, id);
  if (shape->kind == CASE_CYLINDER) {
    put_disc(file, v, shape, 1, base);
    put_disc(file, v, shape, -1, base);
  }
}

void draw_body(FILE *file, const view *v, const case_shape *shape, colour base, size_t id) {
  const real3 origin = real_from_q16(shape->pose.position);
  point2 centre = view_project(v, origin);
  switch (shape->kind) {
    case CASE_POINT:
    case CASE_ELLIPSOID:
      if (shape->kind == CASE_POINT && shape->convex_radius == 0) {
        fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"", centre.x, centre.y);
        put_colour(file, base, 0.9);
        fprintf(file, "\"/>\n");
      } else {
        draw_ball(file, v, shape, base, id);
      }
      break;
    case CASE_CYLINDER: draw_tube(file, v, shape, base, id); break;
    case CASE_SEGMENT:
      if (shape->convex_radius == 0) {
        const real3 z = {0, 0, shape->size.z / 65536.0};
        point2 end[2] = {view_project(v, real_add(origin, geometry_turn(shape, z))),
                         view_project(v, real_sub(origin, geometry_turn(shape, z)))};
        fprintf(file, "<polyline stroke-width=\"2\" points=\"");
        svg_points(file, end, 2);
        fprintf(file, "\" stroke=\"");
        put_colour(file, base, 0.9);
        fprintf(file, "\"/>\n");
      } else {
        draw_tube(file, v, shape, base, id);
      }
      break;
    case CASE_CONE: put_cone(file, v, shape, base); break;
    default:
      if (shape->convex_radius > 0) {
        point2 outline[OUTLINE_POINTS];
        draw_outline(v, shape, outline);
        put_polygon(file, outline, OUTLINE_POINTS, base, 0.85);
      }
      put_faces(file, v, shape, base);
      break;
  }
}
