#!/usr/bin/env python3
"""Prints the tables of docs/public_problems.md from the tables that bench_public wrote.

tabulate_public.py FOLDER
"""

import csv
import math
import statistics
import sys

OURS = "clearway"
FCL = "RRTConnect+FCL"


def rows_of(folder, name):
    with open(f"{folder}/{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def short(value):
    """Two digits, without an exponent."""
    if value == 0:
        return "0"
    rounded = float(f"{value:.2g}")
    return f"{rounded:.{max(0, 1 - math.floor(math.log10(abs(rounded))))}f}"


def spread(values, write=short):
    """The median with the least and the largest value."""
    if not values:
        return ""
    if write(min(values)) == write(max(values)):
        return write(values[0])
    return f"{write(statistics.median(values))} ({write(min(values))} to {write(max(values))})"


def seconds(value):
    return "< 0.01" if value < 0.01 else short(value)


def in_order(rows, key):
    """The distinct values of a column, in order."""
    return list(dict.fromkeys(row[key] for row in rows))


def print_table(head, lines):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def count(rows, column="valid"):
    return f"{sum(row[column] == '1' for row in rows)} of {len(rows)}"


def print_runs(rows):
    """Seconds are those of the runs that found a path; the median counts the others as the limit."""
    others = [name for name in in_order(rows, "contender") if name not in (OURS, FCL)]
    lines = []
    for problem in in_order(rows, "problem"):
        of = {name: [r for r in rows if (r["problem"], r["contender"]) == (problem, name)] for name in [OURS, FCL, *others]}
        ours = of[OURS]
        if ours and all(row["note"] for row in ours):
            lines.append([problem, "no problem: " + ours[0]["note"].split(";")[0]])
            continue
        solved = [row for row in ours if row["valid"] == "1"]
        lines.append(
            [problem, count(ours), spread([float(r["seconds"]) for r in ours], seconds), spread([float(r["clearance"]) for r in solved])]
            + [" / ".join(str(sum(r["valid"] == "1" for r in of[name])) for name in others)]
            + [f"{sum(r['found'] == '1' for r in of[FCL])} found, {sum(r['valid'] == '1' for r in of[FCL])} valid"]
        )
    print_table(["problem", "solved", "seconds, median (range)", "room, median (range)", " / ".join(others), FCL], lines)


def print_parts(rows):
    lines = []
    for assembly in in_order(rows, "assembly"):
        parts = [row for row in rows if row["assembly"] == assembly]
        found = [row for row in parts if row["found"] == "1"]
        straight = [row for row in parts if row["found"] != "1" and row["straight"] not in ("", "0")]
        lines.append(
            [assembly, str(len(parts)), str(sum(row["touching"] != "0" for row in parts)), str(len(found)), str(len(straight))]
            + [str(sum(row["note"] != "" for row in parts))]
            + [spread([float(row["seconds"]) for row in found], seconds), spread([float(row["preparing_seconds"]) for row in parts], seconds)]
        )
    print_table(
        ["assembly", "parts", "touch others", "taken out", "only straight", "refused", "seconds, median (range)", "preparing"],
        lines,
    )


def print_paths(paths, segments):
    lines = [
        [row["problem"], row["path"], row["segments"], row["not_valid"], row["confirmed"], short(float(row["least_clearance"]))]
        for row in paths
    ]
    print_table(["problem", "path", "segments", "not valid", "confirmed", "least clearance"], lines)
    keys = ["problem", "segment", "t", "x", "y", "z", "qx", "qy", "qz", "qw"]
    triangles = [
        f"{row['part_triangle']} of {row['part_mesh']}, {row['environment_triangle']} of {row['environment_mesh']}" for row in segments
    ]
    print_table(
        ["problem", "segment", "t", "pose (x y z qx qy qz qw)", "triangles"],
        [
            [row["problem"], row["segment"], row["t"], " ".join(row[key] for key in keys[3:]), pair]
            for row, pair in zip(segments, triangles)
        ],
    )


def main():
    folder = sys.argv[1]
    print_paths(rows_of(folder, "paths"), rows_of(folder, "invalid_segments"))
    print_runs(rows_of(folder, "runs"))
    print_parts(rows_of(folder, "parts"))


if __name__ == "__main__":
    main()
