// The program on a part that sits a little way in its floor: how deep, the least overlap that frees it, and a way out.
#include <filesystem>
#include <fstream>

#include "clearway/overlap.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "program/cli/run_program.h"
#include "support/invalid_words.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(overlap_program_test)

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
    BOOST_TEST(holds(row(lifted, "to try first"), "overlap = 0.07"), lifted.out);
    folder.problem("", "block.obj", 3);
    BOOST_TEST(row(runIn(folder, "info p.cfg --lift"), "start") ==
               "neither part nor obstacles reach into the other");
    BOOST_TEST(runIn(folder, "info block.obj --lift").code == 2);
}

BOOST_AUTO_TEST_CASE(a_sunk_part_is_planned_checked_and_drawn_with_its_overlap) {
    const SunkFolder folder;
    folder.problem("overlap = 0.045\n");
    const Outcome planned = runIn(folder, "plan p.cfg --quick --path o.path --report o.html");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(holds(row(planned, "least slack"), "before the overlap may exceed 0.045"), planned.out);
    BOOST_TEST(holds(row(planned, "  on the part"), "of 'block' as it is shrunk"), planned.out);
    BOOST_TEST(!holds(planned.out, "clearance"), planned.out);
    const std::string page = readText(folder.file("o.html"));
    BOOST_TEST(holds(page, "Overlaps, where they are deepest", "\"measure\":\"slack\"", "least slack"));
    BOOST_TEST(!holds(page, "least clearance"));
    for (const char* command :
         {"check p.cfg o.path", "render p.cfg o.path --out o.png --size 64x64 --samples 1"}) {
        const auto depth = factsOf(folder, command)["overlaps"][0]["depth"];
        BOOST_TEST(depth["lower"].get<double>() <= 0.03 * (1 + 1e-9));
        BOOST_TEST(depth["upper"].get<double>() >= 0.03 * (1 - 1e-9));
        BOOST_TEST(depth["upper"].get<double>() <=
                   (depth["lower"].get<double>() + 0.1 * 0.045) * (1 + 1e-9));  // a tenth of the overlap
    }
    const Outcome checked = runIn(folder, "check p.cfg o.path --csv o.csv --json o.json");
    BOOST_TEST(holds(row(checked, "overlap"), "of 'floor', at 0 of the path"), checked.out);
    BOOST_TEST(holds(checked.out, "slack along the path"), checked.out);
    BOOST_TEST(!holds(checked.out, "clearance"), checked.out);
    const auto audit = jsonIn(folder, "o.json")["audit"];
    BOOST_TEST(audit["slack"]["lower"].get<double>() > 0);
    BOOST_TEST((audit["segments"][0].contains("slack") && !audit.contains("clearance")));
    BOOST_TEST(readText(folder.file("o.csv")).find("segment,t,travel,slack,slack_to_next,x,") == 0u);
    const auto drawn = factsOf(folder, "render p.cfg o.path --out o.png --size 64x64 --samples 1");
    BOOST_TEST(drawn["poses"][0]["slack"].get<double>() > 0);
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

BOOST_AUTO_TEST_CASE(depths_are_as_close_as_the_least_overlap_asks) {
    const SunkFolder folder;
    saveMesh(assembled({named(translated(box({6, 6, 1}), {0, 0, -1}), "floor"),
                        named(translated(box({2, 2, 2}), {20, 0, 0}), "post")}),
             folder.file("floor.obj"));
    folder.problem("overlap.floor = 0.045\noverlap.post = 1.5\n");
    folder.write("o.path", "0 0 1.97 0 0 0 1\n0 0 5 0 0 0 1\n");
    const auto found = factsOf(folder, "check p.cfg o.path --any-ends")["overlaps"];
    BOOST_TEST_REQUIRE(found.size() == 1u);
    BOOST_TEST(found[0]["depth"]["upper"].get<double>() <= (0.03 + 0.1 * 0.045) * (1 + 1e-9));
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
    BOOST_TEST(holds(row(runIn(folder, "info p.cfg"), "at the start"), "valid, slack"));
}

/// An open part: the floor is shrunk in its place.
struct OpenFolder : SunkFolder {
    OpenFolder() {
        Mesh open = named(box({2, 2, 2}), "lid");
        open.triangles.pop_back();
        open.components[0].triangleCount = 11;
        saveMesh(open, file("lid.obj"));
        const Mesh floor = named(translated(box({6, 6, 1}), {0, 0, -1}), "floor"),
                   post = named(translated(box({1, 1, 1}), {20, 0, 0}), "post");
        saveMesh(assembled({floor, post}), file("floor.obj"));
    }
};

BOOST_AUTO_TEST_CASE(an_open_part_reaches_into_obstacles_as_deep_as_the_overlap) {
    const OpenFolder folder;
    const Mesh lid = loadMesh(folder.file("lid.obj")), floor = loadMesh(folder.file("floor.obj"));
    folder.problem("overlap = 0.1\n", "lid.obj");
    const Problem problem = readProblem(folder.file("p.cfg"));
    const SceneClearance clearance(loadScene(problem).scene);
    const OverlapMeter inFloor(floor);
    const auto at = [](double z) {
        Pose pose;
        pose.translation.z() = z;
        return pose;
    };
    for (const double z : {3.0, 1.99, 1.93}) BOOST_TEST(clearance.at(at(z)).isValid());
    for (const double z : {1.92, 1.8, 0.0}) BOOST_TEST(!clearance.at(at(z)).isValid());
    const WhyInvalid why = clearance.whyInvalid(at(1.8));
    BOOST_TEST((why.kind == WhyInvalid::Kind::kTooDeep));
    BOOST_TEST(why.isPartInside);
    BOOST_TEST(
        holds(why.words(), "the part's mesh 'lid' may reach deeper into the environment's mesh 'floor'"));
    BOOST_TEST(why.nearest.witness->environmentTriangle < 12);
    Random random(5);
    int valid = 0, invalid = 0;
    for (int n = 0; n < 300; ++n) {
        Pose pose = random.pose(1);
        pose.translation += Vector3(n % 2 == 0 ? 20 : 0, 0, 2.5);
        const double deepest = inFloor.deepest(lid, inverse(pose)).lower;
        const bool isValid = clearance.at(pose).isValid();
        (isValid ? valid : invalid)++;
        if (deepest > 0.1) BOOST_REQUIRE(!isValid);
        const SceneDistance near = clearance.distance(pose);
        BOOST_REQUIRE(near.witness->environmentTriangle < 24);
    }
    BOOST_TEST(valid > 30);
    BOOST_TEST(invalid > 30);
}

BOOST_AUTO_TEST_CASE(an_open_part_is_lifted_planned_checked_and_drawn) {
    const OpenFolder folder;
    folder.problem("", "lid.obj");
    const Outcome lifted = runIn(folder, "info p.cfg --lift");
    BOOST_TEST(lifted.code == 0, lifted.err);
    BOOST_TEST(holds(row(lifted, "floor"), "0.03 deep, at ("), lifted.out);
    BOOST_TEST(holds(row(lifted, "floor"), "of the part in 'floor'"), lifted.out);
    BOOST_TEST(holds(row(lifted, "frees the start"), "overlap = 0.04"), lifted.out);
    folder.problem("overlap = 0.045\n", "lid.obj");
    const Outcome planned = runIn(folder, "plan p.cfg --quick --path o.path --report o.html --cache kept");
    BOOST_TEST(planned.code == 0, planned.err);
    const auto checked = factsOf(folder, "check p.cfg o.path --cache kept");
    BOOST_TEST(checked["obstacles"][0]["overlap"] == 0.045);
    BOOST_TEST(checked["overlaps"][0]["triangle_of"] == "part");
    BOOST_TEST(checked["overlaps"][0]["depth"]["lower"].get<double>() <= 0.03 * (1 + 1e-9));
    BOOST_TEST(std::abs(checked["overlaps"][0]["point"][2].get<double>() + 0.03) <
               1e-6);  // the floor's frame
    Mesh open = loadMesh(folder.file("floor.obj"));
    open.triangles.pop_back();
    open.components[1].triangleCount = 11;
    saveMesh(open, folder.file("floor.obj"));
    folder.problem("overlap.post = 0.1\n", "lid.obj");
    requireRefused(folder, "plan p.cfg --path refused.path",
                   {"p.cfg", "'post'", "3 open edges", "'lid' encloses nothing", "contact.start"});
    for (const char* keys : {"overlap = 0.1\n", "overlap.floor = 0.1\n"}) {
        folder.problem(keys, "lid.obj");
        const Outcome outcome = runIn(folder, "plan p.cfg --quick --path o.path");
        BOOST_TEST(outcome.code == 0, outcome.err);
        BOOST_TEST(holds(outcome.err, "no overlap for an open obstacle: 'post'") ==
                   (keys == std::string("overlap = 0.1\n")));
    }
    folder.problem("", "lid.obj");
    BOOST_TEST(holds(row(runIn(folder, "info p.cfg --lift"), "frees the start"), "overlap = 0.04"));
}

/// Block and lid stand side by side, the sheet is pressed into both of them where they touch.
BOOST_AUTO_TEST_CASE(obstacles_that_touch_are_shrunk_each_by_itself) {
    const TemporaryFolder folder;
    Mesh sheet = named(box({1, 1, 0.001}), "sheet");
    sheet.triangles = {sheet.triangles[0], sheet.triangles[1]};
    sheet.components[0].triangleCount = 2;
    Mesh blocks = joined(translated(box({2, 2, 2}), {-2, 0, 0}), translated(box({2, 2, 2}), {2, 0, 0}));
    blocks.components = {{"left", 0, 12}, {"right", 12, 12}};
    saveMesh(sheet, folder.file("sheet.obj"));
    saveMesh(blocks, folder.file("blocks.obj"));
    const auto at = [&](double z, const std::string& keys) {
        folder.write(
            "p.cfg",
            "[problem]\nrobot = sheet.obj\nworld = blocks.obj\nstart.x = 0\nstart.y = 0\nstart.z = " +
                std::to_string(z) +
                "\nstart.axis.x = 0\nstart.axis.y = 0\nstart.axis.z = 1\nstart.theta = 0\n[clearway]\n"
                "reading = stored\ngoal = outside\noutside = +z\n" +
                keys);
        return readProblem(folder.file("p.cfg"));
    };
    const auto why = [](const Problem& problem) {
        return SceneClearance(loadScene(problem).scene).whyInvalid(poseOf(problem.start));
    };
    for (const char* keys : {"overlap = 0.1\n", "overlap = 0.1\noverlap.left = 0.11\n"})
        BOOST_TEST(why(at(1.95, keys)).words() == "");
    const WhyInvalid deep = why(at(1.5, "overlap = 0.2\n"));
    BOOST_TEST((deep.kind == WhyInvalid::Kind::kTooDeep));
    BOOST_TEST(holds(deep.words(), "'sheet' is inside the environment's mesh 'left', and may be deeper"),
               deep.words());
    at(1.95, "overlap = 0.1\n");
    const Outcome planned = runIn(folder, "plan p.cfg --quick --path o.path");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(!holds(planned.err, "go unnoticed"), planned.err);
    const auto states = readPath(folder.file("o.path"), Space::kSe3);
    BOOST_TEST(poseOf(states.back()).translation.z() >
               2);  // outside of the blocks as they are, not of the shrunk ones
}

/// An overlap above half of an obstacle's size lets the part pass through it.
BOOST_AUTO_TEST_CASE(obstacles_smaller_than_the_overlap_refuse_nothing) {
    const OpenFolder folder;
    folder.problem("overlap = 1.5\n", "lid.obj");
    const Outcome outcome = runIn(folder, "info p.cfg");
    BOOST_TEST(holds(row(outcome, "at the start"), "valid"), outcome.out << outcome.err);
}

BOOST_AUTO_TEST_CASE(shrunk_parts_are_kept_with_the_trees) {
    const SunkFolder folder;
    folder.problem("overlap = 0.045\n");
    const std::string command = "plan p.cfg --quick --path o.path --cache kept";
    BOOST_TEST(runIn(folder, command).code == 0);
    namespace fs = std::filesystem;
    std::string kept;
    for (const auto& entry : fs::directory_iterator(folder.file("kept"))) {
        if (entry.path().extension() == ".shrunk") kept = entry.path().string();
    }
    BOOST_REQUIRE(!kept.empty());
    const std::string whole = readText(kept);
    BOOST_TEST(runIn(folder, command).err == "");
    for (const std::size_t at : {whole.size() / 2, whole.size() - 1, std::size_t(3)}) {
        std::string bytes = whole.substr(0, whole.size() - (at == 3 ? 8 : 0));
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        std::ofstream(kept, std::ios::binary) << bytes;
        const Outcome again = runIn(folder, command);
        BOOST_TEST(again.code == 0);
        BOOST_TEST(holds(again.err, "it is shrunk again"), again.err);
        BOOST_TEST(readText(kept) == whole);
    }
}

BOOST_AUTO_TEST_CASE(thin_places_are_told_and_two_margins_refused) {
    const SunkFolder folder;
    folder.problem("overlap = 0.045\nmargin = 1\n");
    requireRefused(folder, "plan p.cfg --path o.path", {"'floor'", "margin 1", "overlap 0.045"});
    folder.problem("overlap = 0.2\n", "plate.obj", 0.1);
    const Outcome thin = runIn(folder, "plan p.cfg --quick --path o.path");
    BOOST_TEST(thin.code == 0, thin.err);
    BOOST_TEST(holds(thin.err, "thin places of the part allow less, down to about 0.04"), thin.err);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
