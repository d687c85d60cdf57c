"""Tables and plot of growth.csv: what a query, a certified motion and a build take as one of two linked rings grows."""

import math

from queries import thousands
from results import NotMeasured, distinct, matching, seconds, shown, table, whole
from svg import LIGHT, Log, Page, decades, powers

KEPT = 30_000  # triangles of the ring that does not grow, about
GROWING = {"environment": ("environment_triangles", "part_triangles"), "part": ("part_triangles", "environment_triangles")}

# Engine in the table: label, colour, mark.
STYLES = {
    "clearway": ("clearway", "#1b5e9e", "circle"),
    "PQP": ("PQP, warm", "#000000", "plus"),
    "FCL RSS": ("FCL RSS", "#000000", "cross"),
    "Coal OBBRSS": ("Coal OBBRSS", "#000000", "star"),
}

MOTION = ("clearway, a certified motion", "#d95f02", "diamond")


def series(results, grows):
    """The rows in which one ring grows and the other is kept, from few triangles to many."""
    grown, kept = GROWING[grows]
    rows = [row for row in results.rows("growth") if abs(int(row[kept]) - KEPT) < 0.05 * KEPT]
    if not rows:
        raise NotMeasured(f"growth.csv, {grows}")
    return sorted(rows, key=lambda row: int(row[grown]))


def engines(rows):
    return [engine for engine in STYLES if any(row["engine"] == engine for row in rows)]


def cell(row, column, write=shown):
    return "-" if not row else write(row[column]) if row[column] else "left out"


def growth(results, grows):
    """A row a size; times of all engines, then clearway's work, motions, builds and bytes."""
    rows = series(results, grows)
    grown, _ = GROWING[grows]
    named = engines(rows)
    lines = []
    for size in distinct(rows, grown):
        of = {row["engine"]: row for row in matching(rows, **{grown: size})}
        ours = of["clearway"]
        lines.append([thousands(size)] + [cell(of.get(engine), "us_median") for engine in named] +
                     [cell(ours, column) for column in ("node_visits", "triangle_tests", "us_motion_median")] +
                     [" / ".join(cell(of.get(engine), "build_seconds", seconds) for engine in named),
                      " / ".join(cell(of.get(engine), "bytes_per_triangle") for engine in named)])
    names = [STYLES[engine][0] for engine in named]
    return table([f"triangles of the {grows}"] + [f"{name}, us a distance" for name in names] +
                 ["nodes visited", "pairs of triangles tested", "us a certified motion", "seconds to build both: " + " / ".join(names),
                  "bytes a triangle"], lines)


def slope(points):
    """The exponent of y over x, by least squares in the logarithms of the larger half of the points."""
    larger = sorted(points)[-((len(points) + 1) // 2):]
    if len(larger) < 2:
        return None
    x, y = ([math.log(point[k]) for point in larger] for k in (0, 1))
    middle_x, middle_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - middle_x) * (b - middle_y) for a, b in zip(x, y)) / sum((a - middle_x) ** 2 for a in x)


def slopes(results):
    """An exponent for each engine and figure. Queries and motions are over the ring that grows, builds over the triangles of both."""
    lines = []
    for grows in GROWING:
        rows = series(results, grows)
        for title, column in (("a distance", "us_median"), ("a certified motion", "us_motion_median"), ("a build", "build_seconds")):
            cells = []
            for engine in STYLES:
                points = [(float(row["part_triangles"]) + float(row["environment_triangles"]) if column == "build_seconds"
                           else float(row[GROWING[grows][0]]), float(row[column])) for row in matching(rows, engine=engine) if row[column]]
                fitted = slope(points)
                cells.append("-" if fitted is None else f"{fitted:.2f}")
            lines.append([f"{title}, the {grows} grows"] + cells)
    used = [k for k in range(len(STYLES)) if any(line[1 + k] != "-" for line in lines)]
    names = [style[0] for style in STYLES.values()]
    return table(["exponent of the time over the triangles"] + [names[k] for k in used], [[line[0]] + [line[1 + k] for k in used] for line in lines])


def rings(results):
    """The two largest rings."""
    rows = [row for row in results.rows("growth") if row["part_triangles"] == row["environment_triangles"]]
    if not rows:
        raise NotMeasured("growth.csv, rings")
    lines = []
    for row in rows:
        left_out = f" ({row['left_out']})" if row["left_out"] else ""
        lines.append([STYLES[row["engine"]][0] + left_out] +
                     [shown(float(row[column]) / 1000) if row[column] else "-" for column in ("us_median", "us_mean", "us_motion_median")] +
                     [f"{seconds(row['build_seconds'])} s", shown(row["bytes_per_triangle"])])
    return table([f"two rings of {whole(rows[0]['part_triangles'])} triangles each", "ms a distance, median", "mean", "ms a certified motion, median",
                  "build of both, one thread", "bytes a triangle"], lines)


def plot(results):
    """A panel for each ring that grows: distances of all engines, and clearway's certified motions; then the builds."""
    page = Page(1000, 400)
    panels = [("microseconds a distance, the environment grows", "environment", "us_median"),
              ("microseconds a distance, the part grows", "part", "us_median"),
              ("seconds to build both, the environment grows", "environment", "build_seconds")]
    every = [row for grows in GROWING for row in series(results, grows)]
    sizes = decades([float(row[grown]) for row in every for grown in ("part_triangles", "environment_triangles")])
    times = decades([float(row[column]) for row in every for column in ("us_median", "us_motion_median") if row[column]])
    builds = decades([float(row["build_seconds"]) for row in every])
    for number, (title, grows, column) in enumerate(panels):
        left, top = 60 + 322 * number, 40
        x = Log(*sizes, left, left + 262)
        y = Log(*(builds if column == "build_seconds" else times), top + 260, top)
        page.text(left, top - 14, title, 11)
        for value in powers(x):
            page.line(x(value), y.begin, x(value), y.end, LIGHT)
            page.text(x(value), y.begin + 14, thousands(value), 11, "middle")
        for value in powers(y):
            page.line(x.begin, y(value), x.end, y(value), LIGHT)
            page.text(x.begin - 6, y(value) + 4, f"{value:g}", 11, "end")
        page.line(x.begin, y.begin, x.end, y.begin)
        page.line(x.begin, y.begin, x.begin, y.end)
        rows = series(results, grows)
        drawn = [(column, engine, *STYLES[engine][1:]) for engine in engines(rows)]
        if column == "us_median":
            drawn.append(("us_motion_median", "clearway", *MOTION[1:]))
        for shown_column, engine, colour, shape in drawn:
            points = [(x(float(row[GROWING[grows][0]])), y(float(row[shown_column]))) for row in matching(rows, engine=engine) if row[shown_column]]
            for (x1, y1), (x2, y2) in zip(points, points[1:]):
                page.line(x1, y1, x2, y2, colour, 0.8)
            for point in points:
                page.mark(shape, *point, colour)
    page.text(500, 340, "triangles of the ring that grows; the other has 30k", 12, "middle")
    entries = [(shape, colour, True, label) for label, colour, shape in [STYLES[engine] for engine in engines(every)] + [MOTION]]
    page.legend(entries, 70, 370)
    return page.write()
