#include "clearway/planning/valid_state_samplers.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <boost/test/unit_test.hpp>
#include <string>

#include "clearway/problem.h"
#include "planning/plan/problem_settings.h"
#include "planning/space/ompl_states.h"
#include "support/motion_window.h"
#include "support/words.h"

namespace clearway::planning {

namespace {

constexpr unsigned kSeedOfSamples = 9;

/// OMPL's samples are random; its seed can be set once.
struct SeededSamples {
    SeededSamples() {
        ompl::RNG::setSeed(kSeedOfSamples);
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(valid_state_samplers_test, *boost::unit_test::fixture<SeededSamples>())

using Fixture = testing::MotionWindow;

/// States from the sampler, each checked to be valid.
std::vector<ob::ScopedState<>> draw(const Fixture& f, ob::ValidStateSampler& sampler, int tries) {
    std::vector<ob::ScopedState<>> states;
    ob::ScopedState<> state(f.space);
    for (int i = 0; i < tries; ++i) {
        if (!sampler.sample(state.get())) continue;
        BOOST_TEST(f.si->isValid(state.get()), "seed " << kSeedOfSamples << ", try " << i);
        states.push_back(state);
    }
    return states;
}

double clearanceAt(const Fixture& f, const ob::ScopedState<>& state) {
    return f.si->getStateValidityChecker()->clearance(state.get());
}

BOOST_AUTO_TEST_CASE(contact_samples_are_valid_and_keep_the_wanted_clearance_where_there_is_room) {
    for (const Space kind : {Space::kSe3, Space::kSe2}) {
        const Fixture f(0.5, {}, kind);
        ContactNormalSampler sampler(f.si.get());
        BOOST_TEST(sampler.params().setParam("clearance", "2"));
        const auto states = draw(f, sampler, 300);
        BOOST_TEST(states.size() > 290u);
        int kept = 0, beside = 0;
        for (const ob::ScopedState<>& state : states) {
            const double clearance = clearanceAt(f, state);
            kept += clearance >= 2;
            beside += clearance < 3;
        }
        BOOST_TEST(kept > 0.9 * static_cast<double>(states.size()));
        // States that collided when they were drawn.
        BOOST_TEST(beside > 0.05 * static_cast<double>(states.size()));
    }
}

BOOST_AUTO_TEST_CASE(gap_samples_are_in_the_window_and_in_its_middle) {
    // Inside the window the plate has 11 above and below; the bounds are far wider.
    const Fixture f;
    NarrowGapSampler sampler(f.si.get());
    BOOST_TEST(sampler.params().setParam("gap", "30"));
    sampler.setNrAttempts(1000);
    const auto states = draw(f, sampler, 40);
    BOOST_TEST(states.size() >= 30u);
    for (const ob::ScopedState<>& state : states) {
        const auto& checker = dynamic_cast<const ValidityChecker&>(*f.si->getStateValidityChecker());
        // The plate's farthest corner is 36.4 from its middle, and the window's rim at most 15 from the
        // plate.
        const Vector3 p = checker.pose(state.get()).translation;
        BOOST_TEST(std::abs(p.x()) < 2 + 36.4 + 15);
        BOOST_TEST(std::abs(p.z()) < 16 + 36.4 + 15);
        BOOST_TEST(clearanceAt(f, state) <= 15);
    }
}

BOOST_AUTO_TEST_CASE(gap_samples_are_as_far_from_one_side_as_from_the_other) {
    // In the plane: 64 between left and right, the plate turned to 60 in width leaves 2 at each side.
    const Fixture f(0, {}, Space::kSe2);
    NarrowGapSampler sampler(f.si.get());
    BOOST_TEST(sampler.params().setParam("gap", "10"));
    ob::ScopedState<> state(f.space);
    const auto near = f.at({0, 0.8, 0}, M_PI / 2);
    int found = 0;
    for (int i = 0; i < 50; ++i) {
        if (!sampler.sampleNear(state.get(), near.get(), 1.5)) continue;
        ++found;
        BOOST_TEST(f.si->isValid(state.get()));
        BOOST_TEST(f.space->distance(state.get(), near.get()) <= 1.5);
        BOOST_TEST(std::abs(state->as<ob::SE2StateSpace::StateType>()->getY()) < 0.35);  // 10 in 2^5 parts
    }
    BOOST_TEST(found > 10);
}

BOOST_AUTO_TEST_CASE(samples_near_a_state_are_near_it) {
    const Fixture f;
    ContactNormalSampler contact(f.si.get());
    ob::ScopedState<> state(f.space);
    const auto near = f.at({-33, 0, 30});
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        if (!contact.sampleNear(state.get(), near.get(), 5)) continue;
        ++found;
        BOOST_TEST(f.si->isValid(state.get()));
        BOOST_TEST(f.space->distance(state.get(), near.get()) <= 5);
    }
    BOOST_TEST(found > 150);
}

BOOST_AUTO_TEST_CASE(what_the_samplers_cannot_work_with_is_refused_by_name) {
    const Fixture f;
    ob::SpaceInformation other(f.space);
    other.setStateValidityChecker([](const ob::State*) { return true; });
    testing::requireRefusedBy([&] { NarrowGapSampler{&other}; }, {"narrow_gap", "ValidityChecker"});
    const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
    space->setBounds(-100, 100);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const StateToPose pose = [](const ob::State* state) {
        const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return Pose{Matrix3::Identity(), {x[0], x[1], x[2]}};
    };
    si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, SharedScene(f.window.scene, pose)));
    testing::requireRefusedBy([&] { ContactNormalSampler{si.get()}; }, {"contact_normal", space->getName()});
}

BOOST_AUTO_TEST_CASE(a_problem_names_them_as_it_names_those_of_ompl) {
    const Fixture f;
    for (const std::string name : {"contact_normal", "narrow_gap"}) {
        setSampler(*f.si, name, [](ob::ValidStateSampler&) {});
        BOOST_TEST(f.si->allocValidStateSampler()->getName() == name);
    }
    testing::requireRefusedBy([&] { setSampler(*f.si, "narrow", [](ob::ValidStateSampler&) {}); },
                              {"narrow_gap"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
