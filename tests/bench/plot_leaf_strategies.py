#!/usr/bin/env python3
"""Draws the results of `clearway bench --study leaf-strategies`: the time of each leaf split over the first one, with
intervals.

    plot_leaf_strategies.py STUDY... PLOT.svg

STUDY: a study's folder or its statistics.csv; each scene may have its own folder.
Each scene has a column. Above, by planner: the planner's own seconds per call (hollow) and the seconds of these calls replayed
(full). Below, by tree and instruction set: the replayed calls of all planners. Needs matplotlib (Debian: python3-matplotlib).
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import matplotlib.ticker

COLOURS = {"chain": "#1b9e77", "edge": "#d95f02", "all": "#7570b3", "none": "#666666"}
SHIFTS = 0.22  # between the leaf splits of a line
TICKS = (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.4, 2, 3, 5, 7, 10, 20)


def read(paths):
    rows = []
    for path in paths:
        file = os.path.join(path, "statistics.csv") if os.path.isdir(path) else path
        with open(file, newline="") as table:
            rows += csv.DictReader(table)
    if not rows:
        sys.exit(f"{', '.join(paths)}: no rows, expected the table that a study writes")
    return rows


def tree(row):
    parts = [row["general_split"]]
    if row["leaf_size"] != "4":
        parts.append(f"leaves of {row['leaf_size']}")
    if row["node_width"] != "8":
        parts.append(f"width {row['node_width']}")
    if row["instructions"] != "best":
        parts.append(row["instructions"])
    return ", ".join(parts)


def usual(row):
    return (row["leaf_size"], row["node_width"], row["instructions"]) == ("4", "8", "best")


def lines_by_planner(rows):
    """Returns a dictionary from line label to rows: the runs and their replay, planner by planner."""
    lines = {}
    for source, measure in (("runs", "seconds_per_call"), ("replay", "seconds")):
        for row in rows:
            if row["source"] == source and row["measure"] == measure and usual(row) and row["planner"] != "all":
                if row["general_split"] != "mean":
                    lines.setdefault(f"{row['planner']}, {row['general_split']}", []).append(row)
    return dict(sorted(lines.items()))


def lines_by_tree(rows):
    """Sorts the lines of a general split: the usual tree, then other leaf sizes, other widths and other instructions."""
    replayed = [row for row in rows if row["source"] == "replay" and row["measure"] == "seconds" and row["planner"] == "all"]
    replayed.sort(key=lambda row: (row["general_split"], row["instructions"] != "best", -int(row["node_width"]),
                                   int(row["leaf_size"]), row["instructions"]))
    lines = {}
    for row in replayed:
        lines.setdefault(tree(row), []).append(row)
    return lines


def draw(axes, lines, splits):
    axes.axvline(1, color="#999999", linewidth=0.8, zorder=0)
    for line, rows in enumerate(lines.values()):
        for row in rows:
            y = line + SHIFTS * (splits.index(row["leaf_split"]) - (len(splits) - 1) / 2)
            is_run = row["source"] == "runs"
            y += 0.07 if is_run else -0.07
            colour = COLOURS.get(row["leaf_split"], "#000000")
            ratio, low, high = (float(row[name]) for name in ("ratio", "low", "high"))
            axes.plot([low, high], [y, y], color=colour, linewidth=0.8 if is_run else 1.6, alpha=0.8)
            axes.plot(ratio, y, color=colour, marker="o", markersize=4, markerfacecolor="white" if is_run else colour)
    axes.set_yticks(range(len(lines)))
    axes.set_yticklabels(lines.keys(), fontsize=7)
    axes.set_ylim(len(lines) - 0.4, -0.6)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(matplotlib.ticker.FixedLocator(TICKS))
    axes.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.tick_params(labelsize=7, length=2)
    axes.grid(True, axis="x", color="#e4e4e4", linewidth=0.6)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main():
    if len(sys.argv) < 3:
        sys.exit("usage: plot_leaf_strategies.py STUDY... PLOT.svg")
    *studies, plot = sys.argv[1:]
    rows = read(studies)
    scenes = sorted({row["scene"] for row in rows})
    splits = [split for split in ("none", "chain", "edge", "all") if any(row["leaf_split"] == split for row in rows)]
    baseline = rows[0]["baseline"]
    plt.rcParams.update({"svg.hashsalt": "clearway", "svg.fonttype": "none", "font.family": "sans-serif"})
    drawn = [(lines_by_planner([r for r in rows if r["scene"] == s]), lines_by_tree([r for r in rows if r["scene"] == s]))
             for s in scenes]
    heights = [max(1, max(len(pair[i]) for pair in drawn)) for i in (0, 1)]
    figure, grid = plt.subplots(2, len(scenes), figsize=(max(7.5, 4.6 * len(scenes)), 0.42 * sum(heights) + 1.9), squeeze=False,
                                sharex=True, gridspec_kw={"height_ratios": heights})
    for column, scene in enumerate(scenes):
        for line in (0, 1):
            draw(grid[line][column], drawn[column][line], splits)
        grid[0][column].set_title(f"{scene}: by planner", fontsize=8, loc="left")
        grid[1][column].set_title(f"{scene}: by tree and instructions", fontsize=8, loc="left")
        for line in (0, 1):
            grid[line][column].tick_params(labelbottom=True)
            grid[line][column].set_xlabel(f"seconds over those of '{baseline}'", fontsize=7)
    handles = [plt.Line2D([], [], color=COLOURS[split], marker="o", linestyle="-", label=split) for split in splits]
    handles.append(plt.Line2D([], [], color="#666666", marker="o", linestyle="", label="the same calls, replayed"))
    handles.append(plt.Line2D([], [], color="#666666", marker="o", markerfacecolor="white", linestyle="",
                              label="a planner's own seconds for each call"))
    note = plt.Line2D([], [], linestyle="", label="bars: 95 % intervals")
    figure.legend(handles=handles + [note], loc="lower center", ncol=len(handles) + 1, fontsize=7, frameon=False)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    temporary = plot + ".tmp.svg"
    figure.savefig(temporary, metadata={"Date": None})
    os.replace(temporary, plot)


if __name__ == "__main__":
    main()
