"""Queries about two colliders, and their proofs, as space and the plane have them: of other structures and prefixes."""

import ctypes
import enum
import types
from ctypes import POINTER, c_bool, c_int16, c_int32, c_uint8, c_uint16

from ._library import Certificates, Int32, Record, Uint8, answer, check_sizes, declare, do


class Answer(enum.IntEnum):
    """WithinResult.answer: gjk_answer, gjk2_answer."""

    NO = 0
    YES = 1
    OPEN = 2


def dimension(module, prefix, vector, unit, placing, collider, spin, axes, count, contacts_most, impact_tolerance):
    """Structures and functions of a module, by their names in it.

    placing: the type of a pose. spin: that of a motion's. axes: how many. count: the type of iterations.
    """
    to_pair = POINTER(collider), POINTER(collider)
    points = [("point_a", vector), ("point_b", vector), ("normal", unit)]
    bounds = [("lower", c_int32), ("upper", c_int32)]
    proof = [("count", c_uint8), ("proof", c_uint8)]
    kept = c_uint16 * (4 if axes == 3 else 2)

    class Cache(Record):
        """What may be kept for a pair from one query to the next, for speed alone."""

        C_NAME = prefix + "cache"
        _fields_ = [("direction", c_int16 * axes), ("count", c_uint16), ("a", kept), ("b", kept)]

    class Certificate(Certificates):
        C_NAME = prefix + "certificate"
        _fields_ = [("direction", vector), ("a", c_uint16 * (axes + 1)), ("b", c_uint16 * (axes + 1)), *proof]

    class Decision(Record):
        C_NAME = prefix + "decision"
        _fields_ = [("yes", c_bool), ("iterations", count), ("certificate", Certificate)]

        def __bool__(self):
            return self.yes

    class WithinResult(Record):
        C_NAME = prefix + "within_result"
        _fields_ = [("answer", ctypes.c_int), ("decision", Decision)]

    class DistanceResult(Record):
        C_NAME = prefix + "distance_result"
        _fields_ = [
            ("distance", c_int32),
            *bounds,
            *points,
            ("intersecting", c_bool),
            ("saturated", c_bool),
            ("iterations", count),
            ("certificate", Certificate),
        ]

    class Effort(Record):
        C_NAME = prefix + "effort"
        _fields_ = [("iterations", c_uint8), ("error", c_int32)]

    class PenetrationResult(Record):
        C_NAME = prefix + "penetration_result"
        _fields_ = [
            ("depth", c_int32),
            *bounds,
            *points,
            ("intersecting", c_bool),
            ("iterations", c_uint16),
            ("certificate", Certificate),
        ]

    class Contact(Record):
        C_NAME = prefix + "contact"
        _fields_ = [("point_a", vector), ("point_b", vector), ("distance", c_int32), ("id", c_uint16)]

    class Manifold(Record):
        """The contact points of two shapes. It unpacks to them."""

        C_NAME = prefix + "manifold"
        _fields_ = [
            ("normal", unit),
            ("count", c_uint8),
            ("feature_a", c_uint16),
            ("feature_b", c_uint16),
            ("contact", Contact * contacts_most),
        ]

        def __len__(self):
            return self.count

        def __iter__(self):
            return iter(self.contact[: self.count])

    class CastPath(Record):
        C_NAME = prefix + "cast_path"
        _fields_ = [("to_a", POINTER(vector)), ("to_b", POINTER(vector)), ("margin", c_int32)]

    class CastCertificate(Certificates):
        C_NAME = prefix + "cast_certificate"
        _fields_ = [("direction", vector), ("a", c_uint16 * 3), ("b", c_uint16 * 3), *proof]

    class CastResult(Record):
        C_NAME = prefix + "cast_result"
        _fields_ = [
            ("hit", c_bool),
            ("inside", c_bool),
            ("fraction", c_int32),
            *points,
            ("rest_a", vector),
            ("rest_b", vector),
            ("saturated", c_bool),
            ("iterations", c_uint8),
            ("certificate", CastCertificate),
        ]

        def __bool__(self):
            return self.hit

    class MotionBase(Record):
        C_NAME = prefix + "motion"
        _fields_ = [("start", placing), ("end", placing), ("spin", spin)]

        def pose(self, fraction):
            """The pose at a fraction of the way, Q2.30."""
            return answer(_motion_pose, placing, self, fraction)

    class ImpactSetup(Record):
        C_NAME = prefix + "impact_setup"
        _fields_ = [("margin", c_int32), ("tolerance", c_int32), ("iterations", c_uint8)]

    class ImpactResult(Record):
        C_NAME = prefix + "impact_result"
        _fields_ = [
            ("hit", c_bool),
            ("overlap", c_bool),
            *bounds,
            ("distance", c_int32),
            *points,
            ("pose_a", placing),
            ("pose_b", placing),
            ("iterations", c_uint8),
        ]

        def __bool__(self):
            return self.hit

    to_cache, to_decision, to_distance = POINTER(Cache), POINTER(Decision), POINTER(DistanceResult)
    to_path, to_cast, to_motion = POINTER(CastPath), POINTER(CastResult), POINTER(MotionBase)

    def function(name, *arguments):
        return declare(prefix + name, *arguments)

    _intersect = function("intersect", *to_pair, to_cache, to_decision)
    _within = function("within", *to_pair, Int32, to_cache, to_decision)
    _within_until = function("within_until", *to_pair, Int32, Uint8, to_cache, POINTER(WithinResult))
    _distance = function("distance", *to_pair, to_cache, to_distance)
    _distance_until = function("distance_until", *to_pair, POINTER(Effort), to_cache, to_distance)
    _cast = function("cast", *to_pair, to_path, to_cast)
    _cast_ray = function("cast_ray", to_pair[0], vector, vector, to_cast)
    _motion_pose = function("motion_pose", to_motion, Int32, POINTER(placing))
    _time_of_impact = function(
        "time_of_impact", to_pair[0], to_motion, to_pair[1], to_motion, POINTER(ImpactSetup), POINTER(ImpactResult)
    )
    _check_decision = function("check_decision", *to_pair, Int32, to_decision)
    _check_distance = function("check_distance", *to_pair, to_distance)
    _check_penetration = function("check_penetration", *to_pair, POINTER(PenetrationResult))
    _check_cast = function("check_cast", *to_pair, to_path, to_cast)

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

    def cast_path(to_a, to_b, margin):
        ends = [None if to is None else ctypes.pointer(vector.of(to)) for to in (to_a, to_b)]
        return CastPath(*ends, margin)

    def cast(a, b, to_a=None, to_b=None, margin=0):
        """Where do two shapes first touch, or come within the margin, on straight ways to these positions?

        A CastResult. A shape without an end of its way stands.
        """
        return answer(_cast, CastResult, a, b, cast_path(to_a, to_b, margin))

    def cast_ray(a, start, end):
        """Where does a ray first enter a shape? A CastResult."""
        return answer(_cast_ray, CastResult, a, start, end)

    def time_of_impact(a, motion_a, b, motion_b, margin=0, tolerance=impact_tolerance, iterations=0):
        """When do two shapes that move and turn first come within the margin? An ImpactResult."""
        setup = ImpactSetup(margin, tolerance, iterations)
        return answer(_time_of_impact, ImpactResult, a, motion_a, b, motion_b, setup)

    # Each raises Error(UNPROVEN) for an answer that is not true of these colliders.

    def check_decision(a, b, decision, most=0):
        """Proves a decision of intersect, or of within with its distance."""
        do(_check_decision, a, b, most, decision)

    def check_distance(a, b, result):
        do(_check_distance, a, b, result)

    def check_penetration(a, b, result):
        do(_check_penetration, a, b, result)

    def check_cast(a, b, result, to_a=None, to_b=None, margin=0):
        do(_check_cast, a, b, cast_path(to_a, to_b, margin), result)

    names = dict(locals())
    for name, value in names.items():
        if getattr(value, "__module__", None) == __name__ and hasattr(value, "__qualname__"):
            value.__module__, value.__qualname__ = module, name
    check_sizes(names)
    return types.SimpleNamespace(**names)
