"""Draws speed_error.csv: error on a logarithmic axis against queries a second, one panel a scene."""

from results import distinct, matching
from svg import GREY, LIGHT, Log, Page
from truth import scene_name

# Mode in the table: label, colour, mark, whether it is filled. Peers are strokes.
STYLES = {
    "scalar double": ("scalar double, same trees", "#7f7f7f", "square"),
    "float only": ("float only", "#d95f02", "diamond"),
    "default": ("clearway's default", "#1b5e9e", "circle"),
    "cap": ("capped at 1 % of the scene", "#66a3d2", "circle"),
    "relative error 0.001": ("relative error 0.001", "#1b9e77", "up"),
    "relative error 0.01": ("relative error 0.01", "#66b83c", "up"),
    "relative error 0.1": ("relative error 0.1", "#a6c83c", "up"),
    "root volumes": ("bound of the root volumes", "#e7298a", "down"),
    "FCL RSS": ("FCL RSS", "#000000", "cross"),
    "PQP": ("PQP, warm", "#000000", "plus"),
    "Coal OBBRSS": ("Coal OBBRSS", "#000000", "star"),
    "MeshLib": ("MeshLib, float", "#000000", "up"),
}
NONE = 1e-19  # the height at which an error of 0 is drawn
HEIGHTS = {1e-19: "none", 1e-16: "1e-16", 1e-13: "1e-13", 1e-10: "1e-10", 1e-7: "1e-7", 1e-4: "1e-4", 1e-1: "0.1"}
COLUMNS, WIDTH, HEIGHT = 3, 312, 250  # of panels


def draw(page, scene, rows, left, top, speeds):
    x = Log(*speeds, left, left + WIDTH - 30)
    y = Log(NONE / 3, 3, top + HEIGHT - 50, top)
    for height in HEIGHTS:
        page.line(x.begin, y(height), x.end, y(height), LIGHT)
    speed = speeds[0]
    while speed <= speeds[1] * 1.001:
        page.line(x(speed), y.begin, x(speed), y.end, LIGHT)
        page.text(x(speed), y.begin + 14, f"{speed:.0e}".replace("e+0", "e"), 11, "middle")
        speed *= 10
    page.line(x.begin, y.begin, x.end, y.begin)
    page.line(x.begin, y.begin, x.begin, y.end)
    first = rows[0]
    page.text(left, top - 8, f"{scene}: {scene_name(scene)}; {first['colliding']} of {first['poses']} collide", 11)
    for row in rows:
        _, colour, shape = STYLES[row["mode"]]
        at = x(float(row["queries_per_second"]))
        worst, median = (y(max(NONE, float(row[column]))) for column in ("error_worst", "error_median"))
        page.line(at, median, at, worst, colour, 0.8)
        page.mark("bar", at, median, colour)
        page.mark(shape, at, worst, colour)


def plot(results):
    """The text of the SVG file."""
    rows = [row for row in results.rows("speed_error") if row["error_worst"] and row["mode"] in STYLES]
    scenes = distinct(rows, "scene")
    speeds = [float(row["queries_per_second"]) for row in rows]
    low, high = 1.0, 10.0
    while low * 10 < min(speeds):
        low *= 10
    while high < max(speeds):
        high *= 10
    lines = (len(scenes) + COLUMNS - 1) // COLUMNS
    page = Page(60 + COLUMNS * WIDTH, 40 + lines * HEIGHT + 90)
    for i, scene in enumerate(scenes):
        left, top = 60 + WIDTH * (i % COLUMNS), 30 + HEIGHT * (i // COLUMNS)
        draw(page, scene, matching(rows, scene=scene), left, top, (low, high))
        if i % COLUMNS == 0:
            y = Log(NONE / 3, 3, top + HEIGHT - 50, top)
            for height, label in HEIGHTS.items():
                page.text(left - 6, y(height) + 4, label, 11, "end")
    bottom = 30 + lines * HEIGHT
    page.text(page.size[0] / 2, bottom, "queries a second, one core", 12, "middle")
    page.text(14, 30 + lines * HEIGHT / 2 - 20, "error / scene size: worst (mark) and median (bar)", 12, "middle", GREY, -90)
    modes = [mode for mode in STYLES if any(row["mode"] == mode for row in rows)]
    page.legend([(STYLES[mode][2], STYLES[mode][1], True, STYLES[mode][0]) for mode in modes], 70, bottom + 26)
    return page.write()
