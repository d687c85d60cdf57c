"""The parts `shrinking` and `touching`: how long shrinking takes, and parts that touch, from the advice to a path."""

import json
import re
import statistics

from from_files import timed
from place import Refused

# The rows of shrinking: the part's folder or scene, and the overlap over its diagonal.
SHRUNK = {f"{part} {share}": (part, share)
          for part in ("bracket", "puzzle", "peg-in-hole", "tunnel-console-small", "apartment", "cembox-2", "tunnel-console-3", "large-environment-2")
          for share in ("1e-4", "1e-3")}
TOUCHING = ("plug", "lid", "bearing", "dovetail", "keyhole", "crossbar")
PUZZLES = ("06397", "07631")  # of others, in the folder of --checkouts
SEEDS = {"ci": 1, "quick": 3, "full": 10}
LIMIT = 30  # seconds of a run
COLUMNS = ["problem", "part_triangles", "environment_triangles", "least", "try_first", "over_diagonal", "lift_seconds", "runs", "found", "seconds",
           "seconds_largest", "deepest_over_allowed"]


def shrinking(place, row):
    part, share = SHRUNK[row]
    repetitions = {"ci": 1, "quick": 3, "full": 5}[place.form]
    problem = place.problem(part)
    robot = re.search(r"^robot\s*=\s*(.+?)\s*$", problem.read_text(), re.M)[1]
    return [place.pinned(*place.benchmark("overlaps"), "shrink", problem.parent / robot, share, repetitions, place.scratch / "shrinking.csv", part)]


def problem_of(place, name):
    if name in PUZZLES:
        return place.problem(name)
    place.run([*place.benchmark("overlaps"), "problems", place.scratch])
    return place.scratch / f"{name}.cfg"


def with_overlap(problem, line):
    """The problem with the advised line, beside it: its files have relative names."""
    made = problem.with_name(f"{problem.stem}_first.cfg")
    made.write_text(problem.read_text() + line + "\n")
    return made


def touching(place, row):
    """A row: the advice, then whole commands of `plan --quick` with it, and how deep obstacles reach along the paths."""
    problem = problem_of(place, row)
    lift_seconds, said = timed([place.program(), "info", problem, "--lift"])
    advice = {key: re.search(rf"^{label}:\s*(overlap = (\S+))", said.stdout, re.M)
              for key, label in (("least", "frees the start"), ("try_first", "to try first"))}
    if not all(advice.values()):
        raise Refused(f"info {problem} --lift gives no advice:\n{said.stdout}")
    with_line = with_overlap(problem, advice["try_first"][1])
    path = place.scratch / "found.path"
    times, found, deepest = [], 0, 0
    for seed in range(1, SEEDS[place.form] + 1):
        path.unlink(missing_ok=True)
        seconds, _ = timed([place.program(), "plan", with_line, "--path", path, "--quick", "--time", LIMIT, "--seed", seed], (0, 1))
        times.append(seconds)
        if not path.exists():
            continue
        found += 1
        facts = json.loads(place.run([place.program(), "check", with_line, path, "--json", "-"]))
        deepest = max([deepest] + [overlap["depth"]["lower"] for overlap in facts["overlaps"]])
    facts = json.loads(place.run([place.program(), "info", with_line, "--json", "-"]))
    allowed = float(advice["try_first"][2])
    diagonal = sum((high - low) ** 2 for low, high in zip(facts["part"]["box"]["min"], facts["part"]["box"]["max"])) ** 0.5
    made = {"problem": row, "part_triangles": facts["part"]["triangles"], "environment_triangles": facts["environment"]["triangles"],
            "least": advice["least"][2], "try_first": advice["try_first"][2], "over_diagonal": f"{allowed / diagonal:.3g}",
            "lift_seconds": f"{lift_seconds:.3g}", "runs": len(times), "found": found, "seconds": f"{statistics.median(times):.3g}",
            "seconds_largest": f"{max(times):.3g}", "deepest_over_allowed": f"{deepest / allowed:.3g}"}
    return COLUMNS, [{column: str(made[column]) for column in COLUMNS}]
