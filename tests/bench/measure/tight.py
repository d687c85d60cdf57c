"""The part `tight`: parts in tight fits, such as screws in their threads, and how long the default planner takes to bring them out."""

import json
import statistics

from from_files import timed

# Problems of our own, in the order of the table, and real screws of others, in the folder of --checkouts.
OWN = ("square_peg", "dovetail", "keyway", "bearing", "bayonet", "bayonet_mid", "hook", "corkscrew", "screw", "m12_on_axis", "m12")
BOLTS = ("01738", "10434")
SEEDS = {"ci": 1, "quick": 3, "full": 10}
LIMIT = 30  # seconds of a run
COLUMNS = ["problem", "part_triangles", "environment_triangles", "gap_over_radius", "runs", "found", "by_twists", "seconds", "seconds_largest", "states",
           "turned", "clearance", "clearance_widened"]


def problem_of(place, name):
    if name in BOLTS:
        return place.problem(name)
    place.run([*place.benchmark("overlaps"), "tight", place.scratch])
    return place.scratch / f"{name}.cfg"


def planned(place, problem, seed, *options):
    """The facts of a run of `plan`, after `check` has judged its path."""
    path = place.scratch / "found.path"
    path.unlink(missing_ok=True)
    _, said = timed([place.program(), "plan", problem, "--path", path, "--time", LIMIT, "--seed", seed, "--json", "-", *options], (0, 1))
    facts = json.loads(said.stdout)
    if facts["found"]:
        checked = json.loads(place.run([place.program(), "check", problem, path, "--json", "-"]))
        facts["clearance"], facts["turned"] = checked["audit"]["clearance"]["lower"], checked["audit"]["rotation_degrees"]
        facts["states"] = sum(1 for _ in open(path))
    return facts


def tight(place, row):
    """A row: planning times with --quick, and the clearance of one path with it and of one without."""
    problem = problem_of(place, row)
    info = json.loads(place.run([place.program(), "info", problem, "--json", "-"]))
    box = info["part"]["box"]
    radius = 0.5 * sum((high - low) ** 2 for low, high in zip(box["min"], box["max"])) ** 0.5
    runs = [planned(place, problem, seed, "--quick") for seed in range(1, SEEDS[place.form] + 1)]
    found = [run for run in runs if run["found"]]
    times = [run["planning_seconds"] if run["found"] else LIMIT for run in runs]
    widened = planned(place, problem, 1)

    def middle(key):
        return f"{statistics.median(run[key] for run in found):.3g}" if found else ""

    made = {"problem": row, "part_triangles": info["part"]["triangles"], "environment_triangles": info["environment"]["triangles"],
            "gap_over_radius": f"{info['at_start']['clearance'] / radius:.2g}", "runs": len(runs), "found": len(found),
            "by_twists": sum(run["found_by"] == "TwistSearch" for run in found), "seconds": f"{statistics.median(times):.3g}",
            "seconds_largest": f"{max(times):.3g}", "states": middle("states"), "turned": middle("turned"), "clearance": middle("clearance"),
            "clearance_widened": f"{widened['clearance']:.3g}" if widened["found"] else ""}
    return COLUMNS, [{column: str(made[column]) for column in COLUMNS}]
