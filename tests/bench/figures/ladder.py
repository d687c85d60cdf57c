"""Table of ladder.csv: what each step from the thesis's engine to clearway's does to a query's work and time."""

from queries import thousands
from results import distinct, matching, shown, table
from truth import in_short

# What a step changes.
STEPS = {
    "thesis's tree": "AxisSplit, volumes in the one frame of the corners' covariance, leaves of one triangle, nodes of two children "
                                           "with the exact distance of rectangles; searched in scalar double, cold",
    "builder": "the surface-area split",
    "fit": "the least volume of several frames",
    "leaves of four": "leaves of up to four triangles",
    "leaf width": "float: pairs of triangles side by side in registers, and the two children of a node, too",
    "node width": "nodes of eight children, side by side in a register",
    "cheap bound": "a lower bound by projections in place of the rectangles' distance",
    "double finish": "the closest pairs in double, and exactly where that leaves them open",
    "warm start": "begins with the closest pairs of earlier queries",
    "PQP": "for comparison PQP, cold: scalar double, MeanSplit, leaves of one triangle",
}
MOTIONS = {
    "motions in steps": "a motion, by `collides` at poses so close that no corner of the part's box moves farther than 0.03 % of its diagonal",
    "certified motions": "a motion, certified",
}


def scenes(results):
    rows = results.rows("ladder")
    return [(letter, matching(rows, scene=letter)) for letter in distinct(rows, "scene")]


def title(letter, rows):
    return f"{letter}: {rows[0]['scene_name']}, {thousands(rows[0]['part_triangles'])} / {thousands(rows[0]['environment_triangles'])}"


def times_faster(before, after):
    return "" if before is None else f"{float(before['us_mean']) / float(after['us_mean']):.2f}"


def ladder(results):
    """The steps that ask for distances, a block of columns for each scene."""
    lines = []
    for step, change in STEPS.items():
        cells, found = [], False
        for _, rows in scenes(results):
            of = matching(rows, step=step)
            if not of:
                cells += [""] * 5
                continue
            found = True
            own = list(STEPS).index(step)
            before = matching(rows, step=list(STEPS)[own - 1]) if 0 < own and step != "PQP" else []
            cells += [shown(of[0]["volume_tests"]), shown(of[0]["triangle_tests"]), f"{shown(of[0]['us_mean'])} ({shown(of[0]['us_median'])})",
                      times_faster(before[0] if before else None, of[0]), in_short(of[0]["error_worst"])]
        if found:
            lines.append([f"{step}: {change}"] + cells)
    head = ["step"]
    for letter, rows in scenes(results):
        head += [f"{title(letter, rows)}: volume tests", "triangle tests", "us, mean (median)", "times faster", "largest error"]
    return table(head, lines)


def motions(results):
    """The last step: whole motions in place of poses."""
    lines = []
    for step, change in MOTIONS.items():
        cells = []
        for _, rows in scenes(results):
            of = matching(rows, step=step)
            cells += [shown(of[0]["volume_tests"]), shown(of[0]["triangle_tests"]), f"{shown(of[0]['us_mean'])} ({shown(of[0]['us_median'])})",
                      of[0]["missed"]] if of else [""] * 4
        lines.append([change] + cells)
    head = ["certified motions"]
    for letter, rows in scenes(results):
        number = next((row["count"] for row in rows if row["asked"] == "motion"), "0")
        head += [f"{letter}, {number} motions: volume tests", "triangle tests", "us, mean (median)", "contacts missed"]
    return table(head, lines)


def total(results):
    """How many times as long the first step takes as the last that asks for distances."""
    def us(rows, step):
        return float(matching(rows, step=step)[0]["us_mean"])

    of = [us(rows, "thesis's tree") / us(rows, "warm start") for _, rows in scenes(results)]
    return f"{shown(min(of))} to {shown(max(of))}"
