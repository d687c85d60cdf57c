"""Tables of shrinking.csv and touching.csv: parts that are shrunk for an overlap, and parts that come out with one."""

from results import percent, seconds, shown, table, whole


def shrinking(results):
    """A row a part and overlap."""
    lines = []
    for row in results.rows("shrinking"):
        more = float(row["triangles_shrunk"]) / float(row["triangles"]) - 1
        lines.append([row["part"], whole(row["triangles"]), row["overlap_over_diagonal"], seconds(row["seconds"]), percent(more),
                      percent(row["share_shallow"]), shown(row["deepest_over_overlap"])])
    return table(["part", "triangles", "overlap over the diagonal", "seconds", "more triangles", "area shallower than half", "deepest, of the overlap"],
                 lines)


def touching(results):
    """A row a problem."""
    lines = []
    for row in results.rows("touching"):
        lines.append([row["problem"], f"{whole(row['part_triangles'])} / {whole(row['environment_triangles'])}", row["least"], row["try_first"],
                      seconds(row["lift_seconds"]), f"{row['found']} of {row['runs']}", f"{seconds(row['seconds'])} / {seconds(row['seconds_largest'])}",
                      shown(row["deepest_over_allowed"])])
    return table(["problem", "triangles", "least overlap that frees it", "to try first", "s to tell both", "found", "s of `plan --quick`, median / largest",
                  "deepest along a path, of the overlap"], lines)
