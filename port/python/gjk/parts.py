"""Bodies of many convex parts: compounds, meshes, height fields. `import gjk` has all of these names."""

import ctypes
import enum
import itertools
from ctypes import POINTER, c_bool, c_int16, c_int32, c_uint8, c_uint16, c_uint32, c_void_p

from ._library import Error, Int32, Record, Status, Uint16, Uint32, Unsigned
from ._library import answer, check_sizes, checked, constant, declare, do, library
from .bodies import Aabb, Collider, Pose, Shape, Vec3
from .queries import CastPath, CastResult, Decision, DistanceResult, Manifold, PenetrationResult, Workspace, cast_path

__all__ = ["Compound", "HeightField", "Mesh", "MeshFault", "Parts", "PartsManifold", "concave", "mesh_check"]

_NONE = constant("GJK_PARTS_NONE")
_HOLE = constant("GJK_HEIGHT_HOLE")


# Queries: gjk/parts.h.


class PartsManifold(Record):
    """The contacts of one part."""

    C_NAME = "gjk_parts_manifold"
    _fields_ = [("part", c_uint32), ("part_of_b", c_uint32), ("manifold", Manifold)]


class _Room(Record):
    C_NAME = "gjk_parts_room"
    _fields_ = [("shape", Shape), ("vertices", Vec3 * 4)]


class Parts(Record):
    """A body of many parts at a pose, which may be set. Its parts count from 0; len() says how many there are.

    Queries take it as A, and a Collider as B. They answer as those of pairs; the part of an answer is its number, or
    None.
    """

    C_NAME = "gjk_parts"
    _fields_ = [("type", c_void_p), ("data", c_void_p), ("pose", Pose)]

    def _bind(self, bind, data, pose, *keep):
        do(bind, data, self)
        self.keep = data, keep  # what the body points to
        if pose is not None:
            self.pose = pose

    def __len__(self):
        return library.gjk_parts_count(self)

    def place(self, part):
        """The Collider of one part: the very one that queries ask, and that proofs take."""
        room, collider = _Room(), Collider.__new__(Collider)
        do(_place, self, part, room, collider)
        collider.shape = room, self
        return collider

    def intersect(self, b):
        """Does some part share a point with B? A Decision."""
        return _of_part(_intersect, Decision, self, b)

    def within(self, b, most):
        """Is some part at most so far from B? A Decision."""
        return _of_part(_within, Decision, self, b, most)

    def distance(self, b):
        """How far is the nearest part, and where? A DistanceResult."""
        return _of_part(_distance, DistanceResult, self, b)

    def penetration(self, b, workspace=None):
        """How deep is the deepest part, which way out, where? A PenetrationResult."""
        return _of_part(_penetration, PenetrationResult, self, b, workspace or Workspace())

    def contacts(self, b, margin=0, most=4, workspace=None):
        """The contacts of each part that is at most margin away: a list of PartsManifold."""
        workspace = workspace or Workspace()
        count = c_uint32(16)
        while True:
            room = (PartsManifold * count.value)()
            status = _contacts(self, b, margin, most, workspace, room, len(room), count)
            if count.value <= len(room):
                break
        if status != Status.OK:
            raise Error(status, room[: count.value])
        return room[: count.value]

    def manifolds(self, b, margin=0, most=4, workspace=None):
        """The contacts of all parts, put together by their normals: a list of up to 8 Manifold, the deepest first.

        What a solver takes. Normals of meshes and height fields are those of the surface.
        """
        room, count = (Manifold * constant("GJK_PARTS_MANIFOLDS_MAX"))(), ctypes.c_uint()
        status = _manifolds(self, b, margin, most, workspace or Workspace(), room, len(room), count)
        if status != Status.OK:
            raise Error(status, room[: count.value])
        return room[: count.value]

    def cast_ray(self, start, end):
        """Which part does a ray enter first, and where? A CastResult."""
        return _of_part(_cast_ray, CastResult, self, start, end)

    def cast(self, b, to_a=None, to_b=None, margin=0):
        """Which part is met first, on straight ways of the body and of B to these positions? A CastResult."""
        return _of_part(_cast, CastResult, self, b, cast_path(to_a, to_b, margin))


def _of_part(function, result, *arguments):
    """Calls a function that answers about one part: its result, with the number of the part."""
    part, out = c_uint32(_NONE), result()
    status = function(*arguments, part, out)
    out.part = part.value if part.value != _NONE else None
    if status != Status.OK:
        raise Error(status, out)
    return out


_PAIR = POINTER(Parts), POINTER(Collider)
_NUMBER = POINTER(c_uint32)
library.gjk_parts_count.restype = c_uint32
library.gjk_parts_count.argtypes = [POINTER(Parts)]
_place = declare("gjk_parts_place", POINTER(Parts), Uint32, POINTER(_Room), POINTER(Collider))
_intersect = declare("gjk_parts_intersect", *_PAIR, _NUMBER, POINTER(Decision))
_within = declare("gjk_parts_within", *_PAIR, Int32, _NUMBER, POINTER(Decision))
_distance = declare("gjk_parts_distance", *_PAIR, _NUMBER, POINTER(DistanceResult))
_penetration = declare("gjk_parts_penetration", *_PAIR, POINTER(Workspace), _NUMBER, POINTER(PenetrationResult))
_contacts = declare(
    "gjk_parts_contacts", *_PAIR, Int32, Unsigned, POINTER(Workspace), POINTER(PartsManifold), c_uint32, _NUMBER
)
_manifolds = declare(
    "gjk_parts_manifolds", *_PAIR, Int32, Unsigned, POINTER(Workspace), POINTER(Manifold), Unsigned,
    POINTER(ctypes.c_uint),
)  # fmt: skip
_cast_ray = declare("gjk_parts_cast_ray", POINTER(Parts), Vec3, Vec3, _NUMBER, POINTER(CastResult))
_cast = declare("gjk_parts_cast", *_PAIR, POINTER(CastPath), _NUMBER, POINTER(CastResult))


# Compounds: gjk/compound.h.


class _CompoundPart(Record):
    C_NAME = "gjk_compound_part"
    _fields_ = [("shape", POINTER(Shape)), ("pose", Pose)]


class _CompoundNode(Record):
    C_NAME = "gjk_compound_node"
    _fields_ = [("box", Aabb), ("skip", c_uint16), ("part", c_uint16)]


class _Compound(Record):
    C_NAME = "gjk_compound"
    _fields_ = [
        ("parts", POINTER(_CompoundPart)),
        ("nodes", POINTER(_CompoundNode)),
        ("reach", c_uint32),
        ("count", c_uint16),
        ("node_count", c_uint16),
    ]


class Compound(Parts):
    """Several shapes at poses. parts: shapes, and tuples of a shape and its pose in the compound's frame."""

    def __init__(self, parts, pose=None):
        super().__init__()
        parts = [part if isinstance(part, tuple) else (part, Pose()) for part in parts]
        array = (_CompoundPart * len(parts))(*(_CompoundPart(ctypes.pointer(shape), at) for shape, at in parts))
        nodes = (_CompoundNode * library.gjk_compound_nodes(len(parts)))()
        compound = answer(_compound_build, _Compound, array, len(parts), nodes, len(nodes))
        self._bind(_of_compound, compound, pose, parts, array, nodes)


library.gjk_compound_nodes.restype = c_uint32
library.gjk_compound_nodes.argtypes = [Uint32]
_compound_build = declare(
    "gjk_compound_build", POINTER(_CompoundPart), Uint16, POINTER(_CompoundNode), c_uint32, POINTER(_Compound)
)
_of_compound = declare("gjk_parts_of_compound", POINTER(_Compound), POINTER(Parts))


# Meshes: gjk/mesh.h.


class MeshFault(enum.IntEnum):
    """MeshReport.fault: gjk_mesh_fault."""

    SOUND = 0
    NUMBER_FAULT = 1
    COORDINATE = 2
    SIZE = 3
    SHIFT = 4
    BOX = 5
    EDGES = 6
    DEGENERATE = 7
    CROWDED = 8
    TURNED = 9


class MeshReport(Record):
    """edges: how many there are that are concave, flat, convex and open."""

    C_NAME = "gjk_mesh_report"
    _fields_ = [
        ("fault", c_uint8),
        ("edge", c_uint8),
        ("triangle", c_uint32),
        ("node", c_uint32),
        ("edges", c_uint32 * 4),
    ]


class _Triangle(Record):
    C_NAME = "gjk_mesh_triangle"
    _fields_ = [("corner", c_uint32 * 3)]


class _MeshNode(Record):
    C_NAME = "gjk_mesh_node"
    _fields_ = [("lower", c_uint16 * 3), ("upper", c_uint16 * 3)]


class _Mesh(Record):
    C_NAME = "gjk_mesh"
    _fields_ = [
        ("vertices", POINTER(Vec3)),
        ("triangles", POINTER(_Triangle)),
        ("nodes", POINTER(_MeshNode)),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint32),
        ("lower", Vec3),
        ("upper", Vec3),
        ("shift", c_uint8 * 3),
        ("two_sided", c_bool),
    ]


_NUMBERS = 0x0FFFFFFF  # the bits of a corner that are the number of a vertex


class Mesh(Parts):
    """A surface of triangles: three numbers of vertices each, counterclockwise seen from the front.

    Its parts are the triangles in an order of its own: triangle() says which is which. two_sided: contacts are on both
    sides, otherwise in front alone.
    """

    def __init__(self, vertices, triangles, two_sided=False, pose=None):
        super().__init__()
        vertices = Vec3.array(vertices)
        triangles = [tuple(checked(n, "vertex", 0, _NUMBERS) for n in triangle) for triangle in triangles]
        if any(len(triangle) != 3 for triangle in triangles):
            raise ValueError("a triangle has three vertices")
        array = (_Triangle * len(triangles))(*map(_Triangle, triangles))
        nodes = (_MeshNode * library.gjk_mesh_nodes(len(array)))()
        mesh = answer(_mesh_build, _Mesh, vertices, len(vertices), array, len(array), two_sided, nodes, len(nodes))
        self._bind(_of_mesh, mesh, pose, vertices, array, nodes)

    def triangle(self, part):
        """The numbers of the three vertices of a part."""
        if not 0 <= part < len(self):
            raise IndexError(part)
        return [corner & _NUMBERS for corner in self.keep[0].triangles[part].corner]


def mesh_check(mesh):
    """Is a mesh a surface? A MeshReport."""
    return answer(_mesh_check, MeshReport, mesh.keep[0])


library.gjk_mesh_nodes.restype = c_uint32
library.gjk_mesh_nodes.argtypes = [Uint32]
_mesh_build = declare(
    "gjk_mesh_build", POINTER(Vec3), c_uint32, POINTER(_Triangle), c_uint32, c_bool, POINTER(_MeshNode), c_uint32,
    POINTER(_Mesh),
)  # fmt: skip
_mesh_check = declare("gjk_mesh_check", POINTER(_Mesh), POINTER(MeshReport))
_of_mesh = declare("gjk_parts_of_mesh", POINTER(_Mesh), POINTER(Parts))


# Height fields: gjk/height_field.h.


class _HeightField(Record):
    C_NAME = "gjk_height_field"
    _fields_ = [
        ("heights", POINTER(c_int16)),
        ("columns", c_uint16),
        ("rows", c_uint16),
        ("step_x", c_int32),
        ("step_y", c_int32),
        ("step_z", c_int32),
    ]


class HeightField(Parts):
    """Ground. rows: lists of integer heights, None for a hole; height rows[j][i] stands at (i step_x, j step_y), and is
    in steps of step_z."""

    def __init__(self, rows, step_x, step_y, step_z, pose=None):
        super().__init__()
        rows = list(rows)
        columns = len(rows[0]) if rows else 0
        if any(len(row) != columns for row in rows):
            raise ValueError("the rows are not equally long")
        heights = [
            _HOLE if h is None else checked(h, "height", -32767, 32767) for h in itertools.chain.from_iterable(rows)
        ]
        field = _HeightField((c_int16 * len(heights))(*heights), columns, len(rows), step_x, step_y, step_z)
        do(_height_field_check, field)
        self._bind(_of_height_field, field, pose)


_height_field_check = declare("gjk_height_field_check", POINTER(_HeightField))
_of_height_field = declare("gjk_parts_of_height_field", POINTER(_HeightField), POINTER(Parts))


# Concave shapes: gjk/concave.h.


class _Concave(Record):
    C_NAME = "gjk_concave"
    _fields_ = [("parts", Parts), ("centre", Vec3)]


def concave(body):
    """A Compound, Mesh or HeightField as a shape for a Scene, and for nothing else. Its pose does not count."""
    keep, shape = _Concave(), Shape()
    do(_concave_init, body, keep, shape)
    shape.keep = keep, body
    return shape


_concave_init = declare("gjk_concave_init", POINTER(Parts), POINTER(_Concave), POINTER(Shape))

check_sizes(globals())
