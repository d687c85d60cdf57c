"""Draws the certified clearance along a path, and that of its states alone.

In cells, for editors and Jupyter that run `# %%` files; or as a script: clearance_profile.py [PROBLEM.cfg [PATH.path [PICTURE]]]
Needs matplotlib."""

# %% The problem, and a path: from a file, or planned now
import pathlib
import sys

import matplotlib
import numpy as np

import clearway
import clearway.planning

given = sys.argv[1:] if sys.argv[0].endswith("clearance_profile.py") else []  # an editor's arguments are not ours
data = pathlib.Path(__file__).parents[2] / "data" if "__file__" in globals() else pathlib.Path("data")
problem = clearway.Problem.load(given[0] if given else data / "bracket" / "bracket.cfg")
if len(given) > 1:
    path = clearway.read_path(given[1], space=problem.space)
else:
    planned = clearway.planning.plan(problem, seconds=20, progress=lambda now: print("%5.1f s  %s" % (now.seconds, now.phase)))
    if not planned:
        sys.exit(str(planned.why_no_path))
    path = planned.path

# %% The check certifies every pose of the path, also between its states
scene = clearway.Scene.load(problem)
checked = clearway.planning.check(problem, path, scene=scene)
audit, profile = checked.audit, checked.profile
print("%s, clearance %.4g to %.4g %s" % (audit.verdict, audit.lower_clearance, audit.upper_clearance, problem.unit))
print("closest in segment %d: %s and %s" % (audit.closest.segment, audit.closest.part_mesh, audit.closest.environment_mesh))
for fault in audit.faults:
    print("segment %d is %s" % (fault.segment, fault.why))

# %% The states alone tell less: between them the part may come closer
at_states = scene.clearance_batch(path)
first_points = np.searchsorted(profile.segment, np.arange(len(path) - 1))  # where the segments begin
travel_of_states = np.append(profile.travel[first_points], profile.travel[-1])

# %% The picture
if len(given) > 2:
    matplotlib.use("Agg")  # draws without a screen
import matplotlib.pyplot as plt  # noqa: E402

figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
axes.fill_between(profile.travel, profile.lower_to_next, step="post", alpha=0.3, label="certified for every pose up to the next one")
axes.plot(profile.travel, profile.clearance, linewidth=1, label="at the poses looked at")
axes.plot(travel_of_states, at_states, "o", label="at the path's states")
axes.axhline(0, color="black", linewidth=0.8)
axes.set_xlabel("travelled by the part's fastest point" + (", " + problem.unit if problem.unit else ""))
axes.set_ylabel("clearance: distance less margin")
axes.set_ylim(bottom=min(0, profile.clearance.min()))
axes.legend()
if len(given) > 2:
    figure.savefig(given[2])
    print("picture: " + given[2])
else:
    plt.show()
