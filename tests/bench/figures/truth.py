"""Tables of speed_error.csv and torture.csv: how true answers are, and what that costs."""

from results import distinct, matching, numbers, shown, span, table, whole

MARGINS = ("0", "1e-06", "0.001")
PEERS = ("FCL RSS", "PQP", "Coal OBBRSS")
MODE_NAMES = {"isWithin": "`isWithin`", "default": "`distance`, valid when lower > margin"}
SHORT_LIST = ("isWithin", "default") + PEERS

# Scenes of speed_error.csv by letter, as `benchmarks queries` has them or had them.
OLDER = {"A": "tunnel-console-2, in the tunnel", "B": "tunnel-console-2, outside", "C": "cembox-1", "D": "large-environment-1",
         "E": "puzzle-1"}
NOW = {"F": "boxes-1", "I": "cembox-2", "J": "large-environment-2", "K": "tunnel-console-3, in the tunnel", "L": "tunnel-console-3, outside",
       "M": "linked-rings-1", "N": "puzzle-2"}


def scene_name(letter):
    return OLDER.get(letter) or NOW[letter]


def total(rows, column):
    return sum(int(row[f"{column}_at_{margin}"]) for row in rows for margin in MARGINS)


def in_short(value):
    """An error or a width: two digits, with an exponent when it is small."""
    value = float(value)
    return "0" if value == 0 else shown(value) if value >= 1e-3 else f"{value:.1e}".replace("e-0", "e-")


def verdicts(results, which="all"):
    """Wrong verdicts of each mode over all scenes and margins; with errors and widths unless only the short list is asked for."""
    rows = results.rows("speed_error")
    lines = []
    for mode in distinct(rows, "mode"):
        of = matching(rows, mode=mode)
        if which == "short" and mode not in SHORT_LIST:
            continue
        errors, widths = numbers(of, "error_worst"), numbers(of, "width_worst")
        measured = [] if which == "short" else [in_short(max(errors)) if errors else "", in_short(max(widths)) if widths else ""]
        lines.append([MODE_NAMES.get(mode, mode)] + measured + [whole(total(of, "false_valid")), whole(total(of, "false_invalid"))])
    order = [MODE_NAMES.get(mode, mode) for mode in SHORT_LIST]
    lines.sort(key=lambda line: order.index(line[0]) if line[0] in order[:2] else len(order))
    middle = [] if which == "short" else ["worst error", "widest interval"]
    return table([""] + middle + ["called valid, but not valid", "called invalid, but valid"], lines)


def asked(results):
    """How many verdicts each mode gave."""
    return whole(total(results.select("speed_error", mode="default"), "poses"))


def asked_near(results):
    """How many of these are at poses moved near a margin; the others are at the timed poses."""
    rows = results.select("speed_error", mode="default")
    return whole(total(rows, "poses") - sum(int(row["poses"]) * len(MARGINS) for row in rows))


def truly_valid(results):
    return whole(total(results.select("speed_error", mode="default"), "valid"))


def false_valid(results, *modes):
    """From the least to the largest number of invalid poses that these call valid; by default the peers."""
    measured = distinct(results.rows("speed_error"), "mode")
    of = [mode for mode in modes or PEERS if mode in measured]
    return span([total(results.select("speed_error", mode=mode), "false_valid") for mode in of], whole)


def cost_of_truth(results):
    """A row a scene: the default's time over float alone, and their worst errors."""
    rows = results.rows("speed_error")
    lines = []
    for letter in distinct(rows, "scene"):
        of = {row["mode"]: row for row in matching(rows, scene=letter)}
        default, single = of["default"], of["float only"]
        low, high = (f"{float(default['time_over_float_only_' + end]):.2f}" for end in ("least", "largest"))
        lines.append([f"{letter}: {scene_name(letter)}", f"{float(default['time_over_float_only']):.2f} ({low} to {high})",
                      in_short(default["error_worst"]), in_short(single["error_worst"]), in_short(default["width_worst"]),
                      in_short(single["width_worst"])])
    return table(["scene", "time of `distance` over float alone", "worst error", "of float alone", "widest interval", "of float alone"], lines)


def over_float(results):
    """How much longer the default takes than float alone, over the scenes."""
    return span([100 * (float(row["time_over_float_only"]) - 1) for row in results.select("speed_error", mode="default")],
                lambda value: f"{round(value)}") + " %"


def digits_gained(results):
    """The worst error of float alone over the default's, in the scene where that is least, as correct digits."""
    rows = results.rows("speed_error")
    gains = []
    for letter in distinct(rows, "scene"):
        of = {row["mode"]: float(row["error_worst"]) for row in matching(rows, scene=letter) if row["error_worst"]}
        if of["default"] > 0 and of["float only"] > 0:
            digits = 0
            while of["float only"] / of["default"] >= 10 ** (digits + 1):
                digits += 1
            gains.append(digits)
    return str(min(gains))


def hard_pairs(results):
    rows = results.rows("torture")

    def cell(family, figure):
        found = matching(rows, group="pairs", family=family, figure=figure)
        return float(found[0]["value"]) if found else 0.0

    lines = []
    for family in distinct(matching(rows, group="pairs"), "family"):
        finish = [f"double finish {which}: worst error over u64 (M + L)" for which in ("at height/length >= 0.01", "of flatter ones")]
        decided = [100 * cell(family, f"collides decided in {where}") / cell(family, "pairs") for where in ("double", "double-double", "exact")]
        lines.append([family, whole(cell(family, "touching")), whole(cell(family, "violations")), shown(cell(family, "worst error over u64 (M + L)")),
                      shown(cell(family, "widest interval over allowed"))] + [shown(cell(family, name)) for name in finish] +
                     [" / ".join(f"{share:.1f}" for share in decided), whole(cell(family, "FCL contact not seen by collide")),
                      whole(cell(family, "FCL distance too large by over 1e-6 of scene"))])
    return table(["pairs", "touch", "promises broken", "`distance` off, u64 (M + L)", "widest over allowed", "double finish off, regular", "flatter",
                  "`collides` in double / double-double / exact, %", "FCL: contact not seen", "too far"], lines)


def hard_poses(results):
    rows = matching(results.rows("torture"), group="meshes")
    figures = ("touching", "free but nearer than 1e-12 of scene", "violations", "false valid", "FCL contact not seen by collide")
    lines = [[family] + [whole(matching(rows, family=family, figure=figure)[0]["value"]) for figure in figures]
             for family in distinct(rows, "family")]
    return table(["poses", "touch", "free, nearer than 1e-12 of the scene", "promises broken", "false valid", "FCL: contact not seen"], lines)


def torture_total(results, group, figure):
    """The sum of a figure over the families of a group; of 'all', the largest."""
    return whole(sum(numbers(results.select("torture", group=group, figure=figure), "value")))


def torture_each(results, group, figure):
    return span(numbers(results.select("torture", group=group, figure=figure), "value"), whole)


def torture_largest(results, group, figure):
    return shown(max(numbers(results.select("torture", group=group, figure=figure), "value")))


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
