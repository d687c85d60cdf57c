"""The part `from_files`: whole processes, from a problem's files to a certified path and to the first answer, beside those of others."""

import statistics
import subprocess
import time

from place import Refused

ROWS = ("tunnel-console-3", "tunnel-console-small", "cembox-2", "large-environment-2", "puzzle")
STEP = 0.14  # environment units, at which 19 of 20 paths through tunnel-console-small were free
SEEDS = {"ci": 1, "quick": 2, "full": 5}
LIMIT = {"ci": 2, "quick": 20, "full": 20}  # seconds of planning
COLUMNS = ["scene", "what", "runs", "found", "free", "seconds", "seconds_least", "seconds_largest", "answer"]


def timed(command, codes=(0,)):
    """Seconds of a whole process, and the process; throws Refused if it ends with another code."""
    words = [str(word) for word in command]
    begin = time.perf_counter()
    done = subprocess.run(words, capture_output=True, text=True)
    seconds = time.perf_counter() - begin
    if done.returncode not in codes:
        raise Refused(f"'{' '.join(words)}' ends with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return seconds, done


def line(scene, what, times, **more):
    made = {"scene": scene, "what": what, "runs": len(times), "found": "", "free": "", "answer": "", **more}
    made.update(seconds=f"{statistics.median(times):.4g}", seconds_least=f"{min(times):.4g}", seconds_largest=f"{max(times):.4g}")
    return {column: str(made[column]) for column in COLUMNS}


def paths(place, row, problem):
    """A line a contender, which take turns. A run without a path counts with all its time. free: the paths that `clearway check` certifies."""
    path = place.scratch / "found.path"

    def ours(*more):
        return lambda seed: [place.program(), "plan", problem, "--path", path, "--seed", seed, "--time", LIMIT[place.form], *more]

    contenders = {"plan": ours(), "plan --quick": ours("--quick"),
                  "RRTConnect with FCL": lambda seed: [*place.benchmark("from_files"), "plan", problem, STEP, seed, LIMIT[place.form], path]}
    times, found, free = ({name: [] for name in contenders} for _ in range(3))
    for seed in range(1, SEEDS[place.form] + 1):
        for name, command in contenders.items():
            path.unlink(missing_ok=True)
            seconds, _ = timed(command(seed), (0, 1))
            times[name].append(seconds)
            found[name].append(path.exists())
            free[name].append(path.exists() and timed([place.program(), "check", problem, path, "--brief"], (0, 1))[1].returncode == 0)
    return [line(row, name, times[name], found=sum(found[name]), free=sum(free[name])) for name in contenders]


def answers(place, row, problem):
    """A line a library, which take turns: files to its first answer."""
    benchmark = place.benchmark("from_files")
    libraries = place.run([*benchmark, "libraries"]).split("\n")[:-1]
    times, said = ({name: [] for name in libraries} for _ in range(2))
    for _ in range(SEEDS[place.form]):
        for name in libraries:
            seconds, done = timed([*benchmark, "ask", name, problem])
            times[name].append(seconds)
            said[name] = done.stdout.strip()
    return [line(row, f"first answer, {name}", times[name], answer=said[name]) for name in libraries]


def table(place, row):
    problem = place.problem(row)
    return COLUMNS, paths(place, row, problem) + answers(place, row, problem)
