"""The first page of docs/benchmarks.md: how fast, how true, compared with what, one line each."""

import motions
import plans
import queries
import truth
from results import NotMeasured, table


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
    ("wrong answers to these", lambda r: "none" if not wrong(r) else str(wrong(r)), lambda r: "an exact oracle decides where libraries differ"),
    ("invalid poses called valid, close to a margin", lambda r: truth.false_valid(r, "isWithin"),
     lambda r: f"FCL, PQP and Coal: {truth.false_valid(r)} of {truth.asked(r)}"),
    ("a valid motion of RRTConnect, certified", lambda r: f"{motions.certified_valid(r)} us",
     lambda r: f"certified by clearances of the whole part it takes {motions.certified_times(r, 'valid', 'RRTConnect')} times as long"),
    ("a state's check while planning, in place of FCL", lambda r: f"{motions.with_fcl_times(r, 'states')} times faster",
     lambda r: "FCL's OBBRSS `collide` behind the same OMPL validator"),
    ("`plan`: a first certified path", lambda r: f"{plans.median_seconds(r, '3D/bugtrap')} s for OMPL.app's bugtrap, "
                                                f"{plans.median_seconds(r, '3D/alpha-1.2')} s for its alpha-1.2",
     lambda r: f"medians; all of {plans.problems(r)} problems are below"),
]


def wrong(results):
    return sum(int(row["wrong"]) for row in results.rows("queries"))


def answer(results):
    def made(make):
        try:
            return make(results)
        except NotMeasured:
            return "not measured yet"

    return table(["what is asked", "clearway", "compared with"], [[title, made(ours), made(theirs)] for title, ours, theirs in LINES])
