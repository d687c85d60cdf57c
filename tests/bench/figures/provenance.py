"""When, with what and on which machine tables were measured, from runs.csv."""

from results import NotMeasured, distinct, matching, table

# Columns of runs.csv, and their names. Older tables lack some.
PEERS = {"fcl": "FCL", "ompl": "OMPL", "pqp": "PQP", "coal": "Coal", "bullet": "Bullet", "cgal": "CGAL"}


def version_of(rows, peer):
    """The versions of a peer that took part. Some parts need no peer, so that their build may have been without it."""
    versions = {row.get(peer, "") for row in rows} - {"", "not measured"}
    return " or ".join(sorted(versions)) or "not measured"


def measured_on(results):
    """A row for each part of runs.csv: how its rows were measured, and the machine once for all."""
    rows = results.rows("runs")
    lines = []
    for part in distinct(rows, "part"):
        of = matching(rows, part=part)

        def every(column):
            return ", ".join(sorted({row[column] for row in of if row[column]}))

        lines.append([part, every("date").split(", ")[-1], every("clearway"), every("form"),
                      f"{max(float(row['others_share']) for row in of) * 100:.1f} %"])
    first = rows[0]
    if not lines:
        raise NotMeasured("runs.csv")
    of_peers = ", ".join(f"{words} {version_of(rows, name)}" for name, words in PEERS.items())
    machine = [f"{first['cores']} cores of {first['cpu']}, {first['memory_gb']} GB, {first['instruction_set']}; {first['compiler']}, "
               f"`{first['flags']}`. {of_peers}.", ""]
    return machine + table(["part", "last measured", "clearway", "form", "most of the processors that other work took"], lines)
