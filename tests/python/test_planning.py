"""clearway.planning: plans and checks are the program's, can be stopped, and lose nothing that was found."""

import os
import pickle
import re
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest
from support import DATA, cube, place, scene_of_cubes, turned

import clearway

planning = pytest.importorskip("clearway.planning", reason="clearway was built without OMPL")

BRACKET = DATA / "bracket" / "bracket.cfg"
CONSOLE = DATA / "tunnel-console-small" / "tunnel-console.cfg"


def endless():
    """A problem without a path, and its scene: the goal is within a box, of which only the surface counts. A slit leaves it open."""
    problem = clearway.Problem(place(-9), place(), bounds=[[-10] * 3, [10] * 3])
    whole = cube(2)
    box = clearway.Mesh(whole.vertices, whole.triangles[1:], name="cube")
    cover = clearway.Mesh(1.01 * whole.vertices, whole.triangles[:1], name="cover")
    obstacles = [clearway.Obstacle(clearway.Model(mesh)) for mesh in (box, cover)]
    return problem, clearway.Scene(clearway.Model(cube(0.5)), obstacles)


def run_python(text, *arguments, **keywords):
    return subprocess.Popen([sys.executable, "-B", "-c", textwrap.dedent(text), *arguments], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, cwd=os.path.dirname(__file__), **keywords)


@pytest.fixture(scope="module")
def planned():
    return planning.plan(BRACKET, planner="slidingrrtconnect", iterations=20000, quick=True)


def test_a_plan_is_certified_and_passes_the_check(planned, capfd):
    assert planned and planned.is_found and planned.is_valid and not planned.is_stopped
    assert (planned.outcome, planned.space, planned.planners) == ("found", "SE3", ("SlidingRRTConnect",))
    assert planned.states.shape[1:] == (7,) and planned.path.shape == (len(planned.states), 4, 4)
    assert np.array_equal(clearway.poses_from_states(planned.states), planned.path)
    assert 0 < planned.audit.lower_clearance <= planned.audit.upper_clearance and planned.audit.faults == ()
    checked = planning.check(BRACKET, planned)
    assert checked and checked.begins_at_start and checked.ends_at_goal
    assert checked.audit.length == planned.length == planned.audit.length
    scene = clearway.Scene.load(BRACKET)
    assert scene.is_free_batch(planned.path).all()
    steps = zip(planned.path, planned.path[1:])
    assert all(scene.check_motion(a, b)[0] == "certified" for a, b in steps)
    assert capfd.readouterr() == ("", "")  # OMPL's console is kept quiet


def test_a_plan_can_be_repeated(planned):
    scene = clearway.Scene.load(BRACKET)
    again = planning.plan(clearway.Problem.load(BRACKET), scene=scene, planner="SlidingRRTConnect", iterations=20000, quick=True)
    assert planned.is_repeatable and np.array_equal(again.states, planned.states)
    other = planning.plan(BRACKET, planner="SlidingRRTConnect", iterations=20000, quick=True, seed=2, parameters={"range": 20.0})
    assert not np.array_equal(other.states, planned.states)


def test_a_plan_is_that_of_the_program(tmp_path, planned):
    program = os.environ.get("CLEARWAY_PROGRAM")
    if not program:
        pytest.skip("CLEARWAY_PROGRAM does not name the program")
    options = ["--planner", "SlidingRRTConnect", "--iterations", "20000", "--quick"]
    subprocess.run([program, "plan", str(BRACKET), "--path", str(tmp_path / "theirs.path"), *options], check=True,
                   stdout=subprocess.DEVNULL)
    planned.save(tmp_path / "ours.path")
    assert (tmp_path / "ours.path").read_bytes() == (tmp_path / "theirs.path").read_bytes()


def test_plans_in_the_plane():
    found = planning.plan(DATA / "gates" / "gates.cfg", planner="RRTConnect", iterations=5000, quick=True)
    assert found.is_valid and found.space == "SE2" and not found.states[:, 2:5].any()


def test_a_problem_and_a_scene_made_in_memory():
    problem = clearway.Problem(place(-4), place(4), bounds=[[-5, -5, -5], [5, 5, 5]])
    found = planning.plan(problem, scene=scene_of_cubes(0.25), planner="RRTConnect", iterations=5000, quick=True)
    assert found.is_valid and found.length > 8
    assert planning.check(problem, found, scene=scene_of_cubes(0.25))
    assert not planning.check(problem, found, scene=scene_of_cubes(3))  # start and goal keep 2.5


def test_a_check_says_where_a_path_is_not_valid():
    problem, scene = clearway.Problem(place(-4), place(4)), scene_of_cubes(0.25)
    path = [place(-4), place(-4, 3), turned(0.5, 4, 3), place(4, 0.25), place(-4, 0.25)]
    checked = planning.check(problem, path, scene=scene)
    assert not checked and not checked.is_valid and checked.begins_at_start and not checked.ends_at_goal
    fault, = checked.audit.faults
    assert (fault.segment, fault.verdict) == (3, "invalid") and abs(fault.certified_until - 2.25 / 8) < 1e-3
    assert fault.kind == "too close" and fault.part_mesh == fault.environment_mesh == "cube" and "'cube'" in fault.why
    closest = checked.audit.closest
    assert (closest.segment, closest.part_mesh, closest.environment_mesh) == (3, "cube", "cube")
    assert not scene.is_free(closest.pose) and checked.audit.lower_clearance <= -0.25 <= checked.audit.upper_clearance
    good = planning.check(problem, path[:3], scene=scene)
    assert good.is_valid and not good and abs(good.audit.length - 11) < 1e-12 and abs(good.audit.rotation - 0.5) < 1e-12


def test_a_profile_bounds_the_clearance_of_every_pose():
    checked = planning.check(CONSOLE, CONSOLE.with_suffix(".path"))
    scene, profile = clearway.Scene.load(CONSOLE), checked.profile
    assert checked and 10 < checked.audit.lower_clearance <= checked.audit.upper_clearance < 15
    states = clearway.read_path(CONSOLE.with_suffix(".path"))
    assert len(profile.time) > len(states) and (np.diff(profile.travel) >= 0).all()
    assert (profile.lower_to_next >= checked.audit.lower_clearance - 1e-9).all()
    at_states = profile.time == 0
    clearances = scene.clearance_batch(states[:-1])
    assert at_states.sum() == len(clearances) and np.allclose(profile.clearance[at_states], clearances, rtol=1e-9)
    assert (profile.lower_to_next[at_states] <= clearances).all()
    assert planning.check(CONSOLE, states, profile=False).profile is None
    assert not planning.check(CONSOLE, states, margin=12)


def test_a_goal_in_a_closed_surface_is_told_as_a_proof():
    problem = clearway.Problem(place(-9), place(), bounds=[[-10] * 3, [10] * 3])
    shut = clearway.Scene(clearway.Model(cube(0.5)), [clearway.Obstacle(clearway.Model(cube(2)))])
    found = planning.plan(problem, scene=shut, seconds=20)
    assert found.shut_in == ("goal", "cube") and found.outcome == "not found" and found.why_no_path is None
    assert found.planning_seconds == 0


def test_why_there_is_no_path():
    problem, scene = endless()
    found = planning.plan(problem, scene=scene, planner="RRTConnect", iterations=300)
    assert not found and found.outcome == "not found" and found.audit is None and found.states.shape == (0, 7)
    why = found.why_no_path
    assert why.start.states > 1 and why.goal.is_shut_in and why.blockers[0].name == "cube" and why.nearest_states.shape[1] == 7
    assert "may be shut in there" in str(why) and "by 'cube'" in str(why)
    with pytest.raises(ValueError, match="no path to save: the outcome is 'not found'"):
        found.save("never.path")


@pytest.mark.parametrize(
    "options, words",
    [
        ({"seed": 0}, "seed is 0, .*from 1 to 4294967295"),
        ({"seed": -1}, "seed is -1"),
        ({"seed": 10**30}, "seed is 10{30}, expected"),
        ({"iterations": 0}, "iterations is 0"),
        ({"threads": -1}, "threads is -1"),
        ({"objective": "shortest"}, "shortest"),
        ({"floor": -1}, "floor is -1"),
        ({"objective": "length_with_clearance", "wanted_clearance": -1}, "-1"),
        ({"seconds": -1}, "time is -1.0.*above 0"),
        ({"seconds": float("nan")}, "time is nan"),
        ({"seconds": float("inf")}, "time is inf"),
        ({"seconds": 1, "iterations": 1}, "both a time and a number of iterations"),
        ({"planner": "RTT"}, "RTT"),
        ({"parameters": {"rnage": 1}}, "rnage"),
        ({"margin": -1}, "^margin is -1"),
        ({"margin": float("nan")}, "^margin is nan"),
        ({"quick": True, "objective": "length"}, "both quick and an objective"),
        ({"margin": 1e9}, "start is"),
    ],
)
def test_wrong_options_are_refused_with_the_text_of_the_library(options, words):
    with pytest.raises(ValueError, match=words):
        planning.plan(BRACKET, **options)


def test_wrong_types_of_options_raise():
    problem, scene = endless()
    for options in ({"seed": 1.5}, {"seed": None}, {"seconds": "long"}, {"planner": 3}, {"progress": 3}, {"parameters": 3},
                    {"planner": "\ud800"}, {"margin": []}, {"seed": "1"}):
        with pytest.raises((TypeError, UnicodeEncodeError, AttributeError)):
            planning.plan(problem, **dict({"scene": scene, "iterations": 100000}, **options))
    with pytest.raises(ValueError, match="both a scene and a margin"):
        planning.plan(problem, scene=scene, margin=1)
    with pytest.raises(ValueError, match="names no mesh files"):
        planning.plan(problem)
    for wrong in (7, None):
        with pytest.raises(TypeError):
            planning.plan(wrong)
    with pytest.raises(clearway.FileError, match="missing.cfg"):
        planning.plan("missing.cfg")


@pytest.mark.parametrize("path", [np.empty((0, 7)), np.empty((0, 4, 4)), np.eye(4), [np.eye(4) * 2], None, [[1e300] * 7]])
def test_what_is_no_path_is_not_checked(path):
    problem, scene = endless()
    with pytest.raises(ValueError):
        planning.check(problem, path, scene=scene)


def test_an_invalid_start_names_the_meshes_in_contact():
    problem, scene = endless()
    problem.start = place(2)
    with pytest.raises(ValueError, match="start.*'cube'"):
        planning.plan(problem, scene=scene)


def test_progress_is_told_and_can_stop_the_planning():
    problem, scene = endless()
    told = []

    def tell(now):
        told.append((now, threading.get_ident()))
        return len(told) < 3  # the first answers, True, do not stop

    found = planning.plan(problem, scene=scene, seconds=1e6, progress=tell)
    assert not found and found.is_stopped and found.outcome == "stopped" and len(told) == 3
    assert {thread for _, thread in told} == {threading.get_ident()}
    assert told[0][0].seconds <= told[1][0].seconds <= told[2][0].seconds and told[2][0].phase == "planning"


def test_a_comparison_with_a_number_of_numpy_can_stop_the_planning():
    problem, scene = endless()
    found = planning.plan(problem, scene=scene, seconds=1e6, progress=lambda now: now.seconds < np.float64(0.1))
    assert found.is_stopped


def test_planning_can_be_stopped_while_the_scene_is_loaded(tmp_path):
    x, y = np.meshgrid(np.arange(120.0), np.arange(120.0))
    corner = np.arange(119 * 120).reshape(119, 120)[:, :-1].ravel()
    triangles = np.concatenate([np.stack([corner, corner + 1, corner + 120], 1), np.stack([corner + 1, corner + 121, corner + 120], 1)])
    clearway.Mesh(np.stack([x, y, np.sin(x * y)], -1).reshape(-1, 3), triangles).save(tmp_path / "hills.ply")
    hills = tmp_path / "hills.ply"
    problem = clearway.Problem(place(z=9), place(z=19), bounds=[[-9] * 3, [99] * 3], robot=hills, worlds=[hills])
    phases = []
    found = planning.plan(problem, progress=lambda now: phases.append(now.phase) or False)
    assert not found and found.is_stopped and found.outcome == "stopped" and found.states.shape == (0, 7)
    assert phases == ["loading"]


def test_what_waits_for_its_turn_can_be_stopped():
    problem, scene = endless()
    waits = threading.Event()
    first = threading.Thread(target=planning.plan, args=(problem,),
                             kwargs={"scene": scene, "seconds": 1e6, "progress": lambda now: waits.set() or not is_over.is_set()})
    is_over = threading.Event()
    first.start()
    waits.wait()
    found = planning.plan(problem, scene=scene, seconds=1e6, progress=lambda now: False)
    assert not found and found.is_stopped and found.outcome == "stopped"
    assert first.is_alive()
    is_over.set()
    first.join()


def test_an_exception_of_the_callback_ends_the_planning():
    problem, scene = endless()

    def tell(now):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        planning.plan(problem, scene=scene, seconds=1e6, progress=tell)


def test_an_interrupt_keeps_the_path_found_so_far():
    phases = []

    def tell(now):
        phases.append(now.phase)
        if now.phase == "widening":
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt) as caught:
        planning.plan(BRACKET, planner="SlidingRRTConnect", seconds=1e6, progress=tell)
    assert isinstance(caught.value, planning.PlanningInterrupted) and "best path so far" in str(caught.value)
    result = caught.value.result
    assert result and result.is_stopped and planning.check(BRACKET, result) and "planning" in phases


@pytest.mark.parametrize("call", ["planning.plan(problem, scene=scene, seconds=1e6, progress=ready)",
                                  "path = way(); ready(); planning.check(problem, path, scene=scene)"])
def test_ctrl_c_ends_a_child_process(call):
    child = run_python("""
        import numpy as np
        from test_planning import endless, planning
        problem, scene = endless()
        def way():
            i = np.arange(400000)
            path = np.tile(np.eye(4), (len(i), 1, 1))
            path[:, 0, 0] = path[:, 1, 1] = np.cos(0.5 * i)
            path[:, 1, 0] = np.sin(0.5 * i)
            path[:, 0, 1] = -path[:, 1, 0]
            path[:, 0, 3] = -4 + 1e-4 * i
            return path
        ready = lambda *now: print("ready", flush=True)
        try:
            %s
        except KeyboardInterrupt as stop:
            print(type(stop).__name__, getattr(stop, "result", None))
        """ % call)
    assert child.stdout.readline() == "ready\n"
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=300)
    expected = "PlanningInterrupted PlanResult(stopped)" if "plan(" in call else "KeyboardInterrupt None"
    assert (out.replace("ready\n", "").strip(), err, child.returncode) == (expected, "", 0)


def test_other_threads_go_on_meanwhile():
    problem, scene = endless()
    ticks, is_over = [0], threading.Event()

    def tick():
        while not is_over.wait(0.001):
            ticks[0] += 1

    thread = threading.Thread(target=tick)
    thread.start()
    before = ticks[0]
    planning.plan(problem, scene=scene, seconds=0.5)
    after = ticks[0]
    is_over.set()
    thread.join()
    assert after - before > 10


def test_plans_of_several_threads_take_turns():
    results = []

    def plan():
        results.append(planning.plan(BRACKET, planner="SlidingRRTConnect", iterations=20000, quick=True))

    threads = [threading.Thread(target=plan) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 3 and all(np.array_equal(each.states, results[0].states) for each in results)


def test_a_thread_that_python_does_not_wait_for_ends_quietly():
    child = run_python("""
        import threading, time
        from test_planning import endless, planning
        problem, scene = endless()
        begun = threading.Event()
        tell = lambda now: begun.set()
        threading.Thread(target=lambda: planning.plan(problem, scene=scene, seconds=1e6, progress=tell), daemon=True).start()
        begun.wait()
        """)
    assert child.communicate(timeout=300) == ("", "") and child.returncode == 0


def test_results_can_be_pickled(planned):
    again = pickle.loads(pickle.dumps(planned))
    assert np.array_equal(again.states, planned.states) and again.audit.lower_clearance == planned.audit.lower_clearance
    checked = planning.check(BRACKET, planned)
    assert pickle.loads(pickle.dumps(checked)).audit.verdict == "valid"
    interrupted = pickle.loads(pickle.dumps(planning.PlanningInterrupted(planned)))
    assert np.array_equal(interrupted.result.states, planned.states) and "best path" in str(interrupted)


def test_names():
    assert {"RRTConnect", "PlannerTeam"} <= set(planning.planner_names())
    assert "max_min_clearance" in planning.objective_names()


def test_without_the_extension_the_module_says_what_is_missing(tmp_path):
    folder = tmp_path / "clearway"
    folder.mkdir()
    for name in os.listdir(os.path.dirname(clearway.__file__)):
        if not name.startswith(("_planning", "__pycache__")):
            (folder / name).symlink_to(os.path.join(os.path.dirname(clearway.__file__), name))
    for broken in (None, "_planning" + next(s for s in __import__("importlib.machinery").machinery.EXTENSION_SUFFIXES)):
        if broken:
            (folder / broken).write_bytes(b"no library")
        child = run_python("import clearway\nimport clearway.planning", env=dict(os.environ, PYTHONPATH=str(tmp_path)))
        expected = "could not load OMPL or another library" if broken else "this clearway was built without it"
        assert re.search("ImportError: clearway.planning .*" + expected, child.communicate(timeout=60)[1])
