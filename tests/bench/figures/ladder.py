"""Tables of ladder.csv: what each step from the thesis's engine to clearway's does to a query's work and time."""

from results import NotMeasured, distinct, matching, shown, span, table
from truth import in_short

# The steps that ask for distances, from the first to the last, and the peer beside them.
STEPS = ("thesis's tree", "builder", "fit", "leaves of four", "float", "leaf width", "node width", "cheap bound", "double finish", "warm start")
PEER = "PQP"
MOTIONS = {"motions in steps": "`collides` in steps", "certified motions": "certified motions"}


def scenes(results):
    return distinct(results.rows("ladder"), "scene")


def measured(results, scene, step):
    """The row of a step; None if that peer was not measured."""
    rows = matching(results.rows("ladder"), scene=scene, step=step)
    return rows[0] if rows else None


def times_faster(before, after):
    return shown(float(before["us_median"]) / float(after["us_median"])) if before else ""


def ladder(results, scene):
    """A row a step; then PQP."""
    lines, before = [], None
    for step in STEPS + (PEER,):
        row = measured(results, scene, step)
        if row is None and step == PEER:
            continue
        if row is None:
            raise NotMeasured(f"ladder.csv, {scene}, {step}")
        lines.append(["PQP, cold, for comparison" if step == PEER else step, shown(row["volume_tests"]), shown(row["triangle_tests"]),
                      shown(row["us_median"]), "" if step == PEER else times_faster(before, row), in_short(row["error_worst"])])
        before = row
    name = measured(results, scene, STEPS[0])["scene_name"]
    return table([f"{scene}: {name}", "volume tests", "triangle tests", "us a distance, median", "times faster than the step before",
                  "largest error"], lines)


def motions(results):
    """The last step: whole motions in place of poses."""
    lines = []
    for scene in scenes(results):
        before = None
        for step, name in MOTIONS.items():
            row = measured(results, scene, step)
            if row is None:
                raise NotMeasured(f"ladder.csv, {scene}, {step}")
            lines.append([f"{scene}, {row['count']} motions: {name}", shown(row["volume_tests"]), shown(row["triangle_tests"]),
                          shown(row["us_median"]), times_faster(before, row), row["missed"]])
            before = row
    return table(["motions", "volume tests", "triangle tests", "us a motion, median", "times faster", "contacts missed"], lines)


def total(results):
    """How many times as long the first step takes as the last that asks for distances."""
    ratios = [float(measured(results, scene, STEPS[0])["us_median"]) / float(measured(results, scene, STEPS[-1])["us_median"])
              for scene in scenes(results)]
    return span(ratios)
