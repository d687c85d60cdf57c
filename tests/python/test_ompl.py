"""clearway.ompl with OMPL's own Python bindings, where these are installed, and with a stand-in of the same interface."""

import gc
import importlib
import math
import pathlib
import random
import re
import runpy
import subprocess
import sys
import weakref

import numpy as np
import pytest

import clearway
import ompl_stand_in
from support import prepare_documents

ROOT = pathlib.Path(__file__).parents[2]
UPRIGHT = (0, 0, 0, 1)


def bindings_or_skip():
    try:
        return importlib.import_module("ompl")
    except ImportError:
        pytest.skip("OMPL's Python bindings, the package ompl 2.x, are not installed")


class Bindings:
    """One of the two `ompl`, and the clearway.ompl on it."""

    def __init__(self, ompl):
        self.base, self.util = ompl.base, ompl.util
        self.clearway = importlib.import_module("clearway.ompl")

    def space(self, kind="SE3", bound=10):
        space = getattr(self.base, kind + "StateSpace")(*[2] * (kind == "RealVector"))
        return self.bounded(space, 3 if kind == "SE3" else 2, bound)

    def bounded(self, space, dimensions, bound=10):
        bounds = self.base.RealVectorBounds(dimensions)
        bounds.setLow(-bound)
        bounds.setHigh(bound)
        space.setBounds(bounds)
        return space

    def checked(self, space, scene):
        """A space information with both adaptors."""
        si = self.base.SpaceInformation(space)
        checker, validator = self.clearway.ValidityChecker(si, scene), self.clearway.MotionValidator(si, scene)
        si.setStateValidityChecker(checker)
        si.setMotionValidator(validator)
        si.setup()
        return si, checker, validator


@pytest.fixture(params=["stand-in", "ompl"])
def bindings(request, monkeypatch):
    monkeypatch.delitem(sys.modules, "clearway.ompl", raising=False)
    if request.param == "ompl":
        return Bindings(bindings_or_skip())
    for name, module in (("ompl", ompl_stand_in), ("ompl.base", ompl_stand_in.base), ("ompl.util", ompl_stand_in.util)):
        monkeypatch.setitem(sys.modules, name, module)
    return Bindings(ompl_stand_in)


@pytest.fixture
def real(monkeypatch):
    monkeypatch.delitem(sys.modules, "clearway.ompl", raising=False)
    return Bindings(bindings_or_skip())


def mesh_of_box(*sides, at=(0, 0, 0)):
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.array(sides) / 2 + at
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]]
    faces += [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    return clearway.Mesh(corners, np.array(faces))


def box(*sides, **options):
    return clearway.Model(mesh_of_box(*sides, **options))


def cubes(margin=0.25):
    return clearway.Scene(box(1, 1, 1), [clearway.Obstacle(box(2, 2, 2), margin)])


def se3(space, x, y, z, rotation=UPRIGHT):
    state = space.allocState()
    state.setXYZ(x, y, z)
    state.rotation().x, state.rotation().y, state.rotation().z, state.rotation().w = rotation
    return state


def se2(space, x, y, yaw=0.0):
    state = space.allocState()
    state.setXY(x, y)
    state.setYaw(yaw)
    return state


def pose_of(state):
    q = state.rotation()
    return clearway.pose_from([state.getX(), state.getY(), state.getZ()], [q.x, q.y, q.z, q.w])


def turned(rotation, angle, axis):
    """The rotation (x, y, z, w) turned by an angle about an axis."""
    x, y, z = np.array(axis) / np.linalg.norm(axis) * math.sin(angle / 2)
    w, (a, b, c, d) = math.cos(angle / 2), rotation
    product = [w * a + x * d + y * c - z * b, w * b - x * c + y * d + z * a, w * c + x * b - y * a + z * d]
    return tuple(product + [w * d - x * a - y * b - z * c])


def test_states_are_judged_as_poses_within_the_bounds(bindings):
    scene, space, draw = cubes(), bindings.space(), random.Random(1)
    si, checker, _ = bindings.checked(space, scene)
    valid = 0
    for _ in range(300):
        rotation = turned(UPRIGHT, draw.uniform(0, math.pi), [draw.gauss(0, 1) for _ in range(3)])
        state = se3(space, *[draw.uniform(-2, 2) for _ in range(3)], rotation)
        assert si.isValid(state) == scene.is_free(pose_of(state)) == (checker.clearance(state) > 0)
        assert checker.clearance(state) == pytest.approx(scene.clearance(pose_of(state)), abs=1e-9)
        valid += si.isValid(state)
    assert 50 < valid < 250
    counted = (checker.checks, checker.invalid, checker.out_of_bounds, checker.unusable)
    assert counted == (1200, 4 * (300 - valid), 0, 0)
    outside = se3(space, 10.5, 0, 0)
    assert not si.isValid(outside) and checker.clearance(outside) == 0 and checker.out_of_bounds == 2


def test_planar_states_turn_about_z(bindings):
    scene = clearway.Scene(box(4, 0.5, 1, at=(2, 0, 0)), [clearway.Obstacle(box(1, 1, 1, at=(0, 2, 0)))])
    space = bindings.space("SE2")
    si, checker, validator = bindings.checked(space, scene)
    assert si.isValid(se2(space, 0, 0)) and not si.isValid(se2(space, 0, 0, math.pi / 2))
    assert si.isValid(se2(space, 3, 1, math.pi / 2)) and not si.isValid(se2(space, 0, 10.5))
    assert checker.clearance(se2(space, 0, 0)) == pytest.approx(1.25)
    assert not si.checkMotion(se2(space, 0, 0, 0.2), se2(space, 0, 0, math.pi - 0.2))  # through the obstacle
    assert si.checkMotion(se2(space, 0, 0, 0.2), se2(space, 0, 0, -math.pi + 0.3))
    assert si.checkMotion(se2(space, 0, -2, 3), se2(space, 0, -2, -3))  # the shorter way, past pi
    assert (validator.getValidMotionCount(), validator.getInvalidMotionCount()) == (2, 1)


def motions(draw):
    """Pairs of positions and rotations near the cubes: short and long, with turns that OMPL leaves out, and half turns."""
    angles = (0, 1e-5, 8e-5, 8.95e-5, 1e-4, 1e-3, 0.3, 2, math.pi)
    for i in range(270):
        first = turned(UPRIGHT, draw.uniform(0, math.pi), [draw.gauss(0, 1) for _ in range(3)]) if i % 3 else UPRIGHT
        second = turned(first, angles[i % 9], [draw.gauss(0, 1) for _ in range(3)] if i % 2 else (0, 0, 1))
        if i % 4 == 0:
            second = tuple(-x for x in second)
        at = [draw.uniform(-2.5, 2.5) for _ in range(3)]
        yield at, first, [x + draw.gauss(0, 1) * draw.choice([0.01, 0.1, 2]) for x in at], second


def test_a_certified_motion_is_free_wherever_ompl_interpolates_it(bindings):
    scene, space = cubes(), bindings.space()
    si, checker, validator = bindings.checked(space, scene)
    between, certified, steps = space.allocState(), 0, 200
    for p1, q1, p2, q2 in motions(random.Random(2)):
        s1, s2 = se3(space, *p1, q1), se3(space, *p2, q2)
        least = min(checker.clearance(s1), checker.clearance(s2))
        for i in range(steps + 1):
            space.interpolate(s1, s2, i / steps, between)
            least = min(least, scene.clearance(pose_of(between)))
        angle = 2 * math.acos(min(1, abs(sum(a * b for a, b in zip(q1, q2)))))
        moved = (math.dist(p1, p2) + angle * math.sqrt(0.75)) / steps
        if si.checkMotion(s1, s2):
            certified += 1
            assert least > 0
        elif angle < 3.1:  # a half turn must be free both ways
            assert least < moved
    assert 60 < certified < 210 and validator.undecided < 3
    assert validator.getValidMotionCount() == certified and validator.getCheckedMotionCount() == 270
    assert validator.getValidMotionFraction() == certified / 270
    validator.resetMotionCounter()
    assert validator.getCheckedMotionCount() == validator.getValidMotionFraction() == 0


def test_a_turn_that_ompl_leaves_out_is_left_out(bindings):
    """OMPL keeps the first rotation until the end when the turn is small. At the end of a bar of 1000 it matters."""
    bar = box(1000, 1, 1, at=(500, 0, 0))
    turn = turned(UPRIGHT, 2e-5, (0, 0, 1))  # takes the bar's end to y = 0.52
    scene = clearway.Scene(bar, [clearway.Obstacle(box(1, 1, 1, at=(999.5, 1.015, 5)))])
    space = bindings.space()
    si, _, _ = bindings.checked(space, scene)
    between, halfway = space.allocState(), se3(space, 0, 0, 5, turned(UPRIGHT, 1e-5, (0, 0, 1)))
    for first, second, free in ((turn, UPRIGHT, False), (UPRIGHT, turn, True)):
        s1, s2 = se3(space, 0, 0, 0, first), se3(space, 0, 0, 10, second)
        space.interpolate(s1, s2, 0.5, between)
        assert si.isValid(halfway) and si.isValid(between) == free
        assert si.checkMotion(s1, s2) == free
    s2 = se3(space, 0, 0, 5, turn)
    assert not si.isValid(s2) and not si.checkMotion(se3(space, 0, 0, 0), s2)


def test_the_shorter_turn_counts_whatever_the_sign_of_a_quaternion(bindings):
    scene = clearway.Scene(box(4, 0.5, 1, at=(2, 0, 0)), [clearway.Obstacle(box(1, 1, 1, at=(0, 2, 0)))])
    space = bindings.space()
    si, _, _ = bindings.checked(space, scene)
    for yaw, free in ((math.pi - 0.2, False), (-math.pi + 0.3, True)):
        for sign in (1, -1):
            s1 = se3(space, 0, 0, 0, turned(UPRIGHT, 0.2, (0, 0, 1)))
            s2 = se3(space, 0, 0, 0, tuple(sign * x for x in turned(UPRIGHT, yaw, (0, 0, 1))))
            assert si.checkMotion(s1, s2) == si.checkMotion(s2, s1) == free


def test_thin_walls_are_seen(bindings):
    scene = clearway.Scene(box(1, 1, 1), [clearway.Obstacle(box(1e-6, 9, 9))])
    space = bindings.space()
    si, _, validator = bindings.checked(space, scene)
    assert si.isValid(se3(space, -9, 0, 0)) and si.isValid(se3(space, 9, 0, 0))
    assert not si.checkMotion(se3(space, -9, 0, 0), se3(space, 9, 0, 0))
    assert si.checkMotion(se3(space, -9, 6, 0), se3(space, 9, 6, 0))
    assert not si.checkMotion(se3(space, -9, 6, 0), se3(space, -9, 10.1, 0))  # out of bounds
    assert si.getMotionValidator() is validator and validator.undecided == 0


def test_the_last_valid_state_is_certified_from_the_first_one_on(bindings):
    scene, space, parts = cubes(), bindings.space(), 0
    _, checker, validator = bindings.checked(space, scene)
    for p1, q1, p2, q2 in motions(random.Random(4)):
        s1, s2, last = se3(space, *p1, q1), se3(space, *p2, q2), se3(space, 9, 9, 9)
        valid, fraction = validator.checkMotionWithLastValid(s1, s2, last)
        assert valid == validator.checkMotion(s1, s2) == (fraction == 1) and 0 <= fraction <= 1
        assert validator.checkMotionWithLastValid(s1, s2, None) == (valid, fraction)
        if valid:
            assert last.getX() == 9
        elif fraction == 0:
            assert last.getX() == s1.getX()
        else:
            parts += 1
            assert checker.isValid(last) and validator.checkMotion(s1, last)
            assert validator.checkMotionWithLastValid(s1, s2, s2) == (False, fraction) and pose_of(s2) == pytest.approx(pose_of(last))
    assert parts > 20 and validator.unusable == 0


def test_a_motion_is_followed_up_to_a_wall_and_no_further_than_the_bounds(bindings):
    scene = clearway.Scene(box(1, 1, 1), [clearway.Obstacle(box(1e-6, 9, 9))])
    for space, state in ((bindings.space(), se3), (bindings.space("SE2"), se2)):
        def at(x, space=space, state=state):
            return state(space, x, *[0, 0][:1 + (state is se3)])

        _, _, validator = bindings.checked(space, scene)
        last = space.allocState()
        valid, fraction = validator.checkMotionWithLastValid(at(-9), at(9), last)
        assert not valid and fraction == pytest.approx(8.5 / 18, abs=1e-3) and fraction < 8.5 / 18
        assert last.getX() == pytest.approx(-9 + 18 * fraction)
        assert validator.checkMotionWithLastValid(at(-9), at(0.2), None)[1] == pytest.approx(8.5 / 9.2, abs=1e-3)
        assert validator.checkMotionWithLastValid(at(-9), at(-10.1), last) == (False, 0) and last.getX() == -9
        assert validator.checkMotionWithLastValid(at(0), at(9), last) == (False, 0) and last.getX() == 0
        assert (validator.getInvalidMotionCount(), validator.getValidMotionCount()) == (4, 0)


def test_the_example_finds_the_wall_between_two_steps(bindings, capsys):
    runpy.run_path(str(ROOT / "python" / "examples" / "audit_steps.py"))
    assert "motion 2: free in steps, free up to x = -0.26" in capsys.readouterr().out


def test_other_spaces_are_refused_by_name_or_need_a_callback(bindings):
    scene = cubes(0)
    plane = bindings.space("RealVector")
    si = bindings.base.SpaceInformation(plane)
    with pytest.raises(ValueError, match="%s.*neither SE.3. nor SE.2., expected state_to_pose" % plane.getName()):
        bindings.clearway.ValidityChecker(si, scene)
    with pytest.raises(ValueError, match="%s.*expected SE3StateSpace or SE2StateSpace" % plane.getName()):
        bindings.clearway.MotionValidator(si, scene)
    with pytest.raises(ValueError, match="DubinsStateSpace.*expected SE3StateSpace or SE2StateSpace"):
        bindings.clearway.MotionValidator(bindings.base.SpaceInformation(bindings.space("Dubins")), scene)

    for adaptor in (bindings.clearway.ValidityChecker, bindings.clearway.MotionValidator):
        with pytest.raises(TypeError, match="scene is of type Model, expected clearway.Scene"):
            adaptor(bindings.base.SpaceInformation(bindings.space()), box(1, 1, 1))

    checker = bindings.clearway.ValidityChecker(si, scene, lambda s: clearway.pose_from([s[0], s[1], 0], UPRIGHT))
    si.setStateValidityChecker(checker)
    state = plane.allocState()
    for x, y, valid in ((2, 0, True), (1, 0, False), (0, -11, False)):
        state[0], state[1] = x, y
        assert si.isValid(state) == valid == (checker.clearance(state) > 0)
    assert checker.out_of_bounds == 2


def test_a_python_class_of_se3_is_se3(bindings):
    class Mine(bindings.base.SE3StateSpace):
        pass

    space = bindings.bounded(Mine(), 3)
    si, _, _ = bindings.checked(space, cubes())
    assert si.checkMotion(se3(space, 3, 0, 0), se3(space, 3, 3, 0))


def test_what_cannot_be_judged_is_invalid_counted_and_kept(bindings):
    space, scene = bindings.space(), cubes()
    si, checker, validator = bindings.checked(space, scene)
    nowhere = se3(space, 3, 0, 0)
    nowhere.setX(math.nan)
    assert not si.isValid(nowhere) and not si.checkMotion(nowhere, se3(space, 3, 0, 0))
    assert not si.isValid(se3(space, 3, 0, 0, (0, 0, 0, 0))) and checker.clearance(nowhere) <= 0
    assert not si.checkMotion(se3(space, 3, 0, 0), se3(space, 3, 1, 0, (0, 0, 0, 1 + 2e-9)))

    def raising(state):
        raise KeyError("no such state")

    def raising_about_a_file(state):
        raise FileNotFoundError("caf\udce9.stl")  # the name of a file that is not UTF-8, as Python has it

    for callback, words in ((raising, "in raising"), (raising_about_a_file, "caf?.stl"),
                            (lambda state: np.eye(3), "pose has shape (3, 3)")):
        checker = bindings.clearway.ValidityChecker(si, scene, callback)
        si.setStateValidityChecker(checker)
        assert not si.isValid(se3(space, 3, 0, 0)) and checker.clearance(se3(space, 3, 0, 0)) == 0
        assert words in checker.first_error
        assert checker.unusable == checker.invalid == 2


def test_an_interrupt_ends_the_planner(bindings):
    space = bindings.space()
    si, _, _ = bindings.checked(space, cubes())

    def interrupted(state):
        raise KeyboardInterrupt

    checker = bindings.clearway.ValidityChecker(si, cubes(), interrupted)
    si.setStateValidityChecker(checker)
    with pytest.raises(KeyboardInterrupt):
        si.isValid(se3(space, 3, 0, 0))


def test_adaptors_go_with_their_space_information(bindings):
    def lives():
        return [weakref.ref(thing) for thing in bindings.checked(bindings.space(), cubes())[1:]]

    seen = lives()
    gc.collect()
    assert [thing() for thing in seen] == [None, None]


def test_without_bindings_the_import_names_what_is_missing(monkeypatch):
    monkeypatch.delitem(sys.modules, "clearway.ompl", raising=False)
    for name in ("ompl", "ompl.base"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match="clearway.ompl needs OMPL's Python bindings, the package ompl 2.x"):
        importlib.import_module("clearway.ompl")


def test_the_stand_in_is_as_the_bindings(real):
    for name, stand_in in vars(ompl_stand_in.base).items():
        if isinstance(stand_in, type):
            public = [member for member in vars(stand_in) if not member.startswith("_")]
            assert not [m for m in public if not hasattr(getattr(real.base, name), m)], name
    assert callable(real.util.OMPL_WARN)
    assert not {"x", "w", "getQuaternion"} & set(dir(real.base.SE3State))
    draw, spaces = random.Random(3), [ompl_stand_in.base.SE3StateSpace(), real.base.SE3StateSpace()]
    for p1, q1, p2, q2 in motions(draw):
        time, ways = draw.random(), []
        for space in spaces:
            s1, s2, between = se3(space, *p1, q1), se3(space, *p2, q2), space.allocState()
            space.interpolate(s1, s2, time, between)
            ways.append(pose_of(between))
        half = abs(sum(a * b for a, b in zip(q1, q2))) < 1e-15
        assert half or abs(ways[0] - ways[1]).max() < 1e-9


def assert_solves(real, planner, space, scene, ends, seconds):
    geometric = importlib.import_module("ompl.geometric")
    setup = geometric.SimpleSetup(space)
    si = setup.getSpaceInformation()
    setup.setStateValidityChecker(real.clearway.ValidityChecker(si, scene))
    validator = real.clearway.MotionValidator(si, scene)
    si.setMotionValidator(validator)
    setup.setStartAndGoalStates(*ends)
    setup.setPlanner(getattr(geometric, planner)(si))
    assert str(setup.solve(seconds)) == "Exact solution"
    setup.simplifySolution()
    poses = [pose_of(state) for state in setup.getSolutionPath().getStates()]
    assert len(poses) > 2 and all(scene.check_motion(a, b)[0] == "certified" for a, b in zip(poses, poses[1:]))
    assert validator.getInvalidMotionCount() > 0 and validator.unusable == 0


@pytest.mark.parametrize("planner", ["RRTstar", "KPIECE1", "LBKPIECE1", "PRM", "BITstar"])
def test_planners_go_round_an_obstacle(real, planner):
    space = real.space(bound=4)
    ends = se3(space, -3, 0, 0), se3(space, 3, 0, 0, turned(UPRIGHT, 3, (0, 1, 0)))
    assert_solves(real, planner, space, cubes(), ends, 0.5 if planner in ("RRTstar", "BITstar") else 60)


def test_rrt_connect_takes_the_plate_through_the_window(real):
    part, wall = (clearway.Model(clearway.Mesh.load(str(ROOT / "data" / "window" / f))) for f in ("plate.obj", "wall.obj"))
    space, upright = real.space(bound=80), turned(UPRIGHT, math.pi / 2, (1, 0, 0))
    space.setSubspaceWeight(1, 30)
    ends = se3(space, -60, 0, 0, upright), se3(space, 60, 0, 0, upright)
    assert_solves(real, "RRTConnect", space, clearway.Scene(part, [clearway.Obstacle(wall)]), ends, 60)


def test_errors_do_not_end_planners_that_have_threads(real):
    """PRM ends the process when an exception passes it, so none must."""
    code = """
import clearway, clearway.ompl
from ompl import base, geometric
space = base.SE3StateSpace()
bounds = base.RealVectorBounds(3)
bounds.setLow(-1)
bounds.setHigh(1)
space.setBounds(bounds)
si = base.SpaceInformation(space)
part = clearway.Model(clearway.Mesh([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]], [[0, 1, 2]]))
calls = 0
def pose(state):
    global calls
    calls += 1
    if calls > 20:
        raise RuntimeError("the callback fails")
    return clearway.pose_from([state.getX(), state.getY(), state.getZ()], [0, 0, 0, 1])
checker = clearway.ompl.ValidityChecker(si, clearway.Scene(part, []), pose)
si.setStateValidityChecker(checker)
si.setMotionValidator(clearway.ompl.MotionValidator(si, clearway.Scene(part, [])))
problem = base.ProblemDefinition(si)
start, goal = space.allocState(), space.allocState()
for state, x in ((start, -0.5), (goal, 0.5)):
    state.setXYZ(x, 0, 0)
    state.rotation().setIdentity()
problem.setStartAndGoalStates(start, goal)
planner = geometric.PRMstar(si)
planner.setProblemDefinition(problem)
planner.setup()
planner.solve(0.3)
print(checker.first_error.splitlines()[-1], checker.unusable > 0)
"""
    ended = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    assert ended.stdout.splitlines()[-1] == "RuntimeError: the callback fails True"


def test_the_documents_code_runs_with_ompl(real, tmp_path, monkeypatch):
    pytest.importorskip("clearway.planning", reason="clearway was built without OMPL")
    monkeypatch.chdir(tmp_path)
    prepare_documents(tmp_path)
    pieces = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(), re.S)
    assert any("clearway.ompl" in piece for piece in pieces)
    exec("\n".join(pieces), {})
