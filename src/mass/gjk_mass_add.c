// Parts at poses to one body, by the parallel axis theorem.
//
// Of bodies with masses m and n, centres d apart, and inertias I and J for a mass of 1, together, with M = m + n:
//   (m I + n J) / M + (m n / M^2) (|d|^2 - d d') = (2^32 M (m I + n J) + m n D) / (2^32 M^2)
// with D = |2^16 d|^2 - 2^32 d d'. Bounds:
//   m, n, M    < 2^32
//   I, J       <= 2^60
//   D          <= 2^93, since 2^16 d <= 2^46 along each axis
//   the sum    < 2^160; divided by 2^32 M^2 it is at most 2^60 + 2^59
#include "gjk_moments.h"
#include "gjk_tensor.h"

#include "../arith/gjk_rotation.h"

// A centre in 2^-16 LSB.
static void centre_of(const gjk_mass *mass, int64_t at[3]) {
  const int32_t centre[3] = {mass->centre.x, mass->centre.y, mass->centre.z};
  for (int i = 0; i < 3; i++) {
    at[i] = gjk_shl64(centre[i], 16) + mass->fraction[i];  // < 2^48
  }
}

// A part's centre and inertia in the body's frame. The rotation of the centre is off by 2^-42 |centre| and of the
// fraction by less than 4 of 2^-16 LSB.
static gjk_status place_part(const gjk_mass *part, const gjk_pose *pose, int64_t at[3], gjk_inertia *inertia) {
  gjk_vec3 rows[3];
  int64_t rotated[3], position[3];
  const gjk_vec3 fraction = {part->fraction[0], part->fraction[1], part->fraction[2]};
  if (!gjk_rotation_with_point(&pose->rotation, &part->centre, rows, rotated)) {
    return GJK_ERROR_ROTATION;
  }
  if (!gjk_tensor_fits(&part->inertia)) {
    return GJK_ERROR_RANGE;
  }
  const gjk_vec3 turned = gjk_rotate(rows, &fraction);
  const int32_t rest[3] = {turned.x, turned.y, turned.z};
  position[0] = pose->position.x;
  position[1] = pose->position.y;
  position[2] = pose->position.z;
  for (int i = 0; i < 3; i++) {
    at[i] = gjk_sar64(rotated[i], 14) + rest[i] + gjk_shl64(position[i], 16);  // |rotated| <= 2^62:  |at| < 2^50
  }
  gjk_rotate_tensor(rows, &part->inertia, inertia);
  return GJK_OK;
}

// Are a centre within what rounds to an int32_t, and its distance from the body's at most 2^30 LSB along each axis?
static bool centre_fits(const int64_t at[3], const int64_t d[3]) {
  for (int i = 0; i < 3; i++) {
    const int64_t nearest = gjk_sar64(at[i] + INT64_C(0x8000), 16);
    if (nearest < INT32_MIN || nearest > INT32_MAX || gjk_magnitude64(d[i]) > UINT64_C(1) << 46) {
      return false;
    }
  }
  return true;
}

// *out = x y.
static void multiply_longs(int64_t x, int64_t y, gjk_big *out) {
  gjk_big factor;
  gjk_big_set(&factor, x);
  gjk_big_set(out, 0);
  gjk_big_add_product(out, &factor, y);
}

// entry = m n D.
static void set_apart(const int64_t d[3], const gjk_big *product, gjk_big entry[6]) {
  for (int i = 0; i < 6; i++) {
    gjk_big square;
    multiply_longs(d[gjk_entry_axis[i][0]], d[gjk_entry_axis[i][1]], &square);
    gjk_big_multiply(&entry[i], &square, product);
  }
  gjk_inertia_of_second(entry);
}

// *out = 2^32 x y.
static void multiply_whole(uint32_t x, uint32_t y, gjk_big *out) {
  multiply_longs(x, y, out);
  gjk_big_scale(out, UINT32_C(1) << 16);
  gjk_big_scale(out, UINT32_C(1) << 16);
}

// entry += weight times the inertia.
static void add_weighted(const gjk_inertia *inertia, const gjk_big *weight, gjk_big entry[6]) {
  gjk_big_add_product(&entry[0], weight, inertia->xx);
  gjk_big_add_product(&entry[1], weight, inertia->yy);
  gjk_big_add_product(&entry[2], weight, inertia->zz);
  gjk_big_add_product(&entry[3], weight, inertia->yz);
  gjk_big_add_product(&entry[4], weight, inertia->zx);
  gjk_big_add_product(&entry[5], weight, inertia->xy);
}

// *own += d part / whole, rounded down.
static void move_centre(const int64_t d[3], uint32_t part, uint32_t whole, int64_t own[3]) {
  gjk_big way, all;
  for (int i = 0; i < 3; i++) {
    multiply_longs(d[i], part, &way);
    gjk_big_set(&all, whole);
    gjk_big_divide(&way, &all);
    own[i] += gjk_big_low(&way);
  }
}

static void add_volume(gjk_volume *sum, const gjk_volume *part) {
  sum->low += part->low;
  sum->high += part->high + (sum->low < part->low ? 1u : 0u);
}

// The inertia of both together.
static void join_inertia(const gjk_mass *body, uint32_t part_mass, const gjk_inertia *placed, const int64_t d[3],
                         gjk_inertia *out) {
  const uint32_t whole = body->mass + part_mass;
  gjk_big weight, entry[6];
  multiply_longs(body->mass, part_mass, &weight);
  set_apart(d, &weight, entry);
  multiply_whole(whole, body->mass, &weight);
  add_weighted(&body->inertia, &weight, entry);
  multiply_whole(whole, part_mass, &weight);
  add_weighted(placed, &weight, entry);
  multiply_whole(whole, whole, &weight);
  gjk_set_inertia(entry, &weight, out);
}

gjk_status gjk_mass_add(gjk_mass *body, const gjk_mass *part, const gjk_pose *pose) {
  if (body == NULL || part == NULL || pose == NULL) {
    return GJK_ERROR_NULL;
  }
  if (body == part) {
    return GJK_ERROR_OVERLAP;
  }
  if (part->mass == 0 || part->mass > UINT32_MAX - body->mass || !gjk_tensor_fits(&body->inertia)) {
    return GJK_ERROR_RANGE;
  }
  int64_t at[3], own[3], d[3];
  gjk_inertia placed, joined;
  const gjk_status status = place_part(part, pose, at, &placed);
  if (status != GJK_OK) {
    return status;
  }
  centre_of(body, own);
  for (int i = 0; i < 3; i++) {
    own[i] = body->mass == 0 ? at[i] : own[i];
    d[i] = at[i] - own[i];  // < 2^51
  }
  if (!centre_fits(at, d)) {
    return GJK_ERROR_RANGE;
  }
  join_inertia(body, part->mass, &placed, d, &joined);
  if (!gjk_tensor_fits(&joined)) {
    return GJK_ERROR_RANGE;
  }
  move_centre(d, part->mass, body->mass + part->mass, own);
  gjk_set_centre(own, body);
  body->inertia.xx = joined.xx;
  body->inertia.yy = joined.yy;
  body->inertia.zz = joined.zz;
  body->inertia.yz = joined.yz;
  body->inertia.zx = joined.zx;
  body->inertia.xy = joined.xy;
  body->mass += part->mass;
  add_volume(&body->volume, &part->volume);
  return GJK_OK;
}

gjk_status gjk_mass_set_density(gjk_mass *body, uint32_t density) {
  if (body == NULL) {
    return GJK_ERROR_NULL;
  }
  const uint32_t limb[4] = {gjk_low32(gjk_int64(body->volume.low)), (uint32_t)(body->volume.low >> 32),
                            gjk_low32(gjk_int64(body->volume.high)), (uint32_t)(body->volume.high >> 32)};
  uint64_t carry = 0;
  uint32_t mass[4];
  for (int i = 0; i < 4; i++) {
    carry += gjk_umul32(limb[i], density);  // <= (2^32 - 1)^2 + 2^32 - 1
    mass[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
  // The bits from 48 on, to the nearest.
  const uint64_t rounded = ((uint64_t)mass[2] << 32 | mass[1]) + UINT32_C(0x8000);
  if (carry != 0 || mass[3] != 0 || mass[2] >= UINT32_C(1) << 16 || rounded >> 48 != 0) {
    return GJK_ERROR_RANGE;
  }
  body->mass = (uint32_t)(rounded >> 16);
  return GJK_OK;
}
