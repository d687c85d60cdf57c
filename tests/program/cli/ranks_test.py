"""`clearway bench` and `clearway-study` under mpirun: a killed run, a killed rank, and the same command again.

    ranks_test.py PROGRAM DATA [MPIEXEC]
Without MPIEXEC the program was built without MPI, and must say so.
"""

import csv
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, DATA, MPIEXEC = (sys.argv[1:] + [""])[:3]
SECONDS = 300  # for one command
# Properties of a run that a seed and a number of iterations do not decide.
TIMES = re.compile(r"(time|share|memory|megabytes|seconds) |^time|^memory")

# Open MPI refuses root and more ranks than processors unless it is told not to. Other MPIs do not look at these variables.
ENVIRONMENT = dict(
    os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
    PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe"
)


def require(condition, message):
    if not condition:
        raise SystemExit(f"FAILED: {message}")


def ranked(words):
    """words: a command of clearway's, or those of clearway-study."""
    return [MPIEXEC, "-n", "4", PROGRAM if words[0] == "bench" else PROGRAM + "-study", *words]


def run(words, folder, **more):
    return subprocess.run(words, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=SECONDS, **more)


def show(done):
    return f"exit code {done.returncode}\n{done.stdout}{done.stderr}"


def process_of_run(words, number):
    """The processes that do this run: their numbers, as text."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            line = (process / "cmdline").read_bytes().split(b"\0")[1:-1]
        except OSError:
            continue  # it has ended
        command = [word for word in words if word == "bench"]
        if [word.decode() for word in line] == [*command, "--one-run", str(number), *words[len(command) :]]:
            found.append(int(process.name))
    return found


def kill_during(words, folder, number, which):
    """Starts the command and kills the process of the run with this number, or its rank, as soon as it is seen."""
    started = subprocess.Popen(
        ranked(words), cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    end = time.monotonic() + SECONDS
    while time.monotonic() < end and started.poll() is None:
        for process in process_of_run(words, number):
            if which == "rank":
                status = pathlib.Path(f"/proc/{process}/status").read_text()
                process = int(re.search(r"PPid:\s*(\d+)", status).group(1))
            os.kill(process, signal.SIGKILL)
            output, _ = started.communicate(timeout=SECONDS)
            return subprocess.CompletedProcess(words, started.returncode, output, "")
        time.sleep(0.01)
    started.kill()
    require(False, f"run {number} of {words} was not seen: {started.communicate()[0]}")


def read_log(file):
    """Each planner's runs, as dictionaries of texts."""
    lines = iter(file.read_text().split("\n"))
    planners = {}
    name = ""
    for line in lines:
        if line.endswith(" common properties"):
            name = before
        if line.endswith(" properties for each run") and "progress" not in line:
            columns = [next(lines) for _ in range(int(line.split()[0]))]
            count = int(next(lines).split()[0])
            planners[name] = [dict(zip(columns, next(lines).split("; "))) for _ in range(count)]
        before = line
    return planners


def decided(planners):
    """The properties that seeds and iterations decide."""
    return {
        name: [{key: value for key, value in values.items() if not TIMES.search(key)} for values in runs]
        for name, runs in planners.items()
    }


def times(runs):
    return [values["time REAL"] for values in runs]


def check_benchmark(folder):
    shutil.copytree(f"{DATA}/window", folder / "window")
    # RRTConnect ends with its first path. RRTstar uses up its iterations, so that there is time to kill it. Its run is the last.
    words = ["bench", "window/window.cfg", "--planner", "RRTConnect", "--planner", "RRTstar", "--runs", "3", "--iterations", "2000"]
    words += ["--no-simplify", "--log"]
    alone = run([PROGRAM, *words, "alone.log"], folder)
    require(alone.returncode == 0, "one process: " + show(alone))
    expected = read_log(folder / "alone.log")
    require([len(runs) for runs in expected.values()] == [3, 3], f"one process ran {expected}")

    words += ["ranks.log"]
    killed = kill_during(words, folder, 5, "run")
    require(killed.returncode == 1, "with a run killed: " + show(killed))
    require("geometric_RRTstar, seed 3: ended by signal 9 (Killed)" in killed.stdout, show(killed))
    first = read_log(folder / "ranks.log")
    lost = first["geometric_RRTstar"].pop()
    require(lost["seed INTEGER"] == "3" and lost["solved BOOLEAN"] == "0", f"the lost run has {lost}")
    expected_last = expected["geometric_RRTstar"].pop()
    require(decided(first) == decided(expected), f"{decided(first)}, expected {decided(expected)}")

    other = run(ranked(words + ["--seed", "2"]), folder)
    require(other.returncode != 0 and "has command '" in other.stderr, "with another seed: " + show(other))

    broken = kill_during(words, folder, 5, "rank")
    require(broken.returncode not in (0, 1), "with a rank killed: " + show(broken))
    require(not process_of_run(words, 5), "the killed rank's run goes on")
    kept = sorted(file.name for file in (folder / "ranks.log.runs").glob("*.json"))
    require(kept == [f"{i}.json" for i in range(5)], f"kept are {kept}")

    last = run(ranked(words + []), folder)
    require(last.returncode == 0, "again: " + show(last))
    final = read_log(folder / "ranks.log")
    for name, runs in first.items():
        require(times(final[name])[: len(runs)] == times(runs), f"a run of {name} was repeated")
    expected["geometric_RRTstar"].append(expected_last)
    require(decided(final) == decided(expected), f"{decided(final)}, expected {decided(expected)}")
    require(not (folder / "ranks.log.runs").exists(), "the runs stay when they are in the log")


def check_interrupt(folder):
    """SIGTERM at mpirun leaves a log of the runs that ended."""
    words = ["bench", "window/window.cfg", "--planner", "RRTConnect", "--planner", "RRTstar", "--runs", "2", "--time", "200"]
    words += ["--log", "stopped.log"]
    patient = dict(ENVIRONMENT, OMPI_MCA_odls_base_sigkill_timeout="3")  # seconds after SIGTERM, also on a busy machine
    started = subprocess.Popen(ranked(words), cwd=folder, env=patient, stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + SECONDS
    while time.monotonic() < end and len(list((folder / "stopped.log.runs").glob("[01].json"))) < 2:
        time.sleep(0.01)
    started.terminate()
    started.communicate(timeout=SECONDS)
    runs = read_log(folder / "stopped.log")
    require([len(of) for of in runs.values()] == [2, 0], f"the log of the interrupted benchmark has {runs}")


def rows_of(table):
    with open(table, newline="") as file:
        return sorted([row["scene"], row["planner"], row["general_split"], row["leaf_split"], row["seed"]] for row in csv.DictReader(file))


def check_study(folder):
    words = ["window/window.cfg", "--short", "--planner", "RRTConnect", "--planner", "RRTstar"]
    words += ["--seeds", "1", "--general-split", "sah", "--leaf-split", "none", "--leaf-split", "all", "--time", "1"]
    words += ["--out", "study"]
    killed = kill_during(words, folder, 3, "run")
    require(killed.returncode == 1 and "runs lost: the same command continues it" in killed.stdout, show(killed))
    require("RRTstar sah/all seed 1: ended by signal 9 (Killed)" in killed.stdout, show(killed))
    before = (folder / "study/runs.csv").read_text()
    last = run(ranked(words), folder)
    require(last.returncode == 0, "the study again: " + show(last))
    require((folder / "study/runs.csv").read_text().startswith(before), "the study repeated a run")
    expected = [["window", planner, "sah", leaf, "1"] for planner in ("RRTConnect", "RRTstar") for leaf in ("all", "none")]
    require(rows_of(folder / "study/runs.csv") == expected, f"the study has {rows_of(folder / 'study/runs.csv')}")
    require((folder / "study/claims.csv").exists(), "the study is not complete")


def check_refusals(folder):
    wrong = run(ranked(["bench", "window/window.cfg", "--runs", "0"]), folder)
    require(wrong.returncode == 2 and wrong.stderr.count("--runs is '0'") == 1, "a wrong option: " + show(wrong))
    shown = run(ranked(["bench", "--help"]), folder)
    require(shown.returncode == 0 and shown.stdout.count("Usage:") == 1, "--help: " + show(shown))


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        if not MPIEXEC:
            done = run(["env", "OMPI_COMM_WORLD_RANK=1", PROGRAM, "bench", "--help"], folder)
            require(done.returncode == 2 and "built without MPI" in done.stderr, show(done))
            print("skipped: program/cli/ranks was not tried: this program was built without MPI")
            return
        for check in (check_benchmark, check_interrupt, check_study, check_refusals):
            begin = time.monotonic()
            check(folder)
            print(f"{check.__name__}: {time.monotonic() - begin:.1f} s")


main()
