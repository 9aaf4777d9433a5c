"""Arms and other machines of links and joints, and whole motions of them. `import gjk` has all of these names.

    arm = gjk.Arm.from_urdf("robot.urdf", "robot.srdf")
    arm.obstacles([(gjk.box(q16(0.1), q16(0.1), q16(0.5)), gjk.Pose((q16(0.6), 0, q16(0.5))))])
    path = arm.configurations(waypoints)  # (n, values), radians and metres
    answers = arm.edges(path[:-1], path[1:])  # one call of C
    print((answers["answer"] == gjk.ArmAnswer.FREE).all())

What an answer promises stands in gjk/arm.h. Values are integers: angles of 2^-16 radians, lengths of 2^-16 unit. An Arm
belongs to one thread at a time.
"""

import ctypes
import enum
import typing
from ctypes import POINTER, c_bool, c_int32, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p

from . import urdf
from ._library import Error, Int32, Q16_ONE, Q30_ONE, Record, Status
from ._library import check_sizes, checked, constant, declare, do, size_of
from .bodies import Collider, Pose, Shape, Unit3, Vec3
from .queries import DistanceResult

__all__ = ["Arm", "ArmAnswer", "ArmDistance", "ArmEdge", "ArmLink", "ArmPair", "ArmPart"]

_BASE = constant("GJK_ARM_BASE")
_TOLERANCE = constant("GJK_ARM_TOLERANCE_MIN")
_KINDS = ("fixed", "revolute", "prismatic")


class ArmAnswer(enum.IntEnum):
    """ArmEdge.answer: gjk_arm_answer."""

    UNSETTLED = 0
    FREE = 1
    TOUCH = 2


class ArmLink(typing.NamedTuple):
    """A link, and the joint that it hangs on.

    parent: the name of a link before; None: the base. kind: "fixed", "revolute" or "prismatic". pose: of its frame in
    the parent's, at value 0. axis: of any length. lower, upper: limits of the value; beyond them answers say `outside`.
    """

    name: str
    parent: typing.Optional[str] = None
    kind: str = "fixed"
    pose: typing.Optional[Pose] = None
    axis: typing.Sequence[int] = (0, 0, Q30_ONE)
    lower: int = -(1 << 31)
    upper: int = (1 << 31) - 1


class ArmPart(typing.NamedTuple):
    """A shape on a link, at a pose in its frame."""

    link: str
    shape: Shape
    pose: typing.Optional[Pose] = None


class _Link(Record):
    C_NAME = "gjk_arm_link"
    _fields_ = [
        ("parent", c_uint8),
        ("kind", c_uint8),
        ("fixed", Pose),
        ("axis", Vec3),
        ("lower", c_int32),
        ("upper", c_int32),
    ]


class _Part(Record):
    C_NAME = "gjk_arm_part"
    _fields_ = [("shape", POINTER(Shape)), ("pose", Pose), ("link", c_uint8)]


class _Model(Record):
    C_NAME = "gjk_arm_model"
    _fields_ = [
        ("links", POINTER(_Link)),
        ("parts", POINTER(_Part)),
        ("never", POINTER(c_uint32)),
        ("link_count", c_uint8),
        ("part_count", c_uint16),
    ]


class _Memory(Record):
    C_NAME = "gjk_arm_memory"
    _fields_ = [("links", c_void_p), ("parts", c_void_p), ("pairs", c_void_p), ("pair_capacity", c_uint32)]


class _Setup(Record):
    C_NAME = "gjk_arm_setup"
    _fields_ = [("margin", c_int32), ("tolerance", c_int32), ("resolution", c_int32)]


class _Proof(Record):
    C_NAME = "gjk_arm_proof"
    _fields_ = [("start", c_int32), ("end", c_int32), ("direction", Unit3), ("pair", c_uint32), ("piece", c_uint32)]


class ArmPair(Record):
    """A part by its number, and another one, or an obstacle. Arm.names tells whose they are."""

    C_NAME = "gjk_arm_names"
    _fields_ = [("part", c_uint16), ("other", c_uint16), ("obstacle", c_bool), ("piece", c_uint32)]


class ArmEdge(Record):
    """What is known of an edge. lower, upper: fractions of 2^-30; gap: a length. Arm.edges returns arrays of it."""

    C_NAME = "gjk_arm_edge_result"
    _fields_ = [
        ("answer", ctypes.c_int),
        ("lower", c_int32),
        ("upper", c_int32),
        ("gap", c_int32),
        ("pair", ArmPair),
        ("tests", c_uint32),
        ("outside", c_bool),
    ]


class ArmDistance(Record):
    """What is nearest: a pair, and its DistanceResult from the other thing, A, to the part, B."""

    C_NAME = "gjk_arm_distance_result"
    _fields_ = [("pair", ArmPair), ("distance", DistanceResult), ("outside", c_bool)]


class Arm:
    """A machine at a base, among obstacles.

    links: parents before their children. never: pairs of names of links that are never tested against each other. Names
    of links are unique.
    """

    def __init__(
        self,
        links: typing.Iterable[ArmLink],
        parts: typing.Iterable[ArmPart],
        never: typing.Iterable[typing.Tuple[str, str]] = (),
        base: typing.Optional[Pose] = None,
        scale: float = 1.0,
    ):
        self.links = [ArmLink(*link) for link in links]
        self.parts = [ArmPart(*part) for part in parts]
        self.base, self.scale = base or Pose(), scale
        self._number = {link.name: i for i, link in enumerate(self.links)}
        if len(self._number) != len(self.links):
            raise ValueError("two links have one name")
        self._moving = [link for link in self.links if link.kind != "fixed"]
        self._links = (_Link * len(self.links))(*(self._link(i, link) for i, link in enumerate(self.links)))
        self._parts = (_Part * len(self.parts))(
            *(_Part(ctypes.pointer(p.shape), p.pose or Pose(), self._find(p.link, "a part")) for p in self.parts)
        )
        self._never = (c_uint32 * len(self.links))()
        for one, other in never:
            self._never[self._find(one, "never")] |= 1 << self._find(other, "never")
        self._model = _Model(
            self._links, self._parts, self._never, checked(len(self.links), "number of links", 0, 255),
            checked(len(self.parts), "number of parts", 0, 65535),
        )  # fmt: skip
        self.obstacles([])

    @classmethod
    def from_urdf(cls, path, srdf=None, scale: float = 1.0, base: typing.Optional[Pose] = None,
                  vertices: typing.Optional[int] = None) -> "Arm":  # fmt: skip
        """The machine that gjk-convert makes of a robot: its collision shapes enclosed, meshes (STL, OBJ) by hulls.

        scale: how many units a metre is. srdf: which pairs of links are never tested; without it, as gjk-convert does,
        those that touched in each of 2,000 samples, which is no proof, and those beside links without shapes.
        vertices: of a mesh's hull at most, which still enclose it. ValueError says what is wrong with a file and where.
        """
        robot = urdf.Robot(path, scale, vertices, ArmLink, ArmPart)
        try:
            arm = cls(robot.links, robot.parts, (), base, scale)
            arm.poses([0] * len(arm.moving))
        except Error as error:
            raise ValueError(f"{path}: the machine reaches farther than 2048 units: {error}; see scale") from error
        never = robot.sample_pairs(arm) if srdf is None else robot.read_pairs(srdf)
        return cls(robot.links, robot.parts, never, base, scale)

    def _find(self, name, whose):
        if name not in self._number:
            raise ValueError(f"{whose} is of link {name!r}, which is not there")
        return self._number[name]

    def _link(self, i, link):
        parent = _BASE if link.parent is None else self._find(link.parent, f"link {link.name!r}'s parent")
        if parent != _BASE and parent >= i:
            raise ValueError(f"link {link.name!r} comes before its parent {link.parent!r}")
        if link.kind not in _KINDS:
            raise ValueError(f"link {link.name!r} has a joint of kind {link.kind!r}, not one of {', '.join(_KINDS)}")
        kind, limits = _KINDS.index(link.kind), (_int32(link.lower), _int32(link.upper))
        return _Link(parent, kind, link.pose or Pose(), Vec3.of(link.axis), *limits)

    @property
    def moving(self) -> typing.List[ArmLink]:
        """The links whose joints have a value each, in the order of configurations."""
        return list(self._moving)

    def obstacles(self, things: typing.Iterable[typing.Tuple[Shape, Pose]]) -> None:
        """Sets what the arm must not hit: shapes at poses in the world, in the place of those before."""
        placed = [Collider(shape, pose) for shape, pose in things]
        bare = (Collider * len(placed))()
        for i, collider in enumerate(placed):
            size = ctypes.sizeof(Collider)
            ctypes.memmove(ctypes.byref(bare, i * size), ctypes.byref(collider), size)
        n, m = len(self.parts), len(placed)
        pairs = n * m + n * (n - 1) // 2
        rooms = [
            _room("gjk_arm_link_room", len(self.links)), _room("gjk_arm_part_room", n), _room("gjk_arm_pair", pairs)
        ]  # fmt: skip
        memory = _Memory(*map(ctypes.addressof, rooms), pairs)
        handle = _room("gjk_arm", 1)
        do(_init, handle, self._model, self.base, memory)
        do(_obstacles, handle, bare, checked(m, "number of obstacles", 0, 65535))
        self._handle, self._keep = handle, (rooms, placed, bare)

    def names(self, pair) -> typing.Tuple[str, typing.Union[str, int]]:
        """The name of the link of the part, and that of the other part's, or the number of the obstacle. pair: an
        ArmPair, or an item of edges()["pair"]."""
        part, other, obstacle = (
            (pair.part, pair.other, pair.obstacle) if isinstance(pair, ArmPair) else pair.item()[:3]
        )  # fmt: skip
        return self.parts[part].link, other if obstacle else self.parts[other].link

    # One configuration: a sequence of as many integers as joints move.

    def poses(self, values) -> typing.List[Pose]:
        """The poses of all links in the world."""
        out = (Pose * len(self.links))()
        do(_poses, self._handle, self._values(values), out)
        return list(out)

    def near(self, values, distance: int = 0) -> typing.Optional[ArmPair]:
        """The first pair that is at most so far apart; None: none is. A curved pair not settled counts as near."""
        yes, pair = c_bool(), ArmPair()
        status = _near(self._handle, self._values(values), distance, yes, pair)
        if status not in (Status.OK, Status.ITERATION_LIMIT):
            raise Error(status)
        return pair if yes else None

    def distance(self, values, most: typing.Optional[int] = None) -> typing.Optional[ArmDistance]:
        """What is nearest; None: no pair is within most. Error(ITERATION_LIMIT) has a result, whose lower counts."""
        out = ArmDistance()
        status = _distance(self._handle, self._values(values), _FAR if most is None else most, out)
        if status == Status.EMPTY:
            return None
        if status != Status.OK:
            raise Error(status, out)
        return out

    def gradient(self, values, nearest: ArmDistance) -> typing.List[int]:
        """How the distance that was found there changes with each value: in LSB per LSB, of 2^-16."""
        out = (c_int32 * len(self._moving))()
        do(_gradient, self._handle, self._values(values), nearest, out)
        return list(out)

    def _values(self, values):
        values = [_int32(int(v) if hasattr(v, "dtype") and v.dtype.kind in "iu" else v) for v in values]
        if len(values) != len(self._moving):
            raise ValueError(f"{len(values)} values for {len(self._moving)} joints that move")
        return (c_int32 * len(values))(*values)

    # Whole motions.

    def edge(self, start, end, margin: int = 0, tolerance: int = _TOLERANCE, resolution: int = Q30_ONE,
             tests: int = (1 << 32) - 1) -> ArmEdge:  # fmt: skip
        """Is the motion from one configuration to another free? An ArmEdge; UNSETTLED: so many tests do not tell."""
        out = (ArmEdge * 1)()
        self._run(self._values(start), self._values(end), 1, (margin, tolerance, resolution), tests, None, out)
        return out[0]

    def edges(self, starts, ends, margin: int = 0, tolerance: int = _TOLERANCE, resolution: int = Q30_ONE,
              tests: int = (1 << 32) - 1, certify: bool = False):  # fmt: skip
        """The same for arrays of integers, (n, values), by one call of C: a numpy array of n ArmEdge.

        certify: each answer is checked by its certificate. Error(UNPROVEN) would tell of one that fails, and
        Error(CAPACITY) tells of one of more than 131,072 steps.
        """
        import numpy

        arrays = [self._array(numpy, values) for values in (starts, ends)]
        if arrays[0].shape != arrays[1].shape:
            raise ValueError(f"{len(arrays[0])} starts and {len(arrays[1])} ends")
        out = numpy.zeros(len(arrays[0]), numpy.dtype(ArmEdge))
        pointers = [array.ctypes.data_as(POINTER(c_int32)) for array in arrays]
        proofs = (_Proof * (1 << 17))() if certify else None
        place = out.ctypes.data_as(POINTER(ArmEdge))
        self._run(*pointers, len(out), (margin, tolerance, resolution), tests, proofs, place)
        return out

    def _run(self, start, end, edges, setup, tests, proofs, out):
        failed = c_uint32()
        status = _edges(
            self._handle, start, end, checked(edges, "uint32", 0, (1 << 32) - 1), _Setup(*map(_int32, setup)),
            checked(tests, "uint32", 0, (1 << 32) - 1), proofs, len(proofs) if proofs is not None else 0, out, failed,
        )  # fmt: skip
        if status != Status.OK:
            error = Error(status)
            error.args = (f"{Status(status).name} of edge {failed.value}",)
            raise error

    def _array(self, numpy, values):
        values = numpy.asarray(values)
        if values.ndim != 2 or values.shape[1] != len(self._moving):
            raise ValueError(f"configurations are an array of (n, {len(self._moving)}), not {values.shape}")
        if values.dtype.kind not in "iu":
            raise TypeError("values are integers; configurations() makes them of radians and metres")
        if values.size > 0 and (int(values.max()) >= 1 << 31 or int(values.min()) < -(1 << 31)):
            raise OverflowError("a value is no int32")
        return numpy.ascontiguousarray(values, numpy.int32)

    def configurations(self, numbers):
        """An array of numbers, in radians and in metres of a scale, as integers: each to the nearest."""
        import numpy

        numbers = numpy.asarray(numbers, dtype=float)
        if numbers.ndim not in (1, 2) or numbers.shape[-1] != len(self._moving):
            raise ValueError(f"configurations are an array of (n, {len(self._moving)}), not {numbers.shape}")
        worth = [Q16_ONE * (self.scale if link.kind == "prismatic" else 1.0) for link in self._moving]
        values = numpy.rint(numbers * worth)
        if not (numpy.abs(values) < 1 << 31).all():
            raise OverflowError("a value is no int32")
        return values.astype(numpy.int32)


def _int32(value):
    return checked(value, "int32", -(1 << 31), (1 << 31) - 1)


def _room(name, count):
    return (c_uint64 * max(1, (size_of(name) * count + 7) // 8))()


_FAR = constant("GJK_DISTANCE_MAX")
_VALUES = POINTER(c_int32)
_init = declare("gjk_arm_init", c_void_p, POINTER(_Model), POINTER(Pose), POINTER(_Memory))
_obstacles = declare("gjk_arm_obstacles", c_void_p, POINTER(Collider), c_uint16)
_poses = declare("gjk_arm_poses", c_void_p, _VALUES, POINTER(Pose))
_near = declare("gjk_arm_near", c_void_p, _VALUES, Int32, POINTER(c_bool), POINTER(ArmPair))
_distance = declare("gjk_arm_distance", c_void_p, _VALUES, Int32, POINTER(ArmDistance))
_gradient = declare("gjk_arm_gradient", c_void_p, _VALUES, POINTER(ArmDistance), POINTER(c_int32))


def _edges(*arguments):  # of this package: a library by another build may lack it
    return declare(
        "gjk_batch_edges", c_void_p, _VALUES, _VALUES, c_uint32, POINTER(_Setup), c_uint32, POINTER(_Proof), c_uint32,
        POINTER(ArmEdge), POINTER(c_uint32),
    )(*arguments)  # fmt: skip


check_sizes(globals())
