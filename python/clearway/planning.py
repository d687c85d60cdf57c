"""Plans and checks paths of a rigid part, with OMPL: plan() and check(), each a single call.

Both take a problem file's name or a clearway.Problem. Poses are (4, 4) arrays, X_environment_part: they map coordinates of the part
to those of the environment. States are (7,): x y z, then a quaternion qx qy qz qw. Lengths are in the environment's unit, angles in
radians, times along a segment from 0 to 1. Errors are ArgumentError, FileError and, for OMPL's own, OmplError, all of clearway.
"""

import importlib.util
import os
import sys
from typing import Callable, List, Mapping, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._core import Problem, Scene
from ._results import (
    Audit,
    Blocker,
    FollowedTrack,
    CheckResult,
    Closest,
    Fault,
    FileName,
    PlanningInterrupted,
    PlanResult,
    Profile,
    Progress,
    Reached,
    WhyNoPath,
    audit_of,
    result_of,
)

if importlib.util.find_spec("clearway._planning") is None:
    raise ImportError("clearway.planning needs OMPL, and this clearway was built without it. Build clearway where OMPL 1.5 or later is"
                      " installed (Debian's libompl-dev), or use the module clearway alone")
try:
    from . import _planning
except ImportError as error:
    raise ImportError("clearway.planning could not load OMPL or another library: %s" % error) from error


def _refuse_other_ompl() -> None:
    """A process has one library of a name: the package ompl may have loaded its own in place of the one that clearway needs."""
    package = getattr(sys.modules.get("ompl"), "__file__", None)
    library = os.path.realpath(_planning.ompl_library())
    if package and library.startswith(os.path.dirname(os.path.realpath(package)) + os.sep):
        raise ImportError("clearway.planning would use the package ompl's own library, %s, because that bears the name of the one that"
                          " clearway was built with; expected a process that imports only one of the two" % library)


_refuse_other_ompl()

__all__ = [
    "Audit",
    "Blocker",
    "FollowedTrack",
    "CheckResult",
    "Closest",
    "Fault",
    "PlanResult",
    "PlanningInterrupted",
    "Profile",
    "Progress",
    "Reached",
    "WhyNoPath",
    "check",
    "objective_names",
    "plan",
    "planner_names",
]


def _parameters_of(parameters: Optional[Mapping[str, object]]) -> List[Tuple[str, str]]:
    def text(value: object) -> str:
        return str(int(value)) if isinstance(value, (bool, np.bool_)) else str(value)

    return [(str(name), text(value)) for name, value in (parameters or {}).items()]


def plan(
    problem: Union[Problem, FileName],
    *,
    scene: Optional[Scene] = None,
    planner: str = "",
    parameters: Optional[Mapping[str, object]] = None,
    seconds: Optional[float] = None,
    iterations: Optional[int] = None,
    threads: int = 0,
    seed: int = 1,
    objective: str = "",
    wanted_clearance: Optional[float] = None,
    margin: Optional[float] = None,
    floor: Optional[float] = None,
    quick: bool = False,
    ompl_weights: bool = False,
    progress: Optional[Callable[[Progress], object]] = None,
) -> PlanResult:
    """Plans a path from the problem's start to its goal, shortens it and audits it along its whole length.

    problem: a problem file's name, or a Problem.
    scene: the part among its obstacles, whose margins count; without it the problem's meshes are loaded.
    planner: one of planner_names(), in any case; empty: the problem's only one, or the default of `clearway plan`.
    parameters: the planner's parameters by name.
    seconds: in all, 30 without iterations; shortening takes at most as long as planning, or 5 s if that is more.
    iterations: of the planner, in place of seconds: repeatable, with the same seed.
    threads: planners side by side; 0: one a core, at most 4.
    seed: of OMPL's random numbers, from 1 to 4294967295.
    objective: one of objective_names(); empty: the problem's. Optimising planners then use all of the time.
    wanted_clearance: that the objective length_with_clearance keeps where it can.
    margin: distance to keep, in place of the problem's margin; its margins by name stay.
    floor: clearance that shortening keeps; a thousandth of the part's diagonal by default.
    quick: leaves out the 1 to 5 seconds that give the path more clearance.
    ompl_weights: weighs rotation as OMPL does, not by the part's radius.
    progress: called a few times a second in the calling thread. Where it returns False, planning stops with the best path so far.
        An exception that it raises stops planning, and is raised.

    Python's other threads go on meanwhile. One plan or check runs at a time in a process; others wait for their turn. Ctrl-C raises
    PlanningInterrupted, a KeyboardInterrupt whose result has what was found; a model that is being built is finished first.

    Raises ArgumentError for a wrong argument or problem, and when start or goal is not valid: then it names the closest meshes.
    """
    options = {
        "planner": planner,
        "parameters": _parameters_of(parameters),
        "seconds": seconds,
        "iterations": iterations,
        "threads": threads,
        "seed": seed,
        "objective": objective,
        "wanted_clearance": wanted_clearance,
        "floor": floor,
        "quick": quick,
        "ompl_weights": ompl_weights,
    }
    callback = None
    if progress is not None:
        tell = progress

        def callback(seconds: float, phase: str) -> object:
            answer = tell(Progress(seconds, phase))
            return bool(answer) if isinstance(answer, np.bool_) else answer  # as comparisons with NumPy's numbers give

    found, raised = _planning.plan(problem, scene, margin, options, callback)
    result = result_of(found)
    if isinstance(raised, KeyboardInterrupt):
        raise PlanningInterrupted(result) from raised
    if raised is not None:
        raise raised
    return result


def check(
    problem: Union[Problem, FileName],
    path: Union[npt.ArrayLike, FileName, PlanResult],
    *,
    scene: Optional[Scene] = None,
    margin: Optional[float] = None,
    profile: bool = True,
) -> CheckResult:
    """Audits a path along its whole length, also between its states, as `clearway check` does.

    problem: a problem file's name, or a Problem.
    path: poses (N, 4, 4), states (N, 7), a path file's name, or a PlanResult.
    scene, margin: as for plan().
    profile: whether to tell clearances along the path, which costs a few times as many queries.

    Bounds that the problem does not state hold the path too. Ctrl-C raises KeyboardInterrupt.

    Raises ArgumentError for a path without states, or with one that the problem's space cannot hold.
    """
    if isinstance(path, PlanResult):
        path = path.states
    found, raised = _planning.check(problem, path, scene, margin, profile)
    if raised is not None:
        raise raised
    return CheckResult(
        audit=audit_of(found),
        off_start=found["off_start"],
        off_goal=found["off_goal"],
        tolerance=found["tolerance"],
        profile=None if found["profile"] is None else Profile(**found["profile"]),
        warnings=tuple(found["warnings"]),
    )


def planner_names() -> List[str]:
    """The names that plan's planner takes, in any case: OMPL's class names and clearway's own."""
    return _planning.planner_names()


def objective_names() -> List[str]:
    """The names that plan's objective takes."""
    return _planning.objective_names()
