"""Settles a dispute: a library that computes in float says of pairs that they touch, though they are apart.

3,000 pairs of plates, a hundredth as thick as wide, turned any way and then put a millionth of their size apart or
less. What says that they touch is the usual test along separating axes in float32, with the tolerance of 10^-6 that
such code has. The second opinion says which of its answers are wrong, and draws them: dispute.py [PICTURE.svg]. It
needs numpy.
"""

import sys

import numpy

import gjk

PAIRS, HALF, TOLERANCE = 3000, numpy.array([1.0, 1.0, 0.01]), 1e-6


def matrices(q):
    x, y, z, w = (q / numpy.linalg.norm(q, axis=1, keepdims=True)).T
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]).transpose(2, 0, 1)  # fmt: skip


def by_axes(poses_a, poses_b, number):
    """The largest gap along the 15 axes of two boxes, 0 within the tolerance, in floats of a kind."""
    a, b = (matrices(poses[:, 3:]).astype(number) for poses in (poses_a, poses_b))
    between = (poses_b[:, :3] - poses_a[:, :3]).astype(number)
    columns = [m[:, :, i] for m in (a, b) for i in range(3)]
    axes = columns + [numpy.cross(columns[i], columns[3 + j]) for i in range(3) for j in range(3)]
    best = numpy.full(len(between), -numpy.inf, number)
    for axis in axes:
        length = numpy.sqrt((axis * axis).sum(axis=1))
        reach = sum(numpy.abs(numpy.einsum("nij,ni->nj", m, axis)) @ HALF.astype(number) for m in (a, b))
        gap = numpy.abs((between * axis).sum(axis=1)) - reach
        best = numpy.where(length > number(1e-4), numpy.maximum(best, gap / numpy.maximum(length, number(1e-4))), best)
    return numpy.where(best <= number(TOLERANCE), 0, best).astype(float)


def family(seed=7):
    """Poses of plates that all but touch: B is moved along the normal until so much is left of the gap."""
    random = numpy.random.default_rng(seed)
    poses_a, poses_b = (numpy.hstack([numpy.zeros((PAIRS, 3)), random.normal(size=(PAIRS, 4))]) for _ in range(2))
    poses_b[:, :3] = 4 * (lambda v: v / numpy.linalg.norm(v, axis=1, keepdims=True))(random.normal(size=(PAIRS, 3)))
    left = 10 ** random.uniform(-7.5, -5.5, PAIRS)
    for i in range(PAIRS):
        answer = gjk.second_opinion(HALF, HALF, poses_a[i], poses_b[i])
        poses_b[i, :3] -= (answer.lower - left[i]) * numpy.array(answer.normal)
    return poses_a, poses_b, left


def main():
    poses_a, poses_b, left = family()
    opinions = gjk.second_opinions(HALF, HALF, poses_a, poses_b)
    told = opinions.touching == 0
    print(f"{told.sum()} of {PAIRS} pairs are certainly apart, at {opinions.resolution:.2g} to a step")
    for number in (numpy.float32, numpy.float64):
        said = by_axes(poses_a, poses_b, number)
        result = gjk.compare(opinions, said)
        print(f"{number.__name__}: {len(result.touching_wrong)} of them are said to touch")
        if number is numpy.float32 and len(sys.argv) > 1:
            result.draw(sys.argv[1], numpy.log10(left), poses_b[:, 2])
    first = int(numpy.flatnonzero(told)[0])
    print("the first of them:", gjk.second_opinion(HALF, HALF, poses_a[first], poses_b[first]))


if __name__ == "__main__":
    main()
