"""The tables of `clearway-study`: docs/leaf_strategies_tables.md, and `report --study` for a user's own study.

Each scene may have its own folder.
"""

import csv
from statistics import median

SPLITS = ("none", "chain", "edge", "all")


def read(folders, name):
    rows = []
    for folder in folders:
        with open(folder / name, newline="") as file:
            rows += csv.DictReader(file)
    return rows


def short(value):
    if value == "":
        return "-"
    number = float(value)
    return f"{number:,.0f}" if abs(number) >= 1000 else f"{number:.3g}"


def percent(value):
    if value == "":
        return "-"
    share = 100 * float(value)
    return f"{share:.0f} %" if share >= 10 else f"{share:.2g} %"


def ratio(row):
    return "-" if row is None else f"{short(row['ratio'])} ({short(row['low'])} to {short(row['high'])})"


def table(head, rows):
    """A Markdown table with an empty line behind it; nothing without rows."""
    if not rows:
        return []
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def tree(row):
    parts = [row["general_split"]]
    if row["leaf_size"] != "4":
        parts.append(f"leaves of {row['leaf_size']}")
    if row["node_width"] != "8":
        parts.append(f"width {row['node_width']}")
    if row["instructions"] != "best":
        parts.append(row["instructions"])
    return ", ".join(parts)


def found_by(rows, names):
    """Returns the row that has these values in the columns of these names."""
    return {tuple(row[name] for name in names): row for row in rows}


CHECKS = ("state_checks", "motion_checks", "motion_costs")
QUERIES = ("distance_queries", "within_queries")
LEAST_SHARE = 0.95  # of a processor; a run with less was disturbed, as in demos/study/planner_runs.cpp


def total(run, columns):
    return sum(int(run[name]) for name in columns)


def share(part, whole):
    return part / whole if whole > 0 else None


def medians(runs, value):
    """Returns the median over the runs that have the value; None if no run has one."""
    values = [v for v in map(value, runs) if v is not None]
    return median(values) if values else None


def shown(value, form=short):
    return form("" if value is None else value)


def unsplit(runs, baseline):
    """One line per planner and general split, with the leaf split that others are compared with: medians of its runs."""
    groups = {}
    for run in runs:
        if run["leaf_split"] == baseline:
            groups.setdefault(f"{run['planner']}, {run['general_split']}", []).append(run)
    lines = []
    for name, of in sorted(groups.items()):
        solved = [run for run in of if run["solved"] == "1"]
        seconds = [shown(medians(solved, lambda run: float(run[column])))
                   for column in ("first_solution_seconds", "final_solution_seconds")]
        asked = [" / ".join(shown(medians(of, lambda run: int(run[column]))) for column in columns) for columns in (CHECKS, QUERIES)]
        tests = [shown(medians(of, lambda run: share(float(run[column]), total(run, QUERIES))))
                 for column in ("volume_tests", "triangle_tests")]
        fills = [shown(medians(of, lambda run: share(float(run[part]), float(run[whole]))), percent)
                 for part, whole in (("triangle_tests", "triangle_lanes"), ("kernel_pairs", "kernel_lanes"))]
        calls = shown(medians(of, lambda run: share(total(run, CHECKS), float(run["processor_seconds"]))))
        lines.append([name, f"{len(solved)} of {len(of)}"] + seconds + [calls] + asked + tests + fills)
    return table(["planner, tree", "solved", "first solution, s", "final, s", "calls/s", "states / motions / costs asked",
           "distances / withins", "volume tests", "triangle tests", "blocks in use", "kernel in use"], lines)


def was_disturbed(run):
    return float(run["processor_seconds"]) < LEAST_SHARE * float(run["seconds"])


def general_splits(runs, baseline):
    """One line per planner: the time of other general splits over the last one, by pairs of runs with one seed."""
    by_seed = found_by([run for run in runs if run["leaf_split"] == baseline], ("planner", "general_split", "seed"))
    *others, best = sorted({run["general_split"] for run in runs})
    lines = []
    for planner in sorted({run["planner"] for run in runs}):
        for other in others:
            pairs = [(run, by_seed[planner, best, seed]) for (name, split, seed), run in by_seed.items()
                     if (name, split) == (planner, other) and (planner, best, seed) in by_seed]
            calm = [pair for pair in pairs if not any(map(was_disturbed, pair))]
            cells = [f"{planner}, {other} over {best}"]
            for column, of in (("processor_seconds", pairs), ("query_seconds", calm)):
                each = [[share(float(run[column]), total(run, CHECKS)) for run in pair] for pair in of]
                ratios = [here / there for here, there in each if here is not None and there]
                cells.append(f"{short(median(ratios))} ({short(min(ratios))} to {short(max(ratios))})" if ratios else "-")
            lines.append(cells)
    return table(["planner, trees", "planner's time", "query time"], lines)


def planners(summary, statistics):
    """One line per planner, general split and leaf split, with the ratios of pairs of runs."""
    columns = ("planner", "general_split", "leaf_split")
    of_runs = found_by([row for row in summary if row["source"] == "runs" and row["planner"] != "all"], columns)
    ratios = found_by([row for row in statistics if row["source"] == "runs"], ("measure",) + columns)
    baseline = statistics[0]["baseline"]
    measures = ("first_solution_seconds", "seconds_per_call", "query_seconds_per_call", "triangle_tests_per_query", "block_fill")
    lines = []
    for key in sorted(of_runs, key=lambda key: (key[0], key[1], SPLITS.index(key[2]))):
        row, with_baseline = of_runs[key], of_runs.get((key[0], key[1], baseline))
        if key[2] == baseline or with_baseline is None:
            continue
        lines.append([f"{key[0]}, {key[1]}/{key[2]}", f"{row['solved']} ({with_baseline['solved']}) of {row['runs']}",
                      f"{percent(row['query_share'])} ({percent(with_baseline['query_share'])})"] +
                     [ratio(ratios.get((name,) + key)) for name in measures])
    shown_rows = table(["planner, tree", f"solved (`{baseline}`)", f"in queries (`{baseline}`)", "first solution", "planner's time",
           "query time", "triangle tests", "blocks in use"], lines)
    everything = [row for row in summary if row["source"] == "runs" and row["planner"] == "all"]
    disturbed, runs = (sum(int(row[name]) for row in everything) for name in ("disturbed", "runs"))
    if disturbed:
        shown_rows += [f"{disturbed} of {runs} runs had less than 95 % of a processor and are left out of the ratios of first solution and "
                       "query time.", ""]
    return shown_rows


def replays(statistics, summary, baseline):
    """One line per tree, with ratios for the replayed calls of all planners."""
    speeds = {tree(row): row["calls_per_second"] for row in summary
              if (row["source"], row["planner"], row["leaf_split"]) == ("replay", "all", baseline)}
    rows = [row for row in statistics if row["source"] == "replay" and row["planner"] == "all"]
    rows.sort(key=lambda row: (row["general_split"], row["instructions"] != "best", -int(row["node_width"]),
                               int(row["leaf_size"]), row["instructions"]))
    splits = [split for split in SPLITS if any(row["leaf_split"] == split for row in rows)]
    found = found_by([dict(row, tree=tree(row)) for row in rows], ("tree", "measure", "leaf_split"))

    def short_ratios(name, measure):
        of = [found.get((name, measure, split)) for split in splits]
        return ", ".join("-" if row is None else short(row["ratio"]) for row in of)

    lines = [[name, short(speeds[name])] + [ratio(found.get((name, "seconds", split))) for split in splits] +
             [short_ratios(name, "triangle_tests"), short_ratios(name, "block_fill")]
             for name in dict.fromkeys(tree(row) for row in rows)]
    return table(["tree", f"{baseline}: calls/s"] + [f"{split}: seconds" for split in splits] + ["triangle tests", "blocks in use"], lines)


def beside(row, measure):
    theirs = row[f"thesis_{measure}"]
    return short(row[measure]) + (f" [{short(theirs)}]" if theirs else "")


def trees(rows):
    return table(["tree", "build, s", "MB", "leaves of 1 / 2 / 3 / 4", "leaves", "collisions/s", "distances/s"],
          [[f"{row['general_split']}/{row['leaf_split']}, width {row['node_width']}", beside(row, "build_seconds"),
            beside(row, "megabytes"), " / ".join(row[f"leaves_{size}"] for size in (1, 2, 3, 4)), beside(row, "leaves"),
            beside(row, "collisions_per_second"), beside(row, "distances_per_second")] for row in rows])


def claims(rows):
    """One line per claim and scene, one column per engine."""
    widths = sorted({row["node_width"] for row in rows}, key=int)
    found = found_by(rows, ("claim", "scene", "node_width"))
    lines = []
    for claim, scene in dict.fromkeys((row["claim"], row["scene"]) for row in rows):
        of = [found.get((claim, scene, width)) for width in widths]
        thesis = short(next(row for row in of if row)["thesis_ratio"])
        lines.append([claim, scene, thesis] + [f"{row['verdict']}: {short(row['ratio'])}" if row else "-" for row in of])
    lines.sort(key=lambda line: list(dict.fromkeys(row["claim"] for row in rows)).index(line[0]))
    return table(["claim", "scene", "thesis"] + [f"width {width}" for width in widths], lines)


def all_tables(folders):
    """The whole text below the page's heading."""
    names = ("runs.csv", "summary.csv", "statistics.csv", "trees.csv", "claims.csv")
    runs, summary, statistics, built, judged = (read(folders, name) for name in names)
    baseline = statistics[0]["baseline"]
    lines = [f"- Ratios are to `{baseline}`. Below 1 is quicker, or less.",
             "- A ratio is a median; in brackets stands the interval of 95 in 100 bootstrap resamples.",
             f"- Shares of `{baseline}` are in brackets, too.", ""]
    for scene in dict.fromkeys(row["scene"] for row in built):
        of = [[row for row in rows if row["scene"] == scene] for rows in (summary, statistics, built)]
        here = [run for run in runs if run["scene"] == scene]
        lines += [f"## {scene}", "", f"Planner runs with `{baseline}`: medians of all runs; times to solutions are medians of the solved runs. "
                  "Tests are counted per query.", ""] + unsplit(here, baseline)
        lines += ["The general splits: time per call of the planner, as medians (least to largest) of pairs of runs.", ""]
        lines += general_splits(here, baseline)
        lines += [f"The other leaf splits over `{baseline}`: planner's time and query time per call, triangle tests per query.", ""]
        lines += planners(of[0], of[1])
        lines += ["The calls of all planners, replayed. Triangle tests and blocks in use are given for the splits in turn.", ""]
        lines += replays(of[1], of[0], baseline)
        first = of[2][0]
        thesis = f"; in brackets the thesis's {first['thesis_scene']}" if first["thesis_scene"] else ""
        lines += [f"Trees of the environment, {int(first['triangles']):,} triangles; {first['colliding']} of {first['poses']} poses "
                  f"collide{thesis}:", ""] + trees(of[2])
    lines += ["## The thesis's claims", "", "The ratio by which the first has more than the second.", ""] + claims(judged)
    return lines[:-1]
