"""Tables and plot of a leaf-strategy study: those of docs/leaf_strategies.md, and `report --study` for a study of your own."""

import math
from statistics import median

from results import NotMeasured, Results, distinct, matching, numbers, read, shown, span, table
from svg import DARK, GREY, LIGHT, Log, Page, text_width

FILES = ("files", "qualified", "cells", "ratios", "trees", "claims")
NONE = "none"  # the leaf split that the others are compared with
GENERALS = ("sah", "axis", "mean")
BEST = "sah/none"  # the tree that planners qualify in
USUAL = {"leaf_size": "4", "node_width": "8", "instructions": "best"}

COLOURS = {"chain": "#1b9e77", "edge": "#d95f02", "all": "#7570b3", "cost": "#e7298a"}
PARTS = {"loading": "#bdbdbd", "building": "#737373", "volumes": "#4393c3", "triangles": "#d6604d", "elsewhere": "#e4e4e4"}
TICKS = (0.2, 0.3, 0.5, 0.7, 1, 1.4, 2, 3, 5, 7, 10)
PAGE, LINE, GAP = 1100, 30, 36  # pixels: of the page's width, of a line's height, between panels
SHIFT = 6  # between the leaf splits of a line


def joined(folders):
    """The results of a study whose scenes may have folders of their own."""
    results = Results(folders[0])
    for name in FILES:
        results.tables[f"leaf_strategies/{name}"] = [row for folder in folders for row in read(folder / f"{name}.csv")]
    return results


def mean(values):
    """The geometric mean."""
    return math.exp(sum(map(math.log, values)) / len(values))


def per_cent(ratio):
    """A ratio as a change: -12 %, +30 %; from twice on as a factor."""
    if ratio >= 1.995:
        return f"{ratio:.1f} x"
    change = round(100 * (ratio - 1))
    return f"{change:+d} %" if change else "0 %"


def changes(values):
    """The geometric mean, and the least and the largest."""
    if not values:
        return "-"
    return f"{per_cent(mean(values))} ({per_cent(min(values))} to {per_cent(max(values))})"


def ratios(results, source, measure, general, leaf, baseline):
    """The rows of a tree over another one, without those of all planners together for runs, and with them alone for replays."""
    rows = matching(results.rows("leaf_strategies/ratios"), source=source, measure=measure, general_split=general, leaf_split=leaf,
                    baseline=baseline, **USUAL)
    return [row for row in rows if (row["planner"] == "all") == (source == "replay")]


def by_scene(rows):
    """From a scene to the ratios of its planners."""
    found = {}
    for row in rows:
        found.setdefault(row["scene"], []).append(float(row["ratio"]))
    return found


def scene_means(rows):
    """A geometric mean over the planners for each scene, so that scenes count alike."""
    return [mean(values) for values in by_scene(rows).values()]


def certain(rows):
    gains = sum(float(row["high"]) < 1 for row in rows)
    losses = sum(float(row["low"]) > 1 for row in rows)
    return f"{gains}, {losses} of {len(rows)}"


def leaves(results, general, leaf):
    """How many times as many leaves both trees have as without leaf splits, in each scene."""
    counts = {(row["scene"], row["leaf_split"]): int(row["leaves"]) for row in results.select("leaf_strategies/files", general_split=general)}
    return [count / counts[scene, NONE] for (scene, split), count in counts.items() if split == leaf and (scene, NONE) in counts]


def trees(results):
    """All trees, each with its leaf splits and over which tree they are measured."""
    rows = results.rows("leaf_strategies/ratios")
    present = set(distinct(rows, "general_split"))
    for general in (name for name in GENERALS if name in present):
        if f"{general}/{NONE}" != BEST:
            yield general, NONE, BEST
        for leaf in COLOURS:
            if any(row["leaf_split"] == leaf for row in rows):
                yield general, leaf, f"{general}/{NONE}"


def summary(results):
    """A row a tree; each cell is the geometric mean over the scenes, with the range of the scenes."""
    lines = []
    for general, leaf, baseline in trees(results):
        files, planning, asked = (ratios(results, source, measure, general, leaf, baseline)
                                  for source, measure in (("runs", "files_to_path"), ("runs", "planning"), ("replay", "seconds")))
        more = changes(leaves(results, general, leaf)) if leaf != NONE else ""
        lines.append([f"`{general}/{leaf}` over `{baseline}`", changes(scene_means(files)), changes(scene_means(planning)), certain(planning),
                      changes(scene_means(asked)), more])
    return table(["tree", "files to path", "planning", "planners certainly faster, slower", "same queries again", "leaves"], lines)


def shares(cells):
    """Medians over the planners of the time's shares in volumes and in triangles, or nothing."""
    known = [row for row in cells if row["volume_share"]]
    if not known:
        return None
    return [median(numbers(known, column)) for column in ("volume_share", "triangle_share")]


def scenes(results):
    """A row a scene, in trees of sah: what the time is spent on, and what the leaf splits change."""
    lines = []
    cells = results.rows("leaf_strategies/cells")
    for scene in distinct(cells, "scene"):
        own = matching(cells, scene=scene, general_split="sah", leaf_split=NONE)
        files = results.row("leaf_strategies/files", scene=scene, general_split="sah", leaf_split=NONE)
        found = shares(own)
        line = [scene, shown(int(files["triangles"])), shown(float(files["load_seconds"]) + float(files["build_seconds"])),
                f"{span(numbers(own, 'planning_seconds'), shown)} ({len(own)})",
                f"{100 * found[0]:.0f}, {100 * found[1]:.0f} %" if found else "-"]
        for leaf in ("chain", "edge", "all", "cost"):
            line.append("; ".join(per_cent(mean(values)) if values else "-" for values in (
                scene_values(ratios(results, "runs", measure, "sah", leaf, BEST), scene) for measure in ("files_to_path", "planning"))))
        lines.append(line)
    return table(["scene", "triangles", "s of loading and building", "s of planning (planners)", "time in volumes, triangles",
                  "`chain`: files to path; planning", "`edge`", "`all`", "`cost`"], lines)


def scene_values(rows, scene):
    return by_scene(rows).get(scene, [])


def claims(results):
    """How many scenes each verdict on a claim of the thesis has, by engine."""
    rows = results.rows("leaf_strategies/claims")
    lines = []
    for claim in distinct(rows, "claim"):
        cells = []
        for width in ("2", "8"):
            of = matching(rows, claim=claim, node_width=width)
            cells.append(", ".join(f"{verdict} in {len(matching(of, verdict=verdict))}" for verdict in distinct(of, "verdict")))
        lines.append([claim, span(numbers(matching(rows, claim=claim), "thesis_ratio"), shown)] + cells)
    return table(["the thesis's claim", "its ratio", "in its own engine, scenes", "in clearway's, scenes"], lines)


def answer(results):
    """The study's two sentences."""
    file = results.folder / "leaf_strategies" / "answer.txt"
    if not file.exists():
        raise NotMeasured(str(file))
    return [f"> {line}" for line in file.read_text(encoding="utf-8").splitlines()]


def all_tables(results):
    """The tables of a study, one after the other; those that it has no runs for are left out."""
    lines = []
    for make in (summary, scenes, claims):
        try:
            lines += make(results) + [""]
        except NotMeasured:
            continue
    return lines


def draw_ratios(page, results, general, names, left, right, top, limits):
    """A panel: for each scene and leaf split the time over no leaf split, files to path (full) and planning (hollow)."""
    x = Log(*limits, left, right)
    bottom = top + LINE * len(names)
    for tick in TICKS:
        if limits[0] <= tick <= limits[1]:
            page.line(x(tick), top, x(tick), bottom, DARK if tick == 1 else LIGHT, 0.8)
            page.text(x(tick), bottom + 14, f"{tick:g}x" if tick >= 2 else per_cent(tick)[:-2], 12, "middle")
    page.text(left, top - 8, f"trees of {general}", 13)
    for k, leaf in enumerate(COLOURS):
        for measure, full in (("planning", False), ("files_to_path", True)):
            rows = by_scene(ratios(results, "runs", measure, general, leaf, f"{general}/{NONE}"))
            for i, scene in enumerate(names):
                if scene not in rows:
                    continue
                y = top + LINE * (i + 0.5) + SHIFT * (k - (len(COLOURS) - 1) / 2)
                low, middle, high = (x(min(max(value, limits[0]), limits[1])) for value in (min(rows[scene]), mean(rows[scene]), max(rows[scene])))
                if not full:
                    page.line(low, y, high, y, COLOURS[leaf], 0.8)
                page.mark("circle", middle, y, COLOURS[leaf], 2.6, full)


def draw_shares(page, results, names, left, right, top):
    """A panel: what the time from files to a path is spent on, in trees of sah without leaf splits."""
    cells = results.rows("leaf_strategies/cells")
    page.text(left, top - 8, "where time in sah/none goes", 13)
    for i, scene in enumerate(names):
        files = results.row("leaf_strategies/files", scene=scene, general_split="sah", leaf_split=NONE)
        own = matching(cells, scene=scene, general_split="sah", leaf_split=NONE)
        found = shares(own)
        planning = median(numbers(own, "planning_seconds") or [0])
        parts = [float(files["load_seconds"]), float(files["build_seconds"])]
        parts += [planning * share for share in found] if found else [0, 0]
        parts.append(sum(parts[:2]) + planning - sum(parts))
        whole, begin = sum(parts), left
        for colour, part in zip(PARTS.values(), parts):
            end = begin + (right - left) * max(part, 0) / whole
            page.line(begin, top + LINE * (i + 0.5), end, top + LINE * (i + 0.5), colour, 12)
            begin = end


def plot(results):
    """The text of the SVG file: one panel a general split, a line a scene; the last panel says what the time is spent on."""
    rows = results.rows("leaf_strategies/ratios")
    names = [name for name in distinct(results.rows("leaf_strategies/files"), "scene") if any(row["scene"] == name for row in rows)]
    generals = [general for general in GENERALS if any(row["general_split"] == general for row in rows)]
    page = Page(PAGE, LINE * len(names) + 150)
    labels = 30 + max(text_width(name, 12) for name in names)
    width = (PAGE - labels) / (len(generals) + 1)
    top = 30
    for i, name in enumerate(names):
        page.text(labels - 10, top + LINE * (i + 0.5) + 4, name, 12, "end")
    for k, general in enumerate(generals):
        left = labels + width * k
        draw_ratios(page, results, general, names, left, left + width - GAP, top, (0.5, 5))
    draw_shares(page, results, names, labels + width * len(generals), PAGE - GAP, top)
    bottom = top + LINE * len(names)
    page.text(labels, bottom + 34, f"per cent of time over '{NONE}' in the same trees; bars span the planners", 12)
    entries = [("circle", colour, True, split) for split, colour in COLOURS.items()]
    entries += [("circle", GREY, True, "from files to path"), ("circle", GREY, False, "planning alone")]
    page.legend(entries, 40, bottom + 64)
    page.legend([("square", colour, True, part) for part, colour in PARTS.items()], 40, bottom + 90)
    return page.write()
