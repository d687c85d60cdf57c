"""clearway as the checker inside OMPL's own Python bindings, the package `ompl` 2.x.

The classes hand OMPL's states to the core as plain numbers, because no extension can take another one's types. So they need no
OMPL that clearway was built with. States of SE(3) and SE(2) are poses X_environment_part: the position is in the
environment's units, the quaternion or the yaw (radians, about z) turns the part, which keeps z = 0 in SE(2).

OMPL's planners may run Python in threads that they cannot unwind, so nothing but KeyboardInterrupt and its like is raised out of
a planner's calls: a state or motion that cannot be judged counts as invalid, `unusable` counts it, `first_error` is the first
one's traceback, as text, and OMPL's console shows its last line.
"""

import importlib
import math
import traceback
from typing import Any, Callable, Optional, Tuple

import numpy.typing as npt

from . import ArgumentError, Scene, _core

try:
    _base: Any = importlib.import_module("ompl.base")
    _util: Any = importlib.import_module("ompl.util")
except ImportError as error:
    raise ImportError("clearway.ompl needs OMPL's Python bindings, the package ompl 2.x: %s" % error) from error

_Numbers = Tuple[float, ...]


class ValidityChecker(_base.StateValidityChecker):  # type: ignore[misc]
    """Tells OMPL whether the part is free at a state: within the space's bounds, farther from each obstacle than its margin,
    and in no solid.

    Counters, since the checker was made: `checks`, of these `invalid`, of these `out_of_bounds` and `unusable`.
    """

    def __init__(
        self, si: Any, scene: Scene, state_to_pose: Optional[Callable[[Any], npt.ArrayLike]] = None
    ) -> None:
        """si: ompl.base.SpaceInformation, of SE3StateSpace or SE2StateSpace. Any other space needs `state_to_pose`, which
        returns the pose (4, 4), X_environment_part, of a state. Raises ArgumentError, naming the space, without it."""
        super().__init__(si)
        space = si.getStateSpace()
        self._satisfies_bounds = _satisfies_bounds(space)
        self._scene = _require_scene(scene)
        self._pose = state_to_pose
        self._numbers = None if state_to_pose is not None else _pose_numbers(space)
        self.checks = self.invalid = self.out_of_bounds = self.unusable = 0
        self.first_error = ""

    def isValid(self, state: Any) -> bool:
        """Whether the state is valid."""
        self.checks += 1
        try:
            if not self._satisfies_bounds(state):
                self.out_of_bounds += 1
            elif self._numbers is None:
                if self._scene.is_free(self._pose(state)):  # type: ignore[misc]
                    return True
            elif _core.is_free_at_state(self._scene, *self._numbers(state)):
                return True
        except Exception as error:
            self.unusable += 1
            self.first_error = self.first_error or _warn("a state", error)
        self.invalid += 1
        return False

    def clearance(self, state: Any) -> float:
        """A lower bound of distance - margin, the least over the obstacles, in environment units. Above 0 exactly when the
        state is valid; it is no depth of penetration. Infinite without obstacles."""
        self.checks += 1
        try:
            if self._numbers is None:
                clearance = self._scene.clearance(self._pose(state))  # type: ignore[misc]
            else:
                clearance = _core.clearance_at_state(self._scene, *self._numbers(state))
            if not self._satisfies_bounds(state):
                self.out_of_bounds += 1
                clearance = min(clearance, 0.0)
        except Exception as error:
            clearance = 0.0
            self.unusable += 1
            self.first_error = self.first_error or _warn("a state", error)
        if clearance <= 0:
            self.invalid += 1
        return clearance


class MotionValidator(_base.MotionValidator):  # type: ignore[misc]
    """Certifies whole motions of SE3StateSpace and SE2StateSpace as OMPL interpolates them, however thin an obstacle is.

    When checkMotion returns True, both states and all poses between them are within the bounds, and valid as ValidityChecker
    has it. A motion that is too close to a margin to tell is answered False.

    OMPL's bindings have no place for the counts: OMPL's own C++ counters stay 0, while the getters here answer in Python. Bindings
    that do not call checkMotionWithLastValid give C++ planners that ask for the last valid state False and their own default.
    """

    def __init__(self, si: Any, scene: Scene) -> None:
        """si: ompl.base.SpaceInformation. Raises ArgumentError, naming the space, unless it is SE3StateSpace or SE2StateSpace:
        other spaces interpolate in their own ways."""
        super().__init__(si)
        space = si.getStateSpace()
        self._satisfies_bounds = _satisfies_bounds(space)
        self._scene = _require_scene(scene)
        bound = _class_of_bindings(space)
        if bound is _base.SE3StateSpace:
            self._numbers, self._certify, self._follow = _numbers_of_se3, _core.certify_se3_motion, _core.follow_se3_motion
        elif bound is _base.SE2StateSpace:
            self._numbers, self._certify, self._follow = _numbers_of_se2, _core.certify_se2_motion, _core.follow_se2_motion
        else:
            raise ArgumentError(
                "the motions of state space '%s' (%s) are unknown, expected SE3StateSpace or SE2StateSpace"
                % (space.getName(), bound.__name__)
            )
        self._interpolate, self._copy = space.interpolate, space.copyState
        self._valid = self._invalid = self.undecided = self.unusable = 0
        self.first_error = ""

    def checkMotion(self, s1: Any, s2: Any) -> bool:
        """Whether the motion from s1 to s2 is certified."""
        return self._count(self._ask(self._certify, s1, s2))

    def checkMotionWithLastValid(self, s1: Any, s2: Any, last_valid: Optional[Any]) -> Tuple[bool, float]:
        """Whether the motion from s1 to s2 is certified, and the share of it, from s1 on, that is: (True, 1.0) leaves `last_valid` as
        it is. Otherwise the share is below 1, and `last_valid`, unless None, becomes the state there. The share is 0, and the
        state s1, where s1 is not valid or s2 is out of bounds. `last_valid` may be s1 or s2 itself."""
        verdict, share = self._ask(self._follow, s1, s2) or (None, 0.0)
        if self._count(verdict):
            return True, 1.0
        if last_valid is not None:
            if share > 0:
                self._interpolate(s1, s2, share, last_valid)
            else:
                self._copy(last_valid, s1)
        return False, share

    def _ask(self, core: Callable[..., Any], s1: Any, s2: Any) -> Any:
        """What a function of the core answers about the motion; None if a state is out of bounds or cannot be judged."""
        try:
            if self._satisfies_bounds(s1) and self._satisfies_bounds(s2):
                return core(self._scene, *self._numbers(s1), *self._numbers(s2))
        except Exception as error:
            self.unusable += 1
            self.first_error = self.first_error or _warn("a motion", error)
        return None

    def _count(self, verdict: Optional[str]) -> bool:
        if verdict == "certified":
            self._valid += 1
            return True
        self.undecided += verdict == "undecided"
        self._invalid += 1
        return False

    def getValidMotionCount(self) -> int:
        """The number of motions answered True."""
        return self._valid

    def getInvalidMotionCount(self) -> int:
        """The number of motions answered False."""
        return self._invalid

    def getCheckedMotionCount(self) -> int:
        """The number of motions checked."""
        return self._valid + self._invalid

    def getValidMotionFraction(self) -> float:
        """The share of motions answered True; 0 before the first."""
        return self._valid / max(self._valid + self._invalid, 1)

    def resetMotionCounter(self) -> None:
        """Starts the counts at 0."""
        self._valid = self._invalid = self.undecided = self.unusable = 0


def _numbers_of_se3(state: Any) -> _Numbers:
    rotation = state.rotation()
    return state.getX(), state.getY(), state.getZ(), rotation.x, rotation.y, rotation.z, rotation.w


def _numbers_of_se2(state: Any) -> _Numbers:
    return state.getX(), state.getY(), state.getYaw()


def _pose_numbers_of_se2(state: Any) -> _Numbers:
    half = 0.5 * state.getYaw()
    return state.getX(), state.getY(), 0.0, 0.0, 0.0, math.sin(half), math.cos(half)


def _pose_numbers(space: Any) -> Callable[[Any], _Numbers]:
    if isinstance(space, _base.SE3StateSpace):
        return _numbers_of_se3
    if isinstance(space, _base.SE2StateSpace):
        return _pose_numbers_of_se2
    raise ArgumentError(
        "state space '%s' (%s) is neither SE(3) nor SE(2), expected state_to_pose, a function from its states to poses"
        % (space.getName(), type(space).__name__)
    )


def _require_scene(scene: Any) -> Scene:
    if isinstance(scene, Scene):
        return scene
    raise TypeError("scene is of type %s, expected clearway.Scene" % type(scene).__name__)


def _class_of_bindings(space: Any) -> Any:
    """The class that OMPL itself gave the space. A class of Python's that derives from it cannot change its interpolation."""
    bindings = _base.StateSpace.__module__
    return next(c for c in type(space).__mro__ if c.__module__ == bindings)


def _satisfies_bounds(space: Any) -> Callable[[Any], bool]:
    """The space's own function, and not that of the space information, which owns the checker: the two would never be freed."""
    try:
        satisfies: Callable[[Any], bool] = space.satisfiesBounds
    except AttributeError:
        raise ArgumentError(
            "OMPL's bindings of state space '%s' (%s) have no satisfiesBounds, expected a space that has bounds"
            % (space.getName(), type(space).__name__)
        ) from None
    return satisfies


def _warn(what: str, error: Exception) -> str:
    """Shows the error and returns it as text: its frames would keep everything alive that OMPL and Python hold together."""
    text = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    text = text.encode("utf-8", "replace").decode()  # OMPL takes no lone surrogates, as names of files may hold
    _util.OMPL_WARN("clearway: %s was answered invalid: %s. Further ones are only counted." % (what, text.splitlines()[-1]))
    return text
