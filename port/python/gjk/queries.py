"""Queries in space, and their proofs. `import gjk` has all of these names."""

import ctypes
import enum
from ctypes import POINTER, c_uint32, c_void_p

from ._library import Int32, Record, Uint16, Unsigned, answer, check_sizes, declare, library, size_of
from ._pairs import Answer, dimension
from .bodies import Collider, Pose, Unit3, Vec3

__all__ = [
    "Answer", "Cache", "Motion", "Proof", "Workspace",
    "intersect", "within", "within_until", "distance", "distance_until", "penetration", "signed_distance", "contacts",
    "cast", "cast_ray", "time_of_impact", "check_decision", "check_distance", "check_penetration", "check_cast",
]  # fmt: skip

_of = dimension(__name__, "gjk_", Vec3, Unit3, Pose, Collider, Vec3, 3, ctypes.c_uint8, 8, 16)

# gjk/cache.h, gjk/certificate.h, gjk/intersect.h, gjk/distance.h, gjk/cast.h, gjk/impact.h, gjk/check.h
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
    """Certificate.proof: gjk_proof."""

    NONE = 0
    SPHERES = 1
    DIRECTION = 2
    NEAREST = 3
    NEAR = 4
    ENCLOSING = 5
    FACET = 6
    PLANE = 7


class Motion(_of.MotionBase):
    """From one pose to another, turning by spin, an angle times an axis, where that is not 0."""

    def __init__(self, start, end=None, spin=(0, 0, 0)):
        super().__init__(start, end if end is not None else start, Vec3.of(spin))


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
_penetration = declare("gjk_penetration", *_of.to_pair, *_MEMORY, POINTER(PenetrationResult))
_signed_distance = declare("gjk_signed_distance", *_of.to_pair, *_MEMORY, POINTER(DistanceResult))
_contacts = declare("gjk_contacts", *_of.to_pair, Int32, Unsigned, *_MEMORY, POINTER(Manifold))

check_sizes(globals())
