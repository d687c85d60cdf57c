from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy.typing as npt

from ._core import FileName, Problem, Scene

Found = Dict[str, Any]

def plan(
    problem: Union[Problem, FileName],
    scene: Optional[Scene],
    margin: Optional[float],
    options: Mapping[str, object],
    progress: Optional[Callable[[float, str], object]],
) -> Tuple[Found, Optional[BaseException]]: ...
def check(
    problem: Union[Problem, FileName],
    path: Union[npt.ArrayLike, FileName],
    scene: Optional[Scene],
    margin: Optional[float],
    profile: bool,
) -> Tuple[Found, Optional[BaseException]]: ...
def planner_names() -> List[str]: ...
def objective_names() -> List[str]: ...
def ompl_library() -> str: ...
