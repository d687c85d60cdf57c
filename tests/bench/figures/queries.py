"""Tables of queries.csv, builds.csv, strategies.csv and scenes.csv: how many times faster clearway answers than its peers, and what trees and
scenes change."""

from results import distinct, matching, percent, shown, span, table, whole

# The scenes that `benchmarks queries` measures now, in the order of the tables; others in a results folder come after them.
ORDER = ["K", "L", "I", "J", "M", "N", "F"]
REMARKS = {
    "F": "parallel faces",
    "J": "sheets around a sheet",
    "M": "rings that hold each other",
}

# Title, the question, clearway's engine and the peer that it is compared with.
ROWS = [
    ("distance, over PQP with its warm start", "distance", "clearway", "PQP"),
    ("distance, over FCL RSS", "distance", "clearway", "FCL RSS"),
    ("distance, over Coal OBBRSS", "distance", "clearway", "Coal OBBRSS"),
    ("distance with AVX2, over PQP with its warm start", "distance", "clearway, avx2", "PQP"),
    ("distance, cold, over PQP, cold", "distance", "clearway, cold", "PQP, cold"),
    ("distance, cold, over FCL RSS", "distance", "clearway, cold", "FCL RSS"),
    ("distance, poses in random order, over PQP", "distance, shuffled", "clearway", "PQP"),
    *((f"collides, over {peer}", "collides", "clearway", peer) for peer in ("PQP", "FCL OBBRSS", "Coal OBBRSS", "Bullet", "CGAL")),
    ("within 0.1 %, over PQP's tolerance query", "within 0.1 %", "clearway", "PQP"),
    ("within 1 %, over PQP's tolerance query", "within 1 %", "clearway", "PQP"),
]


def scenes_of(rows):
    letters = distinct(rows, "scene")
    return sorted(letters, key=lambda letter: (ORDER.index(letter) if letter in ORDER else len(ORDER), letter))


def thousands(count):
    """A number of triangles, to two or three digits: 100, 2k, 73k, 1.7M."""
    count = int(count)
    if count < 1000:
        return str(count)
    return f"{count / 1e6:.1f}M" if count >= 999_500 else f"{count / 1000:.0f}k"


def name_of(rows, letter):
    """A scene and its poses, in words: 'cembox-2, 30k / 500k, 10 % colliding'."""
    row = matching(rows, scene=letter)[0]
    colliding = percent(int(row["colliding"]) / int(row["poses"])) if row["colliding"] != "0" else "none"
    words = [row["scene_name"], f"{thousands(row['part_triangles'])} / {thousands(row['environment_triangles'])}", f"{colliding} colliding"]
    return ", ".join(words + ([REMARKS[letter]] if letter in REMARKS else []))


def compared(rows, letter, question, engine, over_engine):
    """The row of this comparison; None if that peer or instruction set was not measured."""
    found = matching(rows, scene=letter, question=question, engine=engine, over_question=question, over_engine=over_engine)
    return found[0] if found else None


def ratio_cell(row):
    return shown(row["ratio"]) if row else "-"


def microseconds(rows, letter, question):
    row = matching(rows, scene=letter, question=question, engine="clearway")
    return shown(row[0]["us_mean"]) if row else "-"


def main_table(results):
    """README's table: a row a scene."""
    rows = results.rows("queries")
    lines = []
    for letter in scenes_of(rows):
        def over(question, over_engine):
            return ratio_cell(compared(rows, letter, question, "clearway", over_engine))

        lines.append([name_of(rows, letter), f"{microseconds(rows, letter, 'distance')} us", over("distance", "PQP"), over("distance", "FCL RSS"),
                      over("collides", "FCL OBBRSS")])
    return table(["scene, triangles of part / environment, poses", "exact distance", "over PQP, warm", "over FCL 0.7", "`collides` over FCL"], lines)


def all_ratios(results):
    """A column a scene, a row a comparison; then the time and work of a distance. `collides` has a table of its own."""
    rows = results.rows("queries")
    letters = scenes_of(rows)
    lines = []
    for title, *keys in ROWS:
        of = [compared(rows, letter, *keys) for letter in letters]
        if any(of) and keys[0] != "collides":
            lines.append([title] + [ratio_cell(row) for row in of])
    first = [matching(rows, scene=letter, question="distance", engine="clearway")[0] for letter in letters]
    for title, question in (("microseconds a distance", "distance"), ("microseconds a `collides`", "collides"),
                            ("microseconds a `isWithin`, 1 %", "within 1 %")):
        lines.append([title] + [microseconds(rows, letter, question) for letter in letters])
    for title, column in (("wide nodes visited by a distance", "node_visits"), ("pairs of triangles tested by a distance", "triangle_tests")):
        lines.append([title] + [shown(row[column]) for row in first])
    lines.append(["a repetition's ratio is off the median, usually (at most)"] + [spread(rows, letter) for letter in letters])
    lines.append(["wrong answers, clearway's / peers'"] + [wrong(rows, letter) for letter in letters])
    return table(["how many times faster"] + letters, lines)


def spread(rows, letter):
    """How far the repetitions farthest from the median ratio are from it: the median over the scene's ratios, and the largest."""
    off = sorted(max(float(row["ratio_largest"]) / float(row["ratio"]) - 1, 1 - float(row["ratio_least"]) / float(row["ratio"]))
                 for row in matching(rows, scene=letter) if int(row["repetitions"]) > 1)
    return f"{percent(off[len(off) // 2])} ({percent(off[-1])})" if off else "-"


def all_wrong(results):
    return sum(int(row["wrong"]) for row in results.rows("queries"))


def wrong(rows, letter):
    of = matching(rows, scene=letter)
    theirs = [row for row in of if not row["over_engine"].startswith("clearway")]
    return f"{sum(int(row['wrong']) for row in of)} / {sum(int(row['over_wrong']) for row in theirs)}"


def scene_list(results):
    rows = results.rows("queries")
    return table(["name", "scene, triangles of part / environment, poses"],
                 [[letter, name_of(rows, letter)] for letter in scenes_of(rows)])


def peers_of(rows, question):
    """The peers that were asked this question, in the table's order; none that is cold."""
    of = matching(rows, question=question, engine="clearway", over_question=question)
    return [name for name in distinct(of, "over_engine") if not name.startswith("clearway") and not name.endswith(", cold")]


def collides(results):
    """A row a scene, a column a peer: how many times as long its `collides` takes, and its wrong answers if there are any."""
    rows = results.rows("queries")
    peers = peers_of(rows, "collides")
    lines = []
    for letter in scenes_of(rows):
        cells = []
        for peer in peers:
            row = compared(rows, letter, "collides", "clearway", peer)
            wrong_answers = f", {row['over_wrong']} of {row['poses']} wrong" if row and row["over_wrong"] != "0" else ""
            cells.append(ratio_cell(row) + wrong_answers)
        lines.append([letter, f"{microseconds(rows, letter, 'collides')} us"] + cells)
    return table(["", "clearway"] + [f"over {peer}" for peer in peers], lines)


def losses(results):
    """Every comparison in which a peer is faster: with clearway's default trees a query, and with one thread a build."""
    lines = []
    rows = [row for row in results.rows("queries") if row["engine"].startswith("clearway") and not row["over_engine"].startswith("clearway")]
    lost = [row for row in rows if float(row["ratio"]) < 1]
    for row in lost:
        lines.append([row["scene"], f"{row['question']}, {row['engine']}", f"{row['over_question']}, {row['over_engine']}", shown(row["ratio"])])
    builds_of = results.rows("builds") if results.has("builds") else []
    ours = "clearway, 1 thread"
    seconds = {(row["scene"], row["build"]): float(row["seconds"]) for row in builds_of}
    for peer in distinct(builds_of, "build"):
        quotients = {letter: seconds[letter, peer] / seconds[letter, ours] for letter in scenes_of(builds_of) if (letter, peer) in seconds}
        faster = {letter: quotient for letter, quotient in quotients.items() if quotient < 1}
        if faster and not peer.startswith("clearway"):
            lines.append([", ".join(faster), f"build, {ours}", f"build, {peer}", span(list(faster.values()))])
    sentence = f"Of {whole(len(rows))} comparisons of queries, {len(lost) or 'none'} {'is' if len(lost) < 2 else 'are'} lost to a peer."
    return [sentence] + (["", *table(["", "clearway", "faster", "its time over clearway's"], lines)] if lines else [])


def over(results, question, over_engine):
    """From the least to the largest ratio over the scenes."""
    rows = results.select("queries", question=question, engine="clearway", over_question=question, over_engine=over_engine)
    return span([float(row["ratio"]) for row in rows])


def times(results, question):
    """From the least to the largest mean time over the scenes, in microseconds."""
    return span([float(row["us_mean"]) for row in results.select("queries", question=question, engine="clearway")])


def builds(results):
    rows = results.rows("builds")
    letters = scenes_of(rows)
    names = distinct(rows, "build")
    lines = []
    for name in names:
        cells = []
        for letter in letters:
            row = matching(rows, scene=letter, build=name)
            # CGAL does not say how many bytes it takes.
            size = shown(row[0]["bytes_per_triangle"]) if row and float(row[0]["bytes_per_triangle"]) > 0 else "-"
            cells.append(f"{shown(row[0]['seconds'])} s, {size}" if row else "-")
        lines.append([name] + cells)
    sizes = [f"{letter}, {whole(row['part_triangles'])} / {whole(row['environment_triangles'])}"
             for letter in letters for row in matching(rows, scene=letter)[:1]]
    return table(["seconds, bytes a triangle"] + sizes, lines)


def strategies(results):
    """A row a strategy; in each scene the time of a distance over the default's, and of `collides`."""
    rows = results.rows("strategies")
    letters = scenes_of(rows)
    lines = []
    for name in distinct(rows, "strategy"):
        cells = []
        for letter in letters:
            of = [matching(rows, scene=letter, strategy=name, question=question) for question in ("distance", "collides")]
            cells.append(", ".join(f"{float(row[0]['over_default']):.2f}" for row in of if row))
        builds_of = [float(row["build_seconds"]) for row in matching(rows, strategy=name, question="distance")]
        lines.append([name] + cells + [f"{span(builds_of)} s"])
    return table(["distance, `collides` over the default strategy"] + letters + ["build"], lines)


def scenes(results):
    lines = []
    for row in results.rows("scenes"):
        lines.append([row["scene"], f"{whole(row['part_triangles'])} / {whole(row['environment_triangles'])}",
                      f"{row['clearance_asked']}, {row['clearance_certified']}", percent(row["tight_share"]),
                      percent(int(row["colliding"]) / int(row["poses"])), f"{shown(row['us_mean'])} us", whole(row["volume_tests"])])
    return table(["scene, seed 1", "triangles of part / environment", "clearance asked for, certified", "tight", "poses colliding",
                  "time of a distance", "volume tests of a distance"], lines)
