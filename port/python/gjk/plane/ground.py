"""Ground of the plane: chains, height profiles and grids of tiles. `gjk.plane` has all of these names."""

import ctypes
from ctypes import POINTER, c_bool, c_int16, c_int32, c_uint8, c_uint16, c_uint32, c_void_p

from .._library import Error, Int32, Record, Status, Uint16, answer, check_sizes, checked, constant, declare, do
from .bodies import Collider, Pose, Shape, Vec
from .queries import CastPath, CastResult, DistanceResult, Manifold, cast_path

__all__ = ["ChainContact", "Ground", "Tile", "chain", "heights", "tiles"]


class ChainContact(Record):
    """The contacts of a body with a segment, or with a joint: of the segment of that number a Manifold."""

    C_NAME = "gjk2_chain_contact"
    _fields_ = [("segment", c_uint32), ("manifold", Manifold)]


class Tile(Record):
    """A form of tile, solid below a surface from left to right: heights in quarters, then so many quarter turns.

    one_way: the surface alone.
    """

    C_NAME = "gjk2_tile"
    _fields_ = [("left", c_uint8), ("right", c_uint8), ("turns", c_uint8), ("one_way", c_bool)]


class _Data(Record):
    C_NAME = "gjk2_ground"
    _fields_ = [("type", c_void_p), ("data", c_void_p), ("centre", Vec)]


class _IndexBox(Record):
    C_NAME = "gjk2_index_box"
    _fields_ = [(name, c_uint16) for name in ("lower_x", "lower_y", "upper_x", "upper_y")]


class _Index(Record):
    C_NAME = "gjk2_index"
    _fields_ = [
        ("boxes", POINTER(_IndexBox)),
        ("count", c_uint16),
        ("segments", c_uint16),
        ("shift", c_uint8),
        ("corner", Vec),
    ]


class _Polyline(Record):
    C_NAME = "gjk2_polyline"
    _fields_ = [("vertices", POINTER(Vec)), ("count", c_uint16), ("index", POINTER(_Index))]


class _Heights(Record):
    C_NAME = "gjk2_heights"
    _fields_ = [("heights", POINTER(c_int16)), ("count", c_uint16), ("width", c_int32), ("shift", c_uint8)]


class _Tiles(Record):
    C_NAME = "gjk2_tiles"
    _fields_ = [
        ("cells", POINTER(c_uint8)),
        ("columns", c_uint16),
        ("rows", c_uint16),
        ("size", c_int32),
        ("form_count", c_uint8),
        ("forms", POINTER(Tile)),
    ]


class Ground:
    """Ground, in its own frame; one of the functions below makes it. shape: for the list of shapes of a Scene.

    cells: of a grid, an array to read and to write. After a write, Scene.refilter tells each scene of it.
    Queries are of ground at a pose; None: where it was made. A is the ground, B the body, a Collider.
    """

    def __init__(self, make, data, cells=None):
        self.cells, self._data, self._ground, self.shape = cells, data, _Data(), Shape()
        do(make, data, self._ground, self.shape)
        self.shape.keep = self

    def within(self, body, distance=0, pose=None):
        """Is a segment that counts for the body at most so far away?"""
        return answer(_within, c_bool, self._ground, pose or Pose(), body, distance).value

    def distance(self, body, pose=None):
        """The number of the nearest segment that counts and its DistanceResult; None: there is none."""
        result, segment, found = DistanceResult(), c_uint32(), c_bool()
        do(_distance, self._ground, pose or Pose(), body, result, segment, found)
        return (segment.value, result) if found else None

    def contacts(self, body, margin=0, pose=None):
        """A list of ChainContact."""
        room, count, status = 16, c_uint16(), Status.CAPACITY
        while status == Status.CAPACITY:
            room *= 2
            out = (ChainContact * room)()
            status = _contacts(self._ground, pose or Pose(), body, margin, out, room, count)
        if status != Status.OK:
            raise Error(status)
        return out[: count.value]

    def cast(self, body, to=None, to_ground=None, margin=0, pose=None):
        """The number of the segment that a body meets first on a straight way, and its CastResult; None: none."""
        return self._first(_cast, pose or Pose(), body, cast_path(to_ground, to, margin))

    def cast_ray(self, start, end, pose=None):
        """Where a ray enters from the outside: the segment's number and its CastResult; None: nowhere."""
        return self._first(_cast_ray, pose or Pose(), start, end)

    def _first(self, function, *arguments):
        result, segment = CastResult(), c_uint32()
        do(function, self._ground, *arguments, result, segment)
        return (segment.value, result) if result.hit else None


def chain(vertices):
    """Segments from each vertex to the next, the outside to their right: ground runs from right to left."""
    vertices = Vec.array(vertices)
    data = _Polyline(vertices, len(vertices))
    boxes, index = (_IndexBox * (len(vertices) // 3 + 8))(), _Index()  # GJK2_INDEX_BOXES
    do(_index_build, data, boxes, len(boxes), index)
    data.index, data.keep = ctypes.pointer(index), boxes
    return Ground(_of_chain, data)


def heights(heights, width, shift=0):
    """A profile of columns of that width: vertex i is heights[i] 2^shift high; None: a hole."""
    hole = constant("GJK2_HOLE")
    numbers = [hole if height is None else checked(height, "int16", hole, -hole - 1) for height in heights]
    heights = (c_int16 * len(numbers))(*numbers)
    return Ground(_of_heights, _Heights(heights, len(heights), width, shift))


def tiles(cells, columns, size, forms):
    """A grid of square tiles, the bottom row first, as bytes or numbers.

    forms: a dict that has a Tile for some numbers or characters; other cells are empty.
    """
    numbers = {ord(key) if isinstance(key, str) else key: tile for key, tile in forms.items()}
    table = (Tile * (max(numbers, default=-1) + 1))()
    for number, tile in numbers.items():
        table[number] = tile
    cells = (c_uint8 * len(cells)).from_buffer_copy(bytes(cells))
    if columns < 1 or len(cells) % columns != 0:
        raise ValueError(f"{len(cells)} cells are no rows of {columns}")
    return Ground(_of_tiles, _Tiles(cells, columns, len(cells) // columns, size, len(table), table), cells)


_MADE = POINTER(_Data), POINTER(Shape)
_AT = POINTER(_Data), POINTER(Pose)
_BODY = *_AT, POINTER(Collider)
_of_chain = declare("gjk2_ground_of_chain", POINTER(_Polyline), *_MADE)
_of_heights = declare("gjk2_ground_of_heights", POINTER(_Heights), *_MADE)
_of_tiles = declare("gjk2_ground_of_tiles", POINTER(_Tiles), *_MADE)
_index_build = declare("gjk2_index_build", POINTER(_Polyline), POINTER(_IndexBox), Uint16, POINTER(_Index))
_within = declare("gjk2_ground_within", *_BODY, Int32, POINTER(c_bool))
_distance = declare("gjk2_ground_distance", *_BODY, POINTER(DistanceResult), POINTER(c_uint32), POINTER(c_bool))
_contacts = declare("gjk2_ground_contacts", *_BODY, Int32, POINTER(ChainContact), Uint16, POINTER(c_uint16))
_cast = declare("gjk2_ground_cast", *_BODY, POINTER(CastPath), POINTER(CastResult), POINTER(c_uint32))
_cast_ray = declare("gjk2_ground_cast_ray", *_AT, Vec, Vec, POINTER(CastResult), POINTER(c_uint32))

check_sizes(globals())
