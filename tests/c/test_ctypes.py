"""The shared library through ctypes: the Python module's answers and words."""

import ctypes
import math
import os
import pathlib
import subprocess
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_int64, c_size_t, c_uint32, c_uint64

import numpy as np
import pytest

import clearway

DATA = pathlib.Path(__file__).parents[2] / "data"
OK, INVALID_ARGUMENT, FILE_ERROR = range(3)


class Options(ctypes.Structure):
    _fields_ = [("relative_error", c_double), ("absolute_error", c_double), ("cap", c_double)]


class Result(ctypes.Structure):
    _fields_ = [
        ("lower", c_double),
        ("upper", c_double),
        ("distance", c_double),
        ("point_on_part", c_double * 3),
        ("point_on_environment", c_double * 3),
        ("part_triangle", c_int64),
        ("environment_triangle", c_int64),
    ]


library = ctypes.CDLL(os.environ["CLEARWAY_LIBRARY"])
POSE = POINTER(c_double)
for name, types in {
    "load": [c_char_p, c_double, POINTER(c_uint64)],
    "build": [POSE, c_size_t, POINTER(c_uint32), c_size_t, POINTER(c_uint64)],
    "new_workspace": [POINTER(c_uint64)],
    "distance": [c_uint64, c_uint64, POSE, POINTER(Options), c_uint64, POINTER(Result)],
    "collides": [c_uint64, c_uint64, POSE, c_uint64, POINTER(c_int)],
    "within": [c_uint64, c_uint64, POSE, c_double, c_uint64, POINTER(c_int)],
    "free": [c_uint64],
}.items():
    getattr(library, "clearway_" + name).argtypes = types
library.clearway_last_error.restype = library.clearway_version.restype = c_char_p


def last_error():
    return library.clearway_last_error().decode()


def made(function, *arguments):
    handle = c_uint64()
    assert function(*arguments, byref(handle)) == OK, last_error()
    return handle.value


def load(file):
    return made(library.clearway_load, str(file).encode(), 1.0)


def rows(pose):
    return np.ascontiguousarray(pose, dtype=float).ctypes.data_as(POSE)


def poses(count):
    generator = np.random.default_rng(1)
    for _ in range(count):
        quaternion = generator.normal(size=4)
        yield clearway.pose_from(list(generator.uniform(-60, 60, 3)), list(quaternion))


@pytest.fixture(scope="module")
def models():
    return load(DATA / "window/plate.obj"), load(DATA / "window/wall.obj")


@pytest.fixture(scope="module")
def same():
    return [clearway.Model(clearway.Mesh.load(str(DATA / "window" / name))) for name in ("plate.obj", "wall.obj")]


def test_answers_are_those_of_the_python_module(models, same):
    mine, theirs = made(library.clearway_new_workspace), clearway.Workspace()
    touching = 0
    for pose in poses(200):
        found, flag, near = Result(), c_int(-1), c_int(-1)
        assert library.clearway_distance(*models, rows(pose), None, mine, byref(found)) == OK
        expected = clearway.distance(*same, pose, theirs)
        for name in ("lower", "upper", "distance", "part_triangle", "environment_triangle"):
            assert getattr(found, name) == getattr(expected, name)
        assert list(found.point_on_part) == list(expected.point_on_part)
        assert list(found.point_on_environment) == list(expected.point_on_environment)
        assert library.clearway_collides(*models, rows(pose), mine, byref(flag)) == OK
        assert flag.value == clearway.collides(*same, pose, theirs)
        assert library.clearway_within(*models, rows(pose), 5.0, mine, byref(near)) == OK
        assert near.value == clearway.is_within(*same, pose, 5.0, theirs)
        touching += flag.value
    assert 0 < touching < 200
    beyond = Result()
    far = clearway.pose_from([500.0, 0, 0], [0.0, 0, 0, 1])
    assert library.clearway_distance(*models, rows(far), byref(Options(cap=3)), mine, byref(beyond)) == OK
    assert beyond.lower >= 3 and math.isinf(beyond.upper) and beyond.part_triangle == -1
    assert library.clearway_version().decode() == clearway.__version__


def test_errors_are_those_of_the_python_module(models, same):
    flag = c_int(-1)
    for d in (-1.0, math.nan):
        with pytest.raises(ValueError) as refused:
            clearway.is_within(*same, np.eye(4), d)
        assert library.clearway_within(*models, rows(np.eye(4)), d, 0, byref(flag)) == INVALID_ARGUMENT
        assert last_error() == str(refused.value)
    for entry in ((0, 0), (1, 2), (2, 3)):
        for value in (math.nan, math.inf, 7.0):
            pose = np.eye(4)
            pose[entry] = value
            if entry == (2, 3) and value == 7:
                continue  # a pose
            with pytest.raises(ValueError) as refused:
                clearway.collides(*same, pose)
            assert library.clearway_collides(*models, rows(pose), 0, byref(flag)) == INVALID_ARGUMENT
            assert str(refused.value) == "pose: " + last_error()
    handle = c_uint64()
    with pytest.raises(OSError) as missing:
        clearway.Mesh.load("missing.stl")
    assert library.clearway_load(b"missing.stl", 1.0, byref(handle)) == FILE_ERROR
    assert last_error() == str(missing.value)
    assert flag.value == -1 and handle.value == 0


def test_an_unknown_instruction_set_in_the_environment_is_refused_in_the_same_words(models):
    """By a C call and by Python, from a process whose first query it is."""
    ask = (
        "import ctypes, clearway, numpy, os\n"
        "library = ctypes.CDLL(os.environ['CLEARWAY_LIBRARY'])\n"
        "library.clearway_last_error.restype = ctypes.c_char_p\n"
        "points = (ctypes.c_double * 9)(0, 0, 0, 1, 0, 0, 0, 1, 0)\n"
        "model, flag = ctypes.c_uint64(), ctypes.c_int(-1)\n"
        "assert library.clearway_build(points, ctypes.c_size_t(3), (ctypes.c_uint32 * 3)(0, 1, 2), ctypes.c_size_t(1), ctypes.byref(model)) == 0\n"
        "pose = (ctypes.c_double * 16)(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)\n"
        "print(library.clearway_collides(model, model, pose, ctypes.c_uint64(0), ctypes.byref(flag)))\n"
        "print(library.clearway_last_error().decode())\n"
        "same = clearway.Model(clearway.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))\n"
        "try: clearway.collides(same, same, numpy.eye(4))\n"
        "except ValueError as refused: print(refused)\n"
    )
    environment = dict(os.environ, CLEARWAY_TARGET="avx9")
    told = subprocess.run([sys.executable, "-B", "-c", ask], env=environment, capture_output=True, text=True, check=True).stdout
    expected = "CLEARWAY_TARGET is 'avx9', expected best or one this machine runs: " + ", ".join(clearway.available_targets())
    assert told.splitlines() == [str(INVALID_ARGUMENT), expected, expected]
