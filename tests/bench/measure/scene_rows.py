"""The part `scenes`: makes a demo scene and asks for the distance at each of its poses."""

import csv
import re

# The rows: the scene and the clearance asked for; none: the scene's default.
ROWS = {
    "tunnel-console-3": ("tunnel-console-3", None),
    "tunnel-console-3 at 2": ("tunnel-console-3", 2),
    "cembox-2": ("cembox-2", None),
    "cembox-2 at 2": ("cembox-2", 2),
    "large-environment-2": ("large-environment-2", None),
    "large-environment-2 at 2": ("large-environment-2", 2),
    "peg-in-hole-1": ("peg-in-hole-1", None),
    "apartment-1": ("apartment-1", None),
    "puzzle-2": ("puzzle-2", None),
    "boxes-1": ("boxes-1", None),
}
COLUMNS = ["scene", "clearance_asked", "part_triangles", "environment_triangles", "clearance_certified", "tight_share", "poses", "colliding",
           "us_mean", "volume_tests"]
PASSES = {"ci": 1, "quick": 3, "full": 9}


def files_of(place, row):
    folder = place.scratch / "scene"
    return {name: next(folder.glob(pattern)) for name, pattern in
            (("part", "*_part.obj"), ("environment", "*_environment.obj"), ("poses", "*_replay.poses"), ("problem", "*.cfg"))}


def commands(place, row):
    """Makes the scene; the queries follow in `table`, because they need the names of its files."""
    scene, clearance = ROWS[row]
    more = ["--clearance", clearance] if clearance is not None else []
    return [[place.program("clearway-scene"), scene, *more, "--no-preview", "--out", place.scratch / "scene"]]


def facts_of(problem):
    """The figures that the scene's own files state, in the comments at their beginning."""
    text = problem.read_text()
    triangles = re.search(r"Part: (\d+) triangles.*?environment: (\d+) triangles", text)
    path = re.search(r"least clearance along it: (\S+) \(certified\), expected (\S+); (\S+) % of the path is within", text)
    return {"part_triangles": triangles[1], "environment_triangles": triangles[2], "clearance_certified": path[1],
            "clearance_asked": path[2], "tight_share": f"{float(path[3]) / 100:.4g}"}


def table(place, row):
    """One row: the time of a pose is the least of several passes."""
    files = files_of(place, row)
    answers = place.scratch / "answers.csv"
    least, colliding, tests = [], 0, ""
    for _ in range(PASSES[place.form]):
        printed = place.run(place.pinned(place.program(), "query", "--part", files["part"], "--environment", files["environment"], "--poses",
                                         files["poses"], "--query", "distance", "--csv", answers))
        with open(answers, newline="") as file:
            rows = list(csv.DictReader(file))
        times = [float(answer["nanoseconds"]) for answer in rows]
        least = [min(pair) for pair in zip(least, times)] if least else times
        colliding = sum(float(answer["distance"]) == 0 for answer in rows)
        tests = re.search(r"volume tests per query:\s+([\d.e+]+)", printed)[1]
    made = dict(facts_of(files["problem"]), scene=ROWS[row][0], poses=len(least), colliding=colliding,
                us_mean=f"{sum(least) / len(least) / 1000:.6g}", volume_tests=tests)
    return COLUMNS, [{column: str(made[column]) for column in COLUMNS}]
