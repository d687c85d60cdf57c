// Tests the explanations that `plan` prints when it finds no path.
#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/door_scene.h"
#include "support/invalid_words.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(why_no_path_test)

/// The closed box as files.
struct DoorFolder : TemporaryFolder {
    DoorFolder() {
        saveMesh(door.part, file("block.obj"));
        saveMesh(door.box, file("box.obj"));
        door.problem.meshes.robot = file("block.obj");
        door.problem.meshes.world = file("box.obj");
        writeProblem(door.problem, file("door.cfg"));
    }

    DoorScene door = doorScene();
};

constexpr const char* kPlan = "plan door.cfg --path out.path --iterations 1000";

std::string added(const std::string& more) {
    return std::string(kPlan) + " " + more;
}

BOOST_AUTO_TEST_CASE(without_a_path_the_program_says_what_it_learnt_and_what_may_help) {
    const DoorFolder folder;
    const Outcome outcome = runIn(folder, kPlan);
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(holds(row(outcome, "from the start"), "may be shut in"));
    BOOST_TEST(holds(row(outcome, "at the start"), "'door'"));
    BOOST_TEST(!holds(row(outcome, "at the start"), "the bounds"));
    BOOST_TEST(holds(outcome.out, "hint:               --explain", "hint:               --nearest"));
    BOOST_TEST(!holds(outcome.out, "--margin"));  // there is none to lessen
    BOOST_TEST(holds(runIn(folder, kPlan).out, outcome.out.substr(outcome.out.find("part's diagonal"))));
}

BOOST_AUTO_TEST_CASE(the_nearest_miss_is_a_path_that_check_refuses_where_the_program_says) {
    const DoorFolder folder;
    const Outcome outcome = runIn(folder, added("--nearest near.path"));
    const std::string nearest = row(outcome, "nearest");
    BOOST_TEST_REQUIRE(holds(nearest, "near.path, segment "), nearest);
    const Outcome checked = runIn(folder, "check door.cfg near.path");
    BOOST_TEST(checked.code == 1);
    BOOST_TEST(checked.err == "");  // it begins at the start and ends at the goal
    const std::string segment =
        nearest.substr(nearest.find("segment "), nearest.find(" is not") - nearest.find("segment "));
    BOOST_TEST(holds(row(checked, "first"), segment + ", "), row(checked, "first"));
    BOOST_TEST(holds(row(checked, "audit"), "NOT valid: 1 of "), row(checked, "audit"));
}

BOOST_AUTO_TEST_CASE(without_a_path_the_page_shows_the_nearest_miss_and_rows_tell_what_is_not_written) {
    const DoorFolder folder;
    const Outcome outcome = runIn(folder, added("--report out.html --export out.glb --swept out.stl"));
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(holds(row(outcome, "report"), "out.html, ", "of the nearest miss"), outcome.out);
    BOOST_TEST(holds(readText(folder.file("out.html")), "no path was found", "NOT valid: 1 of ", "</html>"));
    for (const char* label : {"export", "swept"}) BOOST_TEST(holds(row(outcome, label), "not written"));
    const std::vector<std::string> names = folder.names();
    for (const char* name : {"out.glb", "out.stl", "near.path"})
        BOOST_TEST(std::count(names.begin(), names.end(), name) == 0);
}

constexpr const char* kAllFiles = " --nearest near.path --report out.html --export out.glb --swept out.stl";

BOOST_AUTO_TEST_CASE(an_invalid_end_and_an_interrupt_leave_no_file_out_in_silence) {
    const DoorFolder folder;
    Problem problem = folder.door.problem;
    problem.goal.position.x() = 4;  // in the door
    writeProblem(problem, folder.file("goal.cfg"));
    std::swap(problem.start, problem.goal);
    writeProblem(problem, folder.file("start.cfg"));
    const std::vector<std::string> before = folder.names();
    for (const std::string name : {"goal", "start"}) {
        const Outcome outcome = runIn(folder, "plan " + name + ".cfg --path out.path" + kAllFiles);
        BOOST_TEST(outcome.code == 2, outcome.out);
        BOOST_TEST(holds(outcome.err, name + " is " + beginningOf(WhyInvalid::Kind::kCollides)), outcome.err);
        for (const char* label : {"nearest", "report", "export", "swept"})
            BOOST_TEST(holds(row(outcome, label), "not written"));
    }
    const Outcome ended =
        interruptIn(folder, std::string("plan door.cfg --path out.path --time 300") + kAllFiles);
    BOOST_TEST(ended.code == 1, ended.err);
    for (const char* label : {"nearest", "report", "export", "swept"})
        BOOST_TEST(holds(row(ended, label), "not written", "interrupted"));
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_nearest_miss_is_written_when_a_path_was_found) {
    const DoorFolder folder;
    Problem problem = folder.door.problem;
    problem.rules.ignored = {"door"};
    writeProblem(problem, folder.file("open.cfg"));
    const Outcome outcome = runIn(
        folder, "plan open.cfg --path out.path --quick --iterations 20000 --nearest near.path --explain 5");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(row(outcome, "nearest"), "not written"));
    BOOST_TEST(readText(folder.file("near.path")) == "");
}

BOOST_AUTO_TEST_CASE(the_explanation_names_the_door) {
    const DoorFolder folder;
    const Outcome outcome = runIn(folder, added("--explain 100"));
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(holds(row(outcome, "explained by"), "greedy"));
    BOOST_TEST(row(outcome, "found without") == "'door'");
}

BOOST_AUTO_TEST_CASE(the_way_outside_is_explained_and_with_one_obstacle_the_margin_is) {
    const DoorFolder folder;
    Problem problem = folder.door.problem;
    problem.outside = Outside{};
    writeProblem(problem, folder.file("outside.cfg"));
    const Outcome outside = runIn(folder, "plan outside.cfg --path out.path --iterations 1000 --explain 100");
    BOOST_TEST(outside.code == 1, outside.err);
    BOOST_TEST(row(outside, "found without") == "'door'");
    problem = readProblem(CLEARWAY_DATA_DIR "/window/window.cfg");
    saveMesh(named(loadMesh(problem.meshes.world), "wall"), folder.file("wall.obj"));
    problem.meshes.world = folder.file("wall.obj");
    writeProblem(problem, folder.file("one.cfg"));
    const Outcome one =
        runIn(folder, "plan one.cfg --margin 12 --path out.path --iterations 1000 --explain 100");
    BOOST_TEST(one.code == 1, one.err);
    BOOST_TEST(holds(row(one, "found with margin"), " in place of 12 (all margins times "), one.out);
    BOOST_TEST(!holds(one.out, "found without"));
    BOOST_TEST(!holds(one.out, "greedy"));
}

BOOST_AUTO_TEST_CASE(a_path_that_a_trial_finds_among_all_obstacles_is_written) {
    const TemporaryFolder folder;
    const std::string gates = CLEARWAY_DATA_DIR "/gates/gates.cfg --margin 1";
    // The planning has no time to find a path, but each trial has more than a second.
    const Outcome outcome =
        runIn(folder, "plan " + gates + " --time 0.00001 --explain 20 --path out.path --report out.html");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(row(outcome, "found by"), "a trial of --explain"), outcome.out);
    BOOST_TEST(!holds(outcome.out, "found without"));
    BOOST_TEST(!holds(outcome.out, "hint:"));
    BOOST_TEST(holds(row(outcome, "audit"), "valid along the whole path"));
    BOOST_TEST(runIn(folder, "check " + gates + " out.path").code == 0);
    BOOST_TEST(holds(readText(folder.file("out.html")), "</html>"));
}

BOOST_AUTO_TEST_CASE(without_names_and_margins_there_is_nothing_to_explain) {
    const DoorFolder folder;
    saveMesh(boxMesh({Vector3(4, -4, -4), Vector3(5, 4, 4)}), folder.file("box.obj"));
    requireRefused(folder, added("--explain 5"), {"--explain", "1 obstacle and no margin", "expected"});
    requireRefused(folder, added("--explain 0"), {"--explain is '0'"});
    requireRefused(folder, added("--nearest ./box.obj"), {"--nearest is './box.obj'", "input file"});
    requireRefused(folder, added("--nearest out.path"), {"another file"});
}

BOOST_AUTO_TEST_CASE(an_end_at_a_derived_bound_is_told_with_the_key_that_moves_the_bound) {
    const DoorFolder folder;
    Problem problem = folder.door.problem;
    problem.volume.reset();
    writeProblem(problem, folder.file("derived.cfg"));
    const Outcome outcome = runIn(folder, "plan derived.cfg --path out.path --iterations 1000");
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(row(outcome, "bounds") == "the goal is at the greatest x");
    BOOST_TEST(holds(row(outcome, "hint"), "volume.max.x in the problem file"));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
