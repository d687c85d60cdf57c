"""clearway.planning and the package ompl in one process: each plans with its own library, or clearway refuses by name."""

import os
import shutil
import subprocess
import sys
import textwrap

import pytest
from support import DATA

planning = pytest.importorskip("clearway.planning", reason="clearway was built without OMPL")

OURS = """
    import clearway.planning
    def ours():
        found = clearway.planning.plan(%r, planner="SlidingRRTConnect", iterations=20000, quick=True)
        print(found.states.tobytes().hex())
    """ % str(DATA / "bracket" / "bracket.cfg")
THEIRS = """
    from ompl import base, geometric, util
    util.setLogLevel(util.LogLevel.LOG_NONE)
    def theirs():
        space = base.SE3StateSpace()
        bounds = base.RealVectorBounds(3)
        bounds.setLow(-1)
        bounds.setHigh(1)
        space.setBounds(bounds)
        setup = geometric.SimpleSetup(space)
        setup.setStateValidityChecker(lambda state: abs(state.getX()) > 0.1 or state.getY() > 0.5)
        ends = space.allocState(), space.allocState()
        for end, x in zip(ends, (-0.9, 0.9)):
            end.setX(x)
            end.setY(0)
            end.setZ(0)
            end.rotation().setIdentity()
        setup.setStartAndGoalStates(*ends)
        for planner in (geometric.RRTConnect, geometric.PRM):
            setup.clear()
            setup.setPlanner(planner(setup.getSpaceInformation()))
            assert setup.solve(10.0) and setup.haveExactSolutionPath()
    """


def run(text, **variables):
    return subprocess.run([sys.executable, "-B", "-c", textwrap.dedent(text)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=dict(os.environ, **variables))


@pytest.mark.parametrize("first, second, calls", [(OURS, THEIRS, "ours(); theirs(); ours()"), (THEIRS, OURS, "theirs(); ours(); theirs()")])
def test_both_plan_in_one_process(first, second, calls):
    pytest.importorskip("ompl", reason="OMPL's own Python bindings are not installed")
    alone = run(textwrap.dedent(OURS) + "ours()")
    both = run("\n".join(map(textwrap.dedent, (first, second))) + calls)
    assert (alone.returncode, both.returncode) == (0, 0), alone.stderr + both.stderr
    paths = [line for line in both.stdout.splitlines() if not line.startswith(("Info", "Debug", "Warning"))]
    assert paths and set(paths) == set(alone.stdout.split())


def test_a_library_of_one_name_is_refused(tmp_path):
    """A package ompl whose library bears the name of the one that clearway was built with, and came first."""
    library = os.path.realpath(planning._planning.ompl_library())
    (tmp_path / "ompl").mkdir()
    shutil.copy(library, tmp_path / "ompl" / "libompl.so")
    (tmp_path / "ompl" / "__init__.py").write_text("import ctypes, os\nctypes.CDLL(os.path.dirname(__file__) + '/libompl.so')\n")
    path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    refused = run("import ompl, clearway.planning", PYTHONPATH=path)
    assert "ImportError: clearway.planning would use the package ompl's own library" in refused.stderr
    assert run("import clearway.planning, ompl", PYTHONPATH=path).returncode == 0
