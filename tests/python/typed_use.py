"""A user's program, for mypy: every call has a type."""

from typing import Any

import numpy as np

import clearway
import clearway.ompl
import clearway.planning


def clearances(part: clearway.Model, obstacle: clearway.Model, count: int) -> "list[float]":
    scene = clearway.Scene(part, [clearway.Obstacle(obstacle, 0.5)])
    poses = [clearway.pose_from([0.1 * i, 0, 0], [0, 0, 0, 1]) for i in range(count)]
    return [scene.clearance(pose) for pose in poses]


def nearest(part: clearway.Model, obstacle: clearway.Model) -> float:
    workspace = clearway.Workspace()
    result: clearway.DistanceResult = clearway.distance(part, obstacle, np.eye(4), workspace, cap=5.0)
    flags = clearway.is_within_batch(part, obstacle, np.eye(4)[np.newaxis], 1)
    return result.lower if bool(flags.any()) else float("inf")


def clearance_of_a_plan(file: str) -> float:
    def tell(now: clearway.planning.Progress) -> bool:
        return now.seconds < 10

    problem = clearway.Problem.load(file)
    problem.margin = 0.5
    scene: clearway.Scene = clearway.Scene.load(problem)
    try:
        planned = clearway.planning.plan(problem, scene=scene, seconds=5, parameters={"range": 2.5}, progress=tell)
    except clearway.planning.PlanningInterrupted as stop:
        return stop.result.length
    checked: clearway.planning.CheckResult = clearway.planning.check(problem, planned)
    faults = [fault.why for fault in checked.audit.faults]
    return checked.audit.lower_clearance if not faults else float(scene.clearance_batch(planned.path).min())


def plug_in(si: Any, scene: clearway.Scene) -> int:
    checker = clearway.ompl.ValidityChecker(si, scene, lambda state: np.eye(4))
    validator = clearway.ompl.MotionValidator(si, scene)
    si.setStateValidityChecker(checker)
    si.setMotionValidator(validator)
    share: float = validator.checkMotionWithLastValid(si.allocState(), si.allocState(), None)[1]
    assert 0 <= share <= 1
    return checker.unusable + validator.getValidMotionCount()
