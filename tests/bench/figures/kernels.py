"""Tables of kernels.csv: kernels of pairs of triangles, beside tables 1 to 4 of Ytterlid's thesis and its claims.

The thesis's figures are its own: seconds on a Core 2 Duo of 2.66 GHz, with SSE, in 32 bit.
"""

from results import NotMeasured, distinct, matching, shown, table, whole

# The thesis's seconds for 10,000 x 10,000 pairs, by contender and question; and its ISPC's in calls of one pair, not of 1,024.
THESIS_TRIANGLES = 10_000
THESIS = {("PQP itself", "collides"): 11.39, ("by hand", "collides"): 2.34, ("ISPC", "collides"): 1.06,
          ("PQP itself", "distance"): 19.17, ("by hand", "distance"): 11.64, ("ISPC", "distance"): 14.45}
THESIS_ONE_BY_ONE = {"collides": 21.67, "distance": 74.45}
NOUNS = {"collides": "collision", "distance": "distance"}
PQP, SCALAR = ("PQP itself", "scalar"), ("scalar double", "scalar")
HAND, ISPC, ISPC_AVX2 = ("by hand", "SSE4"), ("ISPC", "SSE4"), ("ISPC", "AVX2")
# How much a ratio may differ from the thesis's, or from 1, and still count as equal.
EQUAL = 1.1


def name_of(row):
    contender, instruction_set = row["contender"], row["instruction_set"]
    if instruction_set == "scalar":
        return {"PQP itself": "PQP", "scalar double": "PQP's test, our scalar double"}[contender]
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

    def ns(self, question, key, triangles=None, input_size=None, test="PQP"):
        """Nanoseconds a pair of a contender and instruction set."""
        sample = [row for row in matching(self.rows, contender=key[0], instruction_set=key[1])
                  if row["test"] == (test if key[0] == "ISPC" else row["test"])]
        if not sample:
            raise NotMeasured(f"kernels.csv, {' '.join(key)}")
        row = self.named(name_of(sample[0]), question, triangles, input_size)
        if row["status"] != "measured":
            raise NotMeasured(f"kernels.csv, {' '.join(key)}: {row['status']}")
        return float(row["ns_a_pair"])


def cell(row):
    """The seconds of a row with their range, or why there are none."""
    if row["status"] != "measured":
        return row["status"]
    low, middle, high = (shown(row[column]) for column in ("seconds_least", "seconds", "seconds_largest"))
    return middle if low == high else f"{middle} ({low} to {high})"


def input_sizes(results, question):
    """Nanoseconds a pair, by the pairs in a call. The thesis states the two ends for its ISPC."""
    kernels = Kernels(results)
    lines = []
    for name in kernels.names:
        rows = [kernels.named(name, question, kernels.by_size, size) for size in kernels.sizes]
        lines.append([name] + [shown(row["ns_a_pair"]) if row["status"] == "measured" else row["status"] for row in rows])
    ends = {"1": THESIS_ONE_BY_ONE[question], "1024": THESIS["ISPC", question]}
    lines.append(["*thesis, ISPC*"] + [f"*{shown(1e9 * ends[size] / THESIS_TRIANGLES**2)}*" if size in ends else "" for size in kernels.sizes])
    return table([f"{NOUNS[question]}: pairs in a call"] + kernels.sizes, lines)


def totals(results):
    """Seconds for n x n pairs in the largest calls."""
    kernels = Kernels(results)
    columns = [(question, count) for question in NOUNS for count in kernels.counts]
    lines = [[name] + [cell(kernels.named(name, question, count)) for question, count in columns] for name in kernels.names]
    for name, contender in (("PQP", "PQP itself"), ("Embree's classes", "by hand"), ("ISPC", "ISPC")):
        lines.append([f"*thesis, {name}*"] + [f"*{shown(THESIS[contender, question])}*" if count == str(THESIS_TRIANGLES) else ""
                                            for question, count in columns])
    return table(["seconds"] + [f"{NOUNS[question]}, {whole(count)} squared" for question, count in columns], lines)


def speed_and_error(results):
    """Speeds beside PQP's, and what the oracle finds wrong in the answers to calls of any size."""
    kernels = Kernels(results)
    lines = []
    for name in kernels.names:
        line = [name]
        for question in NOUNS:
            row = kernels.named(name, question)
            if row["status"] != "measured":
                line += [row["status"], "", ""] + ([""] if question == "distance" else [])
                continue
            of = [other for other in matching(kernels.rows, question=question) if name_of(other) == name]
            line += [shown(kernels.ns(question, PQP) / float(row["ns_a_pair"])),
                     whole(max(int(other["open"]) for other in of)), whole(max(int(other["differing"]) for other in of))]
            if question == "distance":
                line.append(f"{max(float(other['largest_error']) for other in of):.1e}".replace("e-0", "e-"))
        lines.append(line)
    return table(["", "collision: PQP's time over it", "left open", "wrong verdicts", "distance: PQP's time over it", "left open",
                  "wrong verdicts", "largest error"], lines)


def times(results, question, contender, instruction_set):
    """PQP's time over the contender's."""
    kernels = Kernels(results)
    return shown(kernels.ns(question, PQP) / kernels.ns(question, (contender, instruction_set)))


def checked(results):
    """How many pairs the oracle has answered for each set of triangles."""
    return whole(max(int(row["checked"]) for row in results.rows("kernels") if row["checked"]))


def touching(results):
    """The share of pairs that touch."""
    kernels = Kernels(results)
    return f"{100 * float(kernels.named(kernels.names[0], 'collides')['touching_share']):.1f} %"


def verdict(here, thesis):
    """Whether a claim holds that something is `thesis` times faster."""
    if here >= thesis * EQUAL:
        return "holds, by more"
    if here >= thesis / EQUAL:
        return "holds"
    if here > EQUAL:
        return "holds less"
    return "does not hold: both are equal" if here >= 1 / EQUAL else "does not hold: it is the other way round"


def why_over_pqp(kernels, question, key):
    scalar = kernels.ns(question, SCALAR)
    return (f"our scalar double, which makes the test in one lane, is {shown(kernels.ns(question, PQP) / scalar)} times as fast as PQP, and four lanes "
            f"are {shown(scalar / kernels.ns(question, key))} times as fast as one")


def why_by_hand(kernels, question, _):
    return (f"both make PQP's test in four lanes here; compiled for AVX2 the ISPC is "
            f"{shown(kernels.ns(question, HAND) / kernels.ns(question, ISPC_AVX2))} times as fast as by hand")


def why_calls(kernels, question, _):
    gains = [kernels.ns(question, key, kernels.by_size, kernels.sizes[0]) / kernels.ns(question, key, kernels.by_size) for key in (SCALAR, HAND, ISPC)]
    return (f"four lanes explain 4, the rest is what a call costs; scalar double gains {shown(gains[0])}, by hand {shown(gains[1])}")


def claims(results):
    """The thesis's claims: its ratio, the ratio here with four lanes and with AVX2, and a verdict on the one with four lanes."""
    kernels = Kernels(results)

    def quotient(question, slow, fast):
        return THESIS[slow[0], question] / THESIS[fast[0], question], kernels.ns(question, slow), kernels.ns(question, fast)

    lines = []

    def claim(text, thesis, slow, fast, modern, why):
        here = slow / fast
        lines.append([text, shown(thesis), shown(here), modern, f"{verdict(here, thesis)}: {why}"])

    for question, noun in NOUNS.items():
        for title, key in (("by hand in SSE", HAND), ("in ISPC", ISPC)):
            thesis, slow, fast = quotient(question, PQP, key)
            modern = shown(slow / kernels.ns(question, ISPC_AVX2)) if key == ISPC else ""
            claim(f"{noun} {title} is faster than PQP", thesis, slow, fast, modern, why_over_pqp(kernels, question, key))
    for question, title, slow, fast in (("collides", "collision in ISPC is faster than by hand", HAND, ISPC),
                                        ("distance", "distance by hand is faster than in ISPC", ISPC, HAND)):
        modern = shown(kernels.ns(question, HAND) / kernels.ns(question, ISPC_AVX2)) if slow == HAND else shown(
            kernels.ns(question, ISPC_AVX2) / kernels.ns(question, HAND))
        claim(title, *quotient(question, slow, fast), modern, why_by_hand(kernels, question, None))
    for question, noun in NOUNS.items():
        first = kernels.by_size
        one, most = kernels.ns(question, ISPC, first, kernels.sizes[0]), kernels.ns(question, ISPC, first)
        modern = shown(kernels.ns(question, ISPC_AVX2, first, kernels.sizes[0]) / kernels.ns(question, ISPC_AVX2, first))
        claim(f"{noun} in ISPC is faster in calls of 1,024 pairs than of one", THESIS_ONE_BY_ONE[question] / THESIS["ISPC", question], one, most, modern,
              why_calls(kernels, question, None))
    return table(["claim", "thesis, times", "here, SSE4", "here, AVX2", "verdict for SSE4, and why"], lines)
