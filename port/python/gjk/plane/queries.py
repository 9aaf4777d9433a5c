"""Queries in the plane, and their proofs. `gjk.plane` has all of these names."""

import enum
from ctypes import POINTER, c_int32, c_uint16

from .._library import Int32, Unsigned, answer, check_sizes, declare
from .._pairs import Answer, dimension
from .bodies import Collider, Pose, Unit, Vec

__all__ = [
    "Answer", "Cache", "Motion", "Proof",
    "intersect", "within", "within_until", "distance", "distance_until", "penetration", "signed_distance", "contacts",
    "cast", "cast_ray", "time_of_impact", "check_decision", "check_distance", "check_penetration", "check_cast",
]  # fmt: skip

_of = dimension(__name__, "gjk2_", Vec, Unit, Pose, Collider, c_int32, 2, c_uint16, 2, 8)

# gjk2/cache.h, gjk2/certificate.h, gjk2/intersect.h, gjk2/distance.h, gjk2/cast.h, gjk2/impact.h, gjk2/check.h
Cache, Certificate, Decision, WithinResult = _of.Cache, _of.Certificate, _of.Decision, _of.WithinResult
DistanceResult, Effort = _of.DistanceResult, _of.Effort
intersect, within, within_until = _of.intersect, _of.within, _of.within_until
distance, distance_until = _of.distance, _of.distance_until
PenetrationResult, Contact, Manifold = _of.PenetrationResult, _of.Contact, _of.Manifold
CastPath, CastCertificate, CastResult, cast_path = _of.CastPath, _of.CastCertificate, _of.CastResult, _of.cast_path
ImpactSetup, ImpactResult = _of.ImpactSetup, _of.ImpactResult
cast, cast_ray, time_of_impact = _of.cast, _of.cast_ray, _of.time_of_impact
check_decision, check_distance = _of.check_decision, _of.check_distance
check_penetration, check_cast = _of.check_penetration, _of.check_cast


class Proof(enum.IntEnum):
    """Certificate.proof: gjk2_proof."""

    NONE = 0
    CIRCLES = 1
    DIRECTION = 2
    NEAREST = 3
    NEAR = 4
    ENCLOSING = 5
    EDGE = 6
    LINE = 7


class Motion(_of.MotionBase):
    """From one pose to another, turning by the angle spin where that is not 0."""

    def __init__(self, start, end=None, spin=0):
        super().__init__(start, end if end is not None else start, spin)


# Depths and contacts: gjk2/penetration.h, gjk2/contacts.h.


def penetration(a, b, cache=None):
    """How deep, which way out, where? A PenetrationResult."""
    return answer(_penetration, PenetrationResult, a, b, cache)


def signed_distance(a, b, cache=None):
    """The gap, or minus the depth: a DistanceResult."""
    return answer(_signed_distance, DistanceResult, a, b, cache)


def contacts(a, b, margin=0, most=2, cache=None):
    """Where do two shapes touch that are at most margin apart? A Manifold of at most so many points, 1 or 2."""
    return answer(_contacts, Manifold, a, b, margin, most, cache)


_penetration = declare("gjk2_penetration", *_of.to_pair, _of.to_cache, POINTER(PenetrationResult))
_signed_distance = declare("gjk2_signed_distance", *_of.to_pair, _of.to_cache, POINTER(DistanceResult))
_contacts = declare("gjk2_contacts", *_of.to_pair, Int32, Unsigned, _of.to_cache, POINTER(Manifold))

check_sizes(globals())
