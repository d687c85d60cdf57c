// OMPL's contract for motion validators: checks that suit any validator.
#include "clearway/planning/motion_validator.h"

#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Console.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(motion_validator_contract_test)

using LastValid = std::pair<ob::State*, double>;
using State = ob::ScopedState<>;

constexpr double kUntouched = 7;

/// The validator's si must have a validity checker. The motion from start to near is valid. The motion from
/// start to far is not, although both states are. blocked is an invalid state.
struct ContractMotions {
    State start, near, far, blocked;
};

class Contract {
  public:
    Contract(const ob::SpaceInformation& si, ob::MotionValidator& validator, const ContractMotions& motions)
        : si_(si), validator_(validator), motions_(motions) {}

    void checkVerdicts() {
        const State &start = motions_.start, &near = motions_.near, &far = motions_.far;
        BOOST_TEST(validator_.checkMotion(start.get(), near.get()));
        BOOST_TEST(validator_.checkMotion(start.get(), start.get()));
        BOOST_TEST(!validator_.checkMotion(start.get(), far.get()));
        BOOST_TEST(!validator_.checkMotion(start.get(), motions_.blocked.get()));
    }

    void checkValidMotionLeavesLastValidAlone() {
        State kept = motions_.far;
        LastValid lastValid(kept.get(), kUntouched);
        BOOST_TEST(validator_.checkMotion(motions_.start.get(), motions_.near.get(), lastValid));
        BOOST_TEST(lastValid.second == kUntouched);
        BOOST_TEST((kept == motions_.far));
    }

    void checkLastValid(const State& to) {
        const State& start = motions_.start;
        State kept = motions_.near, expected = start;
        LastValid lastValid(kept.get(), kUntouched);
        BOOST_TEST(!validator_.checkMotion(start.get(), to.get(), lastValid));
        BOOST_TEST((lastValid.second >= 0 && lastValid.second < 1));
        if (lastValid.second > 0) {
            si_.getStateSpace()->interpolate(start.get(), to.get(), lastValid.second, expected.get());
        }
        BOOST_TEST((kept == expected));
        BOOST_TEST(si_.isValid(kept.get()));
        for (int i = 0; i <= 200; ++i) {
            const double time = lastValid.second * i / 200;
            si_.getStateSpace()->interpolate(start.get(), to.get(), time, expected.get());
            BOOST_TEST(si_.isValid(expected.get()));
        }

        LastValid none(nullptr, kUntouched);
        BOOST_TEST(!validator_.checkMotion(start.get(), to.get(), none));
        BOOST_TEST(none.second == lastValid.second);
        checkAliases(to, kept, lastValid.second);
    }

    void checkAliases(const State& to, const State& expected, double time) {
        State s1 = motions_.start;
        LastValid first(s1.get(), kUntouched);
        BOOST_TEST(!validator_.checkMotion(s1.get(), to.get(), first));
        BOOST_TEST((s1 == expected));
        BOOST_TEST(first.second == time);

        State s2 = to;
        LastValid second(s2.get(), kUntouched);
        BOOST_TEST(!validator_.checkMotion(motions_.start.get(), s2.get(), second));
        BOOST_TEST((s2 == expected));
        BOOST_TEST(second.second == time);
    }

    void checkInvalidStart() {
        State kept = motions_.near;
        LastValid lastValid(kept.get(), kUntouched);
        BOOST_TEST(!validator_.checkMotion(motions_.blocked.get(), motions_.start.get(), lastValid));
        BOOST_TEST(lastValid.second == 0);
        BOOST_TEST((kept == motions_.blocked));
        BOOST_TEST(!validator_.checkMotion(motions_.blocked.get(), motions_.start.get()));
    }

    void checkStatesThatAreNotFinite() {
        ompl::msg::noOutputHandler();
        for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
            State bad = motions_.near;
            bad->as<ob::SE3StateSpace::StateType>()->setX(value);
            const ob::State *one = bad.get(), *other = motions_.start.get();
            for (int turn = 0; turn < 2; ++turn, std::swap(one, other)) {
                LastValid lastValid(nullptr, kUntouched);
                BOOST_TEST(!validator_.checkMotion(one, other));
                BOOST_TEST(!validator_.checkMotion(one, other, lastValid));
                BOOST_TEST(lastValid.second == 0);
            }
        }
        ompl::msg::restorePreviousOutputHandler();
    }

    void checkCounters() {
        validator_.resetMotionCounter();
        LastValid none(nullptr, kUntouched);
        const ob::State *start = motions_.start.get(), *near = motions_.near.get(), *far = motions_.far.get();
        constexpr int kThreads = 4, kRounds = 20;
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t) {
            threads.emplace_back([&, none]() mutable {
                for (int i = 0; i < kRounds; ++i) {
                    validator_.checkMotion(start, near);
                    validator_.checkMotion(start, near, none);
                    validator_.checkMotion(start, far);
                    validator_.checkMotion(start, far, none);
                    validator_.checkMotion(motions_.blocked.get(), near, none);
                }
            });
        }
        for (std::thread& thread : threads) thread.join();
        BOOST_TEST(validator_.getValidMotionCount() == 2u * kThreads * kRounds);
        BOOST_TEST(validator_.getInvalidMotionCount() == 3u * kThreads * kRounds);
    }

  private:
    const ob::SpaceInformation& si_;
    ob::MotionValidator& validator_;
    const ContractMotions& motions_;
};

/// Checks with Boost.Test: the verdicts of both forms; that lastValid is untouched on true; on false a time
/// in [0, 1) with its state, which is valid, as are the states before it; null and aliased arguments; an
/// invalid start; states that are not finite; and OMPL's counters, from several threads too. None of the
/// given states may change.
void checkMotionValidatorContract(const ob::SpaceInformation& si, ob::MotionValidator& validator,
                                  const ContractMotions& motions) {
    const ContractMotions before = motions;
    Contract contract(si, validator, motions);
    contract.checkVerdicts();
    contract.checkValidMotionLeavesLastValidAlone();
    contract.checkLastValid(motions.far);
    contract.checkLastValid(motions.blocked);
    contract.checkInvalidStart();
    contract.checkStatesThatAreNotFinite();
    contract.checkCounters();
    BOOST_TEST((motions.start == before.start && motions.near == before.near));
    BOOST_TEST((motions.far == before.far && motions.blocked == before.blocked));
}

struct Fixture {
    explicit Fixture(double margin) {
        window.scene.obstacles[0].margin = margin;
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, window.scene));
        si->setup();
    }

    ob::ScopedState<> at(const Vector3& position, double angle = 0) const {
        PartState state = window.problem.start;
        state.position = position;
        state.rotation = Eigen::AngleAxisd(angle, Vector3(1, 2, 2).normalized()) * state.rotation;
        return toOmpl(space, Space::kSe3, state);
    }

    /// States on both sides of the wall, where the part stands upright and does not fit through the window.
    ContractMotions motions() const {
        return {at({-60, 0, 0}), at({-50, 20, 5}, 0.3), at({60, 10, 0}, 0.5), at({0, 0, 0}, 0.1)};
    }

    testing::WindowScene window = testing::windowScene();
    ob::StateSpacePtr space = makeSpace(Space::kSe3, *window.problem.volume, 1);
    ob::SpaceInformationPtr si = std::make_shared<ob::SpaceInformation>(space);
};

BOOST_AUTO_TEST_CASE(the_certified_validator_keeps_the_contract) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        MotionValidator validator(f.si, f.window.scene);
        checkMotionValidatorContract(*f.si, validator, f.motions());
    }
}

BOOST_AUTO_TEST_CASE(the_certified_validator_keeps_the_contract_through_callbacks) {
    const Fixture f(2);
    MotionValidator validator(f.si, SharedScene(f.window.scene, stateToPose(*f.space),
                                                displacementBound(*f.space, f.window.scene.part)));
    checkMotionValidatorContract(*f.si, validator, f.motions());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
