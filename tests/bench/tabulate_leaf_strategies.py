#!/usr/bin/env python3
"""Writes what `clearway bench --study leaf-strategies` found as Markdown tables, to standard output.

    tabulate_leaf_strategies.py STUDY_FOLDER > tables.md
"""
import csv
import os
import sys


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as table:
        return list(csv.DictReader(table))


def short(value):
    if value == "":
        return "-"
    number = float(value)
    return f"{number:,.0f}" if abs(number) >= 1000 else f"{number:.3g}"


def percent(value):
    return "-" if value == "" else f"{100 * float(value):.3g} %"


def ratio(row):
    return f"{short(row['ratio'])} ({short(row['low'])} to {short(row['high'])})"


def table(head, rows):
    if not rows:
        return
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def tree(row):
    parts = [row["general_split"], f"leaves of {row['leaf_size']}", f"width {row['node_width']}", row["instructions"]]
    return ", ".join(parts)


def ratios(statistics, source, measure, planners):
    """A line for each tree and planner, a column for each leaf split."""
    found, splits, baseline = {}, [], ""
    for row in statistics:
        if (row["source"], row["measure"]) != (source, measure) or (row["planner"] == "all") == planners:
            continue
        if row["leaf_split"] not in splits:
            splits.append(row["leaf_split"])
        found.setdefault((row["planner"], tree(row)), {})[row["leaf_split"]] = ratio(row)
        baseline = row["baseline"]
    table(["planner", "tree"] + [f"{split} / {baseline}" for split in splits],
          [[planner, name] + [of.get(split, "-") for split in splits] for (planner, name), of in sorted(found.items())])


def runs(summary):
    rows = [row for row in summary if row["source"] == "runs" and row["planner"] != "all"]
    rows.sort(key=lambda row: (row["planner"], row["general_split"]))
    table(["planner", "strategy", "solved", "first solution, s", "calls/s", "in queries", "volumes/query", "triangles/query",
           "blocks full", "kernels full"],
          [[row["planner"], f"{row['general_split']}/{row['leaf_split']}", f"{row['solved']} of {row['runs']}",
            short(row["first_solution_seconds"]), short(row["calls_per_second"]), percent(row["query_share"]),
            short(row["volume_tests"]), short(row["triangle_tests"]), percent(row["block_fill"]), percent(row["kernel_fill"])]
           for row in rows])


def beside(row, measure):
    theirs = row[f"thesis_{measure}"]
    return short(row[measure]) + (f" [{short(theirs)}]" if theirs else "")


def trees(rows):
    table(["width", "strategy", "build, s", "MB", "leaves of 1 / 2 / 3 / 4", "leaves", "collisions/s", "distances/s"],
          [[row["node_width"], f"{row['general_split']}/{row['leaf_split']}", beside(row, "build_seconds"),
            beside(row, "megabytes"), " / ".join(row[f"leaves_{size}"] for size in (1, 2, 3, 4)), beside(row, "leaves"),
            beside(row, "collisions_per_second"), beside(row, "distances_per_second")] for row in rows])


def claims(rows):
    table(["width", "claim", "thesis", "here", "verdict"],
          [[row["node_width"], row["claim"], short(row["thesis_ratio"]), ratio(row), row["verdict"]] for row in rows])


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tabulate_leaf_strategies.py STUDY_FOLDER")
    names = ("summary.csv", "statistics.csv", "trees.csv", "claims.csv")
    summary, statistics, built, judged = (read(sys.argv[1], name) for name in names)
    for scene in dict.fromkeys(row["scene"] for row in built):
        of = [[row for row in rows if row["scene"] == scene] for rows in (summary, statistics, built, judged)]
        print(f"## {scene}\n\nPlanner runs:\n")
        runs(of[0])
        print("Seconds to the first solution, by pairs of runs:\n")
        ratios(of[1], "runs", "first_solution_seconds", True)
        print("Seconds for each call, by pairs of runs:\n")
        ratios(of[1], "runs", "seconds_per_call", True)
        print("Costs of solutions, by pairs of runs:\n")
        ratios(of[1], "runs", "cost", True)
        print("Seconds of the same calls, replayed:\n")
        ratios(of[1], "replay", "seconds", False)
        print(f"Trees; {of[2][0]['colliding']} of {of[2][0]['poses']} poses collide; in brackets the thesis's "
              f"{of[2][0]['thesis_scene'] or '(none)'}:\n")
        trees(of[2])
        print("The thesis's claims:\n")
        claims(of[3])


if __name__ == "__main__":
    main()
