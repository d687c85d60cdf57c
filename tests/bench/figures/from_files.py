"""Tables of from_files.csv: whole processes, from files to a path and to the first answer."""

from results import distinct, matching, seconds, table

PATHS = ("plan", "plan --quick", "RRTConnect with FCL")


def cell(rows, what):
    of = matching(rows, what=what)
    if not of:
        return ""
    row = of[0]
    found = "" if row["found"] in ("", row["runs"]) else f", {row['found']} of {row['runs']} found"
    free = "" if row["free"] in ("", row["found"]) else f", {row['free']} free"
    return f"{seconds(row['seconds'])} s{found}{free}"


def paths(results):
    rows = results.rows("from_files")
    return table(["files to a path"] + [f"`{name}`" if name.startswith("plan") else name for name in PATHS],
                 [[scene] + [cell(matching(rows, scene=scene), name) for name in PATHS] for scene in distinct(rows, "scene")])


def answers(results):
    rows = [row for row in results.rows("from_files") if row["what"].startswith("first answer, ")]
    names = [what.removeprefix("first answer, ") for what in distinct(rows, "what")]
    return table(["files to the first answer"] + names,
                 [[scene] + [cell(matching(rows, scene=scene), f"first answer, {name}") for name in names] for scene in distinct(rows, "scene")])


def main_row(results):
    """The README's: a column a scene."""
    rows = results.rows("from_files")
    scenes = distinct(rows, "scene")
    return table(["from two files to a path, whole process"] + scenes,
                 [[title] + [cell(matching(rows, scene=scene), name) for scene in scenes]
                  for title, name in (("`clearway plan --quick`", "plan --quick"), ("RRTConnect with FCL, in steps", "RRTConnect with FCL"))])
