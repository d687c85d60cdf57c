"""The Python module: its answers are the library's, and whatever is not as it should be is refused by name."""

import copy
import math
import os
import re
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest
from support import ROOT, cube, place, prepare_documents, triangle

import clearway


@pytest.fixture(scope="module")
def models():
    return clearway.Model(triangle(0.25)), clearway.Model(triangle(-0.75))  # the queries are exact: sums without rounding


def test_distance_of_two_triangles(models):
    result = clearway.distance(*models, place(z=2))
    assert result.lower <= 3 <= result.upper
    assert result.upper - result.lower < 1e-10
    assert math.isclose(result.distance, np.linalg.norm(result.point_on_part - result.point_on_environment))
    assert (result.part_triangle, result.environment_triangle, result.collides) == (0, 0, False)
    assert clearway.is_within(*models, place(z=2), 3.001) and not clearway.is_within(*models, place(z=2), 2.999)
    assert clearway.collides(*models, place(z=-1)) and not clearway.collides(*models, place(z=-1.01))
    beyond = clearway.distance(*models, place(z=2), cap=1)
    assert beyond.lower >= 1 and math.isinf(beyond.upper) and beyond.part_triangle == -1


def test_a_copy_of_a_model_is_the_same_model(models):
    for same in copy.copy(models[0]), copy.deepcopy(models[0]):
        assert clearway.distance(same, models[1], place(z=2)).distance == clearway.distance(*models, place(z=2)).distance


def test_batches_answer_as_single_queries(models):
    poses = np.array([place(0.01 * i, 0, math.sin(i)) for i in range(200)])
    batch = clearway.distance_batch(*models, poses)
    assert batch["point_on_part"].shape == (200, 3) and batch["lower"].dtype == np.float64
    for i, pose in enumerate(poses):
        single = clearway.distance(*models, pose)
        assert batch["lower"][i] <= single.upper and single.lower <= batch["upper"][i]
    flags = clearway.is_within_batch(*models, poses, 1.0)
    assert flags.dtype == bool and list(flags) == [clearway.is_within(*models, pose, 1.0) for pose in poses]
    assert clearway.is_within_batch(*models, np.empty((0, 4, 4)), 1.0).shape == (0,)


def test_arrays_of_any_layout_and_of_whole_numbers(models):
    expected = clearway.distance(*models, place(z=2)).distance
    frozen = place(z=2)
    frozen.setflags(write=False)
    strided = np.zeros((8, 8))
    strided[::2, ::2] = place(z=2)
    for pose in (frozen, np.asfortranarray(place(z=2)), strided[::2, ::2], place(z=2).astype(int), place(z=2).tolist(),
                 place(z=2).astype(">f8"), place(z=2).astype(np.float32)):
        assert clearway.distance(*models, pose).distance == expected


@pytest.mark.parametrize(
    "pose, words",
    [
        (np.eye(3), r"shape \(3, 3\), expected \(4, 4\)"),
        (np.eye(4)[0], "expected 2 dimensions"),
        (np.eye(4).astype(complex), "dtype complex128, expected numbers"),
        (np.eye(4).astype(str), "expected numbers"),
        (np.eye(4, dtype=bool), "dtype bool"),
        (None, "expected numbers"),
        (np.diag([1.0, 1, 1, 2]), "last row"),
        (np.diag([1.0, 1, 2, 1]), "pose"),
        (np.diag([1.0, 1, -1, 1]), "pose"),
        (np.diag([1.0, 1, np.nan, 1]), "pose"),
        (place(z=np.inf), "pose"),
    ],
)
def test_what_is_no_pose_is_refused(models, pose, words):
    for query in (clearway.distance, clearway.collides):
        with pytest.raises(ValueError, match=words):
            query(*models, pose)


def test_the_first_wrong_pose_of_a_batch_is_named(models):
    poses = np.array([np.eye(4)] * 3)
    poses[2, 0, 0] = 5
    with pytest.raises(ValueError, match=re.escape("poses[2]")):
        clearway.distance_batch(*models, poses)
    with pytest.raises(ValueError, match=re.escape("expected (N, 4, 4)")):
        clearway.is_within_batch(*models, np.zeros((2, 3, 4)), 1)


def test_what_is_no_mesh_is_refused(tmp_path):
    with pytest.raises(ValueError, match="names vertex 3, expected 0 to 2"):
        clearway.Mesh(np.zeros((3, 3)), [[0, 1, 3]])
    with pytest.raises(ValueError, match="names vertex -1"):
        clearway.Mesh(np.zeros((3, 3)), [[0, 1, -1]])
    with pytest.raises(ValueError, match="dtype float64, expected"):
        clearway.Mesh(np.zeros((3, 3)), [[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError, match=re.escape("expected (N, 3)")):
        clearway.Mesh(np.zeros((3, 2)), [[0, 1, 2]])
    with pytest.raises(ValueError, match="triangle"):
        clearway.Model(clearway.Mesh(np.zeros((3, 3)), np.zeros((0, 3), dtype=int)))
    with pytest.raises(clearway.FileError, match="missing.stl") as caught:
        clearway.Mesh.load(str(tmp_path / "missing.stl"))
    assert isinstance(caught.value, OSError) and isinstance(caught.value, ValueError)
    with pytest.raises(clearway.ArgumentError, match="leafSize|leaf_size"):
        clearway.Model(triangle(0), leaf_size=0)
    for kind, standard in ((clearway.ArgumentError, ValueError), (clearway.FileError, OSError), (clearway.OmplError, RuntimeError)):
        assert issubclass(kind, clearway.Error) and issubclass(kind, standard)
    with pytest.raises(ValueError, match="general"):
        clearway.Model(triangle(0), general_split="best")
    with pytest.raises(ValueError):
        clearway.use_target("avx9")


def test_the_preset_fast_is_deprecated():
    with pytest.warns(DeprecationWarning, match="means 'best'"):
        assert clearway.Model(triangle(0), preset="fast").triangle_count == 1
    with pytest.raises(ValueError, match="preset is 'slow', expected best"):
        clearway.Model(triangle(0), preset="slow")


def test_meshes_and_models_come_back_from_files(tmp_path, models):
    cube(0.5).save(str(tmp_path / "cube.glb"))
    mesh = clearway.Mesh.load(str(tmp_path / "cube.glb"), scale=2)
    assert mesh.components == ["cube"] and np.array_equal(mesh.vertices.max(axis=0), [1, 1, 1])
    model = clearway.Model(mesh)
    model.save(str(tmp_path / "cube.model"))
    again = clearway.Model.load(str(tmp_path / "cube.model"))
    assert np.array_equal(again.box, [[-1, -1, -1], [1, 1, 1]]) and again.triangle_count == 12
    with pytest.raises(clearway.FileError):
        clearway.Model.load(str(tmp_path / "cube.glb"))


def test_a_workspace_serves_one_thread(models):
    workspace = clearway.Workspace()
    assert clearway.distance(*models, place(z=2), workspace).lower > 2
    raised = []

    def elsewhere():
        try:
            clearway.distance(*models, place(z=2), workspace)
        except ValueError as error:
            raised.append(str(error))

    thread = threading.Thread(target=elsewhere)
    thread.start()
    thread.join()
    assert raised == ["the workspace belongs to another thread, expected one for each thread"]


def test_threads_share_models(models):
    answers = []
    ask = lambda: answers.append([clearway.distance(*models, place(z=0.01 * i)).distance for i in range(300)])  # noqa: E731
    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 4 and all(answer == answers[0] for answer in answers)


PREPARE = """
import os, threading, time
import clearway
from support import cube, place, scene_of_cubes
part, scene, pose = clearway.Model(cube(1)), scene_of_cubes(), place(4)
def ask():
    while True:
        %s
for _ in range(3):
    threading.Thread(target=ask, daemon=True).start()
"""
END = """
time.sleep(0.1)
"""
FORK = """
for _ in range(%d):
    child = os.fork()
    if child == 0:
        clearway.distance_batch(part, part, [pose] * 200)
        scene.is_free_batch([pose] * 200)
        clearway.Model(cube(1))
        break
    assert os.waitpid(child, 0)[1] == 0
""" % (6 if os.environ.get("CLEARWAY_FULL") else 2)


def run_beside_support(code):
    paths = os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])
    subprocess.run([sys.executable, "-c", code], env=dict(os.environ, PYTHONPATH=paths), check=True, timeout=60)


@pytest.mark.parametrize("query", ["clearway.distance(part, part, pose)", "clearway.distance_batch(part, part, [pose] * 200)",
                                   "scene.check_motion(pose, pose)", "clearway.Model(cube(1))"])
@pytest.mark.parametrize("then", [END, FORK], ids=["end", "fork"])
def test_threads_that_python_does_not_wait_for_may_query_until_the_end(query, then):
    run_beside_support(PREPARE % query + then)


def test_what_python_calls_at_its_end_may_wait_for_a_thread():
    code = """
        import atexit, threading, time
        is_over = threading.Event()
        def end():  # registered before clearway's own function, so that Python calls it after that
            is_over.set()
            thread.join()
        atexit.register(end)
        import clearway
        from support import cube, place
        part = clearway.Model(cube(1))
        def ask():
            while not is_over.is_set():
                clearway.distance(part, part, place(4))
        thread = threading.Thread(target=ask, daemon=True)
        thread.start()
        time.sleep(0.1)
        """
    run_beside_support(textwrap.dedent(code))


def test_poses():
    assert np.array_equal(clearway.pose_from([1, 2, 3], [0, 0, 0, 4]), place(1, 2, 3))
    with pytest.raises(ValueError, match="expected above 0 and finite"):
        clearway.pose_from([1, 2, 3], [0, 0, 0, 0])
    with pytest.raises(ValueError, match="expected 3 and 4"):
        clearway.pose_from([1, 2], [0, 0, 0, 1])
    rough = place(1, 2, 3)
    rough[0, 0] = 1 + 1e-7
    assert abs(clearway.nearest_pose(rough) - place(1, 2, 3)).max() < 1e-15


def test_scenes():
    part, wall = clearway.Model(cube(0.5)), clearway.Model(cube(1))
    scene = clearway.Scene(part, [clearway.Obstacle(wall, 0.25)])
    assert scene.is_free(place(2)) and not scene.is_free(place(1.7))
    assert scene.clearance(place(2)) <= 0.25 < scene.clearance(place(2)) + 1e-10
    free, touching, close = (scene.why_invalid(place(x)) for x in (2, 1.2, 1.7))
    assert not free and str(free) == "" and (free.kind, free.obstacle, free.part_triangle) == ("valid", None, None)
    assert touching and (touching.kind, close.kind) == ("collides", "too close")
    assert (close.obstacle, close.limit) == (0, 0.25) and 0 <= close.environment_triangle < 12
    assert scene.why_not_free(place(2)) == "" and scene.why_not_free(place(1.2)) == str(scene.why_invalid(place(1.2)))
    verdict, until, contact = scene.check_motion(place(-4), place(4))
    assert verdict == "contact" and abs(until - 2.25 / 8) < 1e-3 and until < contact < 1
    assert scene.check_motion(place(-4, 3), place(4, 3)) == ("certified", 1.0, None)
    lower, upper = scene.escape_distance(place(1.2), [3, 0, 0])
    assert lower <= 0.55 <= upper < lower + 1e-3 and scene.escape_distance(place(2), [1, 0, 0]) == (0, 0)
    near = clearway.near_pairs(part, wall, place(2), 0.6)
    assert len(near) > 1 and near[0].distance == 0.5 and near[0].environment_triangle >= 0
    translation, rotation = clearway.distance_gradient(near[0], [0, 0, 0])
    assert translation[0] == 1 and rotation[0] == 0 and rotation.shape == (3,)
    assert clearway.near_pairs(part, wall, place(2), 0.4) == []
    with pytest.raises(ValueError, match="direction"):
        scene.escape_distance(place(), [0, 0, 0])
    with pytest.raises(ValueError, match="start"):
        scene.check_motion(np.eye(3), place())
    for margin in (-1, math.nan, math.inf):
        with pytest.raises(ValueError, match=f"^margin is {margin}, expected a finite number"):
            clearway.Obstacle(wall, margin)


def test_inside_of_a_solid_nothing_is_free():
    part, block = cube(0.5), cube(5)
    surfaces = clearway.Scene(clearway.Model(part), [clearway.Obstacle(clearway.Model(block))])
    solid = clearway.Scene(
        clearway.Model(part), [clearway.Obstacle(clearway.Model(block), solid=block)], part_mesh=part
    )
    assert surfaces.is_free(place()) and not solid.is_free(place())
    assert solid.check_motion(place(), place(1))[0] == "contact"
    assert solid.notes == []
    with pytest.raises(ValueError, match="solid: "):
        clearway.Obstacle(clearway.Model(triangle(0)), solid=triangle(0))
    open_part = clearway.Scene(clearway.Model(triangle(0)), solid.obstacles, part_mesh=triangle(0))
    assert len(open_part.notes) == 1 and "encloses nothing" in open_part.notes[0]


def test_targets():
    for target in clearway.available_targets():
        clearway.use_target(target)
        assert clearway.current_target() == target
    clearway.use_target("best")


def test_the_version_is_the_same_everywhere():
    project = (ROOT / "pyproject.toml").read_text()
    assert 'version = "%s"' % clearway.__version__ in project
    assert "VERSION %s " % clearway.__version__ in (ROOT / "CMakeLists.txt").read_text()


def test_the_documents_code_runs(tmp_path, monkeypatch, capsys):
    """The pieces of docs/python.md, one after the other, beside two meshes and a problem. test_ompl.py runs those that
    need OMPL's bindings."""
    pytest.importorskip("clearway.planning", reason="clearway was built without OMPL")
    monkeypatch.chdir(tmp_path)
    prepare_documents(tmp_path)
    pieces = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(), re.S)
    pieces = [piece for piece in pieces if "from ompl import" not in piece]
    assert len(pieces) > 4
    exec("\n".join(pieces), {})
    assert "True True True" in capsys.readouterr().out  # what the piece about `check` prints


def test_the_code_beside_trimesh_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    prepare_documents(tmp_path)
    pieces = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "coming_from.md").read_text(), re.S)
    after, = [piece for piece in pieces if "distance_batch" in piece]
    names = {"poses": [place(3), place(4)]}
    exec(after, names)
    assert names["all_distances"][1] == names["distance"] == pytest.approx(2.5) and not names["touches"]


def test_the_example_draws_a_picture(tmp_path):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    pytest.importorskip("clearway.planning", reason="clearway was built without OMPL")
    console = ROOT / "data" / "tunnel-console-small" / "tunnel-console"
    example = ROOT / "python" / "examples" / "clearance_profile.py"
    words = [sys.executable, "-B", str(example), "%s.cfg" % console, "%s.path" % console, str(tmp_path / "profile.png")]
    out = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout
    assert out.startswith("valid, clearance 11.") and (tmp_path / "profile.png").read_bytes()[:4] == b"\x89PNG"
