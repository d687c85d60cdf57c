#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(write_problem_test)

using testing::readText;
using testing::TemporaryFolder;

using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// The error of a pose that was written as axis and angle: a few roundings of numbers up to 2 pi.
constexpr double kRotationRounding = 8 * std::numeric_limits<double>::epsilon();

Problem basicProblem(const TemporaryFolder& folder) {
    Problem problem;
    problem.meshes.robot = folder.file("part.stl");
    problem.meshes.world = folder.file("world.stl");
    return problem;
}

void requireSamePose(const PartState& a, const PartState& b) {
    BOOST_TEST_REQUIRE(a.position == b.position);
    const double difference = (poseOf(a).rotation - poseOf(b).rotation).cwiseAbs().maxCoeff();
    BOOST_TEST_REQUIRE(difference <= kRotationRounding,
                       "rotations differ by " << difference << " at " << a.rotation.coeffs().transpose());
}

BOOST_AUTO_TEST_CASE(everything_written_reads_back_to_the_same_values) {
    const TemporaryFolder folder;
    Problem problem = basicProblem(folder);
    problem.name = "a drawer";
    problem.volume = Box(Vector3(-1.1, -2.2, -3.3), Vector3(1.1, 2.2, 1.0 / 3));
    problem.planning.objective = "clearance";
    problem.planning.objectiveThreshold = 0.1;
    problem.planning.sampler = "gaussian";
    problem.planning.planners = {
        {"rrtconnect", {{"range", "0.7"}, {"name", "RRT 1"}}}, {"prm", {}}, {"rrtconnect", {}}};
    problem.planning.planners[1].settings = {{"sampler", "uniform"}, {"nr_attempts", "3"}};
    problem.planning.settings = {{"longest_valid_segment_fraction", "0.02"}};
    problem.planning.goalThreshold = 1e-3;
    problem.benchmark.outputFolder = "../logs";
    problem.benchmark.savedPaths = SavedPaths::kShortest;
    problem.benchmark.simplify = false;
    problem.benchmark.timeLimit = 0.3;
    problem.benchmark.memoryLimit = 1e3;
    problem.benchmark.runCount = 7;
    problem.margin = 0.1;
    problem.deflection = 0.3;
    problem.fineness = 0.7;
    problem.meshes.asOmplApp = false;

    writeProblem(problem, folder.file("a.cfg"));
    const Problem back = readProblem(folder.file("a.cfg"));
    BOOST_TEST(back.warnings.empty());
    BOOST_TEST(back.name == problem.name);
    BOOST_TEST(back.meshes.robot == problem.meshes.robot);
    BOOST_TEST(back.meshes.world == problem.meshes.world);
    BOOST_TEST(back.volume->min() == problem.volume->min());
    BOOST_TEST(back.volume->max() == problem.volume->max());
    BOOST_TEST(back.planning.objective == problem.planning.objective);
    BOOST_TEST(back.planning.objectiveThreshold.value() == 0.1);
    BOOST_TEST(back.planning.sampler == problem.planning.sampler);
    BOOST_TEST_REQUIRE(back.planning.planners.size() == 3);
    for (int i = 0; i < 3; ++i) {
        BOOST_TEST(back.planning.planners[i].name == problem.planning.planners[i].name);
        BOOST_TEST((back.planning.planners[i].parameters == problem.planning.planners[i].parameters));
        BOOST_TEST((back.planning.planners[i].settings == problem.planning.planners[i].settings));
    }
    BOOST_TEST((back.planning.settings == problem.planning.settings));
    BOOST_TEST(back.planning.goalThreshold.value() == 1e-3);
    BOOST_TEST(back.benchmark.outputFolder == problem.benchmark.outputFolder);
    BOOST_TEST((back.benchmark.savedPaths == SavedPaths::kShortest));
    BOOST_TEST(!back.benchmark.simplify);
    BOOST_TEST(back.benchmark.timeLimit.value() == 0.3);
    BOOST_TEST(back.benchmark.memoryLimit.value() == 1e3);
    BOOST_TEST(back.benchmark.runCount.value() == 7);
    BOOST_TEST(back.margin == 0.1);
    BOOST_TEST(back.deflection == 0.3);
    BOOST_TEST(back.fineness.value() == 0.7);
    BOOST_TEST(!back.meshes.asOmplApp);
}

BOOST_AUTO_TEST_CASE(a_goal_outside_reads_back) {
    const TemporaryFolder folder;
    Problem problem = basicProblem(folder);
    for (const char* side : {"", "+x", "-z"}) {
        problem.outside = Outside{sideNamed(side)};
        writeProblem(problem, folder.file("a.cfg"));
        const Problem back = readProblem(folder.file("a.cfg"));
        BOOST_TEST(back.warnings.empty());
        BOOST_REQUIRE(back.outside.has_value());
        BOOST_TEST((back.outside->side ? nameOf(*back.outside->side) : "") == side);
    }
    problem.rules.goalContact = ContactRule{{"wall"}, 1};
    BOOST_CHECK_THROW(writeProblem(problem, folder.file("a.cfg")), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(states_read_back_to_the_same_pose) {
    constexpr unsigned kSeed = 11;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    std::normal_distribution<double> normal;
    const TemporaryFolder folder;
    Problem problem = basicProblem(folder);
    const double small = 1e-200;
    std::vector<Quaternion> rotations = {{1, 0, 0, 0},          {-1, 0, 0, 0},         {0, 1, 0, 0},
                                         {0, 0, -1, 0},         {0, 0, 0, 1},  // identity and half turns
                                         {1, small, 0, 0},      {-1, 0, small, 0},     {small, 0, 0, 1},
                                         {-small, 0.6, 0, 0.8}, {1, 1e-9, -1e-9, 1e-9}};
    for (int i = 0; i < 400; ++i) {
        Quaternion q(normal(random), normal(random), normal(random), normal(random));
        if (i % 4 == 0) q.w() *= 1e-9;
        if (i % 4 == 1) q.vec() *= 1e-9;
        rotations.push_back(q.normalized());
    }
    for (const Quaternion& rotation : rotations) {
        problem.start = {Vector3(normal(random), 1e3 * normal(random), 1e-9 * normal(random)), rotation};
        problem.goal = {Vector3::Zero(), rotation.conjugate()};
        writeProblem(problem, folder.file("a.cfg"));
        const Problem back = readProblem(folder.file("a.cfg"));
        requireSamePose(back.start, problem.start);
        requireSamePose(back.goal, problem.goal);
    }
}

BOOST_AUTO_TEST_CASE(planar_states_read_back_to_the_same_pose) {
    const TemporaryFolder folder;
    Problem problem = basicProblem(folder);
    problem.space = Space::kSe2;
    for (int i = -24; i <= 24; ++i) {
        const double half =
            i * std::acos(-1.0) / 24;  // half angles from -pi to pi: both signs of every quaternion
        problem.start = {Vector3(i / 3.0, -i, 0), Quaternion(std::cos(half), 0, 0, std::sin(half))};
        writeProblem(problem, folder.file("a.cfg"));
        const Problem back = readProblem(folder.file("a.cfg"));
        BOOST_TEST_REQUIRE((back.space == Space::kSe2));
        requireSamePose(back.start, problem.start);
    }
    BOOST_TEST(readText(folder.file("a.cfg")).find("start.z") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(meshes_are_written_relative_to_the_problem_so_that_the_folder_can_move) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("meshes"));
    Problem problem = basicProblem(folder);
    problem.meshes.world = folder.file("meshes/world.stl");
    writeProblem(problem, folder.file("a.cfg"));
    const std::string text = readText(folder.file("a.cfg"));
    BOOST_TEST(text.find("robot = part.stl\nworld = meshes/world.stl\n") != std::string::npos, text);
    BOOST_TEST(readProblem(folder.file("a.cfg")).meshes.world == folder.file("meshes/world.stl"));
}

BOOST_AUTO_TEST_CASE(what_could_not_be_read_back_is_refused_and_leaves_nothing) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::vector<std::string>& words, auto change) {
        Problem problem = basicProblem(folder);
        change(problem);
        testing::requireRefusedBy([&] { writeProblem(problem, folder.file("a.cfg")); }, words);
        BOOST_TEST(folder.names().empty());
    };
    refused({"name is 'no #1'", "text without #"}, [](Problem& p) { p.name = "no #1"; });
    refused({"sampler is ' x'", "white space at its ends"}, [](Problem& p) { p.planning.sampler = " x"; });
    refused({"start.y is nan", "a finite number"}, [](Problem& p) { p.start.position.y() = std::nan(""); });
    for (const char* const name : {"", "rrt ", "[rrt", "rrt.range", "rrt=", "rrt\n"})
        refused({"a planner's name is '"}, [&](Problem& p) { p.planning.planners = {{name, {}}}; });
    for (const std::string parameter : {"", " range", "a=b", "#"})
        refused({"planner 'rrt'", "'" + parameter + "'", "without any of #="}, [&](Problem& p) {
            p.planning.planners = {{"rrt", {{parameter, "1"}}}};
        });
    Problem problem = basicProblem(folder);
    BOOST_CHECK_THROW(writeProblem(problem, folder.file("none/a.cfg")), std::runtime_error);
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
