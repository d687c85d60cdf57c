"""The first and the last table of docs/benchmarks.md: the answer, a line a question, and from runs.csv how all tables were measured."""

import motions
import plans
import queries
import truth
from results import NotMeasured, distinct, matching, table

# Columns of runs.csv, and their names. Older tables lack some.
PEERS = {"fcl": "FCL", "ompl": "OMPL", "pqp": "PQP", "coal": "Coal", "bullet": "Bullet", "cgal": "CGAL"}


def times_as_long(results, question):
    """'PQP 7 to 63 times as long, FCL OBBRSS 16 to 130, ...'."""
    first, *others = (f"{peer} {queries.over(results, question, peer)}" for peer in queries.peers_of(results.rows("queries"), question))
    return ", ".join([f"{first} times as long", *others])


# Each row is a question, clearway's figure, and what it is compared with; the last two are functions of the results.
LINES = [
    ("an exact distance", lambda r: f"{queries.times(r, 'distance')} us",
     lambda r: f"PQP with its warm start takes {queries.over(r, 'distance', 'PQP')} times as long, FCL RSS {queries.over(r, 'distance', 'FCL RSS')}, "
               f"Coal OBBRSS {queries.over(r, 'distance', 'Coal OBBRSS')}"),
    ("`collides`", lambda r: f"{queries.times(r, 'collides')} us",
     lambda r: times_as_long(r, "collides")),
    ("`isWithin`, 1 % of the part's size", lambda r: f"{queries.times(r, 'within 1 %')} us",
     lambda r: f"PQP's tolerance query {queries.over(r, 'within 1 %', 'PQP')} times as long"),
    ("wrong answers to these", lambda r: str(queries.all_wrong(r) or "none"), lambda r: "an exact oracle decides where libraries differ"),
    ("invalid poses called valid, close to a margin", lambda r: truth.false_valid(r, "isWithin"),
     lambda r: f"FCL, PQP and Coal: {truth.false_valid(r, *truth.PEERS)} of {truth.asked(r)}"),
    ("a valid motion of RRTConnect, certified", lambda r: f"{motions.valid_motion(r, 'us_by_velocities')} us",
     lambda r: f"in a space that only bounds displacements it takes {motions.valid_motion(r, 'times_faster')} times as long"),
    ("a state's check while planning, in place of FCL", lambda r: f"{motions.state_with_fcl(r)} times faster",
     lambda r: "FCL's OBBRSS `collide` behind the same OMPL validator"),
    ("`plan`: a first certified path", lambda r: f"{plans.median_seconds(r, '3D/bugtrap')} s for OMPL.app's bugtrap, "
                                                f"{plans.median_seconds(r, '3D/alpha-1.2')} s for its alpha-1.2",
     lambda r: f"medians; all of {plans.problems(r)} problems are below"),
]


def answer(results):
    def made(make):
        try:
            return make(results)
        except NotMeasured:
            return "not measured yet"

    return table(["what is asked", "clearway", "compared with"], [[title, made(ours), made(theirs)] for title, ours, theirs in LINES])


def measured_on(results):
    """A row for each part of runs.csv: how its rows were measured, and the machine once for all."""
    rows = results.rows("runs")

    def values(of, column):
        return ", ".join(sorted({row[column] for row in of if row[column]}))

    def version(peer):
        """The versions of a peer that took part. Some parts need no peer, so that their build may have been without it."""
        return " or ".join(sorted({row.get(peer, "") for row in rows} - {"", "not measured"})) or "not measured"

    lines = []
    for part in distinct(rows, "part"):
        of = matching(rows, part=part)
        lines.append([part, max(row["date"] for row in of), values(of, "clearway"), values(of, "form"),
                      f"{max(float(row['others_share']) for row in of) * 100:.1f} %"])
    first = rows[0]
    machine = [f"{first['cores']} cores of {first['cpu']}, {first['memory_gb']} GB, {first['instruction_set']}; {first['compiler']}, "
               f"`{first['flags']}`. {', '.join(f'{words} {version(name)}' for name, words in PEERS.items())}.", ""]
    return machine + table(["part", "last measured", "clearway", "form", "most of the processors that other work took"], lines)
