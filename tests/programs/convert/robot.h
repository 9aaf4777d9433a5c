// Robots as URDF describes them, in metres and radians, and which of their links SRDF says need no test.
//
// Taken      Of links all <collision> elements; of joints origin, axis and limit, and whether they mimic others. The rest
//            is passed over. rpy turns about fixed x, y, z in this order.
// Refused    With the line: numbers that are none or not finite; names twice or unknown; joints that are neither
//            revolute, continuous, prismatic nor fixed; joints in a circle; more than one link that hangs on nothing.
// Order      After the first link always the one of the file's first joint whose parent is there and whose child is not.
#ifndef ROBOT_H
#define ROBOT_H

#include "xml.h"

enum { ROBOT_NAME = 64, ROBOT_FILE = 512, ROBOT_LINKS_MAX = 256, ROBOT_SHAPES_MAX = 1024, ROBOT_ROOT = -1 };

typedef struct robot_pose {
  double xyz[3], rpy[3];
} robot_pose;

typedef enum robot_kind { ROBOT_FIXED, ROBOT_REVOLUTE, ROBOT_CONTINUOUS, ROBOT_PRISMATIC } robot_kind;

typedef struct robot_joint {
  char name[ROBOT_NAME], parent[ROBOT_NAME], child[ROBOT_NAME];
  unsigned long line;
  robot_kind kind;
  bool mimics;  // another joint
  robot_pose origin;
  double axis[3], lower, upper;
} robot_joint;

typedef struct robot_link {
  char name[ROBOT_NAME];
  unsigned long line;
  int joint;  // that it hangs on, ROBOT_ROOT: on none
} robot_link;

typedef enum robot_geometry { ROBOT_BOX, ROBOT_SPHERE, ROBOT_CYLINDER, ROBOT_MESH } robot_geometry;

typedef struct robot_shape {
  unsigned link;
  unsigned long line;
  robot_geometry geometry;
  robot_pose origin;
  double size[3];         // of a box; radius; radius and length; the mesh's scale
  char file[ROBOT_FILE];  // of the mesh, as it is written
} robot_shape;

typedef struct robot {
  char name[ROBOT_NAME];
  unsigned links, joints, shapes;
  robot_link link[ROBOT_LINKS_MAX];
  robot_joint joint[ROBOT_LINKS_MAX];
  robot_shape shape[ROBOT_SHAPES_MAX];
  unsigned order[ROBOT_LINKS_MAX];               // links, parents before their children
  unsigned ordered;                              // how many of them there are
  bool never[ROBOT_LINKS_MAX][ROBOT_LINKS_MAX];  // SRDF's, of links by their numbers in the file, both ways
} robot;

// Reads URDF. False: r->problem has the message.
bool robot_read(robot *b, xml_reader *r);

// Reads SRDF of a robot that was read.
bool robot_read_pairs(robot *b, xml_reader *r);

// The number of a link. False: there is none.
bool robot_find(const robot *b, const char *name, unsigned *link);

// The parent of a link that hangs on a joint.
unsigned robot_parent(const robot *b, unsigned link);

// Leaves out of the order the links that a fixed joint holds and that carry nothing, until there are so few.
void robot_leave_out(robot *b, unsigned most);

#endif
