"""Problems, their files and scenes, and path files."""

import copy
import math
import pickle
import re

import numpy as np
import pytest
from support import DATA, cube, place, scene_of_cubes, turned

import clearway

CONSOLE = DATA / "tunnel-console-small" / "tunnel-console.cfg"


def test_a_problem_file_is_read():
    problem = clearway.Problem.load(CONSOLE)
    assert (problem.file, problem.space, problem.name) == (str(CONSOLE), "SE3", "tunnel-console v1")
    assert problem.robot.endswith("tunnel-console_part.obj") and len(problem.worlds) == 1
    assert problem.start.shape == problem.goal.shape == (4, 4) and problem.outside is None
    path = clearway.read_path(CONSOLE.with_suffix(".path"))
    assert abs(path[0] - problem.start).max() < 1e-12 and abs(path[-1] - problem.goal).max() < 1e-12
    assert clearway.Problem.load(str(DATA / "gates" / "gates.cfg")).space == "SE2"


def test_wrong_problem_files_are_refused_with_the_text_of_the_library(tmp_path):
    with pytest.raises(clearway.FileError, match="missing.cfg"):
        clearway.Problem.load(tmp_path / "missing.cfg")
    bad = tmp_path / "bad.cfg"
    bad.write_text(CONSOLE.read_text().replace("start.x = ", "start.x = x"))
    with pytest.raises(ValueError, match=re.escape("bad.cfg") + ".*start.x"):
        clearway.Problem.load(bad)


def test_a_problem_is_changed_and_saved(tmp_path):
    problem = clearway.Problem.load(CONSOLE)
    same = copy.copy(problem)
    problem.margin, problem.start, problem.bounds = 2.5, turned(0.3, 1, 2, 3), [[-9, -9, -9], [9, 9, 9]]
    assert same.margin != 2.5 and not np.array_equal(same.start, problem.start)
    problem.save(tmp_path / "changed.cfg")
    again = clearway.Problem.load(tmp_path / "changed.cfg")
    assert again.margin == 2.5 and np.array_equal(again.bounds, problem.bounds)
    assert abs(again.start - problem.start).max() < 1e-15
    assert np.array_equal(copy.deepcopy(again).start, again.start)
    problem.bounds = None
    assert problem.bounds is None


@pytest.mark.parametrize(
    "name, value, words",
    [
        ("margin", -1, "margin is -1"),
        ("margin", math.nan, "margin is nan"),
        ("start", np.eye(3), "start has shape"),
        ("goal", np.diag([1.0, 1, 2, 1]), "goal"),
        ("bounds", [[0, 0, 0], [1, -1, 1]], re.escape("bounds[:, 1]")),
        ("bounds", [[0, 0, 0], [1, np.inf, 1]], re.escape("bounds[:, 1]")),
        ("bounds", np.zeros((3, 2)), re.escape("expected (2, 3)")),
    ],
)
def test_wrong_values_of_a_problem_are_refused(name, value, words):
    problem = clearway.Problem(place(), place(1))
    with pytest.raises(ValueError, match=words):
        setattr(problem, name, value)


def test_what_python_may_not_change_says_so():
    problem = clearway.Problem(place(), place(1))
    for array in (problem.start, problem.goal):
        with pytest.raises(ValueError, match="read-only"):
            array[0, 3] = 5


def test_problems_in_the_plane():
    problem = clearway.Problem(turned(0.3, 1, 2), place(), space="SE2")
    assert abs(problem.start - turned(0.3, 1, 2)).max() < 1e-15
    for pose in (place(z=1), clearway.pose_from([0, 0, 0], [0.1, 0, 0, 1])):
        with pytest.raises(ValueError, match="start is not in the plane"):
            problem.start = pose
    with pytest.raises(ValueError, match="space is 'SE4', expected 'SE3' or 'SE2'"):
        clearway.Problem(place(), place(), space="SE4")


def test_a_goal_outside(tmp_path):
    lines = [line for line in CONSOLE.read_text().splitlines() if not line.startswith("goal.")]
    lines = [line + "\ngoal = outside\noutside = +x" if line.startswith("[clearway]") else line for line in lines]
    (tmp_path / "outside.cfg").write_text("\n".join(lines) + "\n")
    problem = clearway.Problem.load(tmp_path / "outside.cfg")
    assert problem.goal is None and problem.outside == "+x"
    problem.goal = place(5)
    assert problem.outside is None and np.array_equal(problem.goal, place(5))


def test_a_scene_of_a_problem_answers_with_its_margins(tmp_path):
    cube(0.5).save(tmp_path / "part.obj")
    cube(1).save(tmp_path / "world.obj")
    problem = clearway.Problem(place(-4), place(4), margin=0.25, robot=tmp_path / "part.obj", worlds=[tmp_path / "world.obj"])
    problem.save(tmp_path / "cubes.cfg")
    direct = scene_of_cubes()
    for scene in (clearway.Scene.load(problem), clearway.Scene.load(tmp_path / "cubes.cfg", threads=1)):
        assert scene.part.triangle_count == 12 and scene.obstacles[0].margin == 0.25 and not scene.obstacles[0].is_solid
        for x in (1.7, 1.8, 2.5):
            assert scene.is_free(place(x)) == direct.is_free(place(x))
            assert abs(scene.clearance(place(x)) - direct.clearance(place(x))) < 1e-12
    with pytest.raises(ValueError, match="names no mesh files"):
        clearway.Scene.load(clearway.Problem(place(), place()))
    with pytest.raises(clearway.FileError, match="gone.obj"):
        clearway.Scene.load(clearway.Problem(place(), place(), robot="gone.obj", worlds=["gone.obj"]))
    with pytest.raises(TypeError):
        clearway.Scene.load(7)


def test_loading_tells_what_looks_wrong(tmp_path):
    cube(0.5).save(tmp_path / "part.obj")
    cube(5000).save(tmp_path / "world.obj")
    problem = clearway.Problem(place(-9000), place(9000), robot=tmp_path / "part.obj", worlds=[tmp_path / "world.obj"])
    notes = clearway.Scene.load(problem).notes
    assert len(notes) == 1 and "are both files in one unit?" in notes[0]


def test_scene_batches_answer_as_single_questions():
    scene = scene_of_cubes()
    poses = np.array([turned(0.02 * i, 3 * math.cos(0.1 * i), 2 * math.sin(0.07 * i)) for i in range(300)])
    flags, clearances = scene.is_free_batch(poses), scene.clearance_batch(poses)
    assert flags.shape == clearances.shape == (300,) and flags.dtype == bool and clearances.dtype == np.float64
    assert flags.any() and not flags.all()
    assert list(flags) == [scene.is_free(pose) for pose in poses] == list(clearances > 0)
    assert max(abs(clearances[i] - scene.clearance(pose)) for i, pose in enumerate(poses)) < 1e-10
    assert scene.is_free_batch(np.empty((0, 4, 4))).shape == scene.clearance_batch(np.empty((0, 4, 4))).shape == (0,)
    poses[7, 0, 0] = 5
    for ask in (scene.is_free_batch, scene.clearance_batch):
        with pytest.raises(ValueError, match=re.escape("poses[7]")):
            ask(poses)


def test_paths_come_back_from_files(tmp_path):
    poses = np.array([turned(0.4 * i, i, -i) for i in range(6)])
    states = clearway.states_from_poses(poses)
    assert states.shape == (6, 7) and np.allclose(np.linalg.norm(states[:, 3:], axis=1), 1, atol=1e-15)
    assert abs(clearway.poses_from_states(states) - poses).max() < 1e-15
    for space in ("SE3", "SE2"):
        for path in (poses, states):
            clearway.write_path(path, tmp_path / "a.path", space=space)
            assert abs(clearway.read_path(tmp_path / "a.path", space=space) - poses).max() < 1e-14
    clearway.write_path(states, tmp_path / "a.path")
    first_line = (tmp_path / "a.path").read_text().splitlines()[1]
    assert [float(word) for word in first_line.split()] == list(states[1])  # to the last digit
    quaternions = clearway.poses_from_states([[1, 2, 3, 0, 0, 0, 5]])  # of any length
    assert np.array_equal(quaternions[0], place(1, 2, 3))


@pytest.mark.parametrize(
    "path, words",
    [
        (np.zeros((2, 7)), r"states\[0\]: the quaternion is 0 0 0 0"),
        (np.full((2, 7), np.nan), r"states\[0\] has a number that is not finite"),
        (np.zeros((2, 6)), r"expected \(N, 7\), or poses \(N, 4, 4\)"),
        (np.zeros((2, 3, 4)), r"expected \(N, 4, 4\)"),
        (np.eye(4), r"expected \(N, 7\)"),
        (None, "expected numbers"),
        ([["a"] * 7], "expected numbers"),
        ([place(z=1)], "not in the plane"),
    ],
)
def test_what_is_no_path_is_refused(tmp_path, path, words):
    with pytest.raises(ValueError, match=words):
        clearway.write_path(path, tmp_path / "a.path", space="SE2")
    assert not (tmp_path / "a.path").exists()


def test_wrong_path_files_are_refused(tmp_path):
    file = tmp_path / "a.path"
    file.write_text("0 0 0 0 0 0 1\n0 0 0 0 0 1\n")
    with pytest.raises(ValueError, match="a.path.*2.*6 numbers, expected 7"):
        clearway.read_path(file)
    with pytest.raises(clearway.FileError):
        clearway.read_path(tmp_path / "b.path")


def test_what_cannot_be_pickled_or_copied_says_so():
    model = clearway.Model(cube(1))
    objects = (model, scene_of_cubes(), clearway.Obstacle(model), clearway.Workspace(), cube(1), clearway.Problem(place(), place()))
    for each in objects:
        with pytest.raises(TypeError, match="cannot pickle '.*%s' object" % type(each).__name__):
            pickle.dumps(each)


def test_arrays_are_copies_and_outlive_what_they_come_from():
    mesh = cube(1)
    model = clearway.Model(mesh)
    mesh.vertices[:] = 7
    model.box[:] = 7
    vertices = mesh.vertices
    scene = clearway.Scene(model, [clearway.Obstacle(model, 1)])
    part, obstacle = scene.part, scene.obstacles[0]
    del mesh, scene, model
    assert vertices.max() == 1 and part.box.max() == 1 and obstacle.model.box.max() == 1 and obstacle.margin == 1
