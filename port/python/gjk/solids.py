"""Convex hulls of points, and masses. `import gjk` has all of these names."""

import ctypes
import enum
from ctypes import POINTER, c_int16, c_int64, c_size_t, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p

from ._library import Record, Uint16, Uint32, answer, check_sizes, declare, do, library
from .bodies import HullFaces, Pose, Quat, Shape, Vec3, hull, hull_faces

__all__ = ["HullFault", "Mass", "hull_build", "hull_check", "hull_simplify", "mass"]


# Hulls: gjk/hull.h.


class _Hull(Record):
    C_NAME = "gjk_hull"
    _fields_ = [
        ("dimension", c_uint8),
        ("vertices", c_uint16),
        ("faces", c_uint32),
        ("edges", c_uint32),
        ("corners", c_uint32),
        ("most_corners", c_uint16),
        ("points", POINTER(Vec3)),
        ("workspace", c_void_p),
        ("count", c_uint32),
        ("distinct", c_uint32),
        ("triangles", c_uint32),
    ]


class _HullSimple(Record):
    C_NAME = "gjk_hull_simple"
    _fields_ = [("vertices", c_uint16), ("excess", c_uint32)]


class HullFault(enum.IntEnum):
    """HullReport.fault: gjk_hull_fault."""

    SOUND = 0
    FEW = 1
    NUMBER = 2
    BENT = 3
    TURN = 4
    BEYOND = 5
    OPEN = 6
    DOUBLED = 7
    LAYERS = 8


class HullReport(Record):
    C_NAME = "gjk_hull_report"
    _fields_ = [("fault", c_uint8), ("face", c_uint16), ("corner", c_uint16), ("vertex", c_uint16)]


_FACE_ROOM = 65535  # corners, and faces, that a shape can have


def hull_build(points, radius=0, faces=True):
    """The convex hull of points in any order, exactly: a Shape, with its faces unless they are not wanted.

    Its vertices and faces are those that hull() takes: shape.polyhedron() has them. Points in a line have no faces.
    """
    points = Vec3.array(points)
    workspace = (c_uint32 * (library.gjk_hull_workspace(len(points)) // 4))()
    built = answer(_build, _Hull, points, len(points), workspace, ctypes.sizeof(workspace))
    vertices = (Vec3 * built.vertices)()
    do(_vertices, built, vertices, len(vertices))
    if not faces or built.dimension < 2:
        return hull(vertices, radius=radius)
    corner, end = (c_uint16 * _FACE_ROOM)(), (c_uint16 * _FACE_ROOM)()
    written = answer(_write_faces, HullFaces, built, corner, _FACE_ROOM, end, _FACE_ROOM)
    return hull(vertices, written.lists(), radius)


def hull_simplify(points, most):
    """At most so many vertices whose hull encloses the points, and how far it is beyond theirs at most, in LSB."""
    points = Vec3.array(points)
    workspace = (c_uint32 * (library.gjk_hull_simplify_workspace(len(points)) // 4))()
    vertices = (Vec3 * most)()
    simple = answer(
        _simplify, _HullSimple, points, len(points), most, workspace, ctypes.sizeof(workspace), vertices
    )  # fmt: skip
    return vertices[: simple.vertices], simple.excess


def hull_check(vertices, faces):
    """What is wrong with the faces of a hull? A HullReport; its fault is SOUND, 0, where nothing is."""
    vertices = Vec3.array(vertices)
    return answer(_check, HullReport, vertices, len(vertices), hull_faces(faces))


library.gjk_hull_workspace.restype = library.gjk_hull_simplify_workspace.restype = c_uint32
library.gjk_hull_workspace.argtypes = library.gjk_hull_simplify_workspace.argtypes = [Uint32]
_build = declare("gjk_hull_build", POINTER(Vec3), Uint16, c_void_p, c_size_t, POINTER(_Hull))
_vertices = declare("gjk_hull_vertices", POINTER(_Hull), POINTER(Vec3), Uint16)
_write_faces = declare(
    "gjk_hull_write_faces", POINTER(_Hull), POINTER(c_uint16), Uint16, POINTER(c_uint16), Uint16, POINTER(HullFaces)
)
_simplify = declare(
    "gjk_hull_simplify", POINTER(Vec3), Uint16, Uint16, c_void_p, c_size_t, POINTER(Vec3), POINTER(_HullSimple)
)
_check = declare("gjk_hull_check", POINTER(Vec3), Uint16, POINTER(HullFaces), POINTER(HullReport))


# Masses: gjk/mass.h.


class Volume(Record):
    """Cubic LSB; int() of it is the number."""

    C_NAME = "gjk_volume"
    _fields_ = [("high", c_uint64), ("low", c_uint64)]

    def __int__(self):
        return self.high << 64 | self.low


class Inertia(Record):
    C_NAME = "gjk_inertia"
    _fields_ = [(name, c_int64) for name in ("xx", "yy", "zz", "yz", "zx", "xy")]


class Principal(Record):
    """The principal axes of a body, and the moments about them for a mass of 1."""

    C_NAME = "gjk_principal"
    _fields_ = [("rotation", Quat), ("moment", c_int64 * 3)]


class Mass(Record):
    """The mass properties of a shape or body. Mass() has no parts yet: add() them. inertia is for a mass of 1."""

    C_NAME = "gjk_mass"
    _fields_ = [
        ("volume", Volume),
        ("mass", c_uint32),
        ("centre", Vec3),
        ("fraction", c_int16 * 3),
        ("inertia", Inertia),
    ]

    def set_density(self, density):
        """Sets the mass: the volume times a density, Q16.16 of a unit of mass per cubic unit."""
        do(_set_density, self, density)

    def add(self, part, pose=None):
        """Adds a part, whose mass is set, at a pose."""
        do(_mass_add, self, part, pose if pose is not None else Pose())

    def principal(self):
        """A Principal."""
        return answer(_principal, Principal, self)


def mass(shape, density=None):
    """The volume, centre and inertia of a shape, exactly, and its mass if a density is given: a Mass."""
    of_shape = answer(_of_shape, Mass, shape)
    if density is not None:
        of_shape.set_density(density)
    return of_shape


_of_shape = declare("gjk_mass_of_shape", POINTER(Shape), POINTER(Mass))
_set_density = declare("gjk_mass_set_density", POINTER(Mass), Uint32)
_principal = declare("gjk_mass_principal", POINTER(Mass), POINTER(Principal))
_mass_add = declare("gjk_mass_add", POINTER(Mass), POINTER(Mass), POINTER(Pose))

check_sizes(globals())
