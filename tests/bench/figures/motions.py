"""Tables of certified_motions.csv, motions.csv, fcl_motions.csv and fcl_first_path.csv."""

from results import matching, numbers, shown, span, table, whole

SCENES = ("tunnel-console-3", "large-environment-2", "cembox-2")
# Title, motions, kind.
LINES = [
    ("of RRTConnect, valid", "RRTConnect", "valid"),
    ("of RRTConnect, invalid", "RRTConnect", "invalid"),
    ("of PRM, valid", "PRM", "valid"),
    ("of KPIECE1, to the last valid pose", "KPIECE1", "invalid"),
    ("segments of the scene's path", "path", "valid"),
    ("least clearance of the segments", "path", "least clearance"),
]


def certified(results):
    rows = results.rows("certified_motions")
    made = []
    for title, motions, kind in LINES:
        cells = []
        for scene in SCENES:
            found = matching(rows, scene=scene, motions=motions, kind=kind)
            cells.append(f"{shown(found[0]['us_by_bound'])} -> {shown(found[0]['us_by_velocities'])}" if found else "")
        made.append([title] + cells)
    made.append(["verdicts on planners' motions that velocities lose"] + [lost(rows, scene) for scene in SCENES])
    return table(["motions"] + list(SCENES), made)


def lost(rows, scene):
    of = [row for row in rows if row["scene"] == scene and row["motions"] != "path" and row["kind"] in ("valid", "invalid")]
    each = {row["motions"]: int(row["verdicts_lost"]) for row in of}  # the rows of one run share the number
    return f"{sum(each.values())} of {whole(sum(numbers(of, 'count')))}"


def valid_motion(results, column):
    """A figure of a valid motion of RRTConnect, from the least to the largest over the scenes."""
    return span(numbers(results.select("certified_motions", motions="RRTConnect", kind="valid"), column))


def against_steps(results):
    rows = [row for row in results.rows("motions") if row["us_certified"]]  # others count queries
    return table(["motions of RRTConnect", "count", "certified, us", "in steps, us", "steps take so many times as long"],
                 [[f"{row['scene']}: {row['what']}", whole(row["count"])] + [shown(row[name]) for name in ("us_certified", "us_compared", "times")]
                  for row in rows])


def with_fcl(results):
    rows = results.rows("fcl_motions")
    return table(["microseconds each", "number", "clearway", "FCL", "times faster"],
                 [[row["what"], whole(row["count"])] + [shown(row[name]) for name in ("clearway_us", "fcl_us", "times_faster")] for row in rows])


def state_with_fcl(results):
    return shown(results.row("fcl_motions", what="states")["times_faster"])


def first_path(results):
    lines = []
    for row in results.rows("fcl_first_path"):
        step = f", {shown(row['step'])} apart" if float(row["step"]) else ""
        free = int(row["free"])
        is_half_free = 2 * free > int(row["seeds"])
        lines.append([row["checked_by"] + step, f"{row['found']} of {row['seeds']}", str(free),
                      shown(row["median_seconds_to_a_free_path"]) if is_half_free else f"more than {shown(row['limit'])}"])
    return table(["checked by", "paths found", "free along their whole length", "median seconds to a free path"], lines)
