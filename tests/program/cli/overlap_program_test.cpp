// The program on a part that sits a little way in its floor: how deep, the least overlap that frees it, and a way out.
#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/invalid_words.h"
#include "support/random_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(overlap_program_test)

namespace {

/// A block that sits 0.03 deep in a floor.
struct SunkFolder : TemporaryFolder {
    SunkFolder() {
        saveMesh(named(box({2, 2, 2}), "block"), file("block.obj"));
        saveMesh(named(translated(box({6, 6, 1}), {0, 0, -1}), "floor"), file("floor.obj"));
        saveMesh(named(box({2, 2, 0.1}), "plate"), file("plate.obj"));
    }
    std::string problem(const std::string& keys, const std::string& part = "block.obj",
                        double z = 1.97) const {
        write("p.cfg",
              "[problem]\nrobot = " + part +
                  "\nworld = floor.obj\nstart.x = 0\nstart.y = 0\nstart.z = " + std::to_string(z) +
                  "\nstart.axis.x = 0\nstart.axis.y = 0\nstart.axis.z = 1\nstart.theta = 0\n[clearway]\n"
                  "reading = stored\ngoal = outside\noutside = +z\n" +
                  keys);
        return "p.cfg";
    }
};

BOOST_AUTO_TEST_CASE(a_sunk_start_names_both_cures_and_info_tells_how_deep) {
    const SunkFolder folder;
    folder.problem("");
    requireRefused(
        folder, "plan p.cfg --path o.path",
        {"start is " + beginningOf(WhyInvalid::Kind::kCollides), "contact.start = floor, ", "overlap = X"});
    const Outcome lifted = runIn(folder, "info p.cfg --lift");
    BOOST_TEST(lifted.code == 0, lifted.err);
    BOOST_TEST(holds(row(lifted, "floor"), "0.03 deep, at ("), lifted.out);
    BOOST_TEST(holds(row(lifted, "frees the start"), "overlap = 0.04"), lifted.out);
    BOOST_TEST(holds(row(lifted, "to try first"), "overlap = 0.28"), lifted.out);
    folder.problem("", "block.obj", 3);
    BOOST_TEST(row(runIn(folder, "info p.cfg --lift"), "start") == "no obstacle reaches into the part");
    BOOST_TEST(runIn(folder, "info block.obj --lift").code == 2);
}

BOOST_AUTO_TEST_CASE(a_sunk_part_is_planned_checked_and_drawn_with_its_overlap) {
    const SunkFolder folder;
    folder.problem("overlap = 0.045\n");
    const Outcome planned = runIn(folder, "plan p.cfg --quick --path o.path --report o.html");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(holds(readText(folder.file("o.html")), "Overlaps, where they are deepest"));
    for (const char* command :
         {"check p.cfg o.path", "render p.cfg o.path --out o.png --size 64x64 --samples 1"}) {
        const auto depth = factsOf(folder, command)["overlaps"][0]["depth"];
        BOOST_TEST(depth["lower"].get<double>() <= 0.03 * (1 + 1e-9));
        BOOST_TEST(depth["upper"].get<double>() == 0.03, boost::test_tools::tolerance(0.15));
    }
    const Outcome checked = runIn(folder, "check p.cfg o.path");
    BOOST_TEST(holds(row(checked, "overlap"), "of 'floor', at 0 of the path"), checked.out);
    for (const char* how :
         {"--iterations 500", "--objective max_min_clearance --time 1"}) {  // they raise margins
        const Outcome roomy = runIn(folder, std::string("plan p.cfg --path r.path ") + how);
        BOOST_TEST(roomy.code == 0, roomy.err);
    }
    folder.problem("overlap = 0.02\n");
    const auto deeper = factsOf(folder, "check p.cfg o.path", 1)["audit"]["segments"][0];
    BOOST_TEST(deeper["kind"] == nameOf(WhyInvalid::Kind::kTooDeep));
    BOOST_TEST(holds(deeper["trouble"].get<std::string>(), "0.02"));
    folder.problem("overlap.floor = 0.045\n");
    BOOST_TEST(runIn(folder, "check p.cfg o.path").code == 0);
}

BOOST_AUTO_TEST_CASE(a_start_that_only_touches_is_freed_by_the_least_overlap) {
    const SunkFolder folder;
    folder.problem("", "block.obj", 2);
    const Outcome lifted = runIn(folder, "info p.cfg --lift");
    for (const char* advice : {"frees the start", "to try first"}) {
        folder.problem(row(lifted, advice) + "\n", "block.obj", 2);
        const Outcome planned = runIn(folder, "plan p.cfg --quick --path o.path");
        BOOST_TEST(planned.code == 0, planned.err);
    }
}

/// Where the part is thin, larger overlaps free less.
BOOST_AUTO_TEST_CASE(the_overlap_to_try_first_frees_a_thin_part) {
    const SunkFolder folder;
    saveMesh(named(box({1, 1, 0.005}), "sheet"), folder.file("sheet.obj"));
    folder.problem("", "sheet.obj", 0.0048);
    const Outcome lifted = runIn(folder, "info p.cfg --lift");
    BOOST_TEST(holds(row(lifted, "frees the start"), "overlap = 0.0002"), lifted.out);
    folder.problem(row(lifted, "to try first") + "\n", "sheet.obj", 0.0048);
    BOOST_TEST(holds(row(runIn(folder, "info p.cfg"), "at the start"), "valid, clearance"));
}

BOOST_AUTO_TEST_CASE(thin_places_are_told_and_open_parts_refused) {
    const SunkFolder folder;
    const auto refused = [&](const std::string& keys, const std::string& part,
                             const std::vector<std::string>& words) {
        folder.problem(keys, part);
        requireRefused(folder, "plan p.cfg --path o.path", words);
    };
    Mesh open = named(box({2, 2, 2}), "lid");
    open.triangles.pop_back();
    open.components[0].triangleCount = 11;
    saveMesh(open, folder.file("open.obj"));
    refused("overlap = 0.1\n", "open.obj", {"p.cfg", "'lid' encloses nothing", "3 open edges"});
    refused("overlap = 0.045\nmargin = 1\n", "block.obj", {"'floor'", "margin 1", "overlap 0.045"});
    folder.problem("overlap = 0.2\n", "plate.obj", 0.1);
    const Outcome thin = runIn(folder, "plan p.cfg --quick --path o.path");
    BOOST_TEST(thin.code == 0, thin.err);
    BOOST_TEST(holds(thin.err, "thin places of the part allow less, down to about 0.04"), thin.err);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
