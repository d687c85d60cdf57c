#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(read_problem_test)

using testing::holds;
using testing::requireRefusedBy;
using testing::TemporaryFolder;

const std::string kSpatial = R"([problem]
name = drawer   # a comment
robot = part.stl
world=world.stl
start.x = 1
start.y = -2.5
start.z = 3e1
start.axis.x = 0
start.axis.y = 0
start.axis.z = 2
start.theta = 1.5707963267948966
goal.x = 4
goal.y = 5
goal.z = 6
goal.axis.x = 1
goal.axis.y = 0
goal.axis.z = 0
goal.theta = 0
)";

const std::string kPlanar = R"([problem]
robot = part.stl
world = world.stl
start.x = 1
start.y = 2
start.theta = 0.5
goal.x = 3
goal.y = 4
goal.theta = -3.141592653589793
)";

/// The text with the first line that begins with the key replaced (or removed).
std::string with(std::string text, const std::string& key, const std::string& line) {
    const std::size_t begin = text.find("\n" + key) + 1;
    BOOST_TEST_REQUIRE(begin != 0, key << " is not in the text");
    const std::size_t end = text.find('\n', begin) + 1;
    return text.replace(begin, end - begin, line.empty() ? "" : line + "\n");
}

Problem read(const std::string& text) {
    const TemporaryFolder folder;
    return readProblem(folder.write("a.cfg", text));
}

/// Checks that a problem of this text is refused with the file's name and all the words.
void requireRefused(const std::string& text, std::vector<std::string> words) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.cfg", text);
    words.front().insert(0, file + ":");
    requireRefusedBy([&] { readProblem(file); }, words);
}

/// Checks that a problem of this text is read with as many warnings, each of which holds its words.
void requireWarned(const std::string& text, const std::vector<std::vector<std::string>>& expected) {
    const TemporaryFolder folder;
    const std::vector<std::string> warnings = readProblem(folder.write("a.cfg", text)).warnings;
    BOOST_TEST_REQUIRE(warnings.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (const std::string& word : expected[i])
            BOOST_TEST(holds(warnings[i], word), "no \"" << word << "\" in: " << warnings[i]);
    }
}

BOOST_AUTO_TEST_CASE(states_in_space_are_position_axis_and_angle) {
    const Problem problem = read(kSpatial);
    BOOST_TEST((problem.space == Space::kSe3));
    BOOST_TEST(problem.name == "drawer");
    BOOST_TEST(problem.start.position == Vector3(1, -2.5, 30));
    const double half = std::sqrt(0.5);
    BOOST_TEST((problem.start.rotation.vec() - Vector3(0, 0, half)).norm() <= 2e-16);
    BOOST_TEST(std::abs(problem.start.rotation.w() - half) <= 2e-16);
    BOOST_TEST(problem.goal.position == Vector3(4, 5, 6));
    BOOST_TEST(problem.goal.rotation.w() == 1);
    BOOST_TEST(!problem.volume);
    BOOST_TEST(problem.planning.objective == "length");
    BOOST_TEST(problem.margin == 0);
    BOOST_TEST(!problem.fineness);
    BOOST_TEST(problem.meshes.asOmplApp);
    BOOST_TEST(problem.warnings.empty());
}

BOOST_AUTO_TEST_CASE(states_in_the_plane_turn_about_z) {
    const Problem problem = read(kPlanar);
    BOOST_TEST((problem.space == Space::kSe2));
    BOOST_TEST(problem.start.position == Vector3(1, 2, 0));
    BOOST_TEST(problem.start.rotation.w() == std::cos(0.25));
    BOOST_TEST(problem.start.rotation.z() == std::sin(0.25));
    BOOST_TEST(std::abs(problem.goal.rotation.z() + 1) < 1e-15);
}

BOOST_AUTO_TEST_CASE(volume_objective_and_clearways_own_keys_are_read) {
    const Problem problem = read(kSpatial + R"(volume.min.x = -10
volume.min.y = -11
volume.min.z = -12
volume.max.x = 10
volume.max.y = 11
volume.max.z = 42
objective = max_min_clearance
objective.threshold = 0.25
sampler = obstacle_based
[clearway]
margin = 1.5
fineness = 0.5
reading = stored
)");
    BOOST_TEST_REQUIRE(problem.volume.has_value());
    BOOST_TEST(problem.volume->min() == Vector3(-10, -11, -12));
    BOOST_TEST(problem.volume->max() == Vector3(10, 11, 42));
    BOOST_TEST(problem.planning.objective == "max_min_clearance");
    BOOST_TEST(problem.planning.objectiveThreshold.value() == 0.25);
    BOOST_TEST(problem.planning.sampler == "obstacle_based");
    BOOST_TEST(problem.margin == 1.5);
    BOOST_TEST(problem.fineness.value() == 0.5);
    BOOST_TEST(!problem.meshes.asOmplApp);
    BOOST_TEST(problem.warnings.empty());
}

BOOST_AUTO_TEST_CASE(a_margin_of_the_deflection_keeps_both_surfaces_clear) {
    const Problem problem = read(kSpatial + "[clearway]\ndeflection = 0.05\nmargin = deflection\n");
    BOOST_TEST(problem.deflection == 0.05);
    BOOST_TEST(problem.margin == 0.1);
    BOOST_TEST(read(kSpatial + "[clearway]\ndeflection = 0.05\n").margin == 0);
}

BOOST_AUTO_TEST_CASE(missing_keys_are_named) {
    requireRefused("", {" [problem] robot is missing", "the part's mesh file"});
    requireRefused(with(kSpatial, "robot", ""), {" [problem] robot is missing", "the part's mesh file"});
    requireRefused(with(kSpatial, "world", ""),
                   {" [problem] world is missing", "the environment's mesh file"});
    for (const std::string state : {"start.", "goal."}) {
        const std::string instead = state == "goal." ? "[clearway] goal = outside" : "expected";
        for (const std::string key : {"x", "y", "z", "axis.x", "axis.y", "axis.z", "theta"})
            requireRefused(with(kSpatial, state + key, ""),
                           {" [problem] " + state + key + " is missing", "axis.z and theta", instead});
        for (const std::string key : {"x", "y", "theta"})
            requireRefused(with(kPlanar, state + key, ""),
                           {" [problem] " + state + key + " is missing", "x, y and theta", instead});
    }
    requireRefused(kPlanar + "goal.z = 1\n", {" [problem] start.z is missing", "axis.z and theta"});
}

BOOST_AUTO_TEST_CASE(a_key_that_is_probably_meant_is_named_beside_the_missing_one) {
    requireRefused(with(kSpatial, "start.theta", "strat.theta = 0"),
                   {" ", "start.theta is missing", "is [problem] strat.theta in line "});
    requireRefused(with(kSpatial, "goal.x", "") + "[clearway]\nreading = stored\ngoal.x = 1\n",
                   {" ", "goal.x is missing", "is [clearway] goal.x in line ", "[clearway] goal = outside"});
}

BOOST_AUTO_TEST_CASE(values_that_are_no_finite_numbers_are_refused) {
    for (const std::string value : {"abc", "inf", "nan", "1,5", "1 2", "1e999"})
        requireRefused(with(kSpatial, "start.x", "start.x = " + value),
                       {"5:", "[problem] start.x is '" + value + "'", "a finite number"});
    requireRefused(with(kSpatial, "start.x", "start.x ="), {"5:", "start.x is ''", "a value"});
    requireRefused(with(kSpatial, "robot", "robot ="), {"3:", "robot is ''", "a value"});
}

BOOST_AUTO_TEST_CASE(values_out_of_their_range_are_refused) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> wrong = {
        {"[clearway]\ndeflection = -1", {"20:", "deflection is '-1'", "a number of at least 0"}},
        {"[clearway]\nmargin = deflection",
         {"20:", "margin is 'deflection'", "the key deflection beside it"}},
        {"[clearway]\nmargin = -1", {"20:", "margin is '-1'", "a number of at least 0"}},
        {"[clearway]\nstep = 0", {"20:", "step is '0'", "a number above 0"}},
        {"[clearway]\nrobot.scale = 0", {"20:", "robot.scale is '0'", "a number above 0"}},
        {"[clearway]\nreading = raw", {"20:", "reading is 'raw'", "omplapp or stored"}},
        {"[benchmark]\ntime_limit = 0", {"20:", "time_limit is '0'", "a number above 0"}},
        {"[benchmark]\nrun_count = 2.5", {"20:", "run_count is '2.5'", "an integer from 1 to 1000000"}},
        {"[benchmark]\nsave_paths = some", {"20:", "save_paths is 'some'", "none, all, shortest or best"}},
        {"[benchmark]\nsimplify = maybe", {"20:", "simplify is 'maybe'", "1, true"}},
        {"threshold = -1", {"19:", "threshold is '-1'", "a number of at least 0"}},
        {"[planner]\nrrt. = 5", {"20:", "'rrt.'", "NAME.PARAMETER = VALUE"}},
        {"[planner]\nrrt=\nproblem.objective.threshold = low", {"21:", "'low'", "a finite number"}}};
    for (const auto& [tail, words] : wrong) requireRefused(kSpatial + tail + "\n", words);
    requireRefused(with(kSpatial, "goal.axis.x", "goal.axis.x = 0"),
                   {"15:", "goal.axis.x is '0'", "of length above 0"});
    requireRefused(with(kSpatial, "goal.x", "goal.x = 1e300"), {"12:", "goal.x is '1e300'", "at most 1e+30"});
    BOOST_TEST(read(kSpatial + "threshold = 0\n").planning.goalThreshold.value() == 0);
}

BOOST_AUTO_TEST_CASE(a_volume_is_whole_and_has_an_inside) {
    const std::string volume = "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 9\nvolume.max.y = 9\n";
    BOOST_TEST(read(kPlanar + volume).volume->max() == Vector3(9, 9, 0));
    requireRefused(with(kPlanar + volume, "volume.max.y", ""),
                   {" [problem] volume.max.y is missing", "x, y or none"});
    requireRefused(kSpatial + volume, {" [problem] volume.min.z is missing", "x, y, z or none"});
    requireRefused(with(kPlanar + volume, "volume.min.y", "volume.min.y = 9"),
                   {"11:", "volume.min.y is '9'", "less than volume.max.y = 9"});
}

BOOST_AUTO_TEST_CASE(lines_that_stand_twice_or_are_neither_section_nor_key_are_refused) {
    requireRefused(kSpatial + "start.x = 7\n", {"19:", "start.x", "'7'", "'1' in line 5", "expected once"});
    requireRefused(kSpatial + "[clearway]\nmargin = 1\nmargin = 2\n",
                   {"21:", "margin", "'2'", "'1' in line 20", "expected once"});
    for (const std::string line : {"sampler", "= 5", "[problem"})
        requireRefused(kSpatial + line + "\n", {"19:", "'" + line + "'", "[section] or key = value"});
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_an_error_in_a_file_of_clearway_for_it_may_decide_what_is_valid) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> wrong = {
        {"[clearway]\nsolids = wall\n",
         {"20:", "solids = 'wall'", "did you mean 'solid'?",
          "contact.goal, contact.start, deflection, fineness, goal,"}},
        {"[Clearway]\nmargin = 2\n", {"19:", "[Clearway]", "did you mean 'clearway'?", "[planner]"}},
        {"[clearwey]\nmargin = 2\n", {"19:", "did you mean"}},
        {"[planer]\n", {"19:", "did you mean"}},
        {"[notes]\n[clearway]\n", {"19:", "[notes]", "[problem], [benchmark], [planner] or [clearway]"}},
        {"volum.min.x = 0\n[clearway]\n# margin = 2\n", {"19:", "unknown key"}},
        {"voluem.min.x = 0\n[clearway]\nmargin = 0\n",
         {"19:", "voluem.min.x = '0'", "'volume.min.x'", "name, robot"}},
        {"[benchmark]\nruns = 5\n[clearway]\nmargin = 0\n", {"20:", "runs = '5'", "unknown", "time_limit"}},
        {"margin = 2\n[clearway]\nreading = stored\n", {"19:", "margin = '2'", "belongs in [clearway]"}}};
    for (const auto& [tail, words] : wrong) requireRefused(kSpatial + tail, words);
}

BOOST_AUTO_TEST_CASE(a_key_in_another_section_is_told_where_it_belongs) {
    const std::string degrees = with(kSpatial, "goal.theta", "goal.degrees = 90");
    for (const std::string tail : {"", "[clearway]\nmargin = 0\n"})
        requireRefused(degrees + tail, {"18:", "goal.degrees is '90'", "section [clearway]", "goal.theta"});
    requireWarned(kSpatial + "goal.degrees = 90\n",
                  {{":19:", "goal.degrees = '90'", "belongs in [clearway]"}});
}

BOOST_AUTO_TEST_CASE(a_misspelt_setting_of_a_planner_is_an_error_in_a_file_of_clearway) {
    const std::string text = kSpatial + "[planner]\nprm =\nproblem.sampelr = gaussian\n";
    requireWarned(text, {{":21:", "problem.sampelr", "did you mean 'sampler'?"}});
    requireRefused(text + "[clearway]\nmargin = 0\n", {"21:", "problem.sampelr", "'sampler'", "problem.KEY"});
}

BOOST_AUTO_TEST_CASE(angles_are_in_radians_or_say_that_they_are_in_degrees) {
    const std::string quarter = with(kSpatial, "start.theta", "");
    const Problem degrees = read(quarter + "[clearway]\nstart.degrees = 90\n");
    BOOST_TEST(std::abs(degrees.start.rotation.w() - std::sqrt(0.5)) <= 2e-16);
    requireRefused(kSpatial + "[clearway]\nstart.degrees = 90\n",
                   {"20:", "start.degrees is '90'", "start.theta, not both"});
    const std::string turns = with(kSpatial, "start.theta", "start.theta = 90");
    requireRefused(turns + "[clearway]\nmargin = 0\n", {"11:", "start.theta is '90'", "radians",
                                                        "degrees are written [clearway] start.degrees = 90"});
    requireWarned(turns, {{"in radians, more than a turn", "[clearway] start.degrees = 90"}});
    requireWarned(with(kSpatial, "start.theta", "start.theta = -6.2831853071795865"), {});
    requireWarned(with(kSpatial, "goal.theta", "goal.theta = 6.2832"), {});  // people round 2 pi
    requireRefused(with(kSpatial, "goal.theta", "") + "[clearway]\ngoal = outside\ngoal.degrees = 5\n",
                   {"", "expected no such key together with"});
}

BOOST_AUTO_TEST_CASE(fineness_may_have_its_older_name) {
    BOOST_TEST(read(kSpatial + "[clearway]\nstep = 2\n").fineness.value() == 2);
    requireRefused(kSpatial + "[clearway]\nstep = 2\nfineness = 2\n",
                   {"20:", "step is '2'", "only one of step and fineness"});
}

BOOST_AUTO_TEST_CASE(a_file_of_clearway_reads_meshes_as_stored_and_others_as_omplapp_does) {
    BOOST_TEST(read(kSpatial).meshes.asOmplApp);
    BOOST_TEST(!read(kSpatial).meshes.isReadingStated);
    const Problem unsaid = read(kSpatial + "[clearway]\nmargin = 0\n");
    BOOST_TEST(!unsaid.meshes.asOmplApp);
    BOOST_TEST(!unsaid.meshes.isReadingStated);
    const Problem stated =
        read(kSpatial + "[clearway]\nreading = omplapp\nrobot.scale = 0.001\nworld.scale = 25.4\n");
    BOOST_TEST(stated.meshes.asOmplApp);
    BOOST_TEST(stated.meshes.isReadingStated);
    BOOST_TEST(stated.meshes.partScale == 0.001);
    BOOST_TEST(stated.meshes.worldScale == 25.4);
}

BOOST_AUTO_TEST_CASE(a_part_without_extent_is_refused_by_name) {
    const TemporaryFolder folder;
    Problem problem;
    problem.meshes.asOmplApp = false;
    problem.meshes.robot = folder.write("point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    requireRefusedBy([&] { loadPart(problem); },
                     {problem.meshes.robot, "no extent", "at (1, 2, 3)", "some length"});
}

BOOST_AUTO_TEST_CASE(a_part_that_the_readings_place_differently_needs_a_stated_reading) {
    const TemporaryFolder folder;
    Mesh off;
    off.vertices = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
    off.triangles = {{0, 1, 2}};
    Mesh centred = off;
    for (Vector3& v : centred.vertices) v -= Vector3(16, 1, 0) / 3;
    centred.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
    saveMesh(off, folder.file("off.obj"));
    saveMesh(centred, folder.file("centred.obj"));
    Problem problem;
    problem.file = "p.cfg";
    problem.meshes.world = folder.file("off.obj");
    problem.meshes.asOmplApp = problem.meshes.isReadingStated = false;
    problem.meshes.robot = folder.file("centred.obj");
    BOOST_TEST(loadPart(problem).vertices[0] == Vector3(-1, -1, 0));
    problem.meshes.robot = folder.file("off.obj");
    requireRefusedBy([&] { loadPart(problem); },
                     {"p.cfg: [clearway]", "moved by (-5.333", "(5, 0, 0) to (6, 1, 0)", "(-0.33",
                      "expected reading = stored or reading = omplapp"});
    problem.meshes.asOmplApp = true;
    BOOST_TEST(holds(readingNote(problem, loadPart(problem)), "moved by (-5.33"));
    problem.meshes.isReadingStated = true;
    BOOST_TEST(readingNote(problem, loadPart(problem)).empty());
    problem.meshes.asOmplApp = false;
    problem.meshes.partScale = 2;
    BOOST_TEST(loadPart(problem).vertices[1] == Vector3(12, 0, 0));
}

/// The text without the goal's lines, with a section [clearway].
std::string withoutGoal(const std::string& text, const std::string& clearway) {
    std::string kept;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, 5, "goal.") != 0) kept += line + "\n";
    }
    return kept + "[clearway]\n" + clearway;
}

BOOST_AUTO_TEST_CASE(a_goal_outside_is_read_with_its_side_and_without_a_pose) {
    const Problem anySide = read(withoutGoal(kSpatial, "goal = outside\n"));
    BOOST_REQUIRE(anySide.outside.has_value());
    BOOST_TEST(!anySide.outside->side);
    BOOST_TEST((anySide.space == Space::kSe3));
    BOOST_TEST(anySide.warnings.empty());
    for (const char* name : {"+x", "-x", "+y", "-y", "+z", "-z"}) {
        const Problem problem =
            read(withoutGoal(kSpatial, std::string("goal = outside\noutside = ") + name + "\n"));
        BOOST_TEST(nameOf(problem.outside.value().side.value()) == name);
    }
    BOOST_TEST((read(withoutGoal(kPlanar, "goal = outside\noutside = -y\n")).space == Space::kSe2));
    BOOST_TEST(!read(kSpatial).outside);
    const std::string threshold = with(withoutGoal(kSpatial, "goal = outside\n"), "name", "threshold = 1");
    BOOST_TEST(read(threshold).warnings.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_goal_outside_that_is_wrong_or_has_a_pose_is_refused_with_its_line) {
    const std::string outside = "goal = outside\n";
    requireRefused(withoutGoal(kSpatial, "goal = out\n"), {"13:", "goal is 'out'", "expected outside"});
    requireRefused(withoutGoal(kSpatial, outside + "outside = up\n"),
                   {"14:", "outside is 'up'", "+x, -x, +y, -y, +z or -z"});
    requireRefused(withoutGoal(kPlanar, outside + "outside = +z\n"), {"", "'+z'", "+x, -x, +y or -y"});
    requireRefused(kSpatial + "[clearway]\noutside = +x\n", {"20:", "outside is '+x'", "goal = outside"});
    requireRefused(kSpatial + "[clearway]\n" + outside, {"", "expected no such key", "goal = outside"});
    requireRefused(withoutGoal(kSpatial, outside + "contact.goal = wall, 1\n"),
                   {"14:", "contact.goal is 'wall, 1'", "expected no such key", "goal = outside"});
}

BOOST_AUTO_TEST_CASE(other_unknown_keys_and_sections_are_warned_of_once_each) {
    requireWarned(kSpatial +
                      "solution_length = 5\ncontrol = dynamic_car\n[notes]\nby = me\non = monday\n"
                      "[planner]\nproblem.range = 1\nprm = 5\n",
                  {{":21:", "[notes]", "no effect"},
                   {":25:", "problem.range", "no effect"},
                   {":26:", "prm is '5'", "no effect", "NAME.PARAMETER = VALUE"},
                   {":19:", "solution_length = '5'", "no effect"},
                   {":20:", "control = 'dynamic_car'", "not supported"}});
}

BOOST_AUTO_TEST_CASE(planners_come_in_order_with_the_parameters_set_after_them) {
    const Problem problem = read(kSpatial + R"([planner]
rrtconnect.Range = 50
RRTConnect=
rrtconnect.range=100
rrtconnect.range=200
prm=
rrtconnect=
rrtconnect.name=Second RRT*
kpiece=
)");
    using Parameters = std::vector<std::pair<std::string, std::string>>;
    BOOST_TEST_REQUIRE(problem.planning.planners.size() == 5);
    BOOST_TEST((problem.planning.planners[0].name == "rrtconnect" &&
                problem.planning.planners[0].parameters == Parameters{{"range", "50"}}));
    BOOST_TEST((problem.planning.planners[1].name == "rrtconnect" &&
                problem.planning.planners[1].parameters == Parameters{{"range", "200"}}));
    BOOST_TEST(
        (problem.planning.planners[2].name == "prm" && problem.planning.planners[2].parameters.empty()));
    BOOST_TEST((problem.planning.planners[3].name == "rrtconnect" &&
                problem.planning.planners[3].parameters == Parameters{{"name", "Second RRT*"}}));
    BOOST_TEST(
        (problem.planning.planners[4].name == "kpiece" && problem.planning.planners[4].parameters.empty()));
    BOOST_TEST(problem.warnings.empty());
}

BOOST_AUTO_TEST_CASE(settings_go_to_all_planners_or_to_the_one_named_before_them) {
    const Problem problem = read(kSpatial + R"(threshold = 1e-3
Longest_Valid_Segment_Fraction = 0.02
standard_deviation = 7
[planner]
problem.sampler = gaussian
prm=
problem.longest_valid_segment_fraction = 0.1
problem.longest_valid_segment_fraction = 0.2
rrt=
kpiece.border_fraction = 0.5
problem.projection.cellsize_factor = 4.0
problem.objective.threshold = 12.5
prm.max_nearest_neighbors = 5
problem.nr_attempts = 9
)");
    BOOST_TEST(problem.planning.goalThreshold.value() == 1e-3);
    BOOST_TEST((problem.planning.settings ==
                NamedTexts{{"longest_valid_segment_fraction", "0.02"}, {"standard_deviation", "7"}}));
    BOOST_TEST_REQUIRE(problem.planning.planners.size() == 3);
    BOOST_TEST((problem.planning.planners[0].settings == NamedTexts{{"sampler", "gaussian"},
                                                                    {"longest_valid_segment_fraction", "0.2"},
                                                                    {"nr_attempts", "9"}}));
    BOOST_TEST(problem.planning.planners[1].settings.empty());
    BOOST_TEST((problem.planning.planners[2].settings ==
                NamedTexts{{"projection.cellsize_factor", "4.0"}, {"objective.threshold", "12.5"}}));
    BOOST_TEST(problem.warnings.empty());
}

BOOST_AUTO_TEST_CASE(all_planners_have_one_objective) {
    const Problem named = read(kSpatial + "[planner]\nrrt=\nproblem.objective = mechanical_work\n");
    BOOST_TEST(named.planning.objective == "mechanical_work");
    requireWarned(kSpatial + "objective = length\n[planner]\nrrt=\nproblem.objective = other\n",
                  {{":22:", "problem.objective is 'other'", "no effect", "'length'"}});
    requireWarned(kSpatial + "[planner]\nproblem.sampler = uniform\n", {{"problem.sampler", "no planner"}});
}

BOOST_AUTO_TEST_CASE(all_keys_of_the_benchmark_are_read) {
    const Problem problem = read(kSpatial + R"([benchmark]
time_limit = 8.5
mem_limit = 4096
run_count = 50
output = ../results/
save_paths = best_path
simplify = 0
)");
    BOOST_TEST(problem.benchmark.timeLimit.value() == 8.5);
    BOOST_TEST(problem.benchmark.memoryLimit.value() == 4096);
    BOOST_TEST(problem.benchmark.runCount.value() == 50);
    BOOST_TEST(problem.benchmark.outputFolder == "../results/");
    BOOST_TEST((problem.benchmark.savedPaths == SavedPaths::kShortest));
    BOOST_TEST(!problem.benchmark.simplify);
    BOOST_TEST(problem.warnings.empty());
    const Problem bare = read(kSpatial);
    BOOST_TEST((bare.benchmark.savedPaths == SavedPaths::kNone));
    BOOST_TEST(bare.benchmark.simplify);
    BOOST_TEST((read(kSpatial + "[benchmark]\nsave_paths = all\n").benchmark.savedPaths == SavedPaths::kAll));
}

BOOST_AUTO_TEST_CASE(meshes_are_found_beside_the_problem_whatever_the_current_folder) {
    const TemporaryFolder folder;
    const Problem problem =
        readProblem(folder.write("a.cfg", with(kSpatial, "world", "world = /meshes/world.stl")));
    BOOST_TEST(problem.meshes.robot == folder.file("part.stl"));
    BOOST_TEST(problem.meshes.world == "/meshes/world.stl");
    BOOST_TEST(problem.file == folder.file("a.cfg"));
}

BOOST_AUTO_TEST_CASE(a_mesh_found_in_the_current_folder_alone_is_taken_and_said) {
    const TemporaryFolder folder;
    const TemporaryFolder current;
    current.write("part.stl", "");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(current.path());
    const Problem problem = readProblem(folder.write("a.cfg", kSpatial));
    std::filesystem::current_path(before);
    BOOST_TEST(problem.meshes.robot == "part.stl");
    BOOST_TEST(problem.meshes.world == folder.file("world.stl"));
    BOOST_TEST_REQUIRE(problem.warnings.size() == 1);
    BOOST_TEST(holds(problem.warnings[0], problem.file, "'part.stl'", "from the current folder"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
    const TemporaryFolder folder;
    const std::string missing = folder.file("none.cfg");
    requireRefusedBy<std::runtime_error>([&] { readProblem(missing); }, {missing, "No such file", ".cfg"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
