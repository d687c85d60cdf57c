// A scene that checkers, validators and objectives share: one set of scratch, the answers of separate ones.
#include "clearway/planning/shared_scene.h"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/problem_setup.h"
#include "planning/plan/plan_setup.h"
#include "support/motion_window.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(shared_scene_test)

/// Checks and costs of random motions, by turns.
struct Answers {
    std::vector<bool> verdicts;
    std::vector<double> costs;
};

template <class Fixture>
Answers answersOf(const Fixture& f, const ValidityChecker& checker, const MotionValidator& validator,
                  const MinClearanceObjective& objective) {
    Answers answers;
    testing::Random random(1);
    auto from = f.at(Vector3(-60, 0, 0));
    for (int i = 0; i < 60; ++i) {
        const auto to = f.at(Vector3(-20, 0, 0) + random.inBox(40), random.uniform(0, 1));
        answers.verdicts.push_back(checker.isValid(to.get()));
        answers.verdicts.push_back(validator.checkMotion(from.get(), to.get()));
        answers.costs.push_back(objective.motionCost(from.get(), to.get()).value());
        if (answers.verdicts.back()) from = to;
    }
    return answers;
}

BOOST_AUTO_TEST_CASE(what_is_shared_answers_as_what_is_not) {
    const testing::MotionWindow f;
    const SharedScene shared(f.window.scene);
    const Answers together = answersOf(f, ValidityChecker(f.si, shared), MotionValidator(f.si, shared),
                                       MinClearanceObjective(f.si, shared)),
                  apart = answersOf(f, ValidityChecker(f.si, f.window.scene),
                                    MotionValidator(f.si, f.window.scene),
                                    MinClearanceObjective(f.si, f.window.scene));
    BOOST_TEST(together.verdicts == apart.verdicts, boost::test_tools::per_element());
    BOOST_TEST(together.costs == apart.costs, boost::test_tools::per_element());  // to the last digit
}

/// A state that is found free is known to be free when a motion ends there.
BOOST_AUTO_TEST_CASE(a_validator_knows_what_its_checker_was_asked) {
    const testing::MotionWindow f;
    const SharedScene shared(f.window.scene);
    const ValidityChecker checker(f.si, shared);
    const MotionValidator together(f.si, checker.shared()), apart(f.si, f.window.scene);
    const auto from = f.at(Vector3(-60, 0, 0)), to = f.at(Vector3(-30, 5, 0));
    const auto withins = [&](const MotionValidator& validator) {
        BOOST_TEST(checker.isValid(to.get()));
        takeQueryTally();
        BOOST_TEST(validator.checkMotion(from.get(), to.get()));
        return takeQueryTally().withins;
    };
    BOOST_TEST(withins(together) == 0u);
    BOOST_TEST(withins(apart) == 1u);
    BOOST_TEST(together.shared().clearance() == checker.shared().clearance());
    BOOST_TEST(MinClearanceObjective(f.si, shared).scene().obstacles.size() == 1u);
}

BOOST_AUTO_TEST_CASE(costs_leave_the_warm_start_of_the_others_alone) {
    const testing::MotionWindow f;
    const SharedScene shared(f.window.scene);
    const MotionValidator validator(f.si, shared);
    const MinClearanceObjective objective(f.si, shared);
    const auto from = f.at(Vector3(-60, 0, 0)), to = f.at(Vector3(-30, 5, 0));
    BOOST_TEST(validator.checkMotion(from.get(), to.get()));
    objective.motionCost(to.get(), from.get());
    takeQueryTally();
    BOOST_TEST(validator.checkMotion(from.get(), to.get()));
    BOOST_TEST(takeQueryTally().withins == 0u);
}

/// A callback within a sweep asks about another motion in the same scene: both sweeps keep their places.
BOOST_AUTO_TEST_CASE(a_callback_of_a_motion_may_ask_about_another_one) {
    const testing::MotionWindow f;
    const SharedScene shared(f.window.scene);
    const MotionValidator inner(f.si, shared);
    const MinClearanceObjective cost(f.si, shared);
    const auto here = f.at(Vector3(-60, 0, 0)), there = f.at(Vector3(60, 9, 3));
    const StateMotion plain = stateMotion(f.space, f.window.scene.part);
    int asked = 0;
    const StateMotion asking = [&](const ob::State* from, const ob::State* to) {
        PartMotion motion = plain(from, to);
        motion.pieces = [&, pieces = motion.pieces](double begin, double end) {
            if (++asked % 4 == 0) cost.motionCost(here.get(), there.get());
            inner.checkMotion(here.get(), there.get());
            return pieces(begin, end);
        };
        return motion;
    };
    const Model& part = f.window.scene.part;
    const MotionValidator outer(
        f.si, SharedScene(shared, stateToPose(*f.space), displacementBound(*f.space, part), asking));
    const MotionValidator apart(f.si, f.window.scene);
    BOOST_TEST_REQUIRE(outer.shared().clearance() == inner.shared().clearance());
    testing::Random random(1);
    int valid = 0;
    for (int i = 0; i < 60; ++i) {
        const auto from = f.at(10 * random.direction() - Vector3(40, 0, 0)),
                   to = f.at(60 * random.direction());
        const bool isValid = apart.checkMotion(from.get(), to.get());
        BOOST_TEST(outer.checkMotion(from.get(), to.get()) == isValid);
        valid += isValid;
    }
    BOOST_TEST(asked > 60);  // more than once a motion
    BOOST_TEST(valid > 5);
    BOOST_TEST(valid < 55);
}

BOOST_AUTO_TEST_CASE(a_setup_and_a_plan_have_one_scene) {
    const testing::WindowScene window = testing::windowScene();
    const auto setup = makeSetup(window.problem, window.scene);
    const auto& si = setup.getSpaceInformation();
    BOOST_TEST(motionValidatorOf(si).shared().clearance() == sceneOf(si).clearance());
    PlanReport report;
    const PlanSetup plan = makePlanSetup(window.problem, window.scene, {}, report);
    BOOST_TEST(plan.checker->shared().clearance() == plan.certified->shared().clearance());
    BOOST_TEST(plan.checker->shared().clearance() != plan.auditor->shared().clearance());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
