"""A path that was checked in steps passes through a thin wall, and the audit says where.

Needs OMPL's own Python bindings, the package ompl 2.x. clearway.ompl shares no types of C++ with them."""

import math

from ompl import base

import clearway
import clearway.ompl

STEP = 1.0  # between the poses that the path's maker looked at


def box(*sides):
    corners = [[i * sides[0] / 2, j * sides[1] / 2, k * sides[2] / 2] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return clearway.Model(clearway.Mesh(corners, [half for a, b, c, d in faces for half in ([a, b, c], [a, c, d])]))


def state_at(space, x, y, z):
    state = space.allocState()
    state.setXYZ(x, y, z)
    state.rotation().setIdentity()
    return state


def is_free_in_steps(space, checker, s1, s2):
    """As OMPL's DiscreteMotionValidator decides."""
    way = math.dist((s1.getX(), s1.getY(), s1.getZ()), (s2.getX(), s2.getY(), s2.getZ()))
    steps, between = math.ceil(way / STEP), space.allocState()
    for i in range(steps + 1):
        space.interpolate(s1, s2, i / steps, between)
        if not checker.isValid(between):
            return False
    return True


scene = clearway.Scene(box(0.5, 0.5, 0.5), [clearway.Obstacle(box(0.02, 20, 20))])  # the wall stands at x = 0
space, bounds = base.SE3StateSpace(), base.RealVectorBounds(3)
bounds.setLow(-9)
bounds.setHigh(9)
space.setBounds(bounds)
si = base.SpaceInformation(space)
checker, validator = clearway.ompl.ValidityChecker(si, scene), clearway.ompl.MotionValidator(si, scene)

path = [state_at(space, *place) for place in ((-6, -6, 0), (-3, 0, 0), (4, 1, 0), (6, 6, 0))]
last = space.allocState()
for number, (s1, s2) in enumerate(zip(path, path[1:]), 1):
    in_steps = is_free_in_steps(space, checker, s1, s2)
    certified, share = validator.checkMotionWithLastValid(s1, s2, last)
    answer = "certified" if certified else "free up to x = %.3f, %.0f %% of it" % (last.getX(), 100 * share)
    print("motion %d: %s in steps, %s" % (number, "free" if in_steps else "not free", answer))
