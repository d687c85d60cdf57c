// Parts in tight fits: the planner that follows screws brings them out, by all rules that a scene has, and by OMPL's.
#include "planning/planners/twist_search.h"

#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <boost/test/unit_test.hpp>
#include <set>

#include "clearway/planning/audit.h"
#include "clearway/planning/check_path.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/outside_goal.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/sliding_rrt_connect.h"
#include "clearway/shrink.h"
#include "planning/planners/planner_team.h"
#include "planning/space/ompl_states.h"
#include "support/assembled_problems.h"
#include "support/motion_window.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(twist_search_test)

using testing::AssembledProblem;
using Outcome = PlanReport::Outcome;

AssembledProblem tightProblem(const std::string& name) {
    for (const AssembledProblem& problem : testing::tightProblems()) {
        if (problem.name == name) return problem;
    }
    throw std::invalid_argument(name);
}

Scene sceneOf(const AssembledProblem& problem, double margin = 0) {
    return Scene(Model::build(problem.part), Model::build(problem.environment), margin);
}

Problem outwards() {
    Problem problem;
    problem.outside = Outside{};
    return problem;
}

PlanOptions by(const std::string& planner, std::uint64_t iterations = 4000) {
    PlanOptions options;
    options.planner = planner;
    options.iterations = iterations;
    options.quick = true;
    return options;
}

PlanReport planned(const Problem& problem, const Scene& scene,
                   const PlanOptions& options = by("TwistSearch")) {
    const PlanReport report = plan(problem, scene, options);
    BOOST_TEST((report.outcome == Outcome::kFound));
    if (report.outcome == Outcome::kFound) BOOST_TEST(report.audit.isValid());
    return report;
}

/// A square peg in a sleeve that leaves it 0.01 on each side when it is 2 wide from its middle, turned together.
AssembledProblem pegInSleeve(double halfWidth, const Matrix3& turn = Matrix3::Identity()) {
    const Pose X{turn, Vector3::Zero()};
    Mesh sleeve;
    for (const double side : {-1.0, 1.0}) {
        sleeve =
            testing::joined(sleeve, testing::translated(testing::box(Vector3(1, 5, 8)), {side * 3.01, 0, 0}));
        sleeve =
            testing::joined(sleeve, testing::translated(testing::box(Vector3(5, 1, 8)), {0, side * 3.01, 0}));
    }
    return {"peg", testing::transformed(testing::box(Vector3(halfWidth, halfWidth, 5)), X),
            testing::transformed(sleeve, X)};
}

const Matrix3 kTilt = Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()).toRotationMatrix();

/// The team's other planners take several times as long for these iterations, and find nothing.
void onlyTwistsFind(const Problem& problem, const Scene& scene) {
    planned(problem, scene);
    for (const auto& [planner, iterations] :
         {std::pair<const char*, int>{"RRTConnect", 3000}, {"SlidingRRTConnect", 60}})
        BOOST_TEST((plan(problem, scene, by(planner, iterations)).outcome != Outcome::kFound), planner);
}

ob::PlannerTerminationCondition after(int most) {
    auto asked = std::make_shared<int>(0);
    return ob::PlannerTerminationCondition([=] { return (*asked)++ >= most; });
}

/// A space information with clearway's checker and validator, and the problem to bring a part out.
struct OmplTask {
    explicit OmplTask(const AssembledProblem& problem)
        : scene(sceneOf(problem)),
          si(std::make_shared<ob::SpaceInformation>(
              makeSpace(Space::kSe3, boundsOf(outwards(), scene.environmentBox(), scene.part.box()),
                        scene.part.radiusAboutOrigin()))),
          definition(std::make_shared<ob::ProblemDefinition>(si)) {
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, scene));
        si->setMotionValidator(std::make_shared<MotionValidator>(si, scene));
        si->setup();
        definition->setGoal(std::make_shared<OutsideGoal>(si, scene, Outside{}, PartState{}));
    }
    ob::ScopedState<> at(const Vector3& position) const {
        PartState state;
        state.position = position;
        return toOmpl(si->getStateSpace(), Space::kSe3, state);
    }
    template <class Made>
    std::shared_ptr<Made> planner() const {
        const auto made = std::make_shared<Made>(si);
        made->setProblemDefinition(definition);
        made->setup();
        return made;
    }
    std::vector<std::vector<double>> solution() const {
        std::vector<std::vector<double>> states;
        for (const ob::State* state : definition->getSolutionPath()->as<og::PathGeometric>()->getStates()) {
            states.emplace_back();
            si->getStateSpace()->copyToReals(states.back(), state);
        }
        return states;
    }

    Scene scene;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr definition;
};

/// The path of a planner is valid all along, as another validator tells.
void comesOut(const OmplTask& task) {
    const OmplMessages quiet;
    task.definition->addStartState(task.at(Vector3::Zero()));
    BOOST_REQUIRE((task.planner<TwistSearch>()->solve(after(20000)) == ob::PlannerStatus::EXACT_SOLUTION));
    auto& path = *task.definition->getSolutionPath()->as<og::PathGeometric>();
    const auto si = std::make_shared<ob::SpaceInformation>(task.si->getStateSpace());
    const MotionValidator validator(si, task.scene);
    for (std::size_t i = 0; i + 1 < path.getStateCount(); ++i)
        BOOST_TEST(validator.checkMotion(path.getState(i), path.getState(i + 1)));
    BOOST_TEST(task.definition->getGoal()->isSatisfied(path.getStates().back()));
}

BOOST_AUTO_TEST_CASE(tight_parts_come_out) {
    for (const AssembledProblem& problem : testing::tightProblems()) {
        BOOST_TEST_CONTEXT(problem.name) {
            comesOut(OmplTask(problem));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_screw_leaves_its_nut_with_its_origin_on_the_axis_and_off_it) {
    for (const double shift : {0.0, 20.0}) comesOut(OmplTask(testing::screwAndNut({24, 7, 3.5}, shift)));
}

/// The way that is found without a margin comes closer than the margin.
BOOST_AUTO_TEST_CASE(margins_are_kept) {
    const AssembledProblem problem = tightProblem("hook");
    constexpr double kMargin = 0.03;
    const PlanReport without = planned(outwards(), sceneOf(problem));
    BOOST_TEST(without.audit.upperClearance < kMargin);
    const Scene kept = sceneOf(problem, kMargin);
    const PlanReport with = planned(outwards(), kept);
    BOOST_TEST(with.audit.isValid());
    BOOST_TEST(!checkPath(outwards(), kept, without.path).audit.isValid());
}

/// A second obstacle closes the way that is taken without it.
BOOST_AUTO_TEST_CASE(every_obstacle_counts) {
    const AssembledProblem peg = pegInSleeve(2);
    Scene scene = sceneOf(peg);
    const PlanReport free = planned(outwards(), scene);
    const double way = free.path.back().position.z();
    BOOST_TEST(std::abs(way) > 10);
    const double side = way > 0 ? 1 : -1;
    scene.obstacles.emplace_back(
        Model::build(testing::translated(testing::box(Vector3(5, 5, 1)), {0, 0, side * 12})));
    BOOST_TEST(!checkPath(outwards(), scene, free.path).audit.isValid());
    BOOST_TEST(side * planned(outwards(), scene).path.back().position.z() < 0);
}

/// The inverse problem: the goal is in a tight fit, or both ends are.
BOOST_AUTO_TEST_CASE(a_pose_in_a_tight_fit_is_reached_from_elsewhere) {
    const AssembledProblem peg = tightProblem("square_peg");
    const Scene scene = sceneOf(peg);
    const PlanReport out = planned(outwards(), scene);
    Problem problem;
    problem.start = out.path.back();
    problem.start.position *= 1.5;
    problem.goal = out.path.front();
    planned(problem, scene);
    std::swap(problem.start, problem.goal);
    planned(problem, scene);
}

BOOST_AUTO_TEST_CASE(a_planar_part_leaves_its_slot) {
    const Eigen::AngleAxisd turn(0.3, Vector3::UnitZ());
    const Pose X{turn.toRotationMatrix(), Vector3::Zero()};
    Mesh slot = testing::joined(testing::translated(testing::box(Vector3(8, 1, 1)), {0, 3.01, 0}),
                                testing::translated(testing::box(Vector3(8, 1, 1)), {0, -3.01, 0}));
    slot = testing::joined(slot, testing::translated(testing::box(Vector3(1, 5, 1)), {-8, 0, 0}));
    const Scene scene(Model::build(testing::transformed(testing::box(Vector3(5, 2, 1)), X)),
                      Model::build(testing::transformed(slot, X)));
    Problem problem = outwards();
    problem.space = Space::kSe2;
    onlyTwistsFind(problem, scene);
}

BOOST_AUTO_TEST_CASE(a_part_leaves_a_solid) {
    const AssembledProblem peg = pegInSleeve(2, kTilt);
    Scene scene = sceneOf(peg);
    scene.obstacles[0].solids = makeSolids(peg.environment).solids;
    scene.partSolids = makeSolids(peg.part).solids;
    onlyTwistsFind(outwards(), scene);
}

BOOST_AUTO_TEST_CASE(a_part_that_is_pressed_in_comes_out) {
    const AssembledProblem peg = pegInSleeve(2.02, kTilt);
    Scene scene = sceneOf(peg);
    const ShrunkPart shrunk = shrink(peg.part, {0.02});
    scene.obstacles[0].shrunk = shrunkModel(shrunk, Model::build(shrunk.mesh));
    onlyTwistsFind(outwards(), scene);
}

/// The peg's bottom lies on a plate, which counts no more once the peg has left it.
BOOST_AUTO_TEST_CASE(a_part_in_a_tight_fit_may_touch_another_obstacle) {
    const AssembledProblem peg = pegInSleeve(2, kTilt);
    Scene scene = sceneOf(peg);
    scene.obstacles.emplace_back(Model::build(testing::transformed(
        testing::translated(testing::box(Vector3(9, 9, 1)), {0, 0, -9}), Pose{kTilt, Vector3::Zero()})));
    Problem problem;
    problem.start.position = kTilt * Vector3(0, 0, -3);
    problem.goal.position = kTilt * Vector3(0, 0, 30);
    scene.obstacles[1].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), problem.start.position}, 0.1};
    onlyTwistsFind(problem, scene);
}

BOOST_AUTO_TEST_CASE(a_captive_screw_is_told_as_that) {
    const PlanReport report =
        plan(outwards(), sceneOf(testing::screwAndNut({24, 5.25, 7, 1, true}, 0)), by("TwistSearch"));
    BOOST_REQUIRE(report.whyNoPath.has_value());
    std::set<std::string> faces;
    for (const FollowedTrack& track : report.whyNoPath->tracks) {
        BOOST_TEST(track.length > 0);
        if (track.isSquare) faces.insert(track.obstacleMesh);
    }
    BOOST_TEST((faces == std::set<std::string>{"face_above", "face_below"}));
}

BOOST_AUTO_TEST_CASE(turns_of_any_length_find_the_same_path_and_a_cleared_planner_begins_anew) {
    const OmplMessages quiet;
    std::vector<std::vector<std::vector<double>>> paths;
    for (const int turn : {100000, 7}) {
        ompl::RNG::setSeed(5);
        const OmplTask task(tightProblem("hook"));
        task.definition->addStartState(task.at(Vector3::Zero()));
        const auto planner = task.planner<TwistSearch>();
        ob::PlannerStatus status;
        for (int k = 0; k < 100000 && status != ob::PlannerStatus::EXACT_SOLUTION; ++k)
            status = planner->solve(after(turn));
        BOOST_REQUIRE(status == ob::PlannerStatus::EXACT_SOLUTION);
        paths.push_back(task.solution());
        planner->clear();
        task.definition->clearSolutionPaths();
        planner->setup();
        BOOST_TEST((planner->solve(after(100000)) == ob::PlannerStatus::EXACT_SOLUTION));
    }
    BOOST_TEST((paths[0] == paths[1]));
}

/// Remembers the motions that it was asked about, and refuses every third.
class Grudging : public MotionValidator {
  public:
    using MotionValidator::checkMotion;
    using MotionValidator::MotionValidator;
    bool checkMotion(const ob::State* from, const ob::State* to) const override {
        asked.insert({realsOf(from), realsOf(to)});
        return ++count % 3 != 0 && MotionValidator::checkMotion(from, to);
    }
    std::vector<double> realsOf(const ob::State* state) const {
        std::vector<double> reals;
        si_->getStateSpace()->copyToReals(reals, state);
        return reals;
    }
    mutable std::set<std::pair<std::vector<double>, std::vector<double>>> asked;
    mutable int count = 0;
};

/// Some validators allow a motion one way alone.
template <class Tree>
void asksAsPathsGo(int iterations, bool isGoalTight) {
    OmplTask task(tightProblem("square_peg"));
    const auto validator = std::make_shared<Grudging>(task.si, task.scene);
    task.si->setMotionValidator(validator);
    const auto& bounds = task.si->getStateSpace()->as<ob::SE3StateSpace>()->getBounds();
    auto start = task.at({0.9 * bounds.high[0], 0, 0}), goal = task.at(Vector3::Zero());
    if (!isGoalTight) std::swap(start, goal);
    task.definition->setStartAndGoalStates(start, goal);
    const auto planner = task.planner<Tree>();
    planner->solve(after(iterations));
    ob::PlannerData data(task.si);
    planner->getPlannerData(data);
    int checked = 0;
    for (unsigned int from = 0; from < data.numVertices(); ++from) {
        std::vector<unsigned int> next;
        data.getEdges(from, next);
        for (const unsigned int to : next) {
            if (data.getVertex(to).getTag() != 2) continue;  // of the goal's tree
            ++checked;
            BOOST_TEST(validator->asked.count({validator->realsOf(data.getVertex(from).getState()),
                                               validator->realsOf(data.getVertex(to).getState())}) == 1u);
        }
    }
    BOOST_TEST(checked > 3);
}

BOOST_AUTO_TEST_CASE(motions_are_asked_about_as_paths_go) {
    const OmplMessages quiet;
    asksAsPathsGo<TwistSearch>(2000, true);
    asksAsPathsGo<SlidingRRTConnect>(30, false);
}

BOOST_AUTO_TEST_CASE(any_of_several_starts_will_do_and_an_invalid_one_is_passed_over) {
    const OmplMessages quiet;
    const OmplTask task(testing::screwAndNut({24, 5.25, 7, 1, true}, 0));
    task.definition->addStartState(task.at({3, 0, 0}));        // in collision
    task.definition->addStartState(task.at(Vector3::Zero()));  // captive
    const auto planner = task.planner<TwistSearch>();
    BOOST_TEST((planner->solve(after(20000)) == ob::PlannerStatus::TIMEOUT));
    BOOST_TEST(planner->isExhausted());
    const auto& bounds = task.si->getStateSpace()->as<ob::SE3StateSpace>()->getBounds();
    task.definition->addStartState(task.at({0.9 * bounds.high[0], 0, 0}));
    BOOST_TEST((planner->solve(after(20000)) == ob::PlannerStatus::EXACT_SOLUTION));
}

/// A turn that closes is no way out, however long it is.
BOOST_AUTO_TEST_CASE(a_part_that_only_spins_leaves_nothing_to_try) {
    const OmplMessages quiet;
    const OmplTask task({"spin", testing::tube(1, 3, 1, 32), testing::box(Vector3(3.02, 3.02, 0.52))});
    task.definition->addStartState(task.at(Vector3::Zero()));
    const auto planner = task.planner<TwistSearch>();
    BOOST_TEST((planner->solve(after(100000)) == ob::PlannerStatus::TIMEOUT));
    BOOST_TEST(planner->isExhausted());
}

/// A gap of rounding, as between faces of CAD, takes no more steps than a wider one.
BOOST_AUTO_TEST_CASE(tiny_gaps_do_not_make_for_tiny_steps) {
    const OmplMessages quiet;
    for (const double gap : {1e-7, 1e-12}) {
        const OmplTask task({"lying", testing::box(Vector3(2, 2, 1)),
                             testing::translated(testing::box(Vector3(9, 9, 1)), {0, 0, -2 - gap})});
        task.definition->addStartState(task.at(Vector3::Zero()));
        const auto planner = task.planner<TwistSearch>();
        BOOST_TEST((planner->solve(after(300)) == ob::PlannerStatus::EXACT_SOLUTION));
    }
}

BOOST_AUTO_TEST_CASE(a_start_outside_is_the_path) {
    const OmplMessages quiet;
    const OmplTask task(tightProblem("square_peg"));
    const auto& bounds = task.si->getStateSpace()->as<ob::SE3StateSpace>()->getBounds();
    task.definition->addStartState(task.at({bounds.high[0], bounds.high[1], bounds.high[2]}));
    BOOST_REQUIRE(task.definition->getGoal()->isSatisfied(task.definition->getStartState(0)));
    const auto planner = task.planner<TwistSearch>();
    BOOST_TEST((planner->solve(after(100)) == ob::PlannerStatus::EXACT_SOLUTION));
    BOOST_TEST(task.solution().size() == 1u);
    // The path of another problem begins at its own start.
    const auto other = std::make_shared<ob::ProblemDefinition>(task.si);
    other->addStartState(task.at(Vector3::Zero()));
    other->setGoal(task.definition->getGoal());
    planner->setProblemDefinition(other);
    BOOST_REQUIRE((planner->solve(after(20000)) == ob::PlannerStatus::EXACT_SOLUTION));
    const auto& path = *other->getSolutionPath()->as<og::PathGeometric>();
    BOOST_TEST(task.si->equalStates(path.getState(0), other->getStartState(0)));
}

BOOST_AUTO_TEST_CASE(all_motions_of_the_planner_data_are_valid) {
    const OmplMessages quiet;
    const OmplTask task(tightProblem("hook"));
    task.definition->addStartState(task.at(Vector3::Zero()));
    const auto planner = task.planner<TwistSearch>();
    planner->solve(after(100000));
    ob::PlannerData data(task.si);
    planner->getPlannerData(data);
    BOOST_TEST(data.numStartVertices() == 1u);
    BOOST_TEST(data.numEdges() >= task.solution().size() - 1);
    for (unsigned int from = 0; from < data.numVertices(); ++from) {
        std::vector<unsigned int> next;
        data.getEdges(from, next);
        for (const unsigned int to : next)
            BOOST_TEST(task.si->checkMotion(data.getVertex(from).getState(), data.getVertex(to).getState()));
    }
}

BOOST_AUTO_TEST_CASE(the_team_has_one_only_in_tight_fits) {
    const OmplMessages quiet;
    const OmplTask task(tightProblem("square_peg"));
    task.definition->addStartState(task.at(Vector3::Zero()));
    const auto team = task.planner<PlannerTeam>();
    BOOST_TEST((team->solve(after(100000)) == ob::PlannerStatus::EXACT_SOLUTION));
    BOOST_TEST(team->twistSearch() != nullptr);
    BOOST_TEST(task.definition->getSolutions()[0].plannerName_ == "TwistSearch");

    const testing::MotionWindow wide;
    const auto definition = std::make_shared<ob::ProblemDefinition>(wide.si);
    definition->setStartAndGoalStates(wide.at({-60, 0, 0}), wide.at({60, 0, 0}));
    const auto other = std::make_shared<PlannerTeam>(wide.si);
    other->setProblemDefinition(definition);
    other->setup();
    other->solve(after(3000));
    BOOST_TEST(other->twistSearch() == nullptr);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
