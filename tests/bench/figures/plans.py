"""Tables of the planner studies: plan_*.csv, samplers_*.csv, anytime_clearance.csv."""

import statistics

from results import distinct, matching, median_with_range, numbers, seconds, shown, table, whole

# Problems whose folder's name says too little.
NAMES = {"elk/elk": "Elk v1.75", "tunnel-console-3-2mm/tunnel-console": "tunnel-console-3, clearance 2 mm",
         "tunnel-console-3/tunnel-console": "tunnel-console-3, clearance 10 mm", "tunnel-console-small/tunnel-console": "tunnel-console-small"}
# The clearance of the scene's own path, as `clearway check` certifies it, or of its widest gate, or of the window the part must pass.
OWN = {"bracket/bracket": "6.5", "angle/angle": "5", "gates/gates": "12", "tunnel-console-small/tunnel-console": "11.56"}


def name_of(problem):
    return NAMES.get(problem, problem.split("/")[-1])


def is_omplapp(problem):
    return problem.startswith("3D/")


def times_of(rows, limit=float("inf")):
    """Seconds of the runs; runs without a path count with the limit."""
    return [float(row["planning_seconds"]) if row["found"] == "1" else limit for row in rows]


def first_paths(results):
    """A row a problem, ours first, by the median; of the bracket, a second one with more seeds."""
    rows = results.rows("plan_first_path")
    lines = []
    for problem in distinct(rows, "problem"):
        is_other = is_omplapp(problem) or problem == "elk/elk"
        lines.append((is_other, first_path(name_of(problem), matching(rows, problem=problem))))
    if results.has("plan_bracket"):
        lines.append((False, first_path("bracket, more seeds", results.rows("plan_bracket"))))
    lines.sort(key=lambda line: (line[0], line[1][0]))
    return table(["problem", "solved", "median, s", "worst, s", "refuted by the oracle"], [cells for _, (_, cells) in lines])


def first_path(name, rows):
    """The median, and the cells of a row."""
    times = times_of(rows)
    middle = statistics.median(times)
    return middle, [name, solved(rows), seconds(middle), seconds(max(times)), str(sum(int(row["colliding_by_oracle"]) > 0 for row in rows))]


def solved(rows):
    return f"{sum(row['found'] == '1' for row in rows)} of {len(rows)}"


def problems(results):
    return whole(len(distinct(results.rows("plan_first_path"), "problem")))


def median_seconds(results, problem):
    return seconds(statistics.median(times_of(results.select("plan_first_path", problem=problem))))


def own_room(results, problem):
    if problem == "tunnel-console-3/tunnel-console":
        return f"{float(results.row('scenes', scene='tunnel-console-3', clearance_asked='10')['clearance_certified']):.2f}"
    return OWN.get(problem, "")


def room(results):
    lines = []
    for problem in distinct(results.rows("plan_room"), "problem"):
        with_room = results.select("plan_room", problem=problem)
        found = [row for row in with_room if row["found"] == "1"]
        first = matching(results.rows("plan_first_path"), problem=problem)
        widest = matching(results.rows("plan_widest"), problem=problem) if results.has("plan_widest") else []
        lines.append([name_of(problem), own_room(results, problem),
                      shown(statistics.median(numbers(first, "least_clearance"))) if first else "",
                      median_with_range(numbers(found, "least_clearance"), tenths), shown(statistics.median(numbers(found, "room_seconds"))),
                      tenths(statistics.median(numbers(widest, "least_clearance"))) if widest else ""])
    return table(["scene", "scene's own", "first path", "widened, median (range)", "seconds of widening", "with the objective"], lines)


def tenths(value):
    return f"{float(value):.1f}"


def console(results):
    """tunnel-console at full size, by the clearance asked for."""
    tight = results.select("plan_first_path", problem="tunnel-console-3-2mm/tunnel-console")
    wide = results.select("plan_room", problem="tunnel-console-3/tunnel-console")
    widest = results.select("plan_widest", problem="tunnel-console-3/tunnel-console")
    times = [f"{seconds(statistics.median(times_of(rows)))} s ({seconds(max(times_of(rows)))})" for rows in (wide, tight)]
    return table(["two cores", "clearance 10", "clearance 2"],
                 [["solved", solved(wide), solved(tight)], ["first path, median (worst)"] + times,
                  ["certified after widening, median", tenths(statistics.median(numbers(wide, "least_clearance"))), ""],
                  [f"certified with the objective, median (range) of {len(widest)} seeds",
                   median_with_range(numbers(widest, "least_clearance"), tenths), ""]])


def samplers(results):
    rows = results.rows("samplers_window")
    hard = results.rows("samplers_tunnel_console_small")
    return table(["sampler", "found", "seconds, median", "found, tunnel-console-small"],
                 [[name, solved(of), seconds(statistics.median(times_of(of))), solved(matching(hard, sampler=name))]
                  for name in distinct(rows, "sampler") for of in [matching(rows, sampler=name)]])


def anytime(results, scene="posts"):
    """Medians over the seeds of the certified least clearance, by planner and time; seeds without a path count as worst."""
    rows = [row for row in results.select("anytime_clearance", scene=scene) if row["planner"] not in ("FMT", "RRTConnect")]
    times = sorted(distinct(rows, "seconds"), key=float)
    lines = []
    for planner in distinct(rows, "planner"):
        of = matching(rows, planner=planner)
        cells = []
        for time in times:
            at = [float(row["certified_clearance"]) if row["certified_clearance"] else None for row in matching(of, seconds=time)]
            known = sum(value is not None for value in at)
            median = statistics.median([-1.0 if value is None else value for value in at])
            cells.append((shown(median) if median >= 0 else "-") + (f" ({known})" if known < len(at) else ""))
        more = of[0]["parameters"].replace("=", " ")
        lines.append([f"{planner}, {more}" if more else planner] + cells)
    first = numbers(results.select("anytime_clearance", scene=scene, planner="RRTConnect"), "certified_clearance")
    lines.append(["RRTConnect's first path"] + [shown(statistics.median(first))] * len(times))
    return table(["planner"] + [f"{shown(time)} s" for time in times], lines)


def fmt(results, scene="posts"):
    rows = results.select("anytime_clearance", scene=scene, planner="FMT")
    samples = sorted(distinct(rows, "parameters"), key=lambda text: int(text.split("=")[1]))
    lines = []
    for objective in distinct(rows, "objective"):
        cells = []
        for parameters in samples:
            costs = numbers(matching(rows, objective=objective, parameters=parameters), "cost")
            cells.append(shown(statistics.median(costs)) if costs else "")
        lines.append([f"cost by '{objective}'"] + cells)
    return table(["FMT's samples"] + [text.split("=")[1] for text in samples], lines)
