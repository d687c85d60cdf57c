"""Tables and plot of a leaf-strategy study: those of docs/leaf_strategies.md, and `report --study` for a study of your own."""

from statistics import median

from results import NotMeasured, Results, distinct, matching, numbers, read, shown, span, table
from svg import DARK, LIGHT, Log, Page, text_width

FILES = ("runs", "statistics", "trees", "claims")
USUAL = {"leaf_size": "4", "node_width": "8", "instructions": "best"}
CHECKS = ("state_checks", "motion_checks", "motion_costs")
LEAST_SHARE = 0.95  # of a processor; a run with less was disturbed, as in demos/study/planner_runs.cpp

COLOURS = {"none": "#666666", "chain": "#1b9e77", "edge": "#d95f02", "all": "#7570b3", "cost": "#e7298a"}
TICKS = (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.4, 2, 3, 5, 7, 10, 20)
PAGE, GAP, LINE = 1000, 30, 30  # pixels: of the page's width, between panels, of a line's height
COLUMNS = 3  # scenes beside each other, at most
SHIFT = 7  # between the leaf splits of a line


def joined(folders):
    """The results of a study whose scenes may have folders of their own."""
    results = Results(folders[0])
    for name in FILES:
        results.tables[f"leaf_strategies/{name}"] = [row for folder in folders for row in read(folder / f"{name}.csv")]
    return results


def tree(row):
    parts = [row["general_split"]]
    if row["leaf_size"] != "4":
        parts.append(f"leaves of {row['leaf_size']}")
    if row["node_width"] != "8":
        parts.append(f"width {row['node_width']}")
    if row["instructions"] != "best":
        parts.append(row["instructions"])
    return ", ".join(parts)


def two_decimals(value):
    return f"{value:.2f}"


def leaves(results, general, leaf, baseline):
    """How many times as many leaves, in the trees of the scenes' environments."""
    rows = matching(results.rows("leaf_strategies/trees"), general_split=general, node_width="8")
    counts = {(row["scene"], row["leaf_split"]): int(row["leaves"]) for row in rows}
    return [count / counts[scene, baseline] for (scene, split), count in counts.items() if split == leaf and (scene, baseline) in counts]


def summary(results):
    """A row a general split and leaf split; each cell is a range over the planners and scenes."""
    rows = [row for row in results.select("leaf_strategies/statistics", source="runs", **USUAL) if row["planner"] != "all"]
    baseline = rows[0]["baseline"]
    lines = []
    for general in sorted(distinct(rows, "general_split"), reverse=True):
        for leaf in (split for split in COLOURS if any(row["leaf_split"] == split for row in rows)):
            of = matching(rows, general_split=general, leaf_split=leaf)
            cells = [span(numbers(matching(of, measure=name), "ratio"), two_decimals)
                     for name in ("seconds_per_call", "query_seconds_per_call", "triangle_tests_per_query", "volume_tests_per_query")]
            calls = matching(of, measure="seconds_per_call")
            certain = f"{sum(float(row['high']) < 1 for row in calls)} of {len(calls)}"
            lines.append([f"`{general}`, `{leaf}`", cells[0], certain, *cells[1:], span(leaves(results, general, leaf, baseline), two_decimals)])
    return table([f"over `{baseline}` in the same tree", "time of a call", "certain gains", "query time of a call", "pairs of triangles",
                  "pairs of volumes", "leaves"], lines)


def was_disturbed(run):
    return float(run["processor_seconds"]) < LEAST_SHARE * float(run["seconds"])


def over_general(runs, column):
    """The median over pairs of runs with one seed of axis over sah, for each scene."""
    found = []
    for scene in distinct(runs, "scene"):
        of = {(row["general_split"], row["seed"]): row for row in matching(runs, scene=scene)}
        pairs = [(row, of["sah", seed]) for (general, seed), row in of.items() if general == "axis" and ("sah", seed) in of]
        if column == "query_seconds":
            pairs = [pair for pair in pairs if not any(map(was_disturbed, pair))]
        each = [[float(row[column]) / max(1, sum(int(row[name]) for name in CHECKS)) for row in pair] for pair in pairs]
        quotients = [here / there for here, there in each if there]
        if quotients:
            found.append(median(quotients))
    if not found:
        raise NotMeasured("runs.csv, pairs of runs with axis and with sah")
    return span(found, two_decimals)


def general(results):
    """axis over sah, both without leaf splits: a row a planner, ranges over the scenes."""
    runs = results.select("leaf_strategies/runs", leaf_split="none")
    return table(["`axis` over `sah`", "time of a call", "query time of a call"],
                 [[planner] + [over_general(matching(runs, planner=planner), column) for column in ("processor_seconds", "query_seconds")]
                  for planner in distinct(runs, "planner")])


def best_replays(results):
    """The replays that gain most by a leaf split: a row a tree, the least ratio over scenes and planners."""
    rows = [row for row in results.select("leaf_strategies/statistics", source="replay", measure="seconds") if row["planner"] != "all"]
    rows.sort(key=lambda row: (row["general_split"], int(row["leaf_size"])))
    splits = [split for split in COLOURS if any(row["leaf_split"] == split for row in rows)]
    lines = []
    for name in dict.fromkeys(map(tree, rows)):
        cells = []
        for leaf in splits:
            of = [row for row in rows if tree(row) == name and row["leaf_split"] == leaf]
            best = min(of, key=lambda row: float(row["ratio"]), default=None)
            cells.append(f"{two_decimals(float(best['ratio']))} ({best['planner']}, {best['scene']})" if best else "")
        lines.append([name] + cells)
    return table([f"replayed calls over `{rows[0]['baseline']}`, the best case"] + splits, lines)


def claims(results):
    """How many scenes each verdict on a claim of the thesis has, by engine."""
    rows = results.rows("leaf_strategies/claims")
    lines = []
    for claim in distinct(rows, "claim"):
        cells = []
        for width in ("2", "8"):
            of = matching(rows, claim=claim, node_width=width)
            cells.append(", ".join(f"{verdict} in {len(matching(of, verdict=verdict))}" for verdict in distinct(of, "verdict")))
        lines.append([claim, span(numbers(matching(rows, claim=claim), "thesis_ratio"), shown)] + cells)
    return table(["the thesis's claim", "its ratio", "in its own engine, scenes", "in clearway's, scenes"], lines)


def all_tables(results):
    """The tables of a study, one after the other; those that it has no runs for are left out."""
    lines = []
    for make in (summary, general, best_replays, claims):
        try:
            lines += make(results) + [""]
        except NotMeasured:
            continue
    return lines


def lines_by_planner(rows):
    """From a line's label to its rows: the runs and their replay, planner by planner."""
    lines = {}
    for source, measure in (("runs", "seconds_per_call"), ("replay", "seconds")):
        for row in matching(rows, source=source, measure=measure, **USUAL):
            if row["planner"] != "all" and row["general_split"] != "mean":
                lines.setdefault(f"{row['planner']}, {row['general_split']}", []).append(row)
    return dict(sorted(lines.items()))


def lines_by_tree(rows):
    """The lines of a general split: the usual tree, then other leaf sizes, other widths and other instructions."""
    replayed = matching(rows, source="replay", measure="seconds", planner="all")
    replayed.sort(key=lambda row: (row["general_split"], row["instructions"] != "best", -int(row["node_width"]), int(row["leaf_size"]),
                                   row["instructions"]))
    lines = {}
    for row in replayed:
        lines.setdefault(tree(row), []).append(row)
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


def plot(results):
    """The text of the SVG file: the time of each leaf split over no split, with intervals, one column a scene, COLUMNS of them in a row.

    Above, by planner: the planner's own seconds per call (hollow) and the seconds of these calls replayed (full). Below, by tree and
    instruction set: the replayed calls of all planners.
    """
    rows = results.rows("leaf_strategies/statistics")
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
