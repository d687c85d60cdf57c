"""Tables of certified_motions.csv, motions.csv, fcl_motions.csv and fcl_first_path.csv."""

from results import NotMeasured, matching, numbers, shown, span, table, whole

SCENES = ("tunnel-console-3", "large-environment-2", "cembox-2")
# Title, motions, whether at a margin, parts, kind.
LINES = [
    ("of RRTConnect, valid", "RRTConnect", False, "1", "valid"),
    ("of RRTConnect, invalid", "RRTConnect", False, "1", "invalid"),
    ("of PRM, valid", "PRM", False, "1", "valid"),
    ("of KPIECE1, to the last valid pose", "KPIECE1", False, "1", "invalid"),
    ("segments of the scene's path", "path", False, "1", "valid"),
    ("sixteenths of the segments", "path", False, "16", "valid"),
    ("segments at a margin just below the path's clearance", "path", True, "1", "valid"),
    ("least clearance of the segments", "path", False, "1", "least clearance"),
]


def lines_of(rows, motions, at_margin, parts, kind):
    return [row for row in matching(rows, motions=motions, parts=parts, kind=kind) if (float(row["margin"]) > 0) == at_margin]


def certified(results):
    rows = results.rows("certified_motions")
    made = []
    for title, *keys in LINES:
        cells = []
        for scene in SCENES:
            found = matching(lines_of(rows, *keys), scene=scene)
            cells.append(f"{shown(found[0]['us_globally'])} -> {shown(found[0]['us_by_pairs'])}" if found else "")
        made.append([title] + cells)
    return table(["motions"] + list(SCENES), made)


def certified_valid(results, scene="", motions="RRTConnect"):
    """Microseconds of a valid motion, certified pair by pair; over all scenes if none is named."""
    rows = matching(results.rows("certified_motions"), motions=motions, kind="valid", margin="0", parts="1")
    if scene:
        rows = matching(rows, scene=scene)
    if not rows:
        raise NotMeasured(f"certified_motions.csv, valid motions of {motions} {scene}")
    return span(numbers(rows, "us_by_pairs"))


def certified_times(results, kind, motions):
    """How many times faster by pairs, from the least to the largest."""
    return span(numbers(results.select("certified_motions", kind=kind, motions=motions), "times_faster"))


def verdicts_lost(results):
    """'N of M' verdicts of planners' motions that are lost by certifying pair by pair."""
    rows = [row for row in results.rows("certified_motions") if row["motions"] != "path" and row["kind"] in ("valid", "invalid")]
    if "verdicts_lost" not in rows[0]:
        raise NotMeasured("certified_motions.csv, the column verdicts_lost")
    lost = {}
    for row in rows:  # the rows of one run share the number
        lost[row["scene"], row["motions"]] = int(row["verdicts_lost"])
    return f"{sum(lost.values())} of {whole(sum(numbers(rows, 'count')))}"


def against_steps(results):
    rows = [row for row in results.rows("motions") if row["us_certified"]]  # others count queries
    return table(["motions of RRTConnect", "count", "certified, us", "in steps, us", "steps take so many times as long"],
                 [[f"{row['scene']}: {row['what']}", whole(row["count"])] + [shown(row[name]) for name in ("us_certified", "us_compared", "times")]
                  for row in rows])


def with_fcl(results):
    rows = results.rows("fcl_motions")
    return table(["microseconds each", "number", "clearway", "FCL", "times faster"],
                 [[row["what"], whole(row["count"])] + [shown(row[name]) for name in ("clearway_us", "fcl_us", "times_faster")] for row in rows])


def with_fcl_times(results, what):
    return shown(results.row("fcl_motions", what=what)["times_faster"])


def first_path(results):
    lines = []
    for row in results.rows("fcl_first_path"):
        step = f", {shown(row['step'])} apart" if float(row["step"]) else ""
        free = int(row["free"])
        is_half_free = 2 * free > int(row["seeds"])
        lines.append([row["checked_by"] + step, f"{row['found']} of {row['seeds']}", str(free),
                      shown(row["median_seconds_to_a_free_path"]) if is_half_free else f"more than {shown(row['limit'])}"])
    return table(["checked by", "paths found", "free along their whole length", "median seconds to a free path"], lines)


