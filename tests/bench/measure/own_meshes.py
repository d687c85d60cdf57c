"""`run --mesh`: a user's own meshes and poses, asked of every library and of trees built by every strategy."""

import pathlib
import tempfile

from machine import build_record, machine_record, now
from place import Place, Refused
from queries import ROWS, compared, ratio_cell
from results import distinct, matching, seconds, shown, table
from tables import read, write

CERTAIN = 0.98  # a strategy is faster if all its repetitions, at least three, take less than this share of the default's time
QUESTIONS = ("distance", "collides", "within 1 %")
SIZES = {"ci": (1, 0.3), "quick": (3, 2), "full": (7, 20)}  # repetitions, seconds for a question to a peer


def peers_table(rows):
    lines = []
    for title, *keys in ROWS:
        row = compared(rows, "files", *keys)
        if row:
            lines.append([title, f"{shown(row['us_mean'])} us", f"{shown(row['over_us_mean'])} us", ratio_cell(row),
                          f"{shown(row['ratio_least'])} to {shown(row['ratio_largest'])}"])
    return table(["question", "clearway", "peer", "times faster", "range"], lines)


def strategies_table(rows):
    lines = []
    for name in distinct(rows, "strategy"):
        of = {question: matching(rows, strategy=name, question=question)[0] for question in QUESTIONS}
        first = of["distance"]
        lines.append([name] + [f"{shown(of[question]['us_mean'])} us, {shown(of[question]['over_default'])}" for question in QUESTIONS] +
                     [f"{seconds(first['build_seconds'])} s", shown(first["bytes_per_triangle"])])
    return table(["strategy: general split / leaf split"] + [f"{question}, over the default" for question in QUESTIONS] +
                 ["build", "bytes a triangle"], lines)


def options_of(name):
    """The strategy as options of the program."""
    general, leaf = name.split("/")
    return f"--general-split {general} --leaf-split {leaf}"


def advice_for(rows, question):
    """One line: which strategy answers the question fastest, and from how many queries on a longer build pays."""
    of = matching(rows, question=question)
    default = of[0]
    certain = [row for row in of if float(row["over_default_largest"]) < CERTAIN and int(row["repetitions"]) >= 3]
    best = min(certain, key=lambda row: float(row["over_default"])) if certain else default
    if best is default:
        line = f"{question}: the default, {default['strategy']}; none is certainly faster"
    else:
        share = 100 * (1 - float(best["over_default"]))
        line = f"{question}: {options_of(best['strategy'])}; it takes {share:.0f} % less time than the default, {default['strategy']}"
    quickest = min(of, key=lambda row: float(row["build_seconds"]))
    saved = float(best["build_seconds"]) - float(quickest["build_seconds"])
    slower = 1e-6 * (float(quickest["us_mean"]) - float(best["us_mean"]))
    if saved > 0 and slower > 0:
        line += f". For fewer than {saved / slower:,.0f} queries {options_of(quickest['strategy'])} is done sooner, because it builds in " \
                f"{seconds(quickest['build_seconds'])} s"
    return line + "."


def run(given):
    part, environment = (pathlib.Path(mesh) for mesh in given.mesh)
    for file in (part, environment, pathlib.Path(given.poses)):
        if not file.exists():
            raise Refused(f"there is no file {file}")
    repetitions, budget = SIZES[given.form]
    files = ["--part", part, "--environment", environment, "--poses", given.poses]
    given.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        place = Place(given.form, given.root, given.build, pathlib.Path(scratch), cpu=given.cpu, make=given.make)
        common = [*files, "--repetitions", repetitions, "--cpu", place.cpu, "--peer-budget", budget, "--out", scratch]
        place.run([*place.benchmark("queries"), *common, "--build-rounds", 0])
        place.run([*place.benchmark("strategies"), *common])
        columns, queries = read(place.scratch / "summary.csv")
        strategy_columns, strategies = read(place.scratch / "strategies.csv")
    write(given.out / "own_queries.csv", columns, queries)
    write(given.out / "own_strategies.csv", strategy_columns, strategies)
    record = {"part": part.name, "environment": environment.name, "date": now(), **machine_record(), **build_record(given.root, given.build)}
    write(given.out / "own_runs.csv", list(record), [record])
    first = queries[0]
    print(f"{part.name}, {first['part_triangles']} triangles, in {environment.name}, {first['environment_triangles']} triangles; {first['poses']} "
          f"poses, {first['colliding']} colliding; {record['cpu']}, {record['instruction_set']}\n")
    print("\n".join(peers_table(queries)) + "\n")
    print("\n".join(strategies_table(strategies)) + "\n\nWhich strategy to choose, by what is asked:\n")
    for question in QUESTIONS:
        print(f"- {advice_for(strategies, question)}")
    wrong = sum(int(row["wrong"]) for row in queries)
    print(f"\nclearway's wrong answers: {wrong}. The tables are in {given.out}.")
    return 1 if wrong else 0
