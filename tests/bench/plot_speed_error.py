#!/usr/bin/env python3
"""Draws the table of bench_speed_error: error on a log axis against queries per second, one panel per scene.

    plot_speed_error.py speed_error.csv speed_error.svg

Needs matplotlib (Debian: python3-matplotlib).
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FLOOR = 1e-19  # the height at which an error of 0 is drawn

# Mode in the table: label, colour, marker. Hollow markers are peers.
STYLES = {
    "scalar double": ("scalar double, same trees", "#7f7f7f", "s"),
    "float only": ("float only", "#d95f02", "D"),
    "default": ("clearway's default", "#1b5e9e", "o"),
    "cap": ("capped at 1 % of the scene", "#66a3d2", "o"),
    "relative error 0.001": ("relative error 0.001", "#1b9e77", "^"),
    "relative error 0.01": ("relative error 0.01", "#66b83c", "^"),
    "relative error 0.1": ("relative error 0.1", "#a6c83c", "^"),
    "root volumes": ("bound of the root volumes", "#e7298a", "v"),
    "FCL RSS": ("FCL RSS", "#000000", "x"),
    "PQP": ("PQP, warm", "#000000", "+"),
    "Coal OBBRSS": ("Coal OBBRSS", "#000000", "1"),
}


def rows_of_scenes(path):
    with open(path, newline="") as table:
        scenes = {}
        for row in csv.DictReader(table):
            if row["error_worst"] and row["mode"] in STYLES:
                scenes.setdefault(row["scene"], []).append(row)
    if not scenes:
        sys.exit(f"{path} has no row with an error, expected the table bench_speed_error writes")
    return scenes


def draw(axes, scene, rows):
    for row in rows:
        label, colour, marker = STYLES[row["mode"]]
        speed = float(row["queries_per_second"])
        worst = max(FLOOR, float(row["error_worst"]))
        median = max(FLOOR, float(row["error_median"]))
        axes.plot([speed, speed], [median, worst], color=colour, linewidth=0.8, alpha=0.6, zorder=1)
        axes.plot(speed, median, color=colour, marker="_", markersize=6, linestyle="none", zorder=2)
        axes.plot(speed, worst, color=colour, marker=marker, markersize=6.5, linestyle="none", label=label, zorder=3)
    first = rows[0]
    axes.set_title(f"{scene}   {first['poses']} poses, {first['colliding']} colliding", fontsize=9, loc="left")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(FLOOR / 3, 3)
    axes.set_yticks([1e-19, 1e-16, 1e-13, 1e-10, 1e-7, 1e-4, 1e-1])
    axes.set_yticklabels(["none", "1e-16", "1e-13", "1e-10", "1e-7", "1e-4", "0.1"])
    axes.minorticks_off()
    axes.grid(True, color="#dddddd", linewidth=0.6)
    axes.tick_params(labelsize=8, length=2)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot_speed_error.py TABLE.csv PLOT.svg")
    scenes = rows_of_scenes(sys.argv[1])
    plt.rcParams.update({"svg.hashsalt": "clearway", "svg.fonttype": "none", "font.family": "sans-serif"})
    columns = min(3, len(scenes))
    lines = (len(scenes) + columns - 1) // columns
    figure, grid = plt.subplots(lines, columns, figsize=(3.4 * columns, 2.9 * lines + 1.1), sharex=True, sharey=True,
                                squeeze=False)
    for axes, (scene, rows) in zip(grid.flat, scenes.items()):
        draw(axes, scene, rows)
    for axes in list(grid.flat)[len(scenes):]:
        axes.set_visible(False)
    handles = {}
    for axes in grid.flat:
        handles.update({label: handle for handle, label in zip(*axes.get_legend_handles_labels())})
    figure.supxlabel("queries a second, one core", fontsize=9, y=0.75 / figure.get_figheight())
    figure.supylabel("error / scene size: worst (marker) and median (bar)", fontsize=9)
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncol=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0.01, 0.9 / figure.get_figheight(), 1, 1))
    temporary = sys.argv[2] + ".tmp"
    figure.savefig(temporary, format="svg", metadata={"Date": None})
    os.replace(temporary, sys.argv[2])


if __name__ == "__main__":
    main()
