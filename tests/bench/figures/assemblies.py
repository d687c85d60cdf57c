"""The table of assemblies.csv: assemblies that are taken apart."""

from results import seconds, table, whole


def apart(results):
    """A row an assembly."""
    lines = []
    for row in results.rows("assemblies"):
        lines.append([row["assembly"], row["parts"], whole(row["triangles"]), f"{row['overlaps']} / {row['contacts']}", seconds(row["load_seconds"]),
                      seconds(row["pairs_seconds"]), f"{row['out']} of {row['parts']}", seconds(row["last_out_seconds"]), seconds(row["seconds"])])
    return table(["assembly", "parts", "triangles", "overlaps / contacts", "s to load", "s for the pairs", "came out", "s until the last one",
                  "s in all"], lines)
