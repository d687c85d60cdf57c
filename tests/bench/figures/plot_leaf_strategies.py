"""Draws a leaf-strategy study: the time of each leaf split over no split, with intervals, one column a scene.

Above, by planner: the planner's own seconds per call (hollow) and the seconds of these calls replayed (full). Below, by tree and
instruction set: the replayed calls of all planners.
"""

import leaf_tables
from results import NotMeasured, distinct, matching
from svg import DARK, LIGHT, Log, Page

COLOURS = {"none": "#666666", "chain": "#1b9e77", "edge": "#d95f02", "all": "#7570b3"}
TICKS = (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.4, 2, 3, 5, 7, 10, 20)
LABELS, WIDTH, LINE = 150, 300, 30  # pixels: of the labels, of a panel, of a line's height
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


def draw(page, title, lines, splits, left, top, limits):
    x = Log(*limits, left + LABELS, left + LABELS + WIDTH)
    bottom = top + LINE * len(lines)
    for tick in TICKS:
        if limits[0] <= tick <= limits[1]:
            page.line(x(tick), top, x(tick), bottom, DARK if tick == 1 else LIGHT, 0.8)
            page.text(x(tick), bottom + 13, f"{tick:g}", 10, "middle")
    page.text(left + LABELS, top - 8, title, 11)
    for i, (label, rows) in enumerate(lines.items()):
        middle = top + LINE * (i + 0.5)
        page.text(left + LABELS - 6, middle + 4, label, 10, "end")
        for row in rows:
            is_run = row["source"] == "runs"
            y = middle + SHIFT * (splits.index(row["leaf_split"]) - (len(splits) - 1) / 2) + (2 if is_run else -2)
            ratio, low, high = (x(min(max(float(row[name]), limits[0]), limits[1])) for name in ("ratio", "low", "high"))
            page.line(low, y, high, y, COLOURS[row["leaf_split"]], 0.8 if is_run else 1.6)
            page.mark("circle", ratio, y, COLOURS[row["leaf_split"]], 2.5, not is_run)
    return bottom


def plot(folders):
    """The text of the SVG file. folders: those of a study, each scene may have its own."""
    rows = leaf_tables.read(folders, "statistics.csv")
    if not rows:
        raise NotMeasured("leaf_strategies")
    scenes = sorted(distinct(rows, "scene"))
    splits = [split for split in COLOURS if any(row["leaf_split"] == split for row in rows)]
    drawn = [(lines_by_planner(matching(rows, scene=scene)), lines_by_tree(matching(rows, scene=scene))) for scene in scenes]
    shown = [row for pair in drawn for lines in pair for of in lines.values() for row in of]
    lows, highs = ([float(row[name]) for row in shown] for name in ("low", "high"))
    limits = (max([tick for tick in TICKS if tick <= min(lows)], default=TICKS[0]),
              min([tick for tick in TICKS if tick >= max(highs)], default=TICKS[-1]))
    heights = [LINE * max(len(pair[i]) for pair in drawn) for i in (0, 1)]
    page = Page(len(scenes) * (LABELS + WIDTH + 20) + 20, sum(heights) + 180)
    for column, scene in enumerate(scenes):
        left = 10 + column * (LABELS + WIDTH + 20)
        for i, (what, top) in enumerate((("by planner", 30), ("by tree and instructions", 90 + heights[0]))):
            bottom = draw(page, f"{scene}: {what}", drawn[column][i], splits, left, top, limits)
            page.text(left + LABELS + WIDTH / 2, bottom + 28, f"seconds over those of '{rows[0]['baseline']}'", 10, "middle")
    entries = [("circle", COLOURS[split], True, split) for split in splits]
    entries += [("circle", "#666666", True, "the same calls, replayed"), ("circle", "#666666", False, "a planner's own seconds for each call")]
    page.legend(entries, 40, page.size[1] - 24, 160, len(entries))
    page.text(40, page.size[1] - 6, "Bars are 95 % intervals.", 10)
    return page.write()
