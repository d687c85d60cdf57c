"""Exact distance and contact queries, and certified motions, for rigid parts given as triangle meshes.

A pose is a (4, 4) array, X_environment_part: it maps coordinates of the part to those of the environment. Lengths are in the
environment's unit. What C++ throws, Python raises: ValueError, or FileError (a ValueError and an OSError) about files.
"""

from ._core import (
    DistanceResult,
    FileError,
    Mesh,
    Model,
    Obstacle,
    Problem,
    Scene,
    WhyInvalid,
    Workspace,
    __version__,
    available_targets,
    collides,
    current_target,
    distance,
    distance_batch,
    is_within,
    is_within_batch,
    nearest_pose,
    pose_from,
    poses_from_states,
    read_path,
    states_from_poses,
    use_target,
    write_path,
)

__all__ = [
    "DistanceResult",
    "FileError",
    "Mesh",
    "Model",
    "Obstacle",
    "Problem",
    "Scene",
    "WhyInvalid",
    "Workspace",
    "__version__",
    "available_targets",
    "collides",
    "current_target",
    "distance",
    "distance_batch",
    "is_within",
    "is_within_batch",
    "nearest_pose",
    "pose_from",
    "poses_from_states",
    "read_path",
    "states_from_poses",
    "use_target",
    "write_path",
]
