"""The results that clearway.planning returns."""

import os
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._core import ArgumentError, write_path

Floats = npt.NDArray[np.float64]
FileName = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Progress:
    """The state of a running plan(), for its callback."""

    seconds: float
    """Since the call of plan()."""
    phase: str
    """"loading", "planning", "widening" (there is a path, which gets more clearance), "finishing" (it is shortened and audited)
    or "asking why" (there is no path)."""


@dataclass(frozen=True, eq=False)
class Closest:
    """Where a path comes closest to what it must stay away from, of the poses looked at."""

    segment: int
    """The segment from state [segment] of the path to the next one."""
    time: float
    """Within the segment, from 0 to 1."""
    pose: Floats
    """(4, 4), X_environment_part there."""
    part_mesh: str
    """Name of the part's component; empty when no two triangles are known."""
    environment_mesh: str
    """Name of the environment's component."""
    part_triangle: int
    """Position in the part's mesh, -1 for none."""
    environment_triangle: int
    """Position in the component's file, -1 for none."""
    point_on_part: Floats
    """(3,), environment frame."""
    point_on_environment: Floats
    """(3,), environment frame."""


@dataclass(frozen=True)
class Fault:
    """A segment of a path that is not valid."""

    segment: int
    """The segment from state [segment] of the path to the next one."""
    verdict: str
    """"invalid", or "undecided": too close to a margin to tell, which counts as invalid."""
    certified_until: float
    """The segment is valid up to this time, unless its first state is not."""
    why: str
    """Words after "is", with meshes and triangles: "in collision: ..."."""
    kind: str
    """"out of bounds", "collides", "too deep", "inside a solid", "too close", "no pose", "out of range", "unusable" (a state or
    motion that cannot be judged for another reason) or "undecided"."""
    part_mesh: str
    """Name of the part's component that is the reason, or ""."""
    environment_mesh: str
    """Name of the obstacle's component that is the reason, or ""."""


@dataclass(frozen=True)
class Audit:
    """The proved verdict about all poses of a path, also between its states."""

    verdict: str
    """"valid", "invalid" or "undecided" (neither proved nor refuted, which counts as invalid)."""
    lower_clearance: float
    """No pose of the path has a clearance below this: distance less margin, or where overlaps are allowed, that of the shrunk part."""
    upper_clearance: float
    """Some pose of the path has at most this clearance."""
    length: float
    """Way of the origin of the part's coordinates."""
    rotation: float
    """Radians, summed over the path."""
    closest: Closest
    """Where the path comes closest."""
    faults: Tuple[Fault, ...]
    """The segments that are not valid, in order."""

    @property
    def is_valid(self) -> bool:
        """Whether every pose of the path is certified to be valid."""
        return self.verdict == "valid"


@dataclass(frozen=True, eq=False)
class Profile:
    """Clearances along a path, at M poses in the path's order."""

    segment: npt.NDArray[np.int64]
    """(M,): the segment of each pose."""
    time: Floats
    """(M,): within the segment, from 0 to 1."""
    travel: Floats
    """(M,): no point of the part has moved further since the path's start."""
    clearance: Floats
    """(M,): a lower bound of the clearance at the pose, above 0 exactly when it is valid."""
    lower_to_next: Floats
    """(M,): no pose from this one to the next one has less clearance; minus the largest margin where nothing is certified."""


@dataclass(frozen=True)
class CheckResult:
    """The verdict of check(). bool(result) is `solves`."""

    audit: Audit
    """The proved verdict about the path."""
    off_start: float
    """No point of the part is farther than this from its place at the problem's start when the path begins."""
    off_goal: float
    """The same for the goal and the path's end; for a goal outside, how far the part's box still overlaps the environment's."""
    tolerance: float
    """Offsets up to this are rounding in a file."""
    profile: Optional[Profile]
    """Clearances along the path; None unless asked for."""
    warnings: Tuple[str, ...]
    """About the problem file and the meshes, one line each."""

    @property
    def is_valid(self) -> bool:
        """Whether every pose of the path is certified to be valid, wherever the path begins and ends."""
        return self.audit.is_valid

    @property
    def begins_at_start(self) -> bool:
        """Whether the path begins at the problem's start."""
        return self.off_start <= self.tolerance

    @property
    def ends_at_goal(self) -> bool:
        """Whether the path ends at the problem's goal."""
        return self.off_goal <= self.tolerance

    @property
    def solves(self) -> bool:
        """Whether the path is valid, begins at the start and ends at the goal: what `clearway check` exits with 0 for."""
        return self.is_valid and self.begins_at_start and self.ends_at_goal

    def __bool__(self) -> bool:
        """`solves`."""
        return self.solves


@dataclass(frozen=True)
class Reached:
    """How far planning came from the start or from the goal."""

    states: int
    """States reached from there by valid motions, itself included."""
    has_tree: bool
    """Whether the planner tells the states reached from there."""
    farthest: float
    """The most that any point of the part moves from there to a state reached."""
    motions_stopped: int
    """How many of the motions that were tried from states reached."""
    bounds: Tuple[str, ...]
    """The bounds at which the part's origin is: "least x", "greatest z"."""
    is_shut_in: bool
    """Whether no state was reached in which a point of the part has moved by 1.5 of its diagonals."""


@dataclass(frozen=True)
class Blocker:
    """An obstacle or a bound that stopped motions from states that were reached."""

    name: str
    """The obstacle's component; empty for the bounds."""
    part_mesh: str
    """The part's component that it stopped most often; empty for a part of one component."""
    at_start: int
    """Motions that it stopped, from states reached from the start."""
    at_goal: int
    """Motions that it stopped, from states reached from the goal."""


@dataclass(frozen=True)
class FollowedTrack:
    """The end of a way that the planner for tight fits followed from the start as far as it went."""

    obstacle_mesh: str
    """The obstacle's mesh in the closest pair there; empty where the bounds end the track."""
    part_mesh: str
    """The part's mesh of that pair."""
    is_square: bool
    """The contact's normal is within 25 degrees of the track: nothing beside it gives way."""
    length: float
    """The way of the part's centre, and of a point a quarter of the diagonal from the axis of its turns."""


@dataclass(frozen=True, eq=False)
class WhyNoPath:
    """Why no path was found. str() says it in words."""

    diagonal: float
    """The diagonal of the part's box."""
    start: Reached
    """How far planning came from the start."""
    goal: Reached
    """How far planning came from the goal."""
    motions_tried: int
    """From random states reached towards random poses."""
    blockers: Tuple[Blocker, ...]
    """The obstacles and bounds that stopped them, most first."""
    tracks: Tuple[FollowedTrack, ...]
    """The tracks of the planner for tight fits, where it took part."""
    nearest_states: Floats
    """(N, 7): the way from the start to the goal on which only the motion from state [gap] to the next is not valid."""
    gap: int
    """That motion's segment."""
    displacement: float
    """The most that any point of the part moves over the gap."""

    def __str__(self) -> str:
        """A few lines for people."""
        lines = []
        for name, end in (("start", self.start), ("goal", self.goal)):
            if not end.has_tree:
                lines.append("from the %s: this planner does not expose its tree" % name)
                continue
            shut_in = ": it may be shut in there" if end.is_shut_in else ""
            lines.append("from the %s: %d states reached, where no point of the part has moved by more than %.4g%s"
                         % (name, end.states, end.farthest, shut_in))
            if end.bounds:
                lines.append("the %s is at the bounds %s" % (name, ", ".join(end.bounds)))
        stopped = sum(each.at_start + each.at_goal for each in self.blockers)
        for each in self.blockers[:5]:
            lines.append("%.0f %% of the motions that were stopped: by %s" % (
                100 * (each.at_start + each.at_goal) / stopped, "'%s'" % each.name if each.name else "the bounds"))
        for track in self.tracks:
            where = "%s '%s'" % ("square to" if track.is_square else "beside", track.obstacle_mesh)
            lines.append("a track of length %.4g ends %s" % (track.length, where if track.obstacle_mesh else "at the bounds"))
        lines.append("states reached from start and goal are %.4g apart" % self.displacement)
        return "\n".join(lines)


@dataclass(frozen=True, eq=False, repr=False)
class PlanResult:
    """The outcome of plan(). bool(result) says whether there is a valid path."""

    outcome: str
    """"found", "not found", or "stopped" before there was a path."""
    is_stopped: bool
    """Whether planning was stopped, by Ctrl-C or the callback; a path is then the best so far."""
    states: Floats
    """(N, 7), x y z qx qy qz qw: the path, from the problem's start to its goal; (0, 7) without one."""
    path: Floats
    """(N, 4, 4): the same states as poses, X_environment_part."""
    space: str
    """"SE3" or "SE2"."""
    length: float
    """Way of the origin of the part's coordinates."""
    rotation: float
    """Radians, summed over the path."""
    audit: Optional[Audit]
    """The proved verdict about the path, which is valid; None without one."""
    why_no_path: Optional[WhyNoPath]
    """What the planners learnt without finding a path; None where nothing was planned."""
    shut_in: Optional[Tuple[str, str]]
    """A proof that there is no path: "start" or "goal", and the closed surface that it is inside of, unlike the other end."""
    planners: Tuple[str, ...]
    """Those that ran side by side."""
    found_by: str
    """OMPL's name of the planner that found the path."""
    objective: str
    """Name of the objective; empty: the first path was taken."""
    cost: float
    """The path's cost by the objective, if there is one."""
    is_repeatable: bool
    """Whether the same seed and number of iterations give the same path."""
    floor: float
    """Clearance that shortening kept, where the planner's path kept it."""
    states_before: int
    """Number of states of the path as the planner found it."""
    planning_seconds: float
    """Until there was a path, or until the planner ended."""
    finishing_seconds: float
    """For widening, shortening and auditing, or for finding out why there is no path."""
    checks: int
    """Number of states that were asked about."""
    warnings: Tuple[str, ...]
    """About the problem file, the meshes and the planning, one line each."""

    def __repr__(self) -> str:
        """The outcome, and what is certain about the path."""
        if self.audit is None:
            return "PlanResult(%s)" % self.outcome
        return "PlanResult(%s, %d states, %s, clearance %.6g to %.6g)" % (
            self.outcome, len(self.states), self.audit.verdict, self.audit.lower_clearance, self.audit.upper_clearance)

    @property
    def is_found(self) -> bool:
        """Whether there is a path."""
        return self.outcome == "found"

    @property
    def is_valid(self) -> bool:
        """Whether there is a path, and every pose of it is certified to be valid."""
        return self.audit is not None and self.audit.is_valid

    def __bool__(self) -> bool:
        """`is_valid`."""
        return self.is_valid

    def save(self, file: FileName) -> None:
        """Writes the path file that `clearway plan` would write. Raises ArgumentError without a path."""
        if not self.is_found:
            raise ArgumentError("there is no path to save: the outcome is '%s'" % self.outcome)
        write_path(self.states, file, space=self.space)


class PlanningInterrupted(KeyboardInterrupt):
    """Ctrl-C during plan(). What was found until then is not lost."""

    result: PlanResult
    """The result until then: the best path so far, if there was one."""

    def __init__(self, result: PlanResult) -> None:
        """result: what was found until then."""
        super().__init__("planning was interrupted; %s" % (
            "the exception's result has the best path so far" if result.is_found else "there is no path yet"))
        self.result = result

    def __reduce__(self) -> Tuple[Any, ...]:
        """For pickle, which would make the exception anew from its text."""
        return PlanningInterrupted, (self.result,)


def audit_of(found: Dict[str, Any]) -> Audit:
    """From the extension's dict."""
    fields = ("verdict", "lower_clearance", "upper_clearance", "length", "rotation")
    return Audit(closest=Closest(**found["closest"]), faults=tuple(Fault(*each) for each in found["faults"]),
                 **{name: found[name] for name in fields})


def why_of(found: Dict[str, Any]) -> WhyNoPath:
    """From the extension's dict."""
    def reached(name: str) -> Reached:
        end = dict(found[name], is_shut_in=found["is_shut_in_at_" + name])
        return Reached(**dict(end, bounds=tuple(end["bounds"])))

    fields = ("diagonal", "motions_tried", "nearest_states", "gap", "displacement")
    return WhyNoPath(start=reached("start"), goal=reached("goal"), tracks=tuple(FollowedTrack(*each) for each in found["tracks"]),
                     blockers=tuple(Blocker(*each) for each in found["blockers"]),
                     **{name: found[name] for name in fields})


def result_of(found: Dict[str, Any]) -> PlanResult:
    """From the extension's dict."""
    return PlanResult(**dict(
        found,
        audit=None if found["audit"] is None else audit_of(found["audit"]),
        why_no_path=None if found["why_no_path"] is None else why_of(found["why_no_path"]),
        planners=tuple(found["planners"]),
        warnings=tuple(found["warnings"]),
    ))
