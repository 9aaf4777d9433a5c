"""Vectors, poses, shapes and colliders in space. `import gjk` has all of these names."""

import ctypes
import itertools
from ctypes import POINTER, c_int8, c_int32, c_uint8, c_uint16, c_void_p

from ._library import Int32, Q30_ONE, Record, Uint16, Vector, answer, check_sizes, checked, declare, do

__all__ = [
    "Vec3", "Unit3", "Quat", "Pose", "Shape", "Aabb", "Collider",
    "point", "sphere", "segment", "capsule", "triangle", "box", "hull", "cylinder", "cone", "ellipsoid", "custom",
]  # fmt: skip


# Vectors and poses: gjk/format.h, gjk/pose.h.


class Vec3(Vector):
    """A position, offset or half extents, Q16.16."""

    C_NAME = "gjk_vec3"
    _fields_ = [("x", c_int32), ("y", c_int32), ("z", c_int32)]


class Unit3(Vector):
    """A unit vector, Q2.30."""

    C_NAME = "gjk_unit3"
    _fields_ = [("x", c_int32), ("y", c_int32), ("z", c_int32)]


class Quat(Vector):
    """A rotation: the unit quaternion x i + y j + z k + w, Q2.30."""

    C_NAME = "gjk_quat"
    _fields_ = [("x", c_int32), ("y", c_int32), ("z", c_int32), ("w", c_int32)]

    @classmethod
    def from_axis_angle(cls, axis, angle):
        """By an angle about an axis of any length, right-handed."""
        return answer(_from_axis_angle, cls, axis, angle)

    @classmethod
    def from_euler(cls, x, y, z):
        """About fixed x, then fixed y, then fixed z."""
        return answer(_from_euler, cls, x, y, z)

    def normalized(self):
        return answer(_normalize, Quat, self)

    def __mul__(self, other):
        """First other, then this rotation."""
        return answer(_compose, Quat, self, other)

    def inverse(self):
        return answer(_invert, Quat, self)

    def apply(self, vector):
        """The vector, rotated."""
        return answer(_apply, Vec3, self, vector)


Quat.IDENTITY = (0, 0, 0, Q30_ONE)


class Pose(Record):
    """Where a shape stands: rotated about its own origin, then moved by position."""

    C_NAME = "gjk_pose"
    _fields_ = [("position", Vec3), ("rotation", Quat)]

    def __init__(self, position=(0, 0, 0), rotation=Quat.IDENTITY):
        super().__init__(Vec3.of(position), Quat.of(rotation))

    def __mul__(self, other):
        """First other, then this pose."""
        return answer(_pose_compose, Pose, self, other)

    def inverse(self):
        return answer(_pose_invert, Pose, self)

    def apply(self, vector):
        """The world position of a point of this frame."""
        return answer(_pose_apply, Vec3, self, vector)


_from_axis_angle = declare("gjk_quat_from_axis_angle", Vec3, Int32, POINTER(Quat))
_from_euler = declare("gjk_quat_from_euler", Int32, Int32, Int32, POINTER(Quat))
_normalize = declare("gjk_quat_normalize", Quat, POINTER(Quat))
_compose = declare("gjk_quat_compose", Quat, Quat, POINTER(Quat))
_invert = declare("gjk_quat_invert", Quat, POINTER(Quat))
_apply = declare("gjk_quat_apply", Quat, Vec3, POINTER(Vec3))
_pose_compose = declare("gjk_pose_compose", POINTER(Pose), POINTER(Pose), POINTER(Pose))
_pose_invert = declare("gjk_pose_invert", POINTER(Pose), POINTER(Pose))
_pose_apply = declare("gjk_pose_apply", POINTER(Pose), Vec3, POINTER(Vec3))


# Shapes: gjk/shape.h, gjk/bind.h. radius is the convex radius around the core.


class HullFaces(Record):
    C_NAME = "gjk_hull_faces"
    _fields_ = [("corner", POINTER(c_uint16)), ("end", POINTER(c_uint16)), ("count", c_uint16)]

    def lists(self):
        """Of each face the numbers of its vertices."""
        ends = self.end[: self.count]
        return [self.corner[start:end] for start, end in zip([0] + ends, ends)]


_SUPPORT = ctypes.CFUNCTYPE(None, c_void_p, POINTER(Vec3), POINTER(Vec3))


class Shape(Record):
    """Geometry in its own frame. One of the functions below makes it; do not write to it."""

    C_NAME = "gjk_shape"
    _fields_ = [
        ("type", c_void_p),
        ("vertices", POINTER(Vec3)),
        ("support", c_void_p),
        ("user", c_void_p),
        ("size", Vec3),
        ("convex_radius", c_int32),
        ("count", c_uint16),
        ("faces", c_void_p),
    ]

    def polyhedron(self):
        """The vertices of a hull, and its faces or None, as hull() takes them."""
        vertices, faces = self.keep
        return [tuple(vertex) for vertex in vertices], faces.lists() if faces is not None else None


def _shape(function, *arguments, keep=None):
    shape = answer(function, Shape, *arguments)
    shape.keep = keep  # what the shape points to
    return shape


def point():
    return _shape(_point, 0)


def sphere(radius):
    return _shape(_point, radius)


def segment(half):
    """From (0, 0, -half) to (0, 0, half)."""
    return _shape(_segment, half, 0)


def capsule(radius, half):
    """half: of the straight part's length, along z."""
    return _shape(_segment, half, radius)


def triangle(vertices, radius=0):
    vertices = Vec3.array(vertices)
    if len(vertices) != 3:
        raise ValueError("a triangle has three vertices")
    return _shape(_triangle, vertices, radius, keep=vertices)


def box(half_x, half_y, half_z, radius=0):
    return _shape(_box, half_x, half_y, half_z, radius)


def hull(vertices, faces=None, radius=0):
    """The convex hull of vertices in any order.

    faces: of each face the numbers of its vertices, counterclockwise seen from outside; only contacts need them.
    """
    vertices = Vec3.array(vertices)
    keep = vertices, hull_faces(faces) if faces is not None else None
    return _shape(_hull, vertices, len(vertices), keep[1], radius, keep=keep)


def hull_faces(faces):
    """The faces of a hull as the library takes them."""
    ends = list(itertools.accumulate(map(len, faces)))
    corners = [checked(n, "vertex", 0, 65535) for n in itertools.chain.from_iterable(faces)]
    return HullFaces((c_uint16 * len(corners))(*corners), (c_uint16 * len(ends))(*ends), len(ends))


def cylinder(base_radius, half, radius=0):
    """From z = -half to z = half."""
    return _shape(_cylinder, base_radius, half, radius)


def cone(base_radius, half, radius=0):
    """Apex at z = half, base at z = -half."""
    return _shape(_cone, base_radius, half, radius)


def ellipsoid(radius_x, radius_y, radius_z, radius=0):
    return _shape(_ellipsoid, radius_x, radius_y, radius_z, radius)


def custom(support, bound, radius=0):
    """A shape by its support function: support(direction) is a point of it that is farthest along a Vec3.

    bound: all its points are at most this far from the local origin. If the function raises, the exception is printed,
    and the local origin taken.
    """

    def call(_, direction, out):
        out[0] = Vec3.of(support(direction[0]))

    keep = _SUPPORT(call)
    return _shape(_custom, keep, None, bound, radius, keep=keep)


_point = declare("gjk_shape_point", Int32, POINTER(Shape))
_segment = declare("gjk_shape_segment", Int32, Int32, POINTER(Shape))
_triangle = declare("gjk_shape_triangle", POINTER(Vec3), Int32, POINTER(Shape))
_box = declare("gjk_shape_box", Int32, Int32, Int32, Int32, POINTER(Shape))
_hull = declare("gjk_shape_hull", POINTER(Vec3), Uint16, POINTER(HullFaces), Int32, POINTER(Shape))
_cylinder = declare("gjk_shape_cylinder", Int32, Int32, Int32, POINTER(Shape))
_cone = declare("gjk_shape_cone", Int32, Int32, Int32, POINTER(Shape))
_ellipsoid = declare("gjk_shape_ellipsoid", Int32, Int32, Int32, Int32, POINTER(Shape))
_custom = declare("gjk_shape_custom", _SUPPORT, c_void_p, Int32, Int32, POINTER(Shape))


# Colliders: gjk/collider.h.


class Aabb(Record):
    """An axis-aligned bounding box, both corners inclusive."""

    C_NAME = "gjk_aabb"
    _fields_ = [("lower", Vec3), ("upper", Vec3)]


class Collider(Record):
    """A shape at a pose. baked: the posed vertices of a hull are kept, which is faster; the answers are the same.

    centre and radius, of a sphere around the shape, may be read; the other fields are the library's.
    """

    C_NAME = "gjk_collider"
    _fields_ = [
        ("shape_pointer", c_void_p),
        ("buffer_pointer", c_void_p),
        ("position", Vec3),
        ("centre", Vec3),
        ("local_centre", Vec3),
        ("frame", Vec3 * 3),
        ("core_radius", c_int32),
        ("radius", c_int32),
        ("state", c_uint16),
        ("count", c_uint16),
        ("bits", c_uint8),
        ("fraction", c_int8 * 3),
    ]

    def __init__(self, shape, pose=None, baked=True):
        super().__init__()
        self.shape = shape
        self.buffer = (Vec3 * shape.count)() if baked and shape.count > 0 else None
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


_collider_init = declare("gjk_collider_init", POINTER(Collider), POINTER(Shape), POINTER(Vec3), Uint16)
_collider_pose = declare("gjk_collider_pose", POINTER(Collider), POINTER(Pose))
_collider_move = declare("gjk_collider_move", POINTER(Collider), Vec3)
_collider_aabb = declare("gjk_collider_aabb", POINTER(Collider), POINTER(Aabb))

check_sizes(globals())
