"""The parts of the benchmark: for each the commands that measure it in every form, and the table that they make.

A part PART writes PART.csv. A row of it, PART/ROW, is measured by itself; one row of a part may be several lines of its table.
"""

from dataclasses import dataclass, field
from typing import Callable

import assemblies
import from_files
import overlaps
import scene_rows
import tight

FORMS = ("ci", "quick", "full")


@dataclass(frozen=True)
class Part:
    name: str
    about: str
    rows: tuple  # of the whole form
    commands: Callable  # (place, row) -> the commands that measure the row
    group: tuple  # the columns that all lines of a row share, and no other row has; none: the table is one row
    keys: tuple  # the columns that tell the lines of the table apart
    shown: tuple  # the columns shown beside expected ones; X may have X_least and X_largest beside it
    table: object = None  # the file that the commands write below place.scratch (NAME.csv), or (place, row) -> columns, rows
    quick_rows: tuple = ()  # of the quick form of everything
    ci_rows: tuple = ()
    repetitions: dict = field(default_factory=dict)  # by form; 1 if it is not there
    spread: tuple = ()  # the columns of which several repetitions give the median
    is_shown: Callable = lambda row: True  # which lines are shown
    is_study: bool = False  # takes long: is measured only when it is named

    def rows_of(self, form):
        return {"ci": self.ci_rows, "quick": self.quick_rows, "full": self.rows}[form]


SCENES = ("K", "L", "I", "J", "M", "N", "F")  # of `benchmarks queries`
SMALL_PROBLEM = "data/tunnel-console-small/tunnel-console.cfg"


def queries(place, row):
    sizes = {
        "ci": ["--small", "--pose-count", 20, "--repetitions", 1, "--peer-budget", 0.3, "--targets", "all", "--oracle-poses", 20],
        "quick": ["--pose-count", 400, "--repetitions", 2, "--peer-budget", 2],
        "full": ["--pose-count", 400, "--repetitions", 5, "--peer-budget", 12],
    }
    if place.form == "ci" and row not in ("F", "N"):  # some peers take seconds for a pass over a larger scene
        sizes["ci"].append("--without-peers")
    return [[*place.benchmark("queries"), "--scenes", row, *sizes[place.form], "--build-rounds", 0, "--cpu", place.cpu, "--out", place.scratch]]


def builds(place, row):
    sizes = {"ci": ["--small", "--build-rounds", 1], "quick": ["--build-rounds", 2], "full": ["--build-rounds", 5]}
    return [[*place.benchmark("queries"), "--scenes", row, *sizes[place.form], "--pose-count", 2, "--repetitions", 1, "--peer-budget", 0,
             "--targets", "best", "--out", place.scratch]]


def speed_error(place, row):
    sizes = {
        "ci": ["--small", "--pose-count", 10, "--near-bases", 2, "--repetitions", 1, "--peer-budget", 0.1],
        "quick": ["--pose-count", 200, "--near-bases", 10, "--repetitions", 2, "--peer-budget", 1],
        "full": ["--pose-count", 200, "--near-bases", 10, "--repetitions", 7, "--peer-budget", 4],
    }
    return [[*place.benchmark("speed_error"), "--scenes", row, *sizes[place.form], "--cpu", place.cpu, "--out", place.scratch]]


def motions(place, row):
    count = {"ci": 100, "quick": 300, "full": 1000}[place.form]
    return [place.pinned(*place.benchmark("motions"), place.problem(row), count, 1, place.scratch / "motions.csv", row)]


# The rows of certified_motions: the scene, whose motions, how many.
CERTIFIED = {}
for _scene in ("tunnel-console-3", "large-environment-2", "cembox-2"):
    CERTIFIED.update({
        f"{_scene} RRTConnect": (_scene, "RRTConnect", 3000),
        f"{_scene} PRM": (_scene, "PRM", 1500),
        f"{_scene} KPIECE1": (_scene, "KPIECE1", 300),
        f"{_scene} path": (_scene, "path", 3000),
    })


def certified_motions(place, row):
    scene, motions_of, count = CERTIFIED[row]
    of = place.path(scene) if motions_of == "path" else motions_of
    count = {"ci": 60, "quick": min(count, 300), "full": count}[place.form]
    return [place.pinned(*place.benchmark("certified_motions"), place.problem(scene), of, count, scene,
                         place.scratch / "certified_motions.csv")]


def fcl_motions(place, row):
    count = {"ci": 200, "quick": 300, "full": 1000}[place.form]
    return [place.pinned(*place.benchmark("fcl_motions"), place.problem(row), count, 1, place.scratch / "fcl_motions.csv")]


def fcl_continuous(place, _row):
    count = {"ci": 10, "quick": 60, "full": 300}[place.form]
    return [place.pinned(*place.benchmark("fcl_continuous"), count, 1, place.scratch / "fcl_continuous.csv")]


def fcl_first_path(place, row):
    seeds, limit, step = {"ci": (1, 2, 4.5), "quick": (3, 20, "find"), "full": (20, 20, "find")}[place.form]
    return [[*place.benchmark("fcl_first_path"), place.problem(row), seeds, limit, step, place.scratch / "fcl_first_path.csv"]]


def torture(place, _row):
    pairs, poses = {"ci": (2600, 90), "quick": (500_000, 5000), "full": (10_010_000, 100_000)}[place.form]
    return [[place.test_program("torture"), "--pairs", pairs, "--poses", poses, "--csv", place.scratch / "torture.csv"]]


def strategies(place, row):
    sizes = {"ci": ["--small", "--pose-count", 10, "--repetitions", 1], "quick": ["--pose-count", 200, "--repetitions", 2],
             "full": ["--pose-count", 400, "--repetitions", 5]}
    return [[*place.benchmark("strategies"), "--scenes", row, *sizes[place.form], "--cpu", place.cpu, "--out", place.scratch]]


def kernels(place, row):
    sizes = {
        "ci": ["--triangles", 17, "--triangles-by-size", 24, "--input-sizes", "1,3,16,1024", "--repetitions", 1, "--checked", 600],
        "quick": ["--triangles", 2000, "--repetitions", 2],
        "full": ["--repetitions", 3],
    }
    return [[*place.benchmark("kernels"), "--question", row, *sizes[place.form], "--cpu", place.cpu, "--out", place.scratch]]


# The rows of growth: triangles of part and environment. One of the two linked rings grows while the other stays; then both are as large
# as the largest that others published.
GROWTH = {}
for _grows in ("environment", "part"):
    for _size, _count in (("1k", 1000), ("4k", 4000), ("16k", 16_000), ("64k", 64_000), ("256k", 256_000), ("1M", 1_000_000), ("4M", 4_000_000)):
        GROWTH[f"{_grows} {_size}"] = (30_000, _count) if _grows == "environment" else (_count, 30_000)
GROWTH["rings"] = (7_500_000, 7_500_000)


def growth(place, row):
    part, environment = (min(count, 4000) if place.form == "ci" else count for count in GROWTH[row])
    sizes = {
        "ci": ["--pose-count", 10, "--repetitions", 1, "--peer-budget", 0.3],
        "quick": ["--pose-count", 300, "--repetitions", 1, "--peer-budget", 3],
        "full": ["--pose-count", 300, "--repetitions", 5, "--peer-budget", 12],
    }
    return [[*place.benchmark("growth"), "--part-triangles", part, "--environment-triangles", environment, *sizes[place.form], "--cpu", place.cpu,
             "--out", place.scratch]]


def loading(place, row):
    sizes = {"ci": ["--triangles", 2000, "--repetitions", 1], "quick": ["--repetitions", 3], "full": ["--repetitions", 9]}
    return [[*place.benchmark("loading"), "--formats", row, *sizes[place.form], "--cpu", place.cpu, "--out", place.scratch]]


def ladder(place, row):
    sizes = {
        "ci": ["--pose-count", 10, "--repetitions", 1, "--peer-budget", 0.3],
        "quick": ["--pose-count", 100, "--repetitions", 2, "--peer-budget", 2],
        "full": ["--pose-count", 400, "--repetitions", 5, "--peer-budget", 12],
    }
    return [[*place.benchmark("ladder"), "--scenes", row, *sizes[place.form], "--cpu", place.cpu, "--out", place.scratch]]


# The planner studies.
OWN_PROBLEMS = ("gates", "peg-in-hole", "window", "bracket", "tunnel-console-small", "puzzle", "apartment", "tunnel-console-3-2mm")
OMPLAPP = ("Easy", "Apartment", "alpha-1.5", "Abstract", "Twistycool", "cubicles", "spirelli", "Home", "bugtrap", "alpha-1.2", "Twistycooler",
           "alpha-1.1", "alpha-1.0")
ROOM = ("bracket", "angle", "gates", "tunnel-console-small", "tunnel-console-3")


def plans(table, choices):
    """`benchmarks plan_success` on one problem. choices: row -> its other options, and its seeds and seconds in the full form."""
    def commands(place, row):
        more, seeds, limit = choices(row)
        seeds, limit = {"ci": (1, 10), "quick": (min(seeds, 3), limit), "full": (seeds, limit)}[place.form]
        return [[*place.benchmark("plan_success"), place.problem(row), *more, "--seeds", seeds, "--time", limit, "--out",
                 place.scratch / f"{table}.csv"]]

    return commands


def first_path(row):
    return (["--quick"], *{"alpha-1.1": (10, 60), "alpha-1.0": (5, 300)}.get(row, (20, 60)))


def widest(row):
    return (["--objective", "max_min_clearance"], *{"tunnel-console-3": (3, 60), "tunnel-console-small": (5, 15)}.get(row, (5, 5)))


def samplers(table):
    def commands(place, row):
        seeds, limit = {"ci": (1, 1), "quick": (3, 10), "full": (20, 10) if row == "window" else (2, 15)}[place.form]
        return [[*place.benchmark("samplers"), place.problem(row), seeds, limit, place.scratch / f"{table}.csv"]]

    return commands


def anytime_clearance(place, row):
    limit, seeds = {"ci": (0.2, 1), "quick": (2, 2), "full": (2, 10)}[place.form]
    return [[*place.benchmark("anytime_clearance"), limit, seeds, place.scratch / "anytime_clearance.csv", row]]


def study_of_plans(name, about, rows, choices, ci_rows=()):
    return Part(name, about, rows=rows, commands=plans(name, choices), group=("problem",), keys=("problem", "seed"),
                shown=("found", "planning_seconds", "least_clearance"), ci_rows=ci_rows, is_study=True)


def study_of_samplers(name, problem, ci_rows=()):
    return Part(name, "PRM with samplers of valid states", rows=(problem,), commands=samplers(name), group=(),
                keys=("sampler", "seed"), shown=("found", "planning_seconds"), ci_rows=ci_rows, is_study=True)


PARTS = (
    Part("queries", "queries of clearway and its peers, a row a scene", rows=SCENES, quick_rows=("K", "N", "F"), ci_rows=SCENES,
         commands=queries, table="summary.csv", group=("scene",),
         keys=("scene", "question", "engine", "over_question", "over_engine"), shown=("ratio", "us_mean")),
    Part("builds", "seconds and bytes of trees", rows=("K", "I", "J", "M", "N", "F"), quick_rows=("N", "F"), ci_rows=("F",),
         commands=builds, group=("scene",), keys=("scene", "build"), shown=("seconds", "bytes_per_triangle")),
    Part("speed_error", "speed against error, and wrong verdicts near margins", rows=SCENES, quick_rows=("F",), ci_rows=("F", "N"),
         commands=speed_error, group=("scene",), keys=("scene", "mode"),
         shown=("queries_per_second", "time_over_float_only", "error_worst")),
    Part("growth", "queries, motions and trees as one of two linked rings grows", rows=tuple(GROWTH), quick_rows=("environment 64k",),
         ci_rows=("environment 1k", "part 1k", "rings"), commands=growth,
         group=("scene", "part_triangles", "environment_triangles"), keys=("part_triangles", "environment_triangles", "engine"),
         shown=("us_median", "us_motion_median", "build_seconds", "bytes_per_triangle")),
    Part("loading", "mesh files of 1.7 million triangles read by clearway and by assimp", rows=("stl", "obj", "glb", "ply"),
         quick_rows=("stl", "obj", "glb"), ci_rows=("stl", "obj", "glb", "ply"), commands=loading, group=("format",),
         keys=("format", "reader"), shown=("seconds", "megabytes")),
    Part("from_files", "whole processes, from files to a path and to the first answer, beside others'", rows=from_files.ROWS,
         quick_rows=("tunnel-console-small",), ci_rows=("tunnel-console-small",), commands=lambda place, row: [], table=from_files.table,
         group=("scene",), keys=("scene", "what"), shown=("seconds", "found", "free")),
    Part("shrinking", "parts shrunk for an overlap", rows=tuple(overlaps.SHRUNK), quick_rows=("tunnel-console-small 1e-3",),
         ci_rows=("bracket 1e-3",), commands=overlaps.shrinking, group=("part", "overlap_over_diagonal"),
         keys=("part", "overlap_over_diagonal"), shown=("seconds", "triangles_shrunk", "share_shallow")),
    Part("touching", "parts that touch, from the advised overlap to a path", rows=overlaps.TOUCHING + overlaps.PUZZLES, quick_rows=("plug", "lid"),
         ci_rows=("plug",), commands=lambda place, row: [], table=overlaps.touching, group=("problem",), keys=("problem",),
         shown=("found", "seconds", "lift_seconds")),
    Part("tight", "parts in tight fits, such as screws in their threads", rows=tight.OWN + tight.BOLTS, quick_rows=("square_peg", "hook"),
         ci_rows=("square_peg",), commands=lambda place, row: [], table=tight.tight, group=("problem",), keys=("problem",),
         shown=("found", "seconds", "clearance")),
    Part("assemblies", "which parts of an assembly touch, and which come out one after the other", rows=assemblies.OWN + tuple(assemblies.OTHERS),
         quick_rows=assemblies.OWN, commands=lambda place, row: [], table=assemblies.assemblies, group=("assembly",),
         keys=("assembly",), shown=("out", "last_out_seconds", "pairs_seconds")),
    Part("ladder", "from the thesis's engine to clearway's, step by step", rows=("K", "I"), ci_rows=("N",),
         commands=ladder, group=("scene",), keys=("scene", "step"), shown=("us_mean", "volume_tests", "triangle_tests")),
    Part("scenes", "the demo scenes, and a distance at their poses", rows=tuple(scene_rows.ROWS), quick_rows=("puzzle-2",), ci_rows=("boxes-1",),
         commands=scene_rows.commands, table=scene_rows.table, group=("scene", "clearance_asked"),
         keys=("scene", "clearance_asked"), shown=("us_mean", "volume_tests", "clearance_certified")),
    Part("motions", "certified motions against checks in steps", rows=("tunnel-console-3",), quick_rows=("tunnel-console-3",),
         ci_rows=("tunnel-console-small",), commands=motions, group=("scene",), keys=("scene", "what"),
         shown=("us_certified", "us_compared", "times"), spread=("us_certified", "us_compared", "times"), repetitions={"full": 5}),
    Part("certified_motions", "motions certified by velocities and by bounds of displacements", rows=tuple(CERTIFIED),
         quick_rows=("cembox-2 path",), commands=certified_motions,
         group=("scene", "motions"), keys=("scene", "motions", "kind"),
         shown=("us_by_bound", "us_by_velocities", "times_faster"), spread=("us_by_bound", "us_by_velocities", "times_faster"), repetitions={"full": 3}),
    Part("fcl_motions", "states and motions judged by FCL and by clearway", rows=("tunnel-console-3",), ci_rows=("tunnel-console-small",),
         commands=fcl_motions, group=(), keys=("what",), shown=("clearway_us", "fcl_us", "times_faster"),
         spread=("clearway_us", "fcl_us", "times_faster"), repetitions={"full": 3}),
    Part("fcl_continuous", "FCL's continuous check, judged", rows=("all",), quick_rows=("all",), ci_rows=("all",),
         commands=fcl_continuous, group=(), keys=("scene", "checked_by"),
         shown=("of_these_called_valid", "of_these_called_invalid", "us_a_motion")),
    Part("strategies", "splits of trees beside the default, a row a scene", rows=SCENES, quick_rows=("N", "F"), ci_rows=("N",),
         commands=strategies, group=("scene",), keys=("scene", "question", "strategy"),
         shown=("over_default", "us_mean", "build_seconds")),
    Part("kernels", "kernels of pairs of triangles, as in the thesis's tables 1 to 4", rows=("collides", "distance"),
         quick_rows=("collides", "distance"), ci_rows=("collides", "distance"), commands=kernels,
         group=("question",), keys=("question", "test", "contender", "instruction_set", "triangles", "input_size"),
         shown=("seconds", "largest_error")),
    Part("torture", "hard pairs and poses against exact arithmetic", rows=("all",), ci_rows=("all",), commands=torture,
         group=(), keys=("group", "family", "figure"), shown=("value",), is_shown=lambda row: row["figure"] in ("violations", "false valid")),
    Part("fcl_first_path", "a first path that is free, by steps with FCL and certified", rows=("tunnel-console-3",),
         ci_rows=("tunnel-console-small",), commands=fcl_first_path, group=(), keys=("checked_by", "step"),
         shown=("found", "free", "median_seconds_to_a_free_path"), is_study=True),
    study_of_plans("plan_first_path", "clearway plan, its first path", OWN_PROBLEMS + OMPLAPP + ("elk",), first_path,
                   ci_rows=("bracket", "gates")),
    study_of_plans("plan_bracket", "clearway plan on the bracket, 100 seeds", ("bracket",), lambda _: (["--quick"], 100, 60)),
    study_of_plans("plan_room", "clearway plan with room", ROOM, lambda _: ([], 20, 60)),
    study_of_plans("plan_widest", "clearway plan for the widest path", ROOM, widest),
    study_of_samplers("samplers_window", "window", ci_rows=("window",)),
    study_of_samplers("samplers_tunnel_console_small", "tunnel-console-small"),
    Part("anytime_clearance", "clearance gained with planning time", rows=("posts",), ci_rows=("gates",),
         commands=anytime_clearance, group=("scene",), keys=("scene", "planner", "parameters", "objective", "seed", "seconds"),
         shown=("certified_clearance",), is_study=True),
)


def part_named(name):
    for part in PARTS:
        if part.name == name:
            return part
    raise ValueError(f"there is no part '{name}', expected one of {', '.join(part.name for part in PARTS)}")
