#include "clearway/planning/problem_setup.h"

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <boost/test/unit_test.hpp>

#include "clearway/planning/audit.h"
#include "clearway/planning/clearance_objectives.h"
#include "support/invalid_words.h"
#include "support/ompl_log.h"
#include "support/planar_scenes.h"
#include "support/temporary_folder.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(problem_setup_test)

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace clearway::testing;

bool isSame(const PartState& a, const PartState& b) {
    return (a.position - b.position).norm() < 1e-14 && a.rotation.angularDistance(b.rotation) < 1e-14;
}

/// A plate and four boxes far from it, with additional lines under [clearway].
Problem boxesWith(const TemporaryFolder& folder, const std::string& lines) {
    saveMesh(boxMesh(Box(Vector3(-1, -1, -1), Vector3(1, 1, 1)), "plate"), folder.file("plate.obj"));
    std::string worlds;
    for (const double x : {10, 20, 30, 40}) {
        const std::string name = "at" + std::to_string(static_cast<int>(x));
        saveMesh(boxMesh(Box(Vector3(x, 0, 0), Vector3(x + 1, 1, 1)), name), folder.file(name + ".obj"));
        worlds += (worlds.empty() ? "" : ", ") + name + ".obj";
    }
    return readProblem(
        folder.write("boxes.cfg", "[problem]\nrobot = plate.obj\nworld = " + worlds +
                                      "\nstart.x = 0\nstart.y = 0\nstart.theta = 0\ngoal.x = 50\ngoal.y = 0\n"
                                      "goal.theta = 0\n[clearway]\n" +
                                      lines));
}

BOOST_AUTO_TEST_CASE(the_setup_has_the_problems_bounds_and_ends_and_the_scenes_margin) {
    const WindowScene window = windowScene();
    Scene scene = window.scene;
    scene.obstacles[0].margin = 0.5;
    const og::SimpleSetup setup = makeSetup(window.problem, scene);
    const auto& si = setup.getSpaceInformation();
    const auto& bounds = si->getStateSpace()->as<ob::SE3StateSpace>()->getBounds();
    for (int i = 0; i < 3; ++i) {
        BOOST_TEST(bounds.low[i] == window.problem.volume->min()[i]);
        BOOST_TEST(bounds.high[i] == window.problem.volume->max()[i]);
    }
    BOOST_TEST(si->getStateSpace()->as<ob::SE3StateSpace>()->getSubspaceWeight(1) ==
               scene.part.radiusAboutOrigin());
    BOOST_TEST(sceneOf(si).scene().obstacles[0].margin == 0.5);
    BOOST_TEST(motionValidatorOf(si).scene().obstacles[0].margin == 0.5);

    og::PathGeometric ends(si);
    ends.append(setup.getProblemDefinition()->getStartState(0));
    ends.append(setup.getGoal()->as<ob::GoalState>()->getState());
    const std::vector<PartState> states = partStates(ends);
    BOOST_TEST(isSame(states[0], window.problem.start));
    BOOST_TEST(isSame(states[1], window.problem.goal));
}

BOOST_AUTO_TEST_CASE(a_planner_in_the_setup_finds_a_path_that_an_audit_certifies) {
    const PlanarScene gates = gatesScene();
    const OmplLog quiet;
    og::SimpleSetup setup = makeSetup(gates.problem, gates.scene);
    setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
    BOOST_TEST_REQUIRE((setup.solve(20.0) == ob::PlannerStatus::EXACT_SOLUTION));
    const MotionValidator& motions = motionValidatorOf(setup.getSpaceInformation());
    BOOST_TEST(motions.counters().valid > 0u);
    BOOST_TEST(audit(setup.getSolutionPath(), motions).isValid());
}

BOOST_AUTO_TEST_CASE(a_start_or_goal_in_collision_is_refused_by_name) {
    WindowScene window = windowScene();
    window.problem.start.position = {0, 20, 0};
    window.problem.start.rotation.setIdentity();
    const std::string collides = testing::beginningOf(WhyInvalid::Kind::kCollides);
    requireRefusedBy([&] { makeSetup(window.problem, window.scene); }, {"start is " + collides});
    std::swap(window.problem.start, window.problem.goal);
    requireRefusedBy([&] { makeSetup(window.problem, window.scene); }, {"goal is " + collides});
}

BOOST_AUTO_TEST_CASE(settings_of_the_problem_reach_space_and_sampler_or_are_warned_of) {
    WindowScene window = windowScene();
    window.problem.planning.sampler = "narrow_gap";
    window.problem.planning.settings = {
        {"longest_valid_segment_fraction", "0.25"}, {"gap", "3"}, {"no_such", "1"}};
    OmplLog log;
    const og::SimpleSetup setup = makeSetup(window.problem, window.scene);
    const auto& si = setup.getSpaceInformation();
    BOOST_TEST(si->getStateSpace()->getLongestValidSegmentFraction() == 0.25);
    BOOST_TEST(si->allocValidStateSampler()->params()["gap"].getValue() == "3");
    BOOST_TEST(std::count_if(log.lines.begin(), log.lines.end(), [](const std::string& line) {
                   return line.find("no_such") != std::string::npos;
               }) == 1);
    window.problem.planning.settings = {{"gap", "wide"}};
    requireRefusedBy([&] { makeSetup(window.problem, window.scene); }, {"wide"});
}

BOOST_AUTO_TEST_CASE(a_setup_without_certified_motions_is_told) {
    const WindowScene window = windowScene();
    const auto si = makeSetup(window.problem, window.scene).getSpaceInformation();
    si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
    requireRefusedBy([&] { motionValidatorOf(si); }, {"MotionValidator"});
    BOOST_CHECK_THROW(motionValidatorOf(nullptr), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(paths_go_to_ompl_and_back) {
    PartState turned, moved;
    turned.rotation = Eigen::AngleAxisd(2.5, Vector3::UnitZ());
    moved.position = {1, 2, 0};
    const auto spatial = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE3StateSpace>());
    const auto planar = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE2StateSpace>());
    for (const auto& si : {spatial, planar}) {
        const std::vector<PartState> back = partStates(pathThrough(si, {turned, moved}));
        BOOST_TEST_REQUIRE(back.size() == 2u);
        BOOST_TEST(isSame(back[0], turned));
        BOOST_TEST(isSame(back[1], moved));
    }
    const auto other = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SO3StateSpace>());
    requireRefusedBy([&] { pathThrough(other, {turned}); }, {other->getStateSpace()->getName()});
    BOOST_CHECK_THROW(partStates(og::PathGeometric(other)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_loaded_scene_has_the_problems_margins_and_solids) {
    const TemporaryFolder folder;
    BuildOptions options;
    options.leafSplit = "all";
    const LoadedScene loaded = loadScene(
        boxesWith(folder, "margin = 0.25\nmargin.at10 = 0.5\nsolid = at20\nignore = at30\n"), options);
    const Scene& scene = loaded.scene;
    BOOST_TEST(loaded.notes.empty());
    BOOST_TEST(scene.part.components()[0].name == "plate");
    BOOST_TEST(scene.part.report().options.leafSplit == "all");
    BOOST_TEST((scene.partSolids != nullptr));
    std::map<std::string, std::pair<double, bool>> found;
    for (const Obstacle& obstacle : scene.obstacles) {
        for (const Component& component : obstacle.model.components()) {
            found[component.name] = {obstacle.margin, obstacle.solids != nullptr};
        }
    }
    const std::map<std::string, std::pair<double, bool>> expected = {
        {"at10", {0.5, false}}, {"at20", {0.25, true}}, {"at40", {0.25, false}}};
    for (const auto& [name, how] : found)
        BOOST_TEST_MESSAGE(name << ": margin " << how.first << ", solid " << how.second);
    BOOST_TEST((found == expected));
    BOOST_TEST(loadScene(boxesWith(folder, "")).scene.partSolids == nullptr);
}

BOOST_AUTO_TEST_CASE(a_rule_without_an_obstacle_is_refused_with_the_problems_file) {
    const TemporaryFolder folder;
    requireRefusedBy([&] { loadScene(boxesWith(folder, "ignore = nobody\n")); }, {"boxes.cfg: [clearway]"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
