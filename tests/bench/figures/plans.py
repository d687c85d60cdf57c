"""Tables of the planner studies: plan_*.csv, samplers_*.csv, anytime_clearance.csv."""

import statistics

from results import NotMeasured, distinct, matching, median_with_range, numbers, seconds, shown, table, whole

# Problems whose folder's name says too little.
NAMES = {"elk/elk": "Elk v1.75", "tunnel-console-3-2mm/tunnel-console": "tunnel-console-3, clearance 2 mm",
         "tunnel-console-3/tunnel-console": "tunnel-console-3, clearance 10 mm", "tunnel-console-small/tunnel-console": "tunnel-console-small",
         "problem": "tunnel-console-3, clearance 10 mm"}
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
    """A row a problem, ours first, by the median."""
    rows = results.rows("plan_first_path")
    lines = []
    for problem in distinct(rows, "problem"):
        of = matching(rows, problem=problem)
        times = times_of(of)
        found = sum(row["found"] == "1" for row in of)
        is_other = is_omplapp(problem) or problem == "elk/elk"
        lines.append((is_other, statistics.median(times),
                      [name_of(problem), f"{found} of {len(of)}", seconds(statistics.median(times)), seconds(max(times)),
                       str(sum(int(row["colliding_by_oracle"]) > 0 for row in of))]))
    lines.sort(key=lambda line: line[:2])
    return table(["problem", "solved", "median, s", "worst, s", "refuted by the oracle"], [line[2] for line in lines])


def problems(results):
    return whole(len(distinct(results.rows("plan_first_path"), "problem")))


def median_seconds(results, problem, worst=""):
    """The median, or with 'worst' the longest, time to a first path."""
    times = times_of(results.select("plan_first_path", problem=problem))
    return seconds(max(times) if worst else statistics.median(times))


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
        if not widest and problem.startswith("tunnel-console-3/"):
            widest = matching(results.rows("plan_widest"), problem="problem")
        lines.append([name_of(problem), own_room(results, problem),
                      shown(statistics.median(numbers(first, "least_clearance"))) if first else "",
                      median_with_range(numbers(found, "least_clearance"), tenths), shown(statistics.median(numbers(found, "room_seconds"))),
                      tenths(statistics.median(numbers(widest, "least_clearance"))) if widest else ""])
    return table(["scene", "scene's own", "first path", "with room, median (range)", "seconds for room", "with the objective"], lines)


def tenths(value):
    return f"{float(value):.1f}"


def room_of(results, problem, column="least_clearance"):
    return tenths(statistics.median(numbers(results.select("plan_room", problem=problem), column)))


def degrees(results, table_name, problem):
    return f"{statistics.median(numbers(results.select(table_name, problem=problem), 'turned_degrees')):.0f}"


def longest(results, table_name):
    """The longest run of a study of one problem, and how many runs found a path."""
    rows = results.rows(table_name)
    found = sum(row["found"] == "1" for row in rows)
    return f"{found} of {len(rows)} seeds, the slowest in {seconds(max(numbers(rows, 'planning_seconds')))} s"


def console(results):
    """tunnel-console at full size, by the clearance asked for."""
    tight = results.select("plan_first_path", problem="tunnel-console-3-2mm/tunnel-console")
    wide = results.select("plan_room", problem="tunnel-console-3/tunnel-console")
    found = [f"{sum(row['found'] == '1' for row in rows)} of {len(rows)}" for rows in (wide, tight)]
    times = [f"{seconds(statistics.median(times_of(rows)))} s ({seconds(max(times_of(rows)))})" for rows in (wide, tight)]
    return table(["two cores", "clearance 10", "clearance 2"],
                 [["solved"] + found, ["first path, median (worst)"] + times,
                  ["certified with room, median", tenths(statistics.median(numbers(wide, "least_clearance"))), ""]])


def widest_console(results):
    rows = [row for row in results.rows("plan_widest") if row["problem"] in ("problem", "tunnel-console-3/tunnel-console")]
    if not rows:
        raise NotMeasured("plan_widest.csv, tunnel-console-3")
    return median_with_range(numbers(rows, "least_clearance"), tenths)


def samplers(results):
    rows = results.rows("samplers_window")
    lines = []
    for name in distinct(rows, "sampler"):
        of = matching(rows, sampler=name)
        found = sum(row["found"] == "1" for row in of)
        lines.append([name, f"{found} of {len(of)}", seconds(statistics.median(times_of(of)))])
    return table(["sampler", "found", "seconds, median"], lines)


def samplers_found(results, name):
    rows = results.rows(name)
    return f"{sum(row['found'] == '1' for row in rows)} of {len(rows)}"


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
    return table(["planner"] + [f"{shown(time)} s" for time in times], lines)


def anytime_first(results, scene="posts"):
    return shown(statistics.median(numbers(results.select("anytime_clearance", scene=scene, planner="RRTConnect"), "certified_clearance")))


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
