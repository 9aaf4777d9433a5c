"""Exact collision queries on integers: the library gjk for Python.

Lengths are integers of 2^-16 unit, which q16() makes; unit vectors and fractions are integers of 2^-30. So every answer
has the bits that it has in firmware, and in a game on any other machine.

    import gjk
    from gjk import q16

    crate = gjk.Collider(gjk.box(q16(0.5), q16(0.5), q16(0.5)))
    ball = gjk.Collider(gjk.sphere(q16(0.25)), gjk.Pose((q16(1.5), 0, 0)))
    gap = gjk.distance(crate, ball)
    print(gjk.units(gap.distance), tuple(gap.point_a))

What a call answers, how exactly, and which errors it has, stands in the header of the same name: gjk.distance is
gjk_distance of gjk/distance.h. gjk.plane is the same in the plane. A status that is not OK is raised as gjk.Error.

Results, poses and vectors are the library's own structures, with its names. A shape, and what it is made of, lives as
long as a collider, a scene or a body of many parts that has it.
"""

from . import plane
from ._library import Error, Q16_ONE, Q30_ONE, Status, angle, constant, q16, q30, units
from .arm import *
from .bodies import *
from .opinion import *
from .parts import *
from .queries import *
from .scene import *
from .solids import *
