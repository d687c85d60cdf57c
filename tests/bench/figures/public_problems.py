"""The tables of docs/public_problems.md, from those that `benchmarks public` writes."""

import json
import pathlib

from results import distinct, matching, median_with_range, seconds, shown, table

OURS = "clearway"
FCL = "RRTConnect+FCL"


def manifests():
    """The name and the content of each file of data/problems."""
    folder = pathlib.Path(__file__).resolve().parents[3] / "data" / "problems"
    return [(file.stem, json.loads(file.read_text())) for file in sorted(folder.glob("*.json"))]


def sources(results):
    lines = []
    for name, manifest in manifests():
        problems = manifest.get("problems", [])
        lists = {"problems": problems, "paths": [path for problem in problems for path in problem.get("paths", [])],
                 "assemblies": manifest.get("assemblies", [])}
        address = manifest["repository"]
        lines.append([name, f"[{address.removeprefix('https://github.com/')}]({address})", manifest["commit"][:7],
                      *(str(len(items) or "") for items in lists.values()), manifest["licence"]])
    return table(["folder", "repository", "commit", "problems", "paths", "assemblies", "licence"], lines)


def new(results):
    """The problems with published times, and those that `benchmarks public` has not measured yet, with the figures of their manifests."""
    measured = distinct(results.rows("public/runs"), "problem")
    return table(["problem", "published", "best seconds", "largest clearance"],
                 [[problem["name"], problem.get("published", ""), *(shown(problem[key]) if key in problem else "" for key in ("seconds", "clearance"))]
                  for _, manifest in manifests() for problem in manifest.get("problems", [])
                  if "published" in problem or problem["name"] not in measured and not {"config", "paths"} <= set(problem)])


def count(rows, column="valid"):
    return f"{sum(row[column] == '1' for row in rows)} of {len(rows)}"


def posed(results):
    """The runs on files that pose a problem; others, such as one whose goal is not valid, have a note with all of clearway's runs."""
    rows = results.rows("public/runs")
    problems = {row["problem"] for row in rows if row["contender"] == OURS and not row["note"]}
    return [row for row in rows if row["problem"] in problems]


def runs(results):
    """Seconds are those of the runs that found a path; the median counts the others as the limit."""
    rows = posed(results)
    others = [name for name in distinct(rows, "contender") if name not in (OURS, FCL)]
    problems = distinct(rows, "problem")
    lines = []
    for problem in problems:
        of = {name: [r for r in rows if (r["problem"], r["contender"]) == (problem, name)] for name in [OURS, FCL, *others]}
        ours = of[OURS]
        solved = [row for row in ours if row["valid"] == "1"]
        lines.append(
            [problem, count(ours), median_with_range([float(r["seconds"]) for r in ours], seconds)]
            + [median_with_range([float(r["clearance"]) for r in solved])]
            + [" / ".join(str(sum(r["valid"] == "1" for r in of[name])) for name in others if of[name])]
            + [f"{sum(r['found'] == '1' for r in of[FCL])} found, {sum(r['valid'] == '1' for r in of[FCL])} valid" if of[FCL] else ""]
        )
    fcl = matching(rows, contender=FCL, found="1")
    hits = sum(float(row["colliding_by_oracle"] or 0) > 0 for row in fcl if row["valid"] != "1")
    compared = distinct(matching(rows, contender=others[0]), "problem")
    any_seed = [len(distinct(matching(rows, contender=name, valid="1"), "problem")) for name in (OURS, *others)]
    lines.append(["with any seed", f"{any_seed[0]} of {len(problems)}", "", "", f"{' / '.join(map(str, any_seed[1:]))} of {len(compared)}",
                  f"{len(fcl)} found, {sum(row['valid'] == '1' for row in fcl)} valid; the oracle's samples hit {hits}"])
    return table(["problem", "solved", "seconds, median (range)", "clearance, median (range)", " / ".join(others), "RRTConnect + FCL"], lines)


def parts(results):
    rows = results.rows("public/parts")
    lines = []
    for assembly in distinct(rows, "assembly"):
        parts = [row for row in rows if row["assembly"] == assembly]
        found = [row for row in parts if row["found"] == "1"]
        straight = [row for row in parts if row["found"] != "1" and row["straight"] not in ("", "0")]
        lines.append(
            [assembly, str(len(parts)), str(sum(row["touching"] != "0" for row in parts)), str(len(found)), str(len(straight))]
            + [str(sum(row["note"] != "" for row in parts))]
            + [median_with_range([float(row["seconds"]) for row in found], seconds)]
            + [median_with_range([float(row["preparing_seconds"]) for row in parts], seconds)]
        )
    return table(
        ["assembly", "parts", "touch others", "taken out", "only straight", "refused", "seconds, median (range)", "preparing"],
        lines,
    )


def paths(results):
    return table(["problem", "path", "segments", "not valid", "confirmed", "least clearance"],
                 [[row["problem"], row["path"], row["segments"], row["not_valid"], row["confirmed"], shown(row["least_clearance"])]
                  for row in results.rows("public/paths")])


def segments(results):
    """The motions of published paths that are not valid."""
    lines = []
    for row in results.rows("public/invalid_segments"):
        pose = " ".join(row[key] for key in ("x", "y", "z", "qx", "qy", "qz", "qw"))
        lines.append([row["problem"], row["segment"], row["t"], pose,
                      f"{row['part_triangle']} of {row['part_mesh']}, {row['environment_triangle']} of {row['environment_mesh']}"])
    return table(["problem", "segment", "t", "pose (x y z qx qy qz qw)", "triangles"], lines)
