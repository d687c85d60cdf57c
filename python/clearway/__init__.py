"""Exact distance and contact queries, and certified motions, for rigid parts given as triangle meshes.

A pose is a (4, 4) array, X_environment_part: it maps coordinates of the part to those of the environment. Lengths are in the
environment's unit. What C++ throws, Python raises: ArgumentError (a ValueError), FileError (an OSError and a ValueError) or OmplError (a
RuntimeError), each an Error.
"""

from ._core import (
    ArgumentError,
    DistanceResult,
    Error,
    FileError,
    Mesh,
    Model,
    Obstacle,
    OmplError,
    Problem,
    Scene,
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
    "ArgumentError",
    "DistanceResult",
    "Error",
    "FileError",
    "Mesh",
    "Model",
    "Obstacle",
    "OmplError",
    "Problem",
    "Scene",
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
