#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"

namespace clearway {

BOOST_AUTO_TEST_SUITE(read_problem_test)

using testing::TemporaryFolder;

namespace {

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

/// The message of readProblem after the file's name and folder.
std::string refusalOf(const std::string& text) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.cfg", text);
    try {
        readProblem(file);
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        BOOST_TEST(message.compare(0, file.size(), file) == 0, message << " does not name " << file);
        return message.substr(file.size());
    }
    return "accepted";
}

std::vector<std::string> warningsOf(const std::string& text) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.cfg", text);
    std::vector<std::string> warnings = readProblem(file).warnings;
    for (std::string& warning : warnings) warning.erase(0, file.size());
    return warnings;
}

constexpr const char* kSpatialKeys =
    "x, y, z, axis.x, axis.y, axis.z and theta of start and goal (SE(2): x, y and theta alone)";

std::string orOutside(const std::string& state) {
    return state == "goal." ? ", or [clearway] goal = outside" : "";
}

}  // namespace

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
    BOOST_TEST(problem.objective == "length");
    BOOST_TEST(problem.margin == 0);
    BOOST_TEST(!problem.fineness);
    BOOST_TEST(problem.asOmplApp);
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

BOOST_AUTO_TEST_CASE(every_section_is_read) {
    const Problem problem = read(kSpatial + R"(volume.min.x = -10
volume.min.y = -11
volume.min.z = -12
volume.max.x = 10
volume.max.y = 11
volume.max.z = 42
objective = max_min_clearance
objective.threshold = 0.25
sampler = obstacle_based
[benchmark]
time_limit=20.0
mem_limit = 1000
run_count = 50
[clearway]
margin = 1.5
fineness = 0.5
reading = stored
)");
    BOOST_TEST_REQUIRE(problem.volume.has_value());
    BOOST_TEST(problem.volume->min() == Vector3(-10, -11, -12));
    BOOST_TEST(problem.volume->max() == Vector3(10, 11, 42));
    BOOST_TEST(problem.objective == "max_min_clearance");
    BOOST_TEST(problem.objectiveThreshold.value() == 0.25);
    BOOST_TEST(problem.sampler == "obstacle_based");
    BOOST_TEST(problem.timeLimit.value() == 20);
    BOOST_TEST(problem.memoryLimit.value() == 1000);
    BOOST_TEST(problem.runCount.value() == 50);
    BOOST_TEST(problem.margin == 1.5);
    BOOST_TEST(problem.fineness.value() == 0.5);
    BOOST_TEST(!problem.asOmplApp);
    BOOST_TEST(problem.warnings.empty());
}

BOOST_AUTO_TEST_CASE(missing_keys_are_named) {
    BOOST_TEST(refusalOf(with(kSpatial, "robot", "")) ==
               ": [problem] robot is missing, expected the part's mesh file");
    BOOST_TEST(refusalOf(with(kSpatial, "world", "")) ==
               ": [problem] world is missing, expected the environment's mesh file");
    for (const char* state : {"start.", "goal."}) {
        for (const char* key : {"x", "y", "z", "axis.x", "axis.y", "axis.z", "theta"}) {
            const std::string name = std::string(state) + key;
            BOOST_TEST(refusalOf(with(kSpatial, name, "")) ==
                       ": [problem] " + name + " is missing, expected " + kSpatialKeys + orOutside(state));
        }
        for (const char* key : {"x", "y", "theta"}) {
            const std::string name = std::string(state) + key;
            BOOST_TEST(refusalOf(with(kPlanar, name, "")) ==
                       ": [problem] " + name +
                           " is missing, expected x, y and theta of start and goal (SE(3): z, axis.x, axis.y "
                           "and axis.z too)" +
                           orOutside(state));
        }
    }
    BOOST_TEST(refusalOf("") == ": [problem] robot is missing, expected the part's mesh file");
}

BOOST_AUTO_TEST_CASE(a_key_that_is_probably_meant_is_named_beside_the_missing_one) {
    const std::string misspelt = with(kSpatial, "start.theta", "strat.theta = 0");
    BOOST_TEST(refusalOf(misspelt).find("start.theta is missing (is [problem] strat.theta in line ") !=
                   std::string::npos,
               refusalOf(misspelt));
    const std::string elsewhere = with(kSpatial, "goal.x", "") + "[clearway]\nreading = stored\ngoal.x = 1\n";
    BOOST_TEST(
        refusalOf(elsewhere).find("goal.x is missing (is [clearway] goal.x in line ") != std::string::npos,
        refusalOf(elsewhere));
    BOOST_TEST(refusalOf(elsewhere).find(", or [clearway] goal = outside") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(one_key_of_space_in_a_planar_problem_asks_for_the_others) {
    BOOST_TEST(refusalOf(kPlanar + "goal.z = 1\n") ==
               std::string(": [problem] start.z is missing, expected ") + kSpatialKeys);
}

BOOST_AUTO_TEST_CASE(values_that_are_no_finite_numbers_are_refused) {
    for (const char* value : {"abc", "inf", "nan", "1,5", "1 2", "1e999"}) {
        BOOST_TEST(refusalOf(with(kSpatial, "start.x", std::string("start.x = ") + value)) ==
                   std::string(":5: [problem] start.x is '") + value + "', expected a finite number");
    }
    BOOST_TEST(refusalOf(with(kSpatial, "start.x", "start.x =")) ==
               ":5: [problem] start.x is '', expected a value");
    BOOST_TEST(refusalOf(with(kSpatial, "robot", "robot =")) ==
               ":3: [problem] robot is '', expected a value");
}

BOOST_AUTO_TEST_CASE(values_out_of_their_range_are_refused) {
    const auto refusal = [](const std::string& tail) { return refusalOf(kSpatial + tail); };
    BOOST_TEST(refusal("[clearway]\nmargin = -1") ==
               ":20: [clearway] margin is '-1', expected a number of at least 0");
    BOOST_TEST(refusal("[clearway]\nstep = 0") == ":20: [clearway] step is '0', expected a number above 0");
    BOOST_TEST(refusal("[clearway]\nreading = raw") ==
               ":20: [clearway] reading is 'raw', expected omplapp or stored");
    BOOST_TEST(refusal("[benchmark]\ntime_limit = 0") ==
               ":20: [benchmark] time_limit is '0', expected a number above 0");
    BOOST_TEST(refusal("[benchmark]\nrun_count = 2.5") ==
               ":20: [benchmark] run_count is '2.5', expected an integer from 1 to 1000000");
    BOOST_TEST(refusalOf(with(kSpatial, "goal.axis.x", "goal.axis.x = 0")) ==
               ":15: [problem] goal.axis.x is '0', expected an axis (x, y, z) of length above 0");
}

BOOST_AUTO_TEST_CASE(a_volume_is_whole_and_has_an_inside) {
    const std::string volume = "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 9\nvolume.max.y = 9\n";
    BOOST_TEST(read(kPlanar + volume).volume->max() == Vector3(9, 9, 0));
    BOOST_TEST(refusalOf(with(kPlanar + volume, "volume.max.y", "")) ==
               ": [problem] volume.max.y is missing, expected all of volume.min and volume.max x, y or none");
    BOOST_TEST(
        refusalOf(kSpatial + volume) ==
        ": [problem] volume.min.z is missing, expected all of volume.min and volume.max x, y, z or none");
    BOOST_TEST(refusalOf(with(kPlanar + volume, "volume.min.y", "volume.min.y = 9")) ==
               ":11: [problem] volume.min.y is '9', expected less than volume.max.y = 9");
}

BOOST_AUTO_TEST_CASE(a_key_that_stands_twice_is_refused) {
    BOOST_TEST(refusalOf(kSpatial + "start.x = 7\n") ==
               ":19: [problem] start.x is given again as '7', after '1' in line 5, expected once");
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\nmargin = 1\nmargin = 2\n") ==
               ":21: [clearway] margin is given again as '2', after '1' in line 20, expected once");
}

BOOST_AUTO_TEST_CASE(lines_that_are_neither_section_nor_key_are_refused) {
    BOOST_TEST(refusalOf(kSpatial + "sampler\n") ==
               ":19: the line is 'sampler', expected [section] or key = value");
    BOOST_TEST(refusalOf(kSpatial + "= 5\n") == ":19: the line is '= 5', expected [section] or key = value");
    BOOST_TEST(refusalOf("[problem\n") == ":1: the line is '[problem', expected [section] or key = value");
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_an_error_in_a_file_of_clearway_for_it_may_decide_what_is_valid) {
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\nsolids = wall\n") ==
               ":20: [clearway] solids = 'wall' is an unknown key (did you mean 'solid'?), expected one of "
               "contact.goal, "
               "contact.start, fineness, goal, goal.degrees, ignore, margin, margin.NAME, outside, overlap, "
               "overlap.NAME, "
               "overlap.thin, overlap.tolerance, reading, robot.scale, solid, start.degrees, step, unit, "
               "world.scale");
    BOOST_TEST(refusalOf(kSpatial + "[Clearway]\nmargin = 2\n") ==
               ":19: the section is [Clearway] (did you mean 'clearway'?), expected [problem], [benchmark], "
               "[planner] or [clearway]");
    for (const char* wrong : {"[clearwey]\nmargin = 2\n", "[Clearway]\n", "[planer]\n"})
        BOOST_TEST(refusalOf(kSpatial + wrong).find("did you mean") != std::string::npos, wrong);
    BOOST_TEST(refusalOf(kSpatial + "[notes]\n[clearway]\n") ==
               ":19: the section is [notes], expected [problem], [benchmark], [planner] or [clearway]");
    BOOST_TEST(refusalOf(kSpatial + "volum.min.x = 0\n[clearway]\n# margin = 2\n").find("unknown key") !=
               std::string::npos);
    const std::string problem = refusalOf(kSpatial + "voluem.min.x = 0\n[clearway]\nmargin = 0\n");
    BOOST_TEST(
        problem.find(":19: [problem] voluem.min.x = '0' is an unknown key (did you mean 'volume.min.x'?), "
                     "expected one of name, robot") == 0u,
        problem);
    const std::string benchmark = refusalOf(kSpatial + "[benchmark]\nruns = 5\n[clearway]\nmargin = 0\n");
    BOOST_TEST(
        benchmark.find(":20: [benchmark] runs = '5' is an unknown key, expected one of time_limit") == 0u,
        benchmark);
}

BOOST_AUTO_TEST_CASE(a_key_in_another_section_is_told_where_it_belongs) {
    const std::string degrees = with(kSpatial, "goal.theta", "goal.degrees = 90");
    const std::string expected =
        ":18: [problem] goal.degrees is '90', expected this key in the section [clearway], or [problem] "
        "goal.theta "
        "in radians";
    BOOST_TEST(refusalOf(degrees) == expected);
    BOOST_TEST(refusalOf(degrees + "[clearway]\nmargin = 0\n") == expected);
    BOOST_TEST(warningsOf(kSpatial + "goal.degrees = 90\n") ==
                   std::vector<std::string>{
                       ":19: [problem] goal.degrees = '90' has no effect here; it belongs in [clearway]"},
               boost::test_tools::per_element());
    BOOST_TEST(
        refusalOf(kSpatial + "margin = 2\n[clearway]\nreading = stored\n")
            .find(":19: [problem] margin = '2' is an unknown key; it belongs in [clearway], expected") == 0u);
}

BOOST_AUTO_TEST_CASE(a_misspelt_setting_of_a_planner_is_an_error_in_a_file_of_clearway) {
    const std::string text = kSpatial + "[planner]\nprm =\nproblem.sampelr = gaussian\n";
    BOOST_TEST(warningsOf(text) ==
                   std::vector<std::string>{
                       ":21: [planner] problem.sampelr has no effect here (did you mean 'sampler'?)"},
               boost::test_tools::per_element());
    BOOST_TEST(
        refusalOf(text + "[clearway]\nmargin = 0\n")
            .find(":21: [planner] problem.sampelr is an unknown setting (did you mean 'sampler'?), expected "
                  "problem.KEY, KEY one of ") == 0u);
}

BOOST_AUTO_TEST_CASE(a_coordinate_too_large_for_any_mesh_is_refused_by_its_key) {
    BOOST_TEST(refusalOf(with(kSpatial, "goal.x", "goal.x = 1e300")) ==
               ":12: [problem] goal.x is '1e300', expected a coordinate of at most 1e+30 in size");
}

BOOST_AUTO_TEST_CASE(angles_are_in_radians_or_say_that_they_are_in_degrees) {
    const std::string quarter = with(kSpatial, "start.theta", "");
    const Problem degrees = read(quarter + "[clearway]\nstart.degrees = 90\n");
    BOOST_TEST(std::abs(degrees.start.rotation.w() - std::sqrt(0.5)) <= 2e-16);
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\nstart.degrees = 90\n") ==
               ":20: [clearway] start.degrees is '90', expected it or [problem] start.theta, not both");
    const std::string turns = with(kSpatial, "start.theta", "start.theta = 90");
    BOOST_TEST(refusalOf(turns + "[clearway]\nmargin = 0\n") ==
               ":11: [problem] start.theta is '90', expected radians, at most 2 pi (if these are degrees: "
               "1.5707964, or [clearway] start.degrees = 90)");
    BOOST_REQUIRE(warningsOf(turns).size() == 1u);
    BOOST_TEST(warningsOf(turns)[0].find(
                   "is in radians, more than a turn; if it is in degrees, write 1.57") != std::string::npos);
    BOOST_TEST(warningsOf(with(kSpatial, "start.theta", "start.theta = -6.2831853071795865")).empty());
    BOOST_TEST(warningsOf(with(kSpatial, "goal.theta", "goal.theta = 6.2832")).empty());  // people round 2 pi
    BOOST_TEST(refusalOf(with(kSpatial, "goal.theta", "") + "[clearway]\ngoal = outside\ngoal.degrees = 5\n")
                   .find("expected no such key together with") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(fineness_may_have_its_older_name) {
    BOOST_TEST(read(kSpatial + "[clearway]\nstep = 2\n").fineness.value() == 2);
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\nstep = 2\nfineness = 2\n") ==
               ":20: [clearway] step is '2', expected it or fineness, not both");
}

BOOST_AUTO_TEST_CASE(a_file_of_clearway_reads_meshes_as_stored_and_others_as_omplapp_does) {
    BOOST_TEST(read(kSpatial).asOmplApp);
    BOOST_TEST(!read(kSpatial).isReadingStated);
    const Problem unsaid = read(kSpatial + "[clearway]\nmargin = 0\n");
    BOOST_TEST(!unsaid.asOmplApp);
    BOOST_TEST(!unsaid.isReadingStated);
    const Problem stated =
        read(kSpatial + "[clearway]\nreading = omplapp\nrobot.scale = 0.001\nworld.scale = 25.4\n");
    BOOST_TEST(stated.asOmplApp);
    BOOST_TEST(stated.isReadingStated);
    BOOST_TEST(stated.partScale == 0.001);
    BOOST_TEST(stated.worldScale == 25.4);
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\nrobot.scale = 0\n").find("expected a number above 0") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_part_without_extent_is_refused_by_name) {
    const TemporaryFolder folder;
    Problem problem;
    problem.asOmplApp = false;
    problem.robot = folder.write("point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    BOOST_CHECK_EXCEPTION(loadPart(problem), std::invalid_argument, [&](const std::invalid_argument& error) {
        return std::string(error.what()) ==
               "the part " + problem.robot +
                   " has no extent: all of it is at (1, 2, 3), expected a mesh with "
                   "some length";
    });
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
    problem.world = folder.file("off.obj");
    problem.asOmplApp = problem.isReadingStated = false;
    problem.robot = folder.file("centred.obj");
    BOOST_TEST(loadPart(problem).vertices[0] == Vector3(-1, -1, 0));
    problem.robot = folder.file("off.obj");
    BOOST_CHECK_EXCEPTION(loadPart(problem), std::invalid_argument, [](const std::invalid_argument& error) {
        const std::string message = error.what();
        BOOST_TEST(message.find("p.cfg: [clearway] does not say how to read ") == 0u, message);
        BOOST_TEST(message.find(" as OMPL.app reads it, moved by (-5.333") != std::string::npos, message);
        BOOST_TEST(message.find("its box is (5, 0, 0) to (6, 1, 0) as the file stores it, and (-0.33") !=
                       std::string::npos,
                   message);
        return message.find("expected reading = stored or reading = omplapp") != std::string::npos;
    });
    problem.asOmplApp = true;
    const std::string note = readingNote(problem, loadPart(problem));
    BOOST_TEST(note.find("the part is moved by (-5.33") == 0u, note);
    problem.isReadingStated = true;
    BOOST_TEST(readingNote(problem, loadPart(problem)).empty());
    problem.asOmplApp = false;
    problem.partScale = 2;
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
    const auto refusal = [](const std::string& text, const std::string& clearway) {
        return refusalOf(withoutGoal(text, clearway));
    };
    BOOST_TEST(
        refusal(kSpatial, "goal = out\n") ==
        ":13: [clearway] goal is 'out', expected outside, or no such key where [problem] has the goal");
    BOOST_TEST(refusal(kSpatial, "goal = outside\noutside = up\n") ==
               ":14: [clearway] outside is 'up', expected +x, -x, +y, -y, +z or -z");
    BOOST_TEST(refusal(kPlanar, "goal = outside\noutside = +z\n").find("expected +x, -x, +y or -y") !=
               std::string::npos);
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\noutside = +x\n") ==
               ":20: [clearway] outside is '+x', expected it only together with goal = outside");
    BOOST_TEST(refusalOf(kSpatial + "[clearway]\ngoal = outside\n")
                   .find("expected no such key together with [clearway] goal = outside") !=
               std::string::npos);
    BOOST_TEST(
        refusal(kSpatial, "goal = outside\ncontact.goal = wall, 1\n") ==
        ":14: [clearway] contact.goal is 'wall, 1', expected no such key together with [clearway] goal = "
        "outside");
}

BOOST_AUTO_TEST_CASE(other_unknown_keys_and_sections_are_warned_of_once_each) {
    const std::vector<std::string> expected = {
        ":21: the section is [notes], which has no effect here",
        ":25: [planner] problem.range has no effect here",
        ":26: [planner] prm is '5', which has no effect: parameters are set as NAME.PARAMETER = VALUE",
        ":19: [problem] solution_length = '5' has no effect here",
        ":20: [problem] control = 'dynamic_car' is not supported: planned as a free rigid body",
    };
    BOOST_TEST(
        warningsOf(kSpatial + "solution_length = 5\ncontrol = dynamic_car\n[notes]\nby = me\non = monday\n"
                              "[planner]\nproblem.range = 1\nprm = 5\n") == expected,
        boost::test_tools::per_element());
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
    BOOST_TEST_REQUIRE(problem.planners.size() == 5);
    BOOST_TEST((problem.planners[0].name == "rrtconnect" &&
                problem.planners[0].parameters == Parameters{{"range", "50"}}));
    BOOST_TEST((problem.planners[1].name == "rrtconnect" &&
                problem.planners[1].parameters == Parameters{{"range", "200"}}));
    BOOST_TEST((problem.planners[2].name == "prm" && problem.planners[2].parameters.empty()));
    BOOST_TEST((problem.planners[3].name == "rrtconnect" &&
                problem.planners[3].parameters == Parameters{{"name", "Second RRT*"}}));
    BOOST_TEST((problem.planners[4].name == "kpiece" && problem.planners[4].parameters.empty()));
    BOOST_TEST(problem.warnings.empty());
    BOOST_TEST(refusalOf(kSpatial + "[planner]\nrrt. = 5\n") ==
               ":20: [planner] key is 'rrt.', expected NAME = or NAME.PARAMETER = VALUE");
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
    BOOST_TEST(problem.goalThreshold.value() == 1e-3);
    BOOST_TEST((problem.settings ==
                NamedTexts{{"longest_valid_segment_fraction", "0.02"}, {"standard_deviation", "7"}}));
    BOOST_TEST_REQUIRE(problem.planners.size() == 3);
    BOOST_TEST((problem.planners[0].settings == NamedTexts{{"sampler", "gaussian"},
                                                           {"longest_valid_segment_fraction", "0.2"},
                                                           {"nr_attempts", "9"}}));
    BOOST_TEST(problem.planners[1].settings.empty());
    BOOST_TEST((problem.planners[2].settings ==
                NamedTexts{{"projection.cellsize_factor", "4.0"}, {"objective.threshold", "12.5"}}));
    BOOST_TEST(problem.warnings.empty());
    BOOST_TEST(read(kSpatial + "threshold = 0\n").goalThreshold.value() == 0);
    BOOST_TEST(refusalOf(kSpatial + "threshold = -1\n") ==
               ":19: [problem] threshold is '-1', expected a number of at least 0");
    BOOST_TEST(refusalOf(kSpatial + "[planner]\nrrt=\nproblem.objective.threshold = low\n") ==
               ":21: [planner] problem.objective.threshold is 'low', expected a finite number");
}

BOOST_AUTO_TEST_CASE(all_planners_have_one_objective) {
    const Problem named = read(kSpatial + "[planner]\nrrt=\nproblem.objective = mechanical_work\n");
    BOOST_TEST(named.objective == "mechanical_work");
    const std::vector<std::string> expected = {
        ":22: [planner] problem.objective is 'other', which has no effect: the objective of all planners is "
        "'length'"};
    BOOST_TEST(
        warningsOf(kSpatial + "objective = length\n[planner]\nrrt=\nproblem.objective = other\n") == expected,
        boost::test_tools::per_element());
    BOOST_TEST(warningsOf(kSpatial + "[planner]\nproblem.sampler = uniform\n") ==
                   std::vector<std::string>{": [planner] problem.sampler has no effect: no planner is named"},
               boost::test_tools::per_element());
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
    BOOST_TEST(problem.timeLimit.value() == 8.5);
    BOOST_TEST(problem.memoryLimit.value() == 4096);
    BOOST_TEST(problem.runCount.value() == 50);
    BOOST_TEST(problem.outputFolder == "../results/");
    BOOST_TEST((problem.savedPaths == SavedPaths::kShortest));
    BOOST_TEST(!problem.simplify);
    BOOST_TEST(problem.warnings.empty());
    const Problem bare = read(kSpatial);
    BOOST_TEST((bare.savedPaths == SavedPaths::kNone));
    BOOST_TEST(bare.simplify);
    BOOST_TEST((read(kSpatial + "[benchmark]\nsave_paths = all\n").savedPaths == SavedPaths::kAll));
    BOOST_TEST(refusalOf(kSpatial + "[benchmark]\nsave_paths = some\n") ==
               ":20: [benchmark] save_paths is 'some', expected none, all, shortest or best");
    BOOST_TEST(refusalOf(kSpatial + "[benchmark]\nsimplify = maybe\n") ==
               ":20: [benchmark] simplify is 'maybe', expected 1, true, yes, on, 0, false, no or off");
}

BOOST_AUTO_TEST_CASE(meshes_are_found_beside_the_problem_whatever_the_current_folder) {
    const TemporaryFolder folder;
    const Problem problem =
        readProblem(folder.write("a.cfg", with(kSpatial, "world", "world = /meshes/world.stl")));
    BOOST_TEST(problem.robot == folder.file("part.stl"));
    BOOST_TEST(problem.world == "/meshes/world.stl");
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
    BOOST_TEST(problem.robot == "part.stl");
    BOOST_TEST(problem.world == folder.file("world.stl"));
    BOOST_TEST_REQUIRE(problem.warnings.size() == 1);
    BOOST_TEST(problem.warnings[0] ==
               problem.file + ": 'part.stl' is not in the problem's folder, read from the current folder");
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
    const TemporaryFolder folder;
    const std::string missing = folder.file("none.cfg");
    BOOST_CHECK_EXCEPTION(readProblem(missing), std::runtime_error, [&](const std::runtime_error& error) {
        return error.what() ==
               "cannot read '" + missing + "': No such file or directory, expected a problem file (.cfg)";
    });
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway
