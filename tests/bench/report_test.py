#!/usr/bin/env python3
"""Shows that `report --check` refuses what is wrong with a document, each fault by itself, and that `report` mends what it can.

Every case is a small repository of one document and one table.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

REPORT = pathlib.Path(__file__).with_name("report")
TABLE = """scene,scene_name,part_triangles,environment_triangles,poses,colliding,question,engine,over_question,over_engine,ratio,ratio_least,\
ratio_largest,repetitions,us_mean,us_median,node_visits,volume_tests,triangle_tests,refined_pairs,wrong,over_us_mean,over_us_median,\
over_node_visits,over_volume_tests,over_triangle_tests,over_refined_pairs,over_wrong
K,cembox-2,29956,499972,400,40,distance,clearway,distance,PQP,52.6,50,55,5,16.04,15,93,600,440,3,0,843,800,0,900,80,0,0
"""
SOUND = """# A document

A distance takes <!-- figure: queries-us distance -->16.0<!-- / --> us.

<!-- figures: queries-scenes -->
| name | scene, triangles of part / environment, poses |
|---|---|
| K | cembox-2, 30k / 500k, 10 % colliding |
<!-- end -->
"""


class Report(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        self.results = self.root / "tests/bench/results/epyc-2core"
        self.results.mkdir(parents=True)
        (self.results / "queries.csv").write_text(TABLE)
        self.document = self.root / "README.md"

    def report(self, *more):
        done = subprocess.run([sys.executable, REPORT, "--root", self.root, *more], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def refused(self, text, words):
        self.document.write_text(text)
        code, said = self.report("--check")
        self.assertEqual(code, 1, said)
        self.assertIn(words, said)
        self.assertEqual(self.document.read_text(), text, "--check writes nothing")

    def test_a_sound_document_passes(self):
        self.document.write_text(SOUND)
        self.assertEqual(self.report("--check"), (0, ""))

    def test_a_changed_figure_is_refused_and_written_anew(self):
        self.refused(SOUND.replace("16.0", "15.9"), "+A distance takes <!-- figure: queries-us distance -->16.0<!-- / --> us.")
        self.assertEqual(self.report()[0], 0)
        self.assertEqual(self.document.read_text(), SOUND)

    def test_a_changed_table_is_refused(self):
        self.refused(SOUND.replace("30k / 500k", "30k / 600k"), "+| K | cembox-2, 30k / 500k")

    def test_a_changed_measurement_is_refused(self):
        (self.results / "queries.csv").write_text(TABLE.replace("16.04", "21"))
        self.refused(SOUND, "-->21<!--")

    def test_a_typed_figure_is_refused(self):
        self.refused(SOUND + "\nA motion takes 30 to 36 us.\n", "README.md:11: '30 to 36 us' is typed")

    def test_a_figure_at_the_beginning_of_a_line_is_refused(self):
        self.refused(SOUND.replace("A distance takes <", "A distance takes\n<"), "begins with a figure")

    def test_marks_without_partner_are_refused(self):
        self.refused(SOUND.replace("<!-- end -->", ""), "has no partner")
        self.refused(SOUND.replace("<!-- / -->", ""), "has no partner")

    def test_unknown_figures_and_wrong_arguments_are_refused(self):
        self.refused(SOUND.replace("queries-us", "queries-ns"), "unknown figure 'queries-ns'")
        self.refused(SOUND.replace("queries-us distance", "queries-us"), "cannot be made")
        self.refused(SOUND.replace("queries-us distance", "queries-main"), "is a table, expected a figure")

    def test_what_no_table_holds_is_said_not_invented(self):
        self.document.write_text(SOUND + "\n<!-- figures: builds -->\n<!-- end -->\n")
        self.assertEqual(self.report()[0], 0)
        self.assertIn("<!-- figures: builds -->\n*Not measured yet.*\n<!-- end -->", self.document.read_text())
        self.assertEqual(self.report("--missing"), (0, "builds: builds.csv\n"))

    def test_a_peer_that_is_faster_is_named(self):
        for ratio, words in (("52.6", "Of 1 comparisons of queries, none is lost to a peer."), ("0.8", "| K | distance, clearway | distance, PQP | 0.80 |")):
            (self.results / "queries.csv").write_text(TABLE.replace(",52.6,", f",{ratio},"))
            self.document.write_text("<!-- figures: queries-losses -->\n<!-- end -->\n")
            self.assertEqual(self.report()[0], 0)
            self.assertIn(words, self.document.read_text())


if __name__ == "__main__":
    unittest.main()
