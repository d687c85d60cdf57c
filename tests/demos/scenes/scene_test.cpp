#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "program/cli/run_program.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(scene_test)

constexpr const char* kScene =
    "tunnel-console-3 --seed 3 --part-triangles 15000 --environment-triangles 50000 --clearance 10 "
    "--no-preview --out made";

Outcome runScene(const TemporaryFolder& folder, const std::string& arguments) {
    return runIn(folder, arguments, kSceneProgram);
}

/// The name of the file with which a row begins.
std::string fileOf(const Outcome& outcome, const std::string& label) {
    const std::string value = row(outcome, label);
    return value.substr(0, value.find(','));
}

std::vector<std::string> namesIn(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

void requireSameState(const PartState& a, const PartState& b) {
    BOOST_TEST((a.position - b.position).norm() <= 1e-9);
    BOOST_TEST((poseOf(a).rotation - poseOf(b).rotation).norm() <= 1e-12);
}

BOOST_AUTO_TEST_CASE(a_scene_is_written_with_a_path_from_its_start_to_its_goal_that_keeps_the_clearance) {
    const TemporaryFolder folder;
    const Outcome made = runScene(folder, kScene);
    BOOST_TEST_REQUIRE(made.code == 0, made.err);
    BOOST_TEST(made.err == "");
    std::vector<std::string> written;
    for (const char* label : {"environment", "part", "path", "problem", "replay"})
        written.push_back(std::filesystem::path(fileOf(made, label)).filename().string());
    std::sort(written.begin(), written.end());
    BOOST_TEST(namesIn(folder.file("made")) == written, boost::test_tools::per_element());

    const std::string problem = fileOf(made, "problem"), path = fileOf(made, "path");
    const Problem read = readProblem(folder.file(problem));
    BOOST_TEST(read.warnings.empty());
    BOOST_TEST(read.fineness.has_value());
    const std::vector<PartState> states = readPath(folder.file(path), read.space);
    requireSameState(states.front(), read.start);
    requireSameState(states.back(), read.goal);
    const Model part = Model::build(loadPart(read)), environment = Model::build(loadEnvironment(read));
    BOOST_TEST(std::abs(static_cast<int>(part.report().triangles) - 15000) <= 750);
    BOOST_TEST(std::abs(static_cast<int>(environment.report().triangles) - 50000) <= 2500);

    const double least = std::stod(row(made, "least clearance"));
    BOOST_TEST(least >= 10);
    for (const std::string& file : {problem, path})
        BOOST_TEST(holds(readText(folder.file(file)), row(made, "least clearance"), row(made, "near")), file);
    const auto checked = factsOf(folder, "check " + problem + " " + path);
    BOOST_TEST(checked["audit"]["clearance"]["upper"].get<double>() >= least * (1 - 1e-6));
    BOOST_TEST(checked["audit"]["clearance"]["upper"].get<double>() <= 15);

    const std::vector<Pose> poses = readPoses(folder.file(fileOf(made, "replay"))).poses;
    BOOST_TEST(poses.size() == 1000);
    Workspace workspace;
    int colliding = 0;
    for (const Pose& pose : poses) colliding += collides(part, environment, pose, workspace);
    BOOST_TEST(std::abs(colliding - 750) <= 20);
    const std::string said = row(made, "replay");
    BOOST_TEST(std::stod(said.substr(said.find("path, ") + 6)) == colliding / 10.0);
}

BOOST_AUTO_TEST_CASE(the_command_that_the_files_state_makes_them_again_and_another_seed_others) {
    const TemporaryFolder folder;
    const std::string puzzle = "puzzle-2 --clearance 4.1234567890123 --no-preview --seed ";
    BOOST_TEST_REQUIRE(runScene(folder, puzzle + "5 --out a").code == 0);
    std::istringstream problem(readText(folder.file("a/puzzle.cfg")));
    std::string line;
    const std::string begin = "# clearway-scene ";
    while (line.rfind(begin, 0) != 0) BOOST_TEST_REQUIRE(!std::getline(problem, line).fail());
    const Outcome again = runScene(folder, line.substr(begin.size()) + " --no-preview --out b");
    BOOST_TEST_REQUIRE(again.code == 0, again.err);
    BOOST_TEST_REQUIRE(runScene(folder, puzzle + "6 --out c").code == 0);
    int different = 0;
    for (const std::string& name : namesIn(folder.file("a"))) {
        BOOST_TEST(readText(folder.file("a/" + name)) == readText(folder.file("b/" + name)), name);
        if (readText(folder.file("a/" + name)) != readText(folder.file("c/" + name))) ++different;
    }
    BOOST_TEST(different >= 4);  // both meshes, the path and the poses at least
}

BOOST_AUTO_TEST_CASE(a_scene_replaces_another_ones_files_and_picture_and_nothing_else) {
    const TemporaryFolder folder;
    folder.write("notes.txt", "mine");
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --out .").code == 0);
    BOOST_TEST(folder.names().size() == 7);
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --clearance 2 --no-preview --out .").code == 0);
    BOOST_TEST(folder.names().size() == 6);
    BOOST_TEST(readText(folder.file("notes.txt")) == "mine");
}

BOOST_AUTO_TEST_CASE(files_that_may_not_grow_are_named_and_leave_no_half_and_no_other_scene) {
    const TemporaryFolder folder;
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --no-preview --out .").code == 0);
    const Outcome outcome = runScene(folder, "--version > /dev/null; ulimit -f 60; " CLEARWAY_PROGRAM
                                             "-scene peg-in-hole-1 --clearance 2 --out . 2> said");
    BOOST_TEST(outcome.code == 2);
    BOOST_TEST(holds(readText(folder.file("said")), "cannot write './peg-in-hole_part.obj'"));
    BOOST_TEST(folder.names() == std::vector<std::string>{"said"});
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused_and_makes_nothing) {
    const TemporaryFolder folder;
    folder.write("file", "x");
    const auto refused = [&](const std::string& arguments, const std::vector<std::string>& words) {
        requireRefused(folder, arguments, words, kSceneProgram);
    };
    refused("", {"NAME is missing", "clearway-scene"});
    refused("tunnel --out made", {"'tunnel'", "tunnel-console"});
    refused("tunnel-console", {"--out is missing"});
    refused("tunnel-console --out file", {"--out is 'file'", "expected a folder"});
    refused("tunnel-console --out file/made", {"file/made"});
    refused("tunnel-console --out made --seed -1", {"--seed is '-1'", "an integer from 0"});
    refused("tunnel-console --out made --part-triangles 1e3", {"--part-triangles is '1e3'", "an integer"});
    refused("tunnel-console --out made --part-triangles 10", {"10", "expected"});
    refused("tunnel-console --out made --environment-triangles 10", {"10", "expected"});
    for (const std::string clearance : {"0", "nan"})
        refused("tunnel-console --out made --clearance " + clearance,
                {"--clearance is '" + clearance + "'", "a number above 0"});
    refused("tunnel-console --out made --clearance 1000", {"1000", "expected"});
}

BOOST_AUTO_TEST_CASE(an_interrupt_leaves_no_part_of_a_scene) {
    const TemporaryFolder folder;
    const Outcome outcome = interruptIn(folder, "tunnel-console-3 --out made", kSceneProgram);
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "scene") == "none, interrupted");
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
