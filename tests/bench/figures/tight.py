"""The table of tight.csv: parts in tight fits."""

from results import seconds, shown, table, whole


def tight(results):
    """A row a problem."""
    lines = []
    for row in results.rows("tight"):
        lines.append([row["problem"], f"{whole(row['part_triangles'])} / {whole(row['environment_triangles'])}", row["gap_over_radius"],
                      f"{row['found']} of {row['runs']}", f"{seconds(row['seconds'])} / {seconds(row['seconds_largest'])}", row["by_twists"],
                      whole(row["states"]), shown(row["turned"]), f"{shown(row['clearance'])}, {shown(row['clearance_widened'])}"])
    return table(["problem", "triangles", "gap over radius", "found", "s of planning, median / largest", "by TwistSearch", "states", "degrees turned",
                  "clearance, without and with widening"], lines)
