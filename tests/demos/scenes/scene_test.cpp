#include <set>
#include <sstream>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "program/cli/run_program.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(scene_test)

namespace {

constexpr const char* kScene =
    "tunnel-console-3 --seed 3 --part-triangles 15000 --environment-triangles 50000 --clearance 10 ";

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

int triangles(const Outcome& outcome, const std::string& label) {
    const std::string value = row(outcome, label);
    return std::stoi(value.substr(value.find(',') + 2));
}

void requireSameState(const PartState& a, const PartState& b) {
    BOOST_TEST((a.position - b.position).norm() <= 1e-9);
    BOOST_TEST((poseOf(a).rotation - poseOf(b).rotation).norm() <= 1e-12);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_scene_is_written_with_a_path_from_its_start_to_its_goal_that_keeps_the_clearance) {
    const TemporaryFolder folder;
    const Outcome made = runScene(folder, kScene + std::string("--out made"));
    BOOST_TEST_REQUIRE(made.code == 0, made.err);
    BOOST_TEST(made.err == "");
    std::set<std::string> written;
    for (const char* label : {"part", "environment", "problem", "path", "replay", "preview"}) {
        written.insert(std::filesystem::path(fileOf(made, label)).filename().string());
    }
    const std::vector<std::string> expected(written.begin(), written.end());
    BOOST_TEST(expected.size() == 6);
    BOOST_TEST(namesIn(folder.file("made")) == expected, boost::test_tools::per_element());
    BOOST_TEST(std::abs(triangles(made, "part") - 15000) <= 750);
    BOOST_TEST(std::abs(triangles(made, "environment") - 50000) <= 2500);

    const Problem problem = readProblem(folder.file(fileOf(made, "problem")));
    BOOST_TEST(problem.warnings.empty());
    BOOST_TEST(problem.fineness.has_value());
    const std::vector<PartState> path = readPath(folder.file(fileOf(made, "path")), problem.space);
    requireSameState(path.front(), problem.start);
    requireSameState(path.back(), problem.goal);

    const Outcome asked = runIn(folder, "query --part " + fileOf(made, "part") + " --environment " +
                                            fileOf(made, "environment") + " --poses " + fileOf(made, "path") +
                                            " --query distance");
    BOOST_TEST_REQUIRE(asked.code == 0, asked.err);
    BOOST_TEST(std::stod(row(asked, "least distance")) >= 10 - 1e-3);
    BOOST_TEST(std::stod(row(asked, "least distance")) <= 15);
    BOOST_TEST(runIn(folder, "info " + fileOf(made, "problem")).code == 0);
}

BOOST_AUTO_TEST_CASE(what_is_said_of_the_path_and_of_the_poses_holds) {
    const TemporaryFolder folder;
    const Outcome made = runScene(folder, kScene + std::string("--no-preview --out made"));
    BOOST_TEST_REQUIRE(made.code == 0, made.err);
    BOOST_TEST(made.out.find("preview") == std::string::npos);
    const std::string problem = folder.file(fileOf(made, "problem")),
                      path = folder.file(fileOf(made, "path")), replay = folder.file(fileOf(made, "replay"));
    const double least = std::stod(row(made, "least clearance"));
    BOOST_TEST(least >= 10);
    const std::string stated = row(made, "least clearance");
    for (const std::string& file : {problem, path}) {
        BOOST_TEST(readText(file).find(stated) != std::string::npos, file);
        BOOST_TEST(readText(file).find(row(made, "near")) != std::string::npos, file);
    }
    const Outcome checked = runIn(folder, "check " + problem + " " + path);
    BOOST_TEST_REQUIRE(checked.code == 0, checked.err);
    const std::string bounds = row(checked, "least clearance");  // lower to upper
    BOOST_TEST(std::stod(bounds.substr(bounds.find(" to ") + 4)) >= least);

    const std::vector<Pose> poses = readPoses(replay).poses;
    BOOST_TEST(poses.size() == 1000);
    const Problem read = readProblem(problem);
    const Model part = Model::build(loadPart(read)), environment = Model::build(loadEnvironment(read));
    Workspace workspace;
    int colliding = 0;
    for (const Pose& pose : poses) colliding += collides(part, environment, pose, workspace);
    BOOST_TEST(std::abs(colliding - 750) <= 20);
    const std::string said = row(made, "replay");
    BOOST_TEST(std::stod(said.substr(said.find("path, ") + 6)) == colliding / 10.0);
}

BOOST_AUTO_TEST_CASE(the_same_options_make_the_same_files_and_another_seed_others) {
    const TemporaryFolder folder;
    const std::string sizes = "puzzle-2 --seed ";
    BOOST_TEST_REQUIRE(runScene(folder, sizes + "5 --no-preview --out a").code == 0);
    BOOST_TEST_REQUIRE(runScene(folder, sizes + "5 --no-preview --out b").code == 0);
    BOOST_TEST_REQUIRE(runScene(folder, sizes + "6 --no-preview --out c").code == 0);
    int different = 0;
    for (const std::string& name : namesIn(folder.file("a"))) {
        BOOST_TEST(readText(folder.file("a/" + name)) == readText(folder.file("b/" + name)), name);
        if (readText(folder.file("a/" + name)) != readText(folder.file("c/" + name))) ++different;
    }
    BOOST_TEST(different >= 4);  // both meshes, the path and the poses at least
}

BOOST_AUTO_TEST_CASE(the_command_that_the_files_state_makes_them_again) {
    const TemporaryFolder folder;
    BOOST_TEST_REQUIRE(
        runScene(folder, "puzzle-2 --seed 3 --clearance 4.1234567890123 --no-preview --out a").code == 0);
    std::istringstream problem(readText(folder.file("a/puzzle.cfg")));
    std::string line;
    const std::string begin = "# clearway-scene ";
    while (line.rfind(begin, 0) != 0) BOOST_TEST_REQUIRE(!std::getline(problem, line).fail());
    const Outcome again = runScene(folder, line.substr(begin.size()) + " --no-preview --out b");
    BOOST_TEST_REQUIRE(again.code == 0, again.err);
    for (const std::string& name : namesIn(folder.file("a")))
        BOOST_TEST(readText(folder.file("a/" + name)) == readText(folder.file("b/" + name)), name);
}

BOOST_AUTO_TEST_CASE(what_else_is_in_the_folder_stays_as_it_is) {
    const TemporaryFolder folder;
    folder.write("notes.txt", "mine");
    const Outcome made = runScene(folder, kScene + std::string("--no-preview --out ."));
    BOOST_TEST_REQUIRE(made.code == 0, made.err);
    BOOST_TEST(readText(folder.file("notes.txt")) == "mine");
    BOOST_TEST(folder.names().size() == 6);
    const Outcome again =
        runScene(folder, kScene + std::string("--no-preview --out ."));  // over its own files
    BOOST_TEST_REQUIRE(again.code == 0, again.err);
    BOOST_TEST(folder.names().size() == 6);
}

BOOST_AUTO_TEST_CASE(a_picture_of_another_scene_does_not_stay) {
    const TemporaryFolder folder;
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --out .").code == 0);
    BOOST_TEST(folder.names().size() == 6);
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --clearance 2 --no-preview --out .").code == 0);
    BOOST_TEST(folder.names().size() == 5);
}

BOOST_AUTO_TEST_CASE(files_that_may_not_grow_are_named_and_leave_no_half_and_no_other_scene) {
    const TemporaryFolder folder;
    BOOST_TEST_REQUIRE(runScene(folder, "peg-in-hole-1 --no-preview --out .").code == 0);
    const Outcome outcome = runScene(folder, "--version > /dev/null; ulimit -f 60; " CLEARWAY_PROGRAM
                                             "-scene peg-in-hole-1 --clearance 2 --out . 2> said");
    BOOST_TEST(outcome.code == 2);
    const std::string said = readText(folder.file("said"));
    BOOST_TEST(said.find("cannot write './peg-in-hole_part.obj'") != std::string::npos, said);
    BOOST_TEST(folder.names() == std::vector<std::string>{"said"});
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused_and_makes_nothing) {
    const TemporaryFolder folder;
    folder.write("file", "x");
    const auto refused = [&](const std::string& arguments, const std::vector<std::string>& words) {
        requireRefused(folder, arguments, words, kSceneProgram);
    };
    refused("", {"NAME is missing", "clearway-scene"});
    refused("'' --out out", {"clearway-scene: NAME is '', expected: clearway-scene"});
    refused("tunnel --out made", {"'tunnel'", "tunnel-console"});
    refused("tunnel-console", {"--out is missing"});
    refused("tunnel-console more --out made", {"'more'"});
    refused("tunnel-console --out file", {"--out is 'file'", "expected a folder"});
    refused("tunnel-console --out file/made", {"file/made"});
    refused("tunnel-console --out made --seed x", {"--seed is 'x', expected an integer from 0"});
    refused("tunnel-console --out made --seed -1", {"--seed is '-1', expected an integer from 0"});
    refused("tunnel-console --out made --part-triangles 1e3",
            {"--part-triangles is '1e3', expected an integer"});
    refused("tunnel-console --out made --part-triangles 10", {"10", "expected"});
    refused("tunnel-console --out made --environment-triangles 10", {"10", "expected"});
    refused("tunnel-console --out made --clearance 0", {"--clearance is '0', expected a number above 0"});
    refused("tunnel-console --out made --clearance nan", {"--clearance is 'nan', expected a number"});
    refused("tunnel-console --out made --clearance 1000", {"1000", "expected"});
    refused("tunnel-console --out made --colour red", {"--colour"});
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
