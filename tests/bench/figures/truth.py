"""Tables and plots of speed_error.csv, and tables of torture.csv and fcl_continuous.csv: how true answers are, and what that costs."""

from statistics import median

from results import distinct, matching, numbers, shown, span, table, whole
from svg import GREY, LIGHT, Log, Page, decades, powers, text_width

MARGINS = ("0", "1e-06", "0.001")
PEERS = ("FCL RSS", "PQP", "Coal OBBRSS")
MODE_NAMES = {"isWithin": "`isWithin`", "default": "`distance`, valid when lower > margin"}

# Scenes of speed_error.csv by letter, as `benchmarks queries` has them.
SCENES = {"F": "boxes-1", "I": "cembox-2", "J": "large-environment-2", "K": "tunnel-console-3, in the tunnel",
          "L": "tunnel-console-3, outside", "M": "linked-rings-1", "N": "puzzle-2"}

# Mode in the table: label, colour, mark, whether it is filled. Peers are strokes.
STYLES = {
    "scalar double": ("scalar double, same trees", "#7f7f7f", "square"),
    "float only": ("float only, same trees", "#d95f02", "diamond"),
    "default": ("clearway, default", "#1b5e9e", "circle"),
    "cap": ("clearway, capped at 1 % of the scene", "#66a3d2", "circle"),
    "relative error 0.001": ("clearway, relative error 0.001", "#1b9e77", "up"),
    "relative error 0.01": ("clearway, relative error 0.01", "#66b83c", "up"),
    "relative error 0.1": ("clearway, relative error 0.1", "#a6c83c", "up"),
    "root volumes": ("bound of the root volumes", "#e7298a", "down"),
    "FCL RSS": ("FCL RSS", "#000000", "cross"),
    "PQP": ("PQP, warm", "#000000", "plus"),
    "Coal OBBRSS": ("Coal OBBRSS", "#000000", "star"),
}
NONE = 1e-19  # the height at which an error of 0 is drawn
HEIGHTS = {1e-19: "none", 1e-16: "1e-16", 1e-13: "1e-13", 1e-10: "1e-10", 1e-7: "1e-7", 1e-4: "1e-4", 1e-1: "0.1"}
COLUMNS, WIDTH, HEIGHT = 3, 312, 250  # of panels

EXACT = 1e-15  # a worst error up to this comes from the last digits of a double
SHARES = {1e-1: "a tenth", 1e-3: "a thousandth", 1e-6: "a millionth", 1e-9: "a billionth"}
QUESTIONS = ("within 0.1 %", "within 1 %")  # of queries.csv, answered yes or no
LEFT, RIGHT, SIZE = 190, 1080, 20  # pixels, of the picture with the medians: ends of the speeds' axis, size of letters
ERRORS, TITLE, LANE = 280, 45, 32  # pixels: heights of the errors' axis, of a title below it, of a line there


def total(rows, column):
    return sum(int(row[f"{column}_at_{margin}"]) for row in rows for margin in MARGINS)


def in_short(value):
    """An error or a width: two digits, with an exponent when it is small."""
    value = float(value)
    return "0" if value == 0 else shown(value) if value >= 1e-3 else f"{value:.1e}".replace("e-0", "e-")


def verdicts(results):
    """Errors, widths and wrong verdicts of each mode over all scenes and margins."""
    rows = results.rows("speed_error")
    default = matching(rows, mode="default")
    near = total(default, "poses") - sum(int(row["poses"]) * len(MARGINS) for row in default)  # the others are at the timed poses
    lines = []
    for mode in sorted(distinct(rows, "mode"), key=lambda mode: list(MODE_NAMES).index(mode) if mode in MODE_NAMES else len(MODE_NAMES)):
        of = matching(rows, mode=mode)
        largest = [in_short(max(values)) if values else "" for values in (numbers(of, "error_worst"), numbers(of, "width_worst"))]
        lines.append([MODE_NAMES.get(mode, mode)] + largest + [whole(total(of, "false_valid")), whole(total(of, "false_invalid"))])
    return [f"{asked(results)} verdicts, {whole(near)} of them at poses moved close to a margin; {whole(total(default, 'valid'))} should be \"valid\".", "",
            *table(["", "worst error", "widest interval", "called valid, but not valid", "called invalid, but valid"], lines)]


def asked(results):
    """How many verdicts each mode gave."""
    return whole(total(results.select("speed_error", mode="default"), "poses"))


def false_valid(results, *modes):
    """From the least to the largest number of invalid poses that these call valid."""
    measured = distinct(results.rows("speed_error"), "mode")
    return span([total(results.select("speed_error", mode=mode), "false_valid") for mode in modes if mode in measured], whole)


def cost_of_truth(results):
    """A row a scene: the default's time over float alone, and their worst errors."""
    rows = results.rows("speed_error")
    lines = []
    for letter in distinct(rows, "scene"):
        of = {row["mode"]: row for row in matching(rows, scene=letter)}
        default, single = of["default"], of["float only"]
        low, high = (f"{float(default['time_over_float_only_' + end]):.2f}" for end in ("least", "largest"))
        lines.append([f"{letter}: {SCENES[letter]}", f"{float(default['time_over_float_only']):.2f} ({low} to {high})",
                      in_short(default["error_worst"]), in_short(single["error_worst"]), in_short(default["width_worst"]),
                      in_short(single["width_worst"])])
    return table(["scene", "time of `distance` over float alone", "worst error", "of float alone", "widest interval", "of float alone"], lines)


def hard_pairs(results):
    rows = results.rows("torture")

    def cell(family, figure):
        found = matching(rows, group="pairs", family=family, figure=figure)
        return float(found[0]["value"]) if found else 0.0

    lines = []
    for family in distinct(matching(rows, group="pairs"), "family"):
        finish = [f"double finish {which}: worst error over u64 (M + L)" for which in ("at height/length >= 0.01", "of flatter ones")]
        decided = [100 * cell(family, f"collides decided in {where}") / cell(family, "pairs") for where in ("double", "double-double", "exact")]
        lines.append([family, whole(cell(family, "pairs")), whole(cell(family, "touching")), whole(cell(family, "violations")), shown(cell(family, "worst error over u64 (M + L)")),
                      shown(cell(family, "widest interval over allowed"))] + [shown(cell(family, name)) for name in finish] +
                     [" / ".join(f"{share:.1f}" for share in decided), whole(cell(family, "FCL contact not seen by collide")),
                      whole(cell(family, "FCL distance too large by over 1e-6 of scene"))])
    return table(["pairs", "drawn", "touch", "promises broken", "`distance` off, u64 (M + L)", "widest over allowed", "double finish off, regular", "flatter",
                  "`collides` in double / double-double / exact, %", "FCL: contact not seen", "too far"], lines)


def hard_poses(results):
    rows = matching(results.rows("torture"), group="meshes")
    figures = ("poses", "touching", "free but nearer than 1e-12 of scene", "violations", "false valid", "FCL contact not seen by collide")
    lines = [[family] + [whole(matching(rows, family=family, figure=figure)[0]["value"]) for figure in figures]
             for family in distinct(rows, "family")]
    return table(["poses", "drawn", "touch", "free, nearer than 1e-12 of the scene", "promises broken", "false valid", "FCL: contact not seen"], lines)


def fcl_continuous(results):
    """Totals over the scenes of what each check calls valid and invalid wrongly."""
    rows = results.rows("fcl_continuous")
    lines = []
    for name in distinct(rows, "checked_by"):
        of = matching(rows, checked_by=name)
        wrong = [f"{whole(sum(numbers(of, column)))} of {whole(sum(numbers(of, all_of)))}"
                 for column, all_of in (("of_these_called_valid", "colliding"), ("of_these_called_invalid", "certified"))]
        lines.append([name] + wrong + [span(numbers(of, "us_a_motion"))])
    return table(["check", "colliding motions called valid", "certified motions called invalid", "microseconds a motion"], lines)


def draw(page, scene, rows, left, top, speeds):
    x = Log(*speeds, left, left + WIDTH - 30)
    y = Log(NONE / 3, 3, top + HEIGHT - 50, top)
    for height in HEIGHTS:
        page.line(x.begin, y(height), x.end, y(height), LIGHT)
    for speed in powers(x):
        page.line(x(speed), y.begin, x(speed), y.end, LIGHT)
        page.text(x(speed), y.begin + 14, f"{speed:.0e}".replace("e+0", "e"), 11, "middle")
    page.line(x.begin, y.begin, x.end, y.begin)
    page.line(x.begin, y.begin, x.begin, y.end)
    first = rows[0]
    page.text(left, top - 8, f"{scene}: {SCENES[scene]}; {first['colliding']} of {first['poses']} collide", 11)
    for row in rows:
        _, colour, shape = STYLES[row["mode"]]
        at = x(float(row["queries_per_second"]))
        worst, usual = (y(max(NONE, float(row[column]))) for column in ("error_worst", "error_median"))
        page.line(at, usual, at, worst, colour, 0.8)
        page.mark("bar", at, usual, colour)
        page.mark(shape, at, worst, colour)


def measured(results):
    """The rows of the modes that answer with a distance."""
    return [row for row in results.rows("speed_error") if row["error_worst"] and row["mode"] in STYLES]


def over_pqp(results):
    """Yields each mode's style, its speeds over PQP's exact distance and its worst errors, a value a scene.

    The median of such ratios compares the modes; queries a second differ widely from scene to scene.
    """
    pqp = {row["scene"]: float(row["queries_per_second"]) for row in results.select("speed_error", mode="PQP")}
    for mode in distinct(measured(results), "mode"):
        rows = matching(measured(results), mode=mode)
        speeds = [float(row["queries_per_second"]) / pqp[row["scene"]] for row in rows]
        yield STYLES[mode], speeds, numbers(rows, "error_worst")


def yes_or_no(results, question):
    """Yields the styles of PQP and clearway, and their speeds at this question over PQP's exact distance, a value a scene."""
    exact = results.select("queries", question="distance", engine="clearway", over_engine="PQP")
    microseconds = {row["scene"]: float(row["over_us_mean"]) for row in exact}
    rows = results.select("queries", question=question, engine="clearway", over_question=question, over_engine="PQP")
    for label, mode, column in (("PQP's tolerance query", "PQP", "over_us_mean"), ("clearway", "default", "us_mean")):
        yield (f"{label}, {question.split(maxsplit=1)[1]}", *STYLES[mode][1:]), [microseconds[row["scene"]] / float(row[column]) for row in rows]


def place(page, x, y, style, speeds):
    """Draws a line from the least speed to the largest, a mark at the median, and the label right of the line or, without room there, left."""
    label, colour, shape = style
    label = f"{label}: {shown(median(speeds))}"
    low, high = x(min(speeds)), x(max(speeds))
    page.line(low, y, high, y, colour, 1.5)
    page.mark(shape, x(median(speeds)), y, colour, 8)
    fits = high + 14 + text_width(label, SIZE) < page.size[0]
    page.text(high + 14 if fits else low - 14, y + 7, label, SIZE, "start" if fits else "end")


def plot(results):
    """The text of the SVG file with the medians: inexact distances by their errors, then exact distances, then answers of yes or no."""
    modes = list(over_pqp(results))
    inexact = [(style, speeds, median(errors)) for style, speeds, errors in modes if max(errors) > EXACT]
    exact = [(style, speeds) for style, speeds, errors in modes if max(errors) <= EXACT]
    lanes = {
        "exact, but for the rounding of a double": sorted(exact, key=lambda lane: median(lane[1])),
        "yes or no: is the distance within a share of the part's size?": [lane for question in QUESTIONS for lane in yes_or_no(results, question)],
    }
    speeds = [speed for _, of, *_ in inexact + sum(lanes.values(), []) for speed in of]
    page = Page(1100, 40 + ERRORS + sum(TITLE + LANE * len(of) for of in lanes.values()) + 100)
    x, bottom = Log(min(speeds) / 1.3, max(speeds) * 1.3, LEFT, RIGHT), page.size[1] - 90
    for speed in (10.0 ** power for power in range(-9, 10)):
        if x.low <= speed <= x.high:
            page.line(x(speed), 40, x(speed), bottom, GREY if speed == 1 else LIGHT)
            page.text(x(speed), bottom + 24, f"{speed:,g}", SIZE, "middle")
    page.line(LEFT, bottom, RIGHT, bottom)
    page.text(RIGHT, bottom + 54, "times as fast as PQP's exact distance", SIZE, "end")
    page.text(RIGHT, bottom + 80, f"mark: median over {len(modes[0][1])} scenes; line: from the slowest scene to the fastest", SIZE, "end", GREY)

    page.text(10, 26, "largest error of a distance, as a share of the scene's size", SIZE)
    errors = [error for *_, error in inexact]
    y = Log(min(errors) / 5, max(errors) * 10, 40 + ERRORS, 40)
    for share, label in SHARES.items():
        if y.low <= share <= y.high:
            page.line(LEFT, y(share), RIGHT, y(share), LIGHT)
            page.text(LEFT - 10, y(share) + 7, label, SIZE, "end")
    for style, of, error in inexact:
        place(page, x, y(error), style, of)

    top = 40 + ERRORS
    for title, of in lanes.items():
        page.line(10, top, RIGHT, top)
        page.text(10, top + 27, title, SIZE)
        for lane, (style, values) in enumerate(of):
            place(page, x, top + TITLE + LANE * (lane + 0.5) - 4, style, values)
        top += TITLE + LANE * len(of)
    return page.write()


def plot_scenes(results):
    """The text of the SVG file with a panel a scene."""
    rows = measured(results)
    scenes = distinct(rows, "scene")
    speeds = decades([float(row["queries_per_second"]) for row in rows])
    lines = (len(scenes) + COLUMNS - 1) // COLUMNS
    page = Page(60 + COLUMNS * WIDTH, 40 + lines * HEIGHT + 90)
    for i, scene in enumerate(scenes):
        left, top = 60 + WIDTH * (i % COLUMNS), 30 + HEIGHT * (i // COLUMNS)
        draw(page, scene, matching(rows, scene=scene), left, top, speeds)
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
