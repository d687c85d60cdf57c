"""The figures of docs/leaf_strategies.md and docs/leaf_strategies_tables.md, from the folder leaf_strategies of the results."""

from statistics import median

import leaf_tables
from results import NotMeasured, matching, numbers, shown, span, table

USUAL = {"leaf_size": "4", "node_width": "8", "instructions": "best"}


def folders(results):
    folder = results.folder / "leaf_strategies"
    return [folder] if folder.exists() else []


def read(results, name):
    found = leaf_tables.read(folders(results), name)
    if not found:
        raise NotMeasured(f"leaf_strategies, {name}")
    return found


def all_tables(results):
    if not folders(results):
        raise NotMeasured("leaf_strategies")
    return leaf_tables.all_tables(folders(results))


def ratios(results, source, general, leaf, measure):
    """The ratio to no leaf split, of each planner in each scene."""
    rows = matching(read(results, "statistics.csv"), source=source, general_split=general, leaf_split=leaf, measure=measure, **USUAL)
    return [float(row["ratio"]) for row in rows if row["planner"] != "all"]


def certain_gains(results, source, general, leaf, measure):
    """'N of M': pairs of planner and scene in which the whole interval is below 1."""
    rows = matching(read(results, "statistics.csv"), source=source, general_split=general, leaf_split=leaf, measure=measure, **USUAL)
    of = [row for row in rows if row["planner"] != "all"]
    return f"{sum(float(row['high']) < 1 for row in of)} of {len(of)}"


def two_decimals(value):
    return f"{value:.2f}"


def leaves(results, general, leaf):
    """How many times as many leaves, in the trees of the scenes' environments."""
    rows = matching(read(results, "trees.csv"), general_split=general, node_width="8")
    counts = {(row["scene"], row["leaf_split"]): int(row["leaves"]) for row in rows}
    return [count / counts[scene, "none"] for (scene, split), count in counts.items() if split == leaf and (scene, "none") in counts]


def summary(results):
    """A row a general split and leaf split; each cell is a range over the planners and scenes."""
    lines = []
    for general in ("sah", "axis"):
        for leaf in ("chain", "edge", "all"):
            cells = [span(ratios(results, "runs", general, leaf, name), two_decimals)
                     for name in ("seconds_per_call", "query_seconds_per_call", "triangle_tests_per_query", "volume_tests_per_query")]
            of = leaves(results, general, leaf)
            lines.append([f"`{general}`, `{leaf}`", cells[0], certain_gains(results, "runs", general, leaf, "seconds_per_call"), *cells[1:],
                          span(of, two_decimals) if of else ""])
    return table(["over `none` in the same tree", "time of a call", "certain gains", "query time of a call", "pairs of triangles", "pairs of volumes",
                  "leaves"], lines)


def over_general(results, column, planner):
    """The median over pairs of runs with one seed of axis over sah, for each scene."""
    runs = matching(read(results, "runs.csv"), leaf_split="none", planner=planner)
    found = []
    for scene in dict.fromkeys(row["scene"] for row in runs):
        of = {(row["general_split"], row["seed"]): row for row in runs if row["scene"] == scene}
        pairs = [(row, of["sah", seed]) for (general, seed), row in of.items() if general == "axis" and ("sah", seed) in of]
        if column == "query_seconds":
            pairs = [pair for pair in pairs if not any(map(leaf_tables.was_disturbed, pair))]
        each = [[leaf_tables.share(float(row[column]), leaf_tables.total(row, leaf_tables.CHECKS)) for row in pair] for pair in pairs]
        quotients = [here / there for here, there in each if here is not None and there]
        if quotients:
            found.append(median(quotients))
    return found


def general(results):
    """axis over sah, both without leaf splits: a row a planner, ranges over the scenes."""
    planners = list(dict.fromkeys(row["planner"] for row in read(results, "runs.csv")))
    return table(["`axis` over `sah`", "time of a call", "query time of a call"],
                 [[planner] + [span(over_general(results, column, planner), two_decimals) for column in ("processor_seconds", "query_seconds")]
                  for planner in planners])


def best_replays(results):
    """The replays that gain most by a leaf split: a row a tree, the least ratio over scenes and planners."""
    rows = [row for row in read(results, "statistics.csv") if (row["source"], row["measure"]) == ("replay", "seconds") and row["planner"] != "all"]
    lines = []
    for name in dict.fromkeys(leaf_tables.tree(row) for row in sorted(rows, key=lambda row: (row["general_split"], int(row["leaf_size"])))):
        cells = []
        for leaf in ("chain", "edge", "all"):
            of = [row for row in rows if leaf_tables.tree(row) == name and row["leaf_split"] == leaf]
            if not of:
                cells.append("")
                continue
            best = min(of, key=lambda row: float(row["ratio"]))
            cells.append(f"{two_decimals(float(best['ratio']))} ({best['planner']}, {best['scene']})")
        lines.append([name] + cells)
    return table(["replayed calls over `none`, the best case", "chain", "edge", "all"], lines)


def claims(results):
    """How many of the thesis's claims hold, by engine: verdict -> number."""
    rows = read(results, "claims.csv")
    lines = []
    for claim in dict.fromkeys(row["claim"] for row in rows):
        cells = []
        for width in ("2", "8"):
            of = matching(rows, claim=claim, node_width=width)
            cells.append(", ".join(f"{verdict} in {sum(row['verdict'] == verdict for row in of)}"
                                   for verdict in dict.fromkeys(row["verdict"] for row in of)))
        lines.append([claim, span(numbers(matching(rows, claim=claim), "thesis_ratio"), shown)] + cells)
    return table(["the thesis's claim", "its ratio", "in its own engine, scenes", "in clearway's, scenes"], lines)


def setting(results, name):
    return matching(read(results, "settings.csv"), setting=name)[0]["value"]


def improved(results, planner):
    """'N of M' solved runs of a planner that improved their first solution."""
    runs = matching(read(results, "runs.csv"), planner=planner, solved="1")
    return f"{sum(float(row['final_solution_seconds']) > float(row['first_solution_seconds']) for row in runs)} of {len(runs)}"
