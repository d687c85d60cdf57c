"""Draws a leaf-strategy study: the time of each leaf split over no split, with intervals, one column a scene, COLUMNS of them in a row.

Above, by planner: the planner's own seconds per call (hollow) and the seconds of these calls replayed (full). Below, by tree and
instruction set: the replayed calls of all planners.
"""

import leaf_tables
from results import NotMeasured, distinct, matching
from svg import DARK, LIGHT, Log, Page, text_width

COLOURS = {"none": "#666666", "chain": "#1b9e77", "edge": "#d95f02", "all": "#7570b3"}
TICKS = (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.4, 2, 3, 5, 7, 10, 20)
PAGE, GAP, LINE = 1000, 30, 30  # pixels: of the page's width, between panels, of a line's height
COLUMNS = 3  # scenes beside each other, at most
SHIFT = 7  # between the leaf splits of a line


def usual(row):
    return (row["leaf_size"], row["node_width"], row["instructions"]) == ("4", "8", "best")


def lines_by_planner(rows):
    """From a line's label to its rows: the runs and their replay, planner by planner."""
    lines = {}
    for source, measure in (("runs", "seconds_per_call"), ("replay", "seconds")):
        for row in matching(rows, source=source, measure=measure):
            if usual(row) and row["planner"] != "all" and row["general_split"] != "mean":
                lines.setdefault(f"{row['planner']}, {row['general_split']}", []).append(row)
    return dict(sorted(lines.items()))


def lines_by_tree(rows):
    """The lines of a general split: the usual tree, then other leaf sizes, other widths and other instructions."""
    replayed = matching(rows, source="replay", measure="seconds", planner="all")
    replayed.sort(key=lambda row: (row["general_split"], row["instructions"] != "best", -int(row["node_width"]), int(row["leaf_size"]),
                                   row["instructions"]))
    lines = {}
    for row in replayed:
        lines.setdefault(leaf_tables.tree(row), []).append(row)
    return lines


def draw(page, scene, lines, splits, left, right, top, limits):
    x = Log(*limits, left, right)
    bottom = top + LINE * len(lines)
    for tick in TICKS:
        if limits[0] <= tick <= limits[1]:
            page.line(x(tick), top, x(tick), bottom, DARK if tick == 1 else LIGHT, 0.8)
            page.text(x(tick), bottom + 14, f"{tick:g}", 11, "middle")
    page.text(left, top - 8, scene, 13)
    for i, rows in enumerate(lines.values()):
        middle = top + LINE * (i + 0.5)
        for row in matching(rows, scene=scene):
            is_run = row["source"] == "runs"
            y = middle + SHIFT * (splits.index(row["leaf_split"]) - (len(splits) - 1) / 2) + (2 if is_run else -2)
            ratio, low, high = (x(min(max(float(row[name]), limits[0]), limits[1])) for name in ("ratio", "low", "high"))
            page.line(low, y, high, y, COLOURS[row["leaf_split"]], 0.8 if is_run else 1.6)
            page.mark("circle", ratio, y, COLOURS[row["leaf_split"]], 2.5, not is_run)


def plot(folders):
    """The text of the SVG file. folders: those of a study, each scene may have its own."""
    rows = leaf_tables.read(folders, "statistics.csv")
    if not rows:
        raise NotMeasured("leaf_strategies")
    scenes = sorted(distinct(rows, "scene"))
    splits = [split for split in COLOURS if any(row["leaf_split"] == split for row in rows)]
    parts = {"by planner": lines_by_planner(rows), "by tree": lines_by_tree(rows)}
    shown = [row for lines in parts.values() for of in lines.values() for row in of]
    lows, highs = ([float(row[name]) for row in shown] for name in ("low", "high"))
    limits = (max([tick for tick in TICKS if tick <= min(lows)], default=TICKS[0]),
              min([tick for tick in TICKS if tick >= max(highs)], default=TICKS[-1]))
    bands = [(what, scenes[i:i + COLUMNS]) for what in parts for i in range(0, len(scenes), COLUMNS)]
    page = Page(PAGE, sum(LINE * len(parts[what]) + 80 for what, _ in bands) + 60)
    labels = 20 + max(text_width(label, 12) for lines in parts.values() for label in lines)
    width = (PAGE - labels) / min(COLUMNS, len(scenes))
    top = 30
    for what, beside in bands:
        lines = parts[what]
        page.text(labels - 10, top - 8, what, 13, "end")
        for i, label in enumerate(lines):
            page.text(labels - 10, top + LINE * (i + 0.5) + 4, label, 12, "end")
        for column, scene in enumerate(beside):
            left = labels + width * column
            draw(page, scene, lines, splits, left, left + width - GAP, top, limits)
        top += LINE * len(lines) + 80
        page.text((labels + PAGE - GAP) / 2, top - 48, f"seconds over those of '{rows[0]['baseline']}'", 12, "middle")
    entries = [("circle", COLOURS[split], True, split) for split in splits]
    entries += [("circle", "#666666", True, "the same calls, replayed"), ("circle", "#666666", False, "a planner's own seconds for each call")]
    page.legend(entries, 40, page.size[1] - 38)
    page.text(34, page.size[1] - 14, "Bars are 95 % intervals.", 12)
    return page.write()
