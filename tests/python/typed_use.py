"""A user's program, for mypy: every call has a type."""

from typing import Any

import numpy as np

import clearway
import clearway.ompl


def clearances(part: clearway.Model, obstacle: clearway.Model, count: int) -> "list[float]":
    scene = clearway.Scene(part, [clearway.Obstacle(obstacle, 0.5)])
    poses = [clearway.pose_from([0.1 * i, 0, 0], [0, 0, 0, 1]) for i in range(count)]
    return [scene.clearance(pose) for pose in poses]


def nearest(part: clearway.Model, obstacle: clearway.Model) -> float:
    workspace = clearway.Workspace()
    result: clearway.DistanceResult = clearway.distance(part, obstacle, np.eye(4), workspace, cap=5.0)
    flags = clearway.is_within_batch(part, obstacle, np.eye(4)[np.newaxis], 1)
    return result.lower if bool(flags.any()) else float("inf")


def plug_in(si: Any, scene: clearway.Scene) -> int:
    checker = clearway.ompl.ValidityChecker(si, scene, lambda state: np.eye(4))
    validator = clearway.ompl.MotionValidator(si, scene)
    si.setStateValidityChecker(checker)
    si.setMotionValidator(validator)
    return checker.unusable + validator.getValidMotionCount()
