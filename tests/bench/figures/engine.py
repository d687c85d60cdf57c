"""Tables of kernels.csv, pairs of triangles beside tables 1 to 4 of Ytterlid's thesis and its claims, and of ladder.csv, what each step from
the thesis's engine to clearway's does to a query's work and time.

The thesis's figures are its own: seconds on a Core 2 Duo of 2.66 GHz, with SSE, in 32 bit.
"""

from results import NotMeasured, distinct, matching, numbers, shown, table, whole
from truth import in_short

NOUNS = {"collides": "collision", "distance": "distance"}
# Contenders as tables name them.
PQP, SCALAR = "PQP", "PQP's test, our scalar double"
HAND, ISPC, ISPC_AVX2 = "PQP's test, by hand, SSE4", "PQP's test, ISPC, SSE4", "PQP's test, ISPC, AVX2"
# The thesis's seconds for 10,000 x 10,000 pairs; of its ISPC they are for calls of 1,024 pairs, and below for calls of one.
THESIS_TRIANGLES = 10_000
THESIS = {"collides": {PQP: 11.39, HAND: 2.34, ISPC: 1.06}, "distance": {PQP: 19.17, HAND: 11.64, ISPC: 14.45}}
THESIS_ONE_BY_ONE = {"collides": 21.67, "distance": 74.45}
# By how much a ratio may differ from the thesis's, or from 1, and still count as equal.
EQUAL = 1.1
# The steps that ask for distances, from the first to the last.
STEPS = ("thesis's tree", "builder", "fit", "leaves of four", "float", "leaf width", "node width", "cheap bound", "double finish", "warm start", "leaf split")
MOTIONS = {"motions in steps": "`collides` in steps", "certified motions": "certified motions"}


def name_of(row):
    contender, instruction_set = row["contender"], row["instruction_set"]
    if instruction_set == "scalar":
        return {"PQP itself": PQP, "scalar double": SCALAR}[contender]
    if row["test"] == "clearway" and contender != "ISPC":
        return f"{contender}, {instruction_set}"
    return f"{row['test']}'s test, {contender}, {instruction_set}"


class Kernels:
    """The rows of kernels.csv. Where nothing else is said, they are those of most triangles and of the largest calls."""

    def __init__(self, results):
        self.rows = results.rows("kernels")
        self.sizes = distinct(self.rows, "input_size")
        self.by_size, *self.counts = distinct(self.rows, "triangles")
        self.names = list(dict.fromkeys(map(name_of, self.rows)))

    def named(self, name, question, triangles=None, input_size=None):
        found = [row for row in matching(self.rows, question=question, triangles=triangles or self.counts[-1],
                                         input_size=input_size or self.sizes[-1]) if name_of(row) == name]
        if len(found) != 1:
            raise NotMeasured(f"kernels.csv, {question}, {name}, {triangles or self.counts[-1]} triangles")
        return found[0]

    def ns(self, question, name, triangles=None, input_size=None):
        """Nanoseconds a pair."""
        row = self.named(name, question, triangles, input_size)
        if row["status"] != "measured":
            raise NotMeasured(f"kernels.csv, {name}: {row['status']}")
        return float(row["ns_a_pair"])


def cells_of(rows, write):
    """A cell of each row; of a contender that is not measured the first says why."""
    cells = [write(row) if row["status"] == "measured" else "" for row in rows]
    return cells if any(cells) else [rows[0]["status"]] + cells[1:]


def seconds_with_range(row):
    low, middle, high = (shown(row[column]) for column in ("seconds_least", "seconds", "seconds_largest"))
    return middle if low == high else f"{middle} ({low} to {high})"


def input_sizes(results, question):
    """Nanoseconds a pair, by the pairs in a call. The thesis states the two ends for its ISPC."""
    kernels = Kernels(results)
    lines = []
    for name in kernels.names:
        rows = [kernels.named(name, question, kernels.by_size, size) for size in kernels.sizes]
        lines.append([name] + cells_of(rows, lambda row: shown(row["ns_a_pair"])))
    ends = {"1": THESIS_ONE_BY_ONE[question], "1024": THESIS[question][ISPC]}
    lines.append(["*thesis, ISPC*"] + [f"*{shown(1e9 * ends[size] / THESIS_TRIANGLES**2)}*" if size in ends else "" for size in kernels.sizes])
    return table([f"{NOUNS[question]}: pairs in a call"] + kernels.sizes, lines)


def totals(results):
    """Seconds for n x n pairs in the largest calls."""
    kernels = Kernels(results)
    columns = [(question, count) for question in NOUNS for count in kernels.counts]
    lines = [[name] + cells_of([kernels.named(name, question, count) for question, count in columns], seconds_with_range)
             for name in kernels.names]
    for title, name in (("PQP", PQP), ("Embree's classes", HAND), ("ISPC", ISPC)):
        lines.append([f"*thesis, {title}*"] + [f"*{THESIS[question][name]}*" if count == str(THESIS_TRIANGLES) else ""
                                            for question, count in columns])
    return table(["seconds"] + [f"{NOUNS[question]}, {whole(count)} squared" for question, count in columns], lines)


def speed_and_error(results):
    """Speeds beside PQP's, and how the answers to calls of any size compare with the oracle's."""
    kernels = Kernels(results)
    lines = []
    for name in kernels.names:
        line = [name]
        for question in NOUNS:
            fastest = kernels.named(name, question)
            rows = [row for row in matching(kernels.rows, question=question) if name_of(row) == name]
            figures = {"speed": shown(kernels.ns(question, PQP) / float(fastest["ns_a_pair"]))} if fastest["status"] == "measured" else {}
            if figures:
                figures.update({column: whole(max(numbers(rows, column))) for column in ("open", "differing")})
                if question == "distance":
                    figures["error"] = in_short(max(numbers(rows, "largest_error")))
            columns = ("speed", "open", "differing") + (("error",) if question == "distance" else ())
            line += [figures.get(column, fastest["status"] if column == "speed" else "") for column in columns]
        lines.append(line)
    return table(["", "collision: PQP's time over it", "left open", "wrong verdicts", "distance: PQP's time over it", "left open",
                  "wrong verdicts", "largest error"], lines)


def verdict(here, thesis):
    """Whether a claim holds that something is `thesis` times faster."""
    if here >= thesis * EQUAL:
        return "holds, by more"
    if here >= thesis / EQUAL:
        return "holds"
    if here > EQUAL:
        return "holds less"
    return "does not hold, both are equal" if here >= 1 / EQUAL else "does not hold, it is the other way round"


class Claim:
    """The thesis's claim that something is faster: its ratio, the one here with four lanes as there, and the one with AVX2."""

    def __init__(self, text, thesis, here, with_avx2, why):
        self.cells = [text, shown(thesis), shown(here), shown(with_avx2) if with_avx2 else "", f"{verdict(here, thesis)}: {why}"]


def over_pqp(kernels, question, title, name):
    pqp, scalar, fast = (kernels.ns(question, each) for each in (PQP, SCALAR, name))
    thesis = THESIS[question][PQP] / THESIS[question][name]
    why = (f"our scalar double takes {shown(scalar / pqp)} times as long as PQP, and four lanes are {shown(scalar / fast)} times as fast "
           "as scalar double")
    with_avx2 = pqp / kernels.ns(question, ISPC_AVX2) if name == ISPC else None
    return Claim(f"{NOUNS[question]} {title} is faster than PQP", thesis, pqp / fast, with_avx2, why)


def hand_and_ispc(kernels, question, slow, fast, text):
    hand, ispc, ispc_avx2 = (kernels.ns(question, each) for each in (HAND, ISPC, ISPC_AVX2))
    thesis = THESIS[question][slow] / THESIS[question][fast]
    here, with_avx2 = (hand / ispc, hand / ispc_avx2) if fast == ISPC else (ispc / hand, ispc_avx2 / hand)
    why = f"here both make PQP's test, in four lanes; ISPC compiled for AVX2 is {shown(hand / ispc_avx2)} times as fast as SSE4 by hand"
    return Claim(text, thesis, here, with_avx2, why)


def larger_calls(kernels, question):
    def gain(name):
        return kernels.ns(question, name, kernels.by_size, kernels.sizes[0]) / kernels.ns(question, name, kernels.by_size)

    rest = ", the rest is the cost of a call" if gain(ISPC) > 4 else ""
    why = f"four lanes give at most 4{rest}; scalar double gains {shown(gain(SCALAR))}, by hand {shown(gain(HAND))}"
    return Claim(f"{NOUNS[question]} in ISPC is faster in calls of 1,024 pairs than of one", THESIS_ONE_BY_ONE[question] / THESIS[question][ISPC],
                 gain(ISPC), gain(ISPC_AVX2), why)


def claims(results):
    kernels = Kernels(results)
    made = [over_pqp(kernels, question, title, name) for question in NOUNS for title, name in (("by hand", HAND), ("in ISPC", ISPC))]
    made.append(hand_and_ispc(kernels, "collides", HAND, ISPC, "collision in ISPC is faster than by hand"))
    made.append(hand_and_ispc(kernels, "distance", ISPC, HAND, "distance by hand is faster than in ISPC"))
    made += [larger_calls(kernels, question) for question in NOUNS]
    return table(["claim", "thesis, times", "here, SSE4", "here, AVX2", "verdict for SSE4, and why"], [claim.cells for claim in made])


def scenes(results):
    return distinct(results.rows("ladder"), "scene")


def measured(results, scene, step):
    """The row of a step; None if that peer was not measured."""
    rows = matching(results.rows("ladder"), scene=scene, step=step)
    return rows[0] if rows else None


def times_faster(before, after):
    return shown(float(before["us_median"]) / float(after["us_median"])) if before else ""


def ladder(results, scene):
    """A row a step; then PQP."""
    lines, before = [], None
    for step in STEPS + (PQP,):
        row = measured(results, scene, step)
        if row is None and step == PQP:
            continue
        if row is None:
            raise NotMeasured(f"ladder.csv, {scene}, {step}")
        lines.append(["PQP, cold, for comparison" if step == PQP else step, shown(row["volume_tests"]), shown(row["triangle_tests"]),
                      shown(row["us_median"]), "" if step == PQP else times_faster(before, row), in_short(row["error_worst"])])
        before = row
    name = measured(results, scene, STEPS[0])["scene_name"]
    return table([f"{scene}: {name}", "volume tests", "triangle tests", "us a distance, median", "times faster than the step before",
                  "largest error"], lines)


def motions(results):
    """The last step: whole motions in place of poses."""
    lines = []
    for scene in scenes(results):
        before = None
        for step, name in MOTIONS.items():
            row = measured(results, scene, step)
            if row is None:
                raise NotMeasured(f"ladder.csv, {scene}, {step}")
            lines.append([f"{scene}, {row['count']} motions: {name}", shown(row["volume_tests"]), shown(row["triangle_tests"]),
                          shown(row["us_median"]), times_faster(before, row), row["missed"]])
            before = row
    return table(["motions", "volume tests", "triangle tests", "us a motion, median", "times faster", "contacts missed"], lines)
