"""The plane: gjk for two dimensions. gjk.plane.distance is gjk2_distance of gjk2/distance.h, and so on.

    from gjk import q16, plane

    ramp = plane.Collider(plane.polygon([(0, 0), (q16(1), 0), (0, q16(1))]))
    ball = plane.Collider(plane.circle(q16(0.25)), plane.Pose((q16(0.67), q16(0.67))))
    print(plane.penetration(ramp, ball).depth)
"""

from .bodies import *
from .ground import *
from .queries import *
from .scene import *
