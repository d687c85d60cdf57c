"""Meshes, poses and scenes of the tests of the Python module."""

import pathlib

import numpy as np

import clearway

ROOT = pathlib.Path(__file__).parents[2]
DATA = ROOT / "data"


def triangle(z):
    return clearway.Mesh([[0.1, 0, z], [1.3, 0, z], [0.1, 1.7, z]], [[0, 1, 2]])


def cube(size):
    corners = [[x, y, z] for x in (-size, size) for y in (-size, size) for z in (-size, size)]
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]]
    faces += [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    return clearway.Mesh(np.array(corners, dtype=float), np.array(faces), name="cube")


def place(x=0.0, y=0.0, z=0.0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def turned(angle, x=0.0, y=0.0, z=0.0):
    """Turned about z."""
    return clearway.pose_from([x, y, z], [0, 0, np.sin(angle / 2), np.cos(angle / 2)])


def prepare_documents(folder):
    """The files that the pieces of docs/python.md read."""
    cube(0.5).save(folder / "part.stl")
    cube(1).save(folder / "environment.stl")
    problem = clearway.Problem(place(-4), place(4), bounds=[[-5] * 3, [5] * 3], robot=folder / "part.stl", worlds=[folder / "environment.stl"])
    problem.save(folder / "problem.cfg")


def scene_of_cubes(margin=0.25):
    """A cube of side 1 beside one of side 2 around the origin."""
    return clearway.Scene(clearway.Model(cube(0.5)), [clearway.Obstacle(clearway.Model(cube(1)), margin)])
