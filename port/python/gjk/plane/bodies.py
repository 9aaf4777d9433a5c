"""Vectors, poses, shapes and colliders in the plane. `gjk.plane` has all of these names."""

import ctypes
from ctypes import POINTER, c_bool, c_int8, c_int32, c_uint16, c_void_p

from .._library import Int32, Q30_ONE, Record, Uint16, Vector, answer, check_sizes, declare, do

__all__ = [
    "Vec", "Unit", "Rotation", "Pose", "Shape", "Aabb", "Collider",
    "point", "circle", "segment", "capsule", "triangle", "box", "polygon", "ellipse", "custom", "corners",
]  # fmt: skip


# Vectors and poses: gjk2/format.h, gjk2/pose.h.


class Vec(Vector):
    """A position, offset or half extents, Q16.16."""

    C_NAME = "gjk2_vec"
    _fields_ = [("x", c_int32), ("y", c_int32)]


class Unit(Vector):
    """A unit vector, Q2.30."""

    C_NAME = "gjk2_unit"
    _fields_ = [("x", c_int32), ("y", c_int32)]


class Rotation(Vector):
    """A rotation by cosine and sine, Q2.30."""

    C_NAME = "gjk2_rotation"
    _fields_ = [("c", c_int32), ("s", c_int32)]

    @classmethod
    def from_angle(cls, angle):
        return answer(_from_angle, cls, angle)

    def normalized(self):
        return answer(_normalize, Rotation, self)

    def __mul__(self, other):
        """First other, then this rotation."""
        return answer(_compose, Rotation, self, other)

    def inverse(self):
        return answer(_invert, Rotation, self)

    def apply(self, vector):
        """The vector, rotated."""
        return answer(_apply, Vec, self, vector)


Rotation.IDENTITY = (Q30_ONE, 0)


class Pose(Record):
    """Where a shape stands: rotated about its own origin, then moved by position."""

    C_NAME = "gjk2_pose"
    _fields_ = [("position", Vec), ("rotation", Rotation)]

    def __init__(self, position=(0, 0), rotation=Rotation.IDENTITY):
        super().__init__(Vec.of(position), Rotation.of(rotation))

    def __mul__(self, other):
        """First other, then this pose."""
        return answer(_pose_compose, Pose, self, other)

    def inverse(self):
        return answer(_pose_invert, Pose, self)

    def apply(self, vector):
        """The world position of a point of this frame."""
        return answer(_pose_apply, Vec, self, vector)


_from_angle = declare("gjk2_rotation_from_angle", Int32, POINTER(Rotation))
_normalize = declare("gjk2_rotation_normalize", Rotation, POINTER(Rotation))
_compose = declare("gjk2_rotation_compose", Rotation, Rotation, POINTER(Rotation))
_invert = declare("gjk2_rotation_invert", Rotation, POINTER(Rotation))
_apply = declare("gjk2_rotation_apply", Rotation, Vec, POINTER(Vec))
_pose_compose = declare("gjk2_pose_compose", POINTER(Pose), POINTER(Pose), POINTER(Pose))
_pose_invert = declare("gjk2_pose_invert", POINTER(Pose), POINTER(Pose))
_pose_apply = declare("gjk2_pose_apply", POINTER(Pose), Vec, POINTER(Vec))


# Shapes: gjk2/shape.h, gjk2/bind.h. radius is the convex radius around the core.


_SUPPORT = ctypes.CFUNCTYPE(None, c_void_p, POINTER(Vec), POINTER(Vec))


class Shape(Record):
    """Geometry in its own frame. One of the functions below makes it; do not write to it."""

    C_NAME = "gjk2_shape"
    _fields_ = [
        ("type", c_void_p),
        ("vertices", POINTER(Vec)),
        ("support", c_void_p),
        ("user", c_void_p),
        ("size", Vec),
        ("convex_radius", c_int32),
        ("count", c_uint16),
    ]


def _shape(function, *arguments, keep=None):
    shape = answer(function, Shape, *arguments)
    shape.keep = keep  # what the shape points to
    return shape


def point():
    return _shape(_point, 0)


def circle(radius):
    return _shape(_point, radius)


def segment(half):
    """From (-half, 0) to (half, 0)."""
    return _shape(_segment, half, 0)


def capsule(radius, half):
    """half: of the straight part's length, along x."""
    return _shape(_segment, half, radius)


def triangle(vertices, radius=0):
    vertices = Vec.array(vertices)
    if len(vertices) != 3:
        raise ValueError("a triangle has three vertices")
    return _shape(_triangle, vertices, radius, keep=vertices)


def box(half_x, half_y, radius=0):
    return _shape(_box, half_x, half_y, radius)


def polygon(vertices, radius=0):
    """The convex hull of vertices in any order."""
    vertices = Vec.array(vertices)
    return _shape(_polygon, vertices, len(vertices), radius, keep=vertices)


def corners(points):
    """The corners of the convex hull of points, counterclockwise from the lowest on: gjk2/polygon.h."""
    points = Vec.array(points)
    count = c_uint16()
    do(_polygon_order, points, len(points), points, count)
    return points[: count.value]


def ellipse(radius_x, radius_y, radius=0):
    return _shape(_ellipse, radius_x, radius_y, radius)


def custom(support, bound, radius=0):
    """A shape by its support function: support(direction) is a point of it that is farthest along a Vec.

    bound: all its points are at most this far from the local origin. If the function raises, the exception is printed,
    and the local origin taken.
    """

    def call(_, direction, out):
        out[0] = Vec.of(support(direction[0]))

    keep = _SUPPORT(call)
    return _shape(_custom, keep, None, bound, radius, keep=keep)


_point = declare("gjk2_shape_point", Int32, POINTER(Shape))
_segment = declare("gjk2_shape_segment", Int32, Int32, POINTER(Shape))
_triangle = declare("gjk2_shape_triangle", POINTER(Vec), Int32, POINTER(Shape))
_box = declare("gjk2_shape_box", Int32, Int32, Int32, POINTER(Shape))
_polygon = declare("gjk2_shape_polygon", POINTER(Vec), Uint16, Int32, POINTER(Shape))
_polygon_order = declare("gjk2_polygon_order", POINTER(Vec), Uint16, POINTER(Vec), POINTER(c_uint16))
_ellipse = declare("gjk2_shape_ellipse", Int32, Int32, Int32, POINTER(Shape))
_custom = declare("gjk2_shape_custom", _SUPPORT, c_void_p, Int32, Int32, POINTER(Shape))


# Colliders: gjk2/collider.h.


class Aabb(Record):
    """An axis-aligned bounding box, both corners inclusive."""

    C_NAME = "gjk2_aabb"
    _fields_ = [("lower", Vec), ("upper", Vec)]


class Collider(Record):
    """A shape at a pose. baked: the posed vertices of a polygon are kept, which is faster; the answers are the same.

    centre and radius, of a circle around the shape, may be read; the other fields are the library's.
    """

    C_NAME = "gjk2_collider"
    _fields_ = [
        ("shape_pointer", c_void_p),
        ("buffer_pointer", c_void_p),
        ("position", Vec),
        ("centre", Vec),
        ("local_centre", Vec),
        ("frame", Vec * 3),
        ("core_radius", c_int32),
        ("radius", c_int32),
        ("state", c_uint16),
        ("count", c_uint16),
        ("fraction", c_int8 * 2),
        ("ordered", c_bool),
    ]

    def __init__(self, shape, pose=None, baked=True):
        super().__init__()
        self.shape = shape
        self.buffer = (Vec * shape.count)() if baked and shape.count > 0 else None
        do(_collider_init, self, shape, self.buffer, shape.count)
        self.pose(pose if pose is not None else Pose())

    def pose(self, pose):
        """Places the collider."""
        do(_collider_pose, self, pose)

    def move(self, position):
        """Moves the collider, keeping its rotation."""
        do(_collider_move, self, position)

    def aabb(self):
        """Its bounding box, convex radius included."""
        return answer(_collider_aabb, Aabb, self)


_collider_init = declare("gjk2_collider_init", POINTER(Collider), POINTER(Shape), POINTER(Vec), Uint16)
_collider_pose = declare("gjk2_collider_pose", POINTER(Collider), POINTER(Pose))
_collider_move = declare("gjk2_collider_move", POINTER(Collider), Vec)
_collider_aabb = declare("gjk2_collider_aabb", POINTER(Collider), POINTER(Aabb))

check_sizes(globals())
