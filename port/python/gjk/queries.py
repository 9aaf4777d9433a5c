"""Queries in space, and their proofs. `import gjk` has all of these names."""

import ctypes
import enum
from ctypes import POINTER, c_bool, c_int16, c_int32, c_uint8, c_uint16, c_uint32, c_void_p

from ._library import Certificates, Int32, Record, Uint8, Uint16, Unsigned
from ._library import answer, check_sizes, declare, do, library, size_of
from .bodies import Collider, Pose, Unit3, Vec3

__all__ = [
    "Answer", "Cache", "Motion", "Proof", "Workspace",
    "intersect", "within", "within_until", "distance", "distance_until", "penetration", "signed_distance", "contacts",
    "cast", "cast_ray", "time_of_impact", "check_decision", "check_distance", "check_penetration", "check_cast",
]  # fmt: skip

_PAIR = POINTER(Collider), POINTER(Collider)


# Decisions and distances: gjk/cache.h, gjk/certificate.h, gjk/intersect.h, gjk/distance.h.


class Cache(Record):
    """What may be kept for a pair from one query to the next, for speed alone."""

    C_NAME = "gjk_cache"
    _fields_ = [("direction", c_int16 * 3), ("count", c_uint16), ("a", c_uint16 * 4), ("b", c_uint16 * 4)]


class Proof(enum.IntEnum):
    """Certificate.proof: gjk_proof."""

    NONE = 0
    SPHERES = 1
    DIRECTION = 2
    NEAREST = 3
    NEAR = 4
    ENCLOSING = 5
    FACET = 6
    PLANE = 7


class Certificate(Certificates):
    C_NAME = "gjk_certificate"
    _fields_ = [
        ("direction", Vec3),
        ("a", c_uint16 * 4),
        ("b", c_uint16 * 4),
        ("count", c_uint8),
        ("proof", c_uint8),
    ]


class Decision(Record):
    C_NAME = "gjk_decision"
    _fields_ = [("yes", c_bool), ("iterations", c_uint8), ("certificate", Certificate)]

    def __bool__(self):
        return self.yes


class Answer(enum.IntEnum):
    """WithinResult.answer: gjk_answer."""

    NO = 0
    YES = 1
    OPEN = 2


class WithinResult(Record):
    C_NAME = "gjk_within_result"
    _fields_ = [("answer", ctypes.c_int), ("decision", Decision)]


class DistanceResult(Record):
    C_NAME = "gjk_distance_result"
    _fields_ = [
        ("distance", c_int32),
        ("lower", c_int32),
        ("upper", c_int32),
        ("point_a", Vec3),
        ("point_b", Vec3),
        ("normal", Unit3),
        ("intersecting", c_bool),
        ("saturated", c_bool),
        ("iterations", c_uint8),
        ("certificate", Certificate),
    ]


class Effort(Record):
    C_NAME = "gjk_effort"
    _fields_ = [("iterations", c_uint8), ("error", c_int32)]


def intersect(a, b, cache=None):
    """Do two shapes share a point? A Decision, which is true or false by itself."""
    return answer(_intersect, Decision, a, b, cache)


def within(a, b, most, cache=None):
    """Are two shapes at most so far apart? A Decision."""
    return answer(_within, Decision, a, b, most, cache)


def within_until(a, b, most, iterations, cache=None):
    """The same, which gives up after so many iterations: a WithinResult."""
    return answer(_within_until, WithinResult, a, b, most, iterations, cache)


def distance(a, b, cache=None):
    """How far apart, and where? A DistanceResult."""
    return answer(_distance, DistanceResult, a, b, cache)


def distance_until(a, b, iterations=0, error=0, cache=None):
    """The same, until so many iterations are spent or the bounds are so near: a DistanceResult."""
    return answer(_distance_until, DistanceResult, a, b, Effort(iterations, error), cache)


_intersect = declare("gjk_intersect", *_PAIR, POINTER(Cache), POINTER(Decision))
_within = declare("gjk_within", *_PAIR, Int32, POINTER(Cache), POINTER(Decision))
_within_until = declare("gjk_within_until", *_PAIR, Int32, Uint8, POINTER(Cache), POINTER(WithinResult))
_distance = declare("gjk_distance", *_PAIR, POINTER(Cache), POINTER(DistanceResult))
_distance_until = declare("gjk_distance_until", *_PAIR, POINTER(Effort), POINTER(Cache), POINTER(DistanceResult))


# Depths and contacts: gjk/penetration.h, gjk/contacts.h.


class Workspace(Record):
    """Memory for the depth of hulls and curved shapes: for an EPA hull of so many vertices, or of so many cells."""

    C_NAME = "gjk_workspace"
    _fields_ = [("cells", c_void_p), ("count", c_uint32)]

    def __init__(self, vertices=1000, cells=None):
        if cells is None:
            cells = library.gjk_workspace_bytes(vertices) // size_of("gjk_epa_cell")
        self.memory = (ctypes.c_uint32 * (cells * size_of("gjk_epa_cell") // 4))()
        super().__init__(ctypes.addressof(self.memory), cells)


class PenetrationResult(Record):
    C_NAME = "gjk_penetration_result"
    _fields_ = [
        ("depth", c_int32),
        ("lower", c_int32),
        ("upper", c_int32),
        ("point_a", Vec3),
        ("point_b", Vec3),
        ("normal", Unit3),
        ("intersecting", c_bool),
        ("iterations", c_uint16),
        ("certificate", Certificate),
    ]


class Contact(Record):
    C_NAME = "gjk_contact"
    _fields_ = [("point_a", Vec3), ("point_b", Vec3), ("distance", c_int32), ("id", c_uint16)]


class Manifold(Record):
    """The contact points of two shapes. It unpacks to them."""

    C_NAME = "gjk_manifold"
    _fields_ = [
        ("normal", Unit3),
        ("count", c_uint8),
        ("feature_a", c_uint16),
        ("feature_b", c_uint16),
        ("contact", Contact * 8),
    ]

    def __len__(self):
        return self.count

    def __iter__(self):
        return iter(self.contact[: self.count])


def penetration(a, b, cache=None, workspace=None):
    """How deep, which way out, where? A PenetrationResult. Without a workspace the call takes one of 1000 vertices."""
    return answer(_penetration, PenetrationResult, a, b, cache, workspace or Workspace())


def signed_distance(a, b, cache=None, workspace=None):
    """The gap, or minus the depth: a DistanceResult."""
    return answer(_signed_distance, DistanceResult, a, b, cache, workspace or Workspace())


def contacts(a, b, margin=0, most=4, cache=None, workspace=None):
    """Where do two shapes touch that are at most margin apart? A Manifold of at most so many points, 1 to 8."""
    return answer(_contacts, Manifold, a, b, margin, most, cache, workspace or Workspace())


library.gjk_workspace_bytes.restype = ctypes.c_size_t
library.gjk_workspace_bytes.argtypes = [Uint16]
_MEMORY = POINTER(Cache), POINTER(Workspace)
_penetration = declare("gjk_penetration", *_PAIR, *_MEMORY, POINTER(PenetrationResult))
_signed_distance = declare("gjk_signed_distance", *_PAIR, *_MEMORY, POINTER(DistanceResult))
_contacts = declare("gjk_contacts", *_PAIR, Int32, Unsigned, *_MEMORY, POINTER(Manifold))


# Casts and times of impact: gjk/cast.h, gjk/impact.h.


class CastPath(Record):
    C_NAME = "gjk_cast_path"
    _fields_ = [("to_a", POINTER(Vec3)), ("to_b", POINTER(Vec3)), ("margin", c_int32)]


class CastCertificate(Certificates):
    C_NAME = "gjk_cast_certificate"
    _fields_ = [
        ("direction", Vec3),
        ("a", c_uint16 * 3),
        ("b", c_uint16 * 3),
        ("count", c_uint8),
        ("proof", c_uint8),
    ]


class CastResult(Record):
    C_NAME = "gjk_cast_result"
    _fields_ = [
        ("hit", c_bool),
        ("inside", c_bool),
        ("fraction", c_int32),
        ("point_a", Vec3),
        ("point_b", Vec3),
        ("normal", Unit3),
        ("rest_a", Vec3),
        ("rest_b", Vec3),
        ("saturated", c_bool),
        ("iterations", c_uint8),
        ("certificate", CastCertificate),
    ]

    def __bool__(self):
        return self.hit


class Motion(Record):
    """From one pose to another, turning by spin, an angle times an axis, where that is not 0."""

    C_NAME = "gjk_motion"
    _fields_ = [("start", Pose), ("end", Pose), ("spin", Vec3)]

    def __init__(self, start, end=None, spin=(0, 0, 0)):
        super().__init__(start, end if end is not None else start, Vec3.of(spin))

    def pose(self, fraction):
        """The pose at a fraction of the way, Q2.30."""
        return answer(_motion_pose, Pose, self, fraction)


class ImpactSetup(Record):
    C_NAME = "gjk_impact_setup"
    _fields_ = [("margin", c_int32), ("tolerance", c_int32), ("iterations", c_uint8)]


class ImpactResult(Record):
    C_NAME = "gjk_impact_result"
    _fields_ = [
        ("hit", c_bool),
        ("overlap", c_bool),
        ("lower", c_int32),
        ("upper", c_int32),
        ("distance", c_int32),
        ("point_a", Vec3),
        ("point_b", Vec3),
        ("normal", Unit3),
        ("pose_a", Pose),
        ("pose_b", Pose),
        ("iterations", c_uint8),
    ]

    def __bool__(self):
        return self.hit


def cast_path(to_a, to_b, margin):
    ends = [None if to is None else ctypes.pointer(Vec3.of(to)) for to in (to_a, to_b)]
    return CastPath(*ends, margin)


def cast(a, b, to_a=None, to_b=None, margin=0):
    """Where do two shapes first touch, or come within the margin, on straight ways to these positions? A CastResult.

    A shape without an end of its way stands.
    """
    return answer(_cast, CastResult, a, b, cast_path(to_a, to_b, margin))


def cast_ray(a, start, end):
    """Where does a ray first enter a shape? A CastResult."""
    return answer(_cast_ray, CastResult, a, start, end)


def time_of_impact(a, motion_a, b, motion_b, margin=0, tolerance=16, iterations=0):
    """When do two shapes that move and turn first come within the margin? An ImpactResult."""
    setup = ImpactSetup(margin, tolerance, iterations)
    return answer(_time_of_impact, ImpactResult, a, motion_a, b, motion_b, setup)


_cast = declare("gjk_cast", *_PAIR, POINTER(CastPath), POINTER(CastResult))
_cast_ray = declare("gjk_cast_ray", POINTER(Collider), Vec3, Vec3, POINTER(CastResult))
_motion_pose = declare("gjk_motion_pose", POINTER(Motion), Int32, POINTER(Pose))
_time_of_impact = declare(
    "gjk_time_of_impact",
    POINTER(Collider),
    POINTER(Motion),
    POINTER(Collider),
    POINTER(Motion),
    POINTER(ImpactSetup),
    POINTER(ImpactResult),
)


# Proofs: gjk/check.h. Each raises Error(UNPROVEN) for an answer that is not true of these colliders.


def check_decision(a, b, decision, most=0):
    """Proves a decision of intersect, or of within with its distance."""
    do(_check_decision, a, b, most, decision)


def check_distance(a, b, result):
    do(_check_distance, a, b, result)


def check_penetration(a, b, result):
    do(_check_penetration, a, b, result)


def check_cast(a, b, result, to_a=None, to_b=None, margin=0):
    do(_check_cast, a, b, cast_path(to_a, to_b, margin), result)


_check_decision = declare("gjk_check_decision", *_PAIR, Int32, POINTER(Decision))
_check_distance = declare("gjk_check_distance", *_PAIR, POINTER(DistanceResult))
_check_penetration = declare("gjk_check_penetration", *_PAIR, POINTER(PenetrationResult))
_check_cast = declare("gjk_check_cast", *_PAIR, POINTER(CastPath), POINTER(CastResult))

check_sizes(globals())
