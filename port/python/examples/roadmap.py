"""A roadmap for a robot: which of 4,000 motions between random configurations are free, all the way?

A thin rod and a plate stand about the robot. Each motion is asked once, and its answer certified; beside it stands what
is common, samples along the way, which do not see what is between them. roadmap.py ROBOT.urdf [ROBOT.srdf]. It needs
numpy.
"""

import sys
import time

import numpy

import gjk
from gjk import ArmAnswer, Pose, q16

MOTIONS, SAMPLES, SLACK = 4000, 8, 48  # SLACK: what counts as a touch, LSB


def main(urdf, srdf=None):
    arm = gjk.Arm.from_urdf(urdf, srdf)
    arm.obstacles([
        (gjk.capsule(q16(0.004), q16(0.5)), Pose((q16(0.45), q16(0.2), q16(0.5)))),
        (gjk.box(q16(0.2), q16(0.3), q16(0.002)), Pose((q16(0.4), q16(-0.45), q16(0.45)))),
    ])  # fmt: skip
    random = numpy.random.default_rng(1)
    lower, upper = (numpy.array(limits) for limits in zip(*((joint.lower, joint.upper) for joint in arm.moving)))
    lower, upper = numpy.maximum(lower, q16(-3.14)), numpy.minimum(upper, q16(3.14))
    start = random.integers(lower, upper, (MOTIONS, len(lower)))
    reach = (0.15 * (upper - lower)).astype(int)
    end = numpy.clip(start + random.integers(-reach, reach + 1, start.shape), lower, upper)

    begun = time.perf_counter()
    answers = arm.edges(start, end, tolerance=SLACK, certify=True)
    took = time.perf_counter() - begun
    free, touch = ((answers["answer"] == answer) for answer in (ArmAnswer.FREE, ArmAnswer.TOUCH))
    each = f"each certified, {took / MOTIONS * 1e6:.0f} us a motion"
    print(f"{free.sum()} of {MOTIONS} motions are free, {touch.sum()} touch, {each}")

    fractions = numpy.linspace(0, 1, SAMPLES)
    missed = [
        i for i in numpy.flatnonzero(touch)
        if not any(arm.near(numpy.rint(start[i] + f * (end[i] - start[i])).astype(int), SLACK) for f in fractions)
    ]  # fmt: skip
    print(f"{len(missed)} of those that touch look free in {SAMPLES} samples")
    for i in missed[:1]:
        link, other = arm.names(answers[i]["pair"])
        print(f"the first: {link} meets {other} at {answers[i]['upper'] / gjk.Q30_ONE:.3f} of the way")


if __name__ == "__main__":
    main(*sys.argv[1:])
