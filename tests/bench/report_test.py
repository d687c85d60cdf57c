#!/usr/bin/env python3
"""Shows that `report --check` refuses what is wrong with a document, each fault by itself, that `report` mends what it can, and that the
committed plots show all of their text.

Every case of a document is a small repository of one document and one table.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

REPORT = pathlib.Path(__file__).with_name("report")
TABLE = """scene,scene_name,part_triangles,environment_triangles,poses,colliding,question,engine,over_question,over_engine,ratio,ratio_least,\
ratio_largest,repetitions,us_mean,us_median,node_visits,volume_tests,triangle_tests,refined_pairs,wrong,over_us_mean,over_us_median,\
over_node_visits,over_volume_tests,over_triangle_tests,over_refined_pairs,over_wrong
K,cembox-2,29956,499972,400,40,distance,clearway,distance,PQP,52.6,50,55,5,16.04,15,93,600,440,3,0,843,800,0,900,80,0,0
"""
SOUND = """# A document

<!-- figures: queries.scene_list -->
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

    def test_a_changed_table_is_refused(self):
        self.refused(SOUND.replace("30k / 500k", "30k / 600k"), "+| K | cembox-2, 30k / 500k")
        self.assertEqual(self.report()[0], 0)
        self.assertEqual(self.document.read_text(), SOUND)

    def test_a_changed_measurement_is_refused(self):
        (self.results / "queries.csv").write_text(TABLE.replace("400,40", "400,80"))
        self.refused(SOUND, "+| K | cembox-2, 30k / 500k, 20 % colliding")

    def test_marks_without_partner_are_refused(self):
        self.refused(SOUND.replace("<!-- end -->", ""), "has no partner")
        self.refused(SOUND.replace("<!-- end -->", "") + SOUND, "has no partner")
        self.refused(SOUND + "A distance takes <!-- figure: queries-us distance -->16.0<!-- / --> us.\n", "has no partner")

    def test_unknown_tables_and_wrong_arguments_are_refused(self):
        self.refused(SOUND.replace("scene_list", "scene_lists"), "'scene_lists'")
        self.refused(SOUND.replace("queries.", "query."), "'query'")
        self.refused(SOUND.replace("scene_list", "scene_list more"), "cannot be made")

    def test_what_no_table_holds_is_said_not_invented(self):
        self.document.write_text(SOUND + "\n<!-- figures: queries.builds -->\n<!-- end -->\n")
        self.assertEqual(self.report()[0], 0)
        self.assertIn("<!-- figures: queries.builds -->\n*Not measured yet.*\n<!-- end -->", self.document.read_text())

    def test_a_peer_that_is_faster_is_named(self):
        for ratio, words in (("52.6", "Of 1 comparisons of queries, none is lost to a peer."), ("0.8", "| K | distance, clearway | distance, PQP | 0.80 |")):
            (self.results / "queries.csv").write_text(TABLE.replace(",52.6,", f",{ratio},"))
            self.document.write_text("<!-- figures: queries.losses -->\n<!-- end -->\n")
            self.assertEqual(self.report()[0], 0)
            self.assertIn(words, self.document.read_text())


class Plots(unittest.TestCase):
    SHOWN = 830  # pixels: the width of a page on GitHub, to which it shrinks wider pictures

    def texts(self):
        """Yields for each text of each plot: the plot's name and page, the text, its size, and its box (left, top, right, bottom)."""
        for file in sorted(pathlib.Path(__file__).parent.glob("results/*/*.svg")):
            page = xml.etree.ElementTree.parse(file).getroot()
            for text in page.iter("{http://www.w3.org/2000/svg}text"):
                x, y, size = (float(text.get(name)) for name in ("x", "y", "font-size"))
                before = {"start": 0, "middle": 0.5, "end": 1}[text.get("text-anchor")]
                width = 0.6 * size * len(text.text)
                box = (-before * width, -0.8 * size, (1 - before) * width, 0.25 * size)
                if "rotate(-90 " in text.get("transform", ""):
                    box = (box[1], -box[2], box[3], -box[0])
                yield file.name, page, text.text, size, (x + box[0], y + box[1], x + box[2], y + box[3])

    def test_no_text_leaves_the_page(self):
        for name, page, text, _, (left, top, right, bottom) in self.texts():
            with self.subTest(plot=name, text=text):
                self.assertGreaterEqual(min(left, top), 0)
                self.assertLessEqual(right, float(page.get("width")))
                self.assertLessEqual(bottom, float(page.get("height")))

    def test_text_is_large_enough_to_read_where_a_page_shows_it(self):
        for name, page, text, size, _ in self.texts():
            with self.subTest(plot=name, text=text):
                self.assertGreaterEqual(size * min(1, self.SHOWN / float(page.get("width"))), 9)


if __name__ == "__main__":
    unittest.main()
