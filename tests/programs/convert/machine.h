// A robot as a machine of gjk/arm.h: in fixed point, its shapes enclosed.
//
// Enclosed   Boxes, balls and cylinders are rounded up, together with what their place is rounded by. The corners of a
//            mesh are moved into the link's frame and rounded. Where any of them is no whole LSB the hull has a convex
//            radius of 1 LSB: a corner moves by sqrt(3)/2 at most. So in its link's frame each shape encloses that of
//            the file. The roundings of double, below 2^-20 LSB, are not counted.
// Rounded    Offsets, axes, turns and limits of joints, to the nearest. A limit beyond int32 is none.
// Order      Links: robot.h. Parts: those of the first link first, each link's in the order of the file.
#ifndef MACHINE_H
#define MACHINE_H

#include "decompose.h"
#include "gjk/arm.h"
#include "robot.h"

enum { MACHINE_SAMPLES = 2000 };

typedef struct machine_options {
  double scale;           // LSB a metre
  int vertices;           // of a mesh at most, enclosing it; -1: as many as there are
  bool parts;             // meshes as convex parts where they bound a solid, else one hull
  decompose_options how;  // of these parts
} machine_options;

typedef struct machine {
  const robot *from;
  const machine_options *how;
  xml_reader *r;  // of the robot's file, for messages
  unsigned links, parts, values;
  unsigned number[GJK_ARM_LINKS_MAX];            // of the robot's link
  char name[GJK_ARM_LINKS_MAX][ROBOT_NAME + 4];  // of the link, without what a case cannot hold; no two are equal
  gjk_arm_link link[GJK_ARM_LINKS_MAX];
  gjk_arm_part part[GJK_ARM_PARTS_MAX];
  gjk_shape shape[GJK_ARM_PARTS_MAX];
  robot_geometry geometry[GJK_ARM_PARTS_MAX];
  uint32_t never[GJK_ARM_LINKS_MAX];
  bool sampled;                       // never comes from samples
  uint32_t apart[GJK_ARM_LINKS_MAX];  // no sample touched; they are tested all the same
  size_t vertices;                    // of all parts
} machine;

// Makes a machine. pairs: b->never is what is never tested; else it is found by samples. False: r->problem has the
// message.
bool machine_make(machine *m, robot *b, bool pairs, const machine_options *how, xml_reader *r);

void machine_free(machine *m);

gjk_arm_model machine_model(const machine *m);

// Takes MACHINE_SAMPLES configurations within the limits; values without one are up to 3.14 either way.
// Pairs of links that touch in all of them go into never, those that touch in none into apart. Links that are joined
// through links without shapes go into never, too.
void machine_sample(machine *m);

// A mesh's hull, or its convex parts. False: r->problem has the message.
bool machine_add_mesh(machine *m, const robot_shape *s, unsigned link);

// Adds a part. False: there are too many, or the library refuses its shape.
bool machine_add_part(machine *m, const robot_shape *s, unsigned link, const gjk_shape *shape, const gjk_pose *pose);

// The matrix of turns about fixed x, y, z.
void machine_matrix(const double rpy[3], double out[3][3]);

// Words without blanks or signs that mean something in C or in a case.
void machine_word(const char *text, char *out, size_t room);

#endif
