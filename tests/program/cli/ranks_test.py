"""`clearway bench` under mpirun: shares, a stopped rank, a killed rank, and what is left then.

    ranks_test.py PROGRAM DATA [MPIEXEC]
Without MPIEXEC the program was built without MPI, and must say so.
"""

import concurrent.futures
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
    """words: a command of clearway's."""
    return [MPIEXEC, "-n", "4", PROGRAM, *words]


def environment(folder, **more):
    """Open MPI keeps its sessions below TMPDIR, where two jobs that start at once may fail to make one folder."""
    return dict(ENVIRONMENT, TMPDIR=str(folder), **more)


def run(words, folder, **more):
    return subprocess.run(words, cwd=folder, env=environment(folder), capture_output=True, text=True, timeout=SECONDS, **more)


def show(done):
    return f"exit code {done.returncode}\n{done.stdout}{done.stderr}"


def start(words, folder, **more):
    return subprocess.Popen(
        ranked(words), cwd=folder, env=environment(folder, **more), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def wait_for(found, started):
    """Returns what `found` returns, as soon as it is true."""
    end = time.monotonic() + SECONDS
    while time.monotonic() < end and started.poll() is None:
        result = found()
        if result:
            return result
        time.sleep(0.01)
    started.kill()
    require(False, f"{found.__name__} was not seen: {started.communicate()[0]}")


def process_of_rank(number, started):
    """The process of this rank, once it catches SIGTERM."""

    def process():
        for status in pathlib.Path("/proc").glob("[0-9]*/status"):
            try:
                text = status.read_text()
                environment = status.with_name("environ").read_bytes().split(b"\0")
            except OSError:
                continue  # it has ended
            if f"PPid:\t{started.pid}\n" not in text or b"OMPI_COMM_WORLD_RANK=%d" % number not in environment:
                continue
            if int(re.search(r"SigCgt:\s*(\w+)", text).group(1), 16) >> (signal.SIGTERM - 1) & 1:
                return int(status.parent.name)
        return None

    return wait_for(process, started)


def ended(words, started):
    output, _ = started.communicate(timeout=SECONDS)
    return subprocess.CompletedProcess(words, started.returncode, output, "")


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


def bench_words(*more):
    """RRTConnect ends with its first path. RRTstar uses up its time or iterations, on the ranks after RRTConnect's."""
    return ["bench", "window/window.cfg", "--planner", "RRTConnect", "--planner", "RRTstar", "--no-simplify", *more]


def check_benchmark(folder):
    words = bench_words("--runs", "5", "--iterations", "1000", "--save-paths", "all", "--log")
    for place in ("alone", "ranks"):
        (folder / place).mkdir()
    alone = run([PROGRAM, *words, "alone/w.log"], folder)
    require(alone.returncode == 0, "one process: " + show(alone))
    shared = run(ranked(words + ["ranks/w.log"]), folder)
    require(shared.returncode == 0 and "lost" not in shared.stdout, "ranks: " + show(shared))
    expected = decided(read_log(folder / "alone/w.log"))
    require([len(runs) for runs in expected.values()] == [5, 5], f"one process ran {expected}")
    require(decided(read_log(folder / "ranks/w.log")) == expected, f"{decided(read_log(folder / 'ranks/w.log'))}, expected {expected}")
    for path in (folder / "alone").glob("*.path"):
        require((folder / "ranks" / path.name).read_text() == path.read_text(), f"{path.name} is another one")


def runs_in(log):
    return [len(runs) for runs in read_log(log).values()]


def check_killed_rank(folder):
    """The log grows while ranks work, and lacks only what a killed rank had not ended."""
    log = folder / "killed.log"
    words = bench_words("--runs", "2", "--time", "200", "--log", "killed.log")
    started = start(words, folder)
    wait_for(log.exists, started)
    require(runs_in(log) == [2, 0], f"the growing log has {runs_in(log)}")
    os.kill(process_of_rank(3, started), signal.SIGKILL)
    require(ended(words, started).returncode not in (0, 1), "a killed rank left its job alone")
    merged = run([PROGRAM, "bench", "--merge", "killed.log", "--log", "merged.log"], folder)
    require(merged.returncode == 1 and "geometric_RRTstar, seeds 1 to 2" in merged.stdout, "--merge: " + show(merged))


def check_ended_job(folder):
    """SIGTERM at mpirun leaves a log of the runs that ended."""
    log = folder / "ended.log"
    words = bench_words("--runs", "2", "--time", "200", "--log", "ended.log")
    started = start(words, folder, OMPI_MCA_odls_base_sigkill_timeout="3")  # seconds after SIGTERM, also on a busy machine
    wait_for(log.exists, started)
    started.terminate()
    stopped = ended(words, started)
    require("geometric_RRTstar, seeds 1 to 2" in stopped.stdout and "interrupted" in stopped.stdout, show(stopped))
    require(runs_in(log) == [2, 0], f"the log of the interrupted benchmark has {runs_in(log)}")


def check_stopped_rank(folder):
    """SIGTERM at one rank loses its runs alone."""
    words = bench_words("--runs", "2", "--time", "2", "--log", "one.log")
    started = start(words, folder)
    os.kill(process_of_rank(3, started), signal.SIGTERM)
    stopped = ended(words, started)
    require(stopped.returncode == 1 and "geometric_RRTstar, seed 2\n" in stopped.stdout, show(stopped))
    require(runs_in(folder / "one.log") == [2, 1], f"the log has {runs_in(folder / 'one.log')}")


def check_refusals(folder):
    wrong = run(ranked(["bench", "window/window.cfg", "--runs", "0"]), folder)
    require(wrong.returncode == 2 and wrong.stderr.count("--runs is '0'") == 1, "a wrong option: " + show(wrong))
    (folder / "elsewhere").mkdir()
    words = [PROGRAM, *bench_words("--runs", "1", "--iterations", "9", "--log", "x.log")]
    apart = run([MPIEXEC, "-n", "1", *words, ":", "-n", "1", "-wdir", str(folder / "elsewhere"), *words], folder)
    require(apart.returncode == 2 and "clearway: rank 1: cannot read" in apart.stderr, "a rank without files: " + show(apart))


def timed(check, folder):
    begin = time.monotonic()
    shutil.copytree(f"{DATA}/window", folder / "window")
    check(folder)
    print(f"{check.__name__}: {time.monotonic() - begin:.1f} s")


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        if not MPIEXEC:
            done = run(["env", "OMPI_COMM_WORLD_RANK=1", PROGRAM, "bench", "--help"], folder)
            require(done.returncode == 2 and "built without MPI" in done.stderr, show(done))
            print("skipped: program/cli/ranks was not tried: this program was built without MPI")
            return
        # Most of their time the checks wait: for a log to grow, or for a planner to use up its time.
        checks = (check_killed_rank, check_ended_job, check_stopped_rank, check_benchmark, check_refusals)
        with concurrent.futures.ThreadPoolExecutor(len(checks)) as pool:
            for done in [pool.submit(timed, check, folder / check.__name__) for check in checks]:
                done.result()


main()
