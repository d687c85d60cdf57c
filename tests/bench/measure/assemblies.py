"""The part `assemblies`: which parts of an assembly touch, and which come out one after the other, by whole processes."""

import csv
import json
import statistics

from from_files import timed
from place import Refused

OWN = ("pump",)
# Assemblies of others, below the folder of --checkouts.
OTHERS = {"Pump Assembly": "AutomatedAssemblyPlanner/examples/Pumps/Pump Assembly",
          "PumpWithThreadedBolts": "AutomatedAssemblyPlanner/examples/Pumps/PumpWithThreadedBolts",
          "TXT-Binary": "AutomatedAssemblyPlanner/examples/TXT-Binary"}
REPETITIONS = {"ci": 1, "quick": 1, "full": 3}
LIMIT = {"ci": 2, "quick": 20, "full": 20}  # seconds for a part
COLUMNS = ["assembly", "parts", "triangles", "overlaps", "contacts", "load_seconds", "pairs_seconds", "out", "last_out_seconds", "seconds"]


def file_of(place, row):
    if row in OWN:
        return next((place.root / "data" / row).glob(f"{row}.*"))
    if place.checkouts and (place.checkouts / OTHERS[row]).exists():
        return place.checkouts / OTHERS[row]
    raise Refused(f"the assembly '{row}' is not in the folder of --checkouts ({place.checkouts or 'not given'})")


def pairs(place, file):
    """The facts of `info`, and the medians of the seconds of a whole process with the pairs, on one core, and of one that only reads and builds."""
    command = [place.program(), "info", file, "--pairs", "--json", "-"]
    whole, loads = [], []
    for _ in range(REPETITIONS[place.form]):
        seconds, said = timed(place.pinned(*command))
        facts = json.loads(said.stdout)
        whole.append(seconds)
        loads.append(seconds - facts["pairs_seconds"])
    return facts, statistics.median(loads), statistics.median(whole)


def assemblies(place, row):
    file = file_of(place, row)
    facts, load_seconds, whole_seconds = pairs(place, file)
    kinds = [pair["kind"] for pair in facts["pairs"]]
    components = (facts.get("assembly") or facts["mesh"])["components"]
    seconds, _ = timed([place.program("demo_disassemble"), file, place.scratch / "apart", LIMIT[place.form]], (0, 1))
    with open(place.scratch / "apart/disassembly.csv", newline="") as order:
        after = [row["seconds"] for row in csv.DictReader(order) if row["order"]]
    made = {"assembly": row, "parts": len(components), "triangles": sum(component["triangles"] for component in components),
            "overlaps": kinds.count("overlap"), "contacts": kinds.count("contact"), "load_seconds": f"{load_seconds:.3g}",
            "pairs_seconds": f"{whole_seconds - load_seconds:.3g}", "out": len(after), "last_out_seconds": after[-1] if after else "",
            "seconds": f"{seconds:.3g}"}
    return COLUMNS, [{column: str(made[column]) for column in COLUMNS}]
