#!/usr/bin/env python3
"""Shows that `run` merges, compares and refuses as it says, without measuring anything."""

import contextlib
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import types
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "measure"), str(HERE / "figures")]

import compare
import importlib.machinery
import importlib.util
import machine
import own_meshes
import tables
from parts import FORMS, PARTS
from place import Place, Refused

MACHINE = {"cpu": "A", "cores": "2", "memory_gb": "8", "instruction_set": "avx2"}
PART = types.SimpleNamespace(name="part", keys=("scene",), shown=("us",), is_shown=lambda row: row["scene"] != "hidden")


def load_run():
    loader = importlib.machinery.SourceFileLoader("run", str(HERE / "run"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("run", loader))
    loader.exec_module(module)
    return module


RUN = load_run()


class Tables(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_new_rows_replace_those_of_their_group_and_others_stay(self):
        file = self.folder / "t.csv"
        old = [{"scene": "K", "peer": "PQP"}, {"scene": "K", "peer": "Coal"}, {"scene": "L", "peer": "PQP"}]
        tables.merge(file, ["scene", "peer"], old, ("scene",))
        tables.merge(file, ["scene", "peer"], [{"scene": "K", "peer": "FCL"}], ("scene",))
        self.assertEqual(tables.read(file)[1], [{"scene": "L", "peer": "PQP"}, {"scene": "K", "peer": "FCL"}])

    def test_repetitions_give_the_median_with_its_range(self):
        each = [(["scene", "us"], [{"scene": "K", "us": value}]) for value in ("3", "1", "2.5")]
        columns, rows = tables.median_of(each, ("scene",), ("us",))
        self.assertEqual(columns, ["scene", "us", "repetitions", "us_least", "us_largest"])
        self.assertEqual(rows, [{"scene": "K", "us": "2.5", "repetitions": 3, "us_least": "1", "us_largest": "3"}])

    def test_results_of_another_machine_are_not_mixed(self):
        tables.write(self.folder / "runs.csv", list(MACHINE), [dict(MACHINE, cpu="B")])
        with self.assertRaisesRegex(Refused, "results of another machine"):
            RUN.refuse_other_machine(self.folder, MACHINE)
        tables.write(self.folder / "runs.csv", list(MACHINE), [MACHINE])
        RUN.refuse_other_machine(self.folder, MACHINE)

    def test_unknown_parts_and_rows_are_refused_by_name(self):
        for names, words in ((["queri"], "there is no part 'queri'"), (["queries/Z"], "has no row 'Z'")):
            with self.assertRaisesRegex(ValueError, words):
                RUN.chosen(names, "quick")

    def test_studies_run_only_when_named_and_every_form_measures_something(self):
        for form in FORMS:
            parts = [part for part, _ in RUN.chosen([], form)]
            self.assertTrue(parts)
            self.assertFalse([part.name for part in parts if part.is_study])
        self.assertEqual([row for _, row in RUN.chosen(["samplers_window"], "quick")], ["window"])
        for part in PARTS:
            self.assertLessEqual(set(part.quick_rows), set(part.rows), part.name)

    def test_each_program_is_made_once_when_it_is_named(self):
        made = []
        place = Place("ci", self.folder, self.folder, self.folder, make=made.append)
        for name in ("queries", "motions"):
            place.benchmark(name)
        place.program("clearway-scene")
        self.assertEqual(made, ["benchmarks", "clearway_scene_program"])

    def test_a_disturbed_row_is_measured_again_and_the_calmest_kept(self):
        shares = iter([0.5, 0.2, 0.4])

        class Disturbed:
            def disturbance(self):
                return next(shares)

        attempts = []
        part = types.SimpleNamespace(name="part", repetitions={}, spread=(), keys=("scene",), commands=lambda place, row: [],
                                     table=lambda place, row: attempts.append(row) or (["scene"], [{"scene": len(attempts)}]))
        given = types.SimpleNamespace(form="full", build=self.folder, checkouts=None, cpu=0, make=lambda target: None)
        watch, RUN.Watch = RUN.Watch, Disturbed
        self.addCleanup(setattr, RUN, "Watch", watch)
        with contextlib.redirect_stderr(io.StringIO()) as said:
            _, rows, record = RUN.measure(part, "K", given)
        self.assertEqual((len(attempts), rows, record["others_share"]), (3, [{"scene": 2}], "0.200"))
        self.assertIn("part/K: other work took 50 % of the processors", said.getvalue())


class Compare(unittest.TestCase):
    def lines(self, measured, expected, refused=""):
        return "\n".join(compare.compare(PART, measured, expected, refused))

    def test_a_figure_far_off_and_outside_both_ranges_is_called_different(self):
        row = {"scene": "K", "us": "10", "us_least": "9.5", "us_largest": "11"}
        self.assertIn("| K | us | 20 | 10.0 (9.5 to 11.0) | 0.50, different |", self.lines([row], [{"scene": "K", "us": "20"}]))
        self.assertNotIn("hidden", self.lines([row, {"scene": "hidden", "us": "1"}], []))
        wide = {"scene": "K", "us": "20", "us_least": "10", "us_largest": "30"}
        self.assertIn("| 0.50 |", self.lines([row], [wide]))

    def test_figures_of_another_machine_are_shown_but_not_compared(self):
        self.assertIn("another machine", compare.refusal(dict(MACHINE, cpu="B"), MACHINE))
        self.assertIn("do not say which machine", compare.refusal(None, MACHINE))
        self.assertEqual(compare.refusal(dict(MACHINE, date="x"), MACHINE), "")
        self.assertIn("| K | us | 20 | 10.0 | - |", self.lines([{"scene": "K", "us": "10"}], [{"scene": "K", "us": "20"}], "why"))


class Machine(unittest.TestCase):
    STAT = "cpu  {} 10 20 5000 7 1 2 {} 0 0\ncpu0 1 2 3\n"

    def test_busy_time_counts_all_work_and_what_the_host_took(self):
        hertz = os.sysconf("SC_CLK_TCK")
        self.assertAlmostEqual(machine.busy_seconds(self.STAT.format(100, 50)), 183 / hertz)

    def test_own_work_is_no_disturbance(self):
        """Others may be busy here, so the clock of the machine is one that saw this process and its child alone."""
        own = machine.own_seconds()
        watch = machine.Watch.__new__(machine.Watch)
        watch.busy = lambda: 100 + machine.own_seconds() - own
        watch.began = (time.monotonic(), 100.0, own)
        subprocess.run([sys.executable, "-c", "sum(range(3000000))"], check=True)
        self.assertLess(watch.disturbance(), 0.01)
        watch.busy = lambda: 100 + machine.own_seconds() - own + 0.5 * os.cpu_count()
        self.assertGreater(watch.disturbance(), 0.05)

    def test_a_folder_that_is_no_checkout_of_its_own_has_no_commit(self):
        self.assertEqual(machine.commit_of(HERE), "")


class Advice(unittest.TestCase):
    def row(self, strategy, over, largest, build, us, repetitions="3"):
        return {"strategy": strategy, "question": "distance", "over_default": over, "over_default_largest": largest, "build_seconds": build,
                "us_mean": us, "repetitions": repetitions}

    def test_a_strategy_is_advised_when_it_is_certainly_faster(self):
        default = self.row("sah/none", "1", "1", "2", "10")
        line = own_meshes.advice_for([default, self.row("axis/chain", "0.8", "0.9", "3", "8")], "distance")
        self.assertIn("--general-split axis --leaf-split chain; it takes 20 % less time than the default", line)
        self.assertIn("For fewer than 500,000 queries --general-split sah --leaf-split none is done sooner", line)
        for uncertain in (self.row("axis/chain", "0.8", "1.1", "3", "8"), self.row("axis/chain", "0.8", "0.8", "3", "8", "1")):
            line = own_meshes.advice_for([default, uncertain], "distance")
            self.assertIn("the default, sah/none; none is certainly faster", line)


if __name__ == "__main__":
    unittest.main()
