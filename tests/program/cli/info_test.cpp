#include "program/cli/run_program.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(info_test)

namespace {

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
    const Outcome outcome = runIn(folder, "info a.obj");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "mesh") == "a.obj");
    BOOST_TEST(row(outcome, "read") == "as stored");
    BOOST_TEST(row(outcome, "applied") == "scale 1, then shift (0, 0, 0)");
    BOOST_TEST(row(outcome, "box in file units") == "(-1, -1, -1) to (2, 2, 2)");
    BOOST_TEST(row(outcome, "box as applied") == "(-1, -1, -1) to (2, 2, 2)");
    BOOST_TEST(row(outcome, "triangles") == "12");
    BOOST_TEST(row(outcome, "components") == "1");
    BOOST_TEST(row(outcome, "  crate") == "12 triangles");
    BOOST_TEST(row(outcome, "surface") == "closed");
    BOOST_TEST(row(outcome, "tree").find("leaves of up to 4") != std::string::npos);
    BOOST_TEST(std::stoi(row(outcome, "  nodes")) >= 1);
    BOOST_TEST(std::stoi(row(outcome, "  depth")) >= 1);
    BOOST_TEST(row(outcome, "  leaves").find(" of 4") != std::string::npos);
    BOOST_TEST(row(outcome, "  bytes").find(" per triangle") != std::string::npos);
    BOOST_TEST(std::stod(row(outcome, "  build seconds")) >= 0);
}

BOOST_AUTO_TEST_CASE(the_scale_is_applied_and_said_beside_the_file_units) {
    const TemporaryFolder folder;
    folder.write("a.obj", boxObj(-1, 2));
    const Outcome outcome = runIn(folder, "info a.obj --scale 0.5");
    BOOST_TEST(row(outcome, "applied") == "scale 0.5, then shift (0, 0, 0)");
    BOOST_TEST(row(outcome, "box in file units") == "(-1, -1, -1) to (2, 2, 2)");
    BOOST_TEST(row(outcome, "box as applied") == "(-0.5, -0.5, -0.5) to (1, 1, 1)");
    BOOST_TEST(row(outcome, "size as applied") == "(1.5, 1.5, 1.5)");
}

BOOST_AUTO_TEST_CASE(a_mesh_of_points_and_lines_has_no_surface) {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3\nf 1 1 1\n");
    BOOST_TEST(row(runIn(folder, "info a.obj"), "surface") == "none: every triangle is a point or a line");
}

BOOST_AUTO_TEST_CASE(open_borders_degenerate_and_duplicate_triangles_are_counted) {
    const TemporaryFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 2 3 1\nf 1 2 4\n");
    const Outcome outcome = runIn(folder, "info a.obj");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(row(outcome, "triangles") == "3");
    BOOST_TEST(row(outcome, "surface").find("open: ") == 0);
    BOOST_TEST(row(outcome, "cleaning").find("1 triangle without area kept, 1 duplicate dropped") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(strategies_are_chosen_by_name) {
    const TemporaryFolder folder;
    folder.write("a.obj", boxObj(0, 1));
    const Outcome outcome =
        runIn(folder, "info a.obj --general-split mean --leaf-split all --leaf-size 2 --node-width 2");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(row(outcome, "tree") == "mean, fitted by frames, leaves of up to 2 split by all, 2 wide");
    BOOST_TEST(row(outcome, "  leaves") == "12: 12 of 1");
}

BOOST_AUTO_TEST_CASE(a_preset_is_what_single_choices_start_from) {
    const TemporaryFolder folder;
    folder.write("a.obj", boxObj(0, 1));
    const auto tree = [&](const std::string& choices) {
        return row(runIn(folder, "info a.obj " + choices), "tree");
    };
    const std::string rest = ", leaves of up to 4 split by none, 8 wide";
    BOOST_TEST(tree("") == "sah, fitted by frames" + rest);
    BOOST_TEST(tree("--preset best") == "sah, fitted by frames" + rest);
    BOOST_TEST(tree("--preset fast") == "embree, fitted by frames" + rest);
    BOOST_TEST(tree("--preset fast --fit frames --general-split embree") ==
               "embree, fitted by frames" + rest);
}

BOOST_AUTO_TEST_CASE(a_problem_is_described_with_both_meshes_as_omplapp_reads_them) {
    const ProblemFolder folder(
        kProblem +
        "threshold = 3\n[planner]\nrrt=\nrrt.range=5\n[clearway]\nmargin = 0.5\nreading = omplapp\n");
    const Outcome outcome = runIn(folder, "info a.cfg");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "problem") == "a.cfg (demo)");
    BOOST_TEST(row(outcome, "space") == "SE(3)");
    BOOST_TEST(row(outcome, "start") == "position (5, 0, 0), quaternion (x, y, z, w) (0, 0, 0, 1)");
    BOOST_TEST(row(outcome, "goal").find("position (9, 1, 0)") == 0);
    BOOST_TEST(row(outcome, "bounds") ==
               "(-1, -1, -1) to (9, 1, 1) (the environment's box, grown to hold start and goal)");
    BOOST_TEST(row(outcome, "margin") == "0.5");
    BOOST_TEST(row(outcome, "fineness") == "not stated");
    BOOST_TEST(row(outcome, "planners") == "1");
    BOOST_TEST(row(outcome, "  planner") == "rrt, range = 5");
    BOOST_TEST(row(outcome, "goal threshold") == "3");
    const std::size_t part = outcome.out.find("\nPart\n");
    const std::size_t environment = outcome.out.find("\nEnvironment\n");
    BOOST_TEST_REQUIRE((part != std::string::npos && part < environment && environment != std::string::npos));
    const Outcome partHalf{0, outcome.out.substr(part, environment - part), ""};
    BOOST_TEST(row(partHalf, "applied") == "scale 1, then shift (-2.5, -2.5, -2.5)");
    BOOST_TEST(row(partHalf, "box in file units") == "(2, 2, 2) to (3, 3, 3)");
    BOOST_TEST(row(partHalf, "box as applied") == "(-0.5, -0.5, -0.5) to (0.5, 0.5, 0.5)");
    const Outcome environmentHalf{0, outcome.out.substr(environment), ""};
    BOOST_TEST(row(environmentHalf, "applied") == "scale 1, then shift (0, 0, 0)");
    BOOST_TEST(row(environmentHalf, "  wall") == "12 triangles");
    BOOST_TEST(row(environmentHalf, "out of reach").find("0 triangles, never within ") == 0);
}

BOOST_AUTO_TEST_CASE(a_problems_meshes_are_not_moved_when_it_says_stored) {
    const ProblemFolder folder(kProblem + "[clearway]\nreading = stored\n");
    const Outcome outcome = runIn(folder, "info a.cfg");
    BOOST_TEST(row(outcome, "applied") == "scale 1, then shift (0, 0, 0)");
    BOOST_TEST(row(outcome, "box as applied") == "(2, 2, 2) to (3, 3, 3)");
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
    requireRefused(folder, "info .", {"'.'"});
    for (const char* file : {"empty.stl", "garbage.obj", "unknown.xyz", "points.obj", "lines.obj"}) {
        requireRefused(folder, std::string("info ") + file, {file});
    }
    requireRefused(folder, "info nan.obj", {"nan.obj", "triangle 1"});
}

BOOST_AUTO_TEST_CASE(problems_that_lack_something_are_refused) {
    for (const char* key :
         {"robot", "world", "start.x", "start.axis.y", "start.theta", "goal.z", "goal.theta"}) {
        const ProblemFolder folder(without(kProblem, key));
        requireRefused(folder, "info a.cfg", {"a.cfg", key, "missing", "expected"});
    }
    const ProblemFolder folder(kProblem);
    requireRefused(folder, "info none.cfg", {"none.cfg", "expected a problem file"});
    std::filesystem::remove(folder.file("environment.obj"));
    requireRefused(folder, "info a.cfg", {"environment.obj"});
}

BOOST_AUTO_TEST_CASE(problems_with_wrong_values_are_refused) {
    const auto requireTailRefused = [](const std::string& tail, const std::vector<std::string>& words) {
        requireRefused(ProblemFolder(kProblem + tail), "info a.cfg", words);
    };
    requireTailRefused("start.x = abc\n", {"a.cfg:19", "start.x", "'abc'", "expected once"});
    requireRefused(ProblemFolder(without(kProblem, "start.x") + "start.x = abc\n"), "info a.cfg",
                   {"a.cfg:18", "start.x", "'abc'", "expected a finite number"});
    requireRefused(ProblemFolder(without(kProblem, "goal.axis.z") + "goal.axis.z = 0\n"), "info a.cfg",
                   {"a.cfg", "goal.axis", "length above 0"});
    requireTailRefused(
        "volume.min.x = 6\nvolume.min.y = -9\nvolume.min.z = -9\n"
        "volume.max.x = 9\nvolume.max.y = 9\nvolume.max.z = 9\n",
        {"a.cfg", "start.x is 5", "from 6 to 9"});
    requireTailRefused("[clearway]\nsolids = wall\n",
                       {"a.cfg:20", "solids", "did you mean 'solid'?",
                        "margin.NAME, outside, overlap, overlap.NAME, overlap.thin, "
                        "overlap.tolerance, reading, robot.scale, solid, start.degrees, step"});
    requireTailRefused("[clearway]\nmargin = -1\n", {"a.cfg:20", "margin", "'-1'", "at least 0"});
    requireTailRefused("what is this\n", {"a.cfg:19", "'what is this'", "key = value"});
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused) {
    const ProblemFolder folder(kProblem);
    requireRefused(folder, "info", {"MESH|PROBLEM.cfg is missing"});
    requireRefused(folder, "info part.obj environment.obj", {"'environment.obj'", "clearway info"});
    requireRefused(folder, "info part.obj --general-split foo",
                   {"--general-split", "'foo'", "sah, embree, axis, mean"});
    requireRefused(folder, "info part.obj --preset foo", {"--preset", "'foo'", "best, fast"});
    requireRefused(folder, "info part.obj --fit foo", {"--fit", "'foo'", "frames, covariance"});
    requireRefused(folder, "info part.obj --leaf-split foo",
                   {"--leaf-split", "'foo'", "none, chain, edge, all"});
    requireRefused(folder, "info part.obj --leaf-size x",
                   {"--leaf-size is 'x', expected an integer from 1 to 16"});
    requireRefused(folder, "info part.obj --leaf-size 17",
                   {"--leaf-size is '17', expected an integer from 1 to 16"});
    requireRefused(folder, "info part.obj --node-width 3", {"--node-width", "'3'", "8, 2"});
    requireRefused(folder, "info part.obj --scale 0", {"--scale is '0', expected a number above 0"});
    requireRefused(folder, "info part.obj --scale nan", {"--scale is 'nan', expected a number above 0"});
    requireRefused(folder, "info part.obj --scale", {"--scale"});
    requireRefused(folder, "info part.obj --size 3", {"--size"});
    requireRefused(folder, "info a.cfg --scale 2", {"--scale is '2'", "problem"});
    requireRefused(folder, "info part.obj > /dev/full", {"standard output"});
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
