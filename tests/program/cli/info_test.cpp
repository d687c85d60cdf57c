#include <filesystem>

#include "program/cli/run_program.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(info_test)

const std::string kProblem = R"([problem]
name = demo
robot = part.obj
world = environment.obj
start.x = 5
start.y = 0
start.z = 0
start.axis.x = 0
start.axis.y = 0
start.axis.z = 1
start.theta = 0
goal.x = 9
goal.y = 1
goal.z = 0
goal.axis.x = 0
goal.axis.y = 0
goal.axis.z = 1
goal.theta = 3
)";

std::string without(std::string text, const std::string& key) {
    const std::size_t begin = text.find("\n" + key) + 1;
    return text.erase(begin, text.find('\n', begin) + 1 - begin);
}

/// A folder with a part, an environment and the problem's text.
struct ProblemFolder : TemporaryFolder {
    explicit ProblemFolder(const std::string& problem) {
        write("part.obj", boxObj(2, 3));
        write("environment.obj", boxObj(-1, 1, "wall"));
        write("a.cfg", problem);
    }
};

BOOST_AUTO_TEST_CASE(a_mesh_is_described) {
    const TemporaryFolder folder;
    folder.write("a.obj", boxObj(-1, 2, "crate"));
    const auto mesh = factsOf(folder, "info a.obj --scale 0.5")["mesh"];
    BOOST_TEST(mesh["file"] == "a.obj");
    BOOST_TEST(mesh["scale"] == 0.5);
    BOOST_TEST(mesh["box"].dump() == R"({"max":[1.0,1.0,1.0],"min":[-0.5,-0.5,-0.5]})");  // as applied
    BOOST_TEST(mesh["triangles"] == 12);
    BOOST_TEST(mesh["components"].dump() == R"([{"name":"crate","triangles":12}])");
    BOOST_TEST(mesh["closed"] == true);
    BOOST_TEST(mesh["tree"]["leaf_size"] == 4);
    const Outcome outcome = runIn(folder, "info a.obj --scale 0.5");
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "surface") == "closed");
    BOOST_TEST(row(outcome, "box in file units") == "(-1, -1, -1) to (2, 2, 2)");
}

BOOST_AUTO_TEST_CASE(open_borders_degenerate_and_duplicate_triangles_are_counted) {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 2 3 1\nf 1 2 4\n");
    const auto mesh = factsOf(folder, "info a.obj")["mesh"];
    BOOST_TEST(mesh["triangles"] == 3);
    BOOST_TEST(mesh["closed"] == false);
    BOOST_TEST(mesh["edges"]["of_one_triangle"] == 4);
    BOOST_TEST(mesh["cleaning"]["without_area"] == 1);
    BOOST_TEST(mesh["cleaning"]["duplicates_dropped"] == 1);
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3\nf 1 1 1\n");
    BOOST_TEST(holds(row(runIn(folder, "info a.obj"), "surface"), "none", "point or a line"));
}

BOOST_AUTO_TEST_CASE(a_tree_is_chosen_by_names) {
    const TemporaryFolder folder;
    folder.write("a.obj", boxObj(0, 1));
    const auto tree = [&](const std::string& choices) {
        return row(runIn(folder, "info a.obj " + choices), "tree");
    };
    const std::string rest = ", leaves of up to 4 split by cost, 8 wide";
    BOOST_TEST(tree("") == "sah, fitted by frames" + rest);
    BOOST_TEST(tree("--preset best") == "sah, fitted by frames" + rest);
    BOOST_TEST(tree("--preset fast") == "sah, fitted by frames" + rest);
    BOOST_TEST(runIn(folder, "info a.obj --preset fast").err.find("--preset fast: means best") !=
               std::string::npos);
    BOOST_TEST(tree("--general-split mean --leaf-split all --leaf-size 2 --node-width 2") ==
               "mean, fitted by frames, leaves of up to 2 split by all, 2 wide");
}

BOOST_AUTO_TEST_CASE(a_problem_is_described_with_both_meshes_as_omplapp_reads_them) {
    const ProblemFolder folder(
        kProblem +
        "threshold = 3\n[planner]\nrrt=\nrrt.range=5\n[clearway]\nmargin = 0.5\nreading = omplapp\n");
    const auto facts = factsOf(folder, "info a.cfg");
    BOOST_TEST(facts["name"] == "demo");
    BOOST_TEST(facts["space"] == "SE(3)");
    BOOST_TEST(facts["start"].dump() == R"({"position":[5.0,0.0,0.0],"quaternion_xyzw":[0.0,0.0,0.0,1.0]})");
    BOOST_TEST(facts["goal"]["position"].dump() == "[9.0,1.0,0.0]");
    BOOST_TEST(facts["bounds"].dump() == R"({"max":[9.0,1.0,1.0],"min":[-1.0,-1.0,-1.0]})");
    BOOST_TEST(facts["bounds_stated"] == false);  // grown to hold start and goal
    BOOST_TEST(facts["margin"] == 0.5);
    BOOST_TEST(facts["fineness"].is_null());
    BOOST_TEST(facts["planners"].size() == 1u);
    BOOST_TEST(facts["goal_threshold"] == 3.0);
    BOOST_TEST(facts["part"]["shift"].dump() == "[-2.5,-2.5,-2.5]");
    BOOST_TEST(facts["part"]["box"]["min"].dump() == "[-0.5,-0.5,-0.5]");
    BOOST_TEST(facts["environment"]["components"][0]["name"] == "wall");
    BOOST_TEST(facts["environment"]["tree"]["out_of_range"] == 0);
    const Outcome outcome = runIn(folder, "info a.cfg");
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "  planner") == "rrt, range = 5");
    const ProblemFolder stored(kProblem + "[clearway]\nreading = stored\n");
    BOOST_TEST(factsOf(stored, "info a.cfg")["part"]["shift"].dump() == "[0.0,0.0,0.0]");
}

BOOST_AUTO_TEST_CASE(a_problem_is_found_from_any_folder_with_its_meshes) {
    const ProblemFolder folder(kProblem);
    const TemporaryFolder elsewhere;
    BOOST_TEST(runIn(elsewhere, "info '" + folder.file("a.cfg") + "'").code == 0);
}

BOOST_AUTO_TEST_CASE(meshes_that_are_none_are_refused) {
    const TemporaryFolder folder;
    folder.write("empty.stl", "");
    folder.write("garbage.obj", "hello\nworld\n");
    folder.write("unknown.xyz", "1 2 3\n");
    folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    folder.write("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n");
    folder.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 1\nf 1 2 3\nf 1 2 4\n");
    requireRefused(folder, "info none.stl", {"none.stl"});
    requireRefused(folder, "info .", {"empty.stl"});
    for (const char* file : {"empty.stl", "garbage.obj", "unknown.xyz", "points.obj", "lines.obj"}) {
        requireRefused(folder, std::string("info ") + file, {file});
    }
    requireRefused(folder, "info nan.obj", {"nan.obj", "triangle 1"});
}

/// Other defects are refused by readProblem(), whose test has them.
BOOST_AUTO_TEST_CASE(problems_that_are_wrong_are_refused) {
    const ProblemFolder folder(without(kProblem, "goal.z"));
    requireRefused(folder, "info a.cfg", {"a.cfg", "goal.z", "missing", "expected"});
    folder.write("a.cfg", without(kProblem, "start.x") + "start.x = abc\n");
    requireRefused(folder, "info a.cfg", {"a.cfg:18", "start.x", "'abc'", "expected a finite number"});
    folder.write("a.cfg", kProblem + "[clearway]\nsolids = wall\n");
    requireRefused(folder, "info a.cfg", {"a.cfg:20", "solids", "'solid'", "overlap.NAME, part, reading"});
    requireRefused(folder, "info none.cfg", {"none.cfg", "expected a problem file"});
    folder.write("a.cfg", kProblem);
    std::filesystem::remove(folder.file("environment.obj"));
    requireRefused(folder, "info a.cfg", {"environment.obj"});
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused) {
    const ProblemFolder folder(kProblem);
    requireRefused(folder, "info", {"MESH|FOLDER|PROBLEM.cfg is missing"});
    requireRefused(folder, "info part.obj environment.obj", {"'environment.obj'", "clearway info"});
    requireRefused(folder, "info part.obj --general-split foo",
                   {"--general-split", "'foo'", "sah, embree, axis, mean"});
    requireRefused(folder, "info part.obj --preset foo", {"--preset", "'foo'", "best, fast"});
    requireRefused(folder, "info part.obj --fit foo", {"--fit", "'foo'", "frames, covariance"});
    requireRefused(folder, "info part.obj --leaf-split foo",
                   {"--leaf-split", "'foo'", "none, chain, edge, all, cost"});
    for (const std::string size : {"x", "17"})
        requireRefused(folder, "info part.obj --leaf-size " + size,
                       {"--leaf-size is '" + size + "'", "an integer from 1 to 16"});
    requireRefused(folder, "info part.obj --node-width 3", {"--node-width", "'3'", "8, 2"});
    for (const std::string scale : {"0", "nan"})
        requireRefused(folder, "info part.obj --scale " + scale,
                       {"--scale is '" + scale + "'", "a number above 0"});
    requireRefused(folder, "info part.obj --size 3", {"--size"});
    requireRefused(folder, "info a.cfg --scale 2", {"--scale is '2'", "problem"});
    requireRefused(folder, "info part.obj > /dev/full", {"standard output"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
