"""The table of scenes.csv."""

from results import percent, shown, table, whole


def scenes(results):
    lines = []
    for row in results.rows("scenes"):
        lines.append([row["scene"], f"{whole(row['part_triangles'])} / {whole(row['environment_triangles'])}",
                      f"{row['clearance_asked']}, {row['clearance_certified']}", percent(row["tight_share"]),
                      percent(int(row["colliding"]) / int(row["poses"])), f"{shown(row['us_mean'])} us", whole(row["volume_tests"])])
    return table(["scene, seed 1", "triangles of part / environment", "clearance asked for, certified", "tight", "poses colliding",
                  "time of a distance", "volume tests of a distance"], lines)
