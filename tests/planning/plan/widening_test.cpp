#include "planning/plan/widening.h"

#include <boost/test/unit_test.hpp>

#include "clearway/planning/problem_setup.h"
#include "planning/plan/finish.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(widening_test)

BOOST_AUTO_TEST_CASE(the_end_of_a_path_outside_does_not_limit_the_clearance_it_keeps) {
    auto window = testing::windowScene();
    window.problem.outside = Outside{sideNamed("+x")};
    window.problem.start = {{20, 0, 0}, {1, 0, 0, 0}};  // within the window, which leaves it 11
    PlanReport report;
    const PlanSetup setup = makePlanSetup(window.problem, window.scene, PlanOptions(), report);
    const PartState before = {{50, 0, 0}, {1, 0, 0, 0}},
                    end = {{32.5, 35, 0}, {1, 0, 0, 0}};  // 0.5 from the wall
    auto path = pathThrough(setup.si, {window.problem.start, before, end});
    WideningLimits limits;
    limits.sweeps = 64;
    limits.isDue = limits.isSpent = [] { return false; };
    const WideningReport room = widenPath(setup, path, limits);
    BOOST_TEST(room.before <= 0.5);
    BOOST_TEST(room.after > 8);
    BOOST_TEST(setup.definition->getGoal()->isSatisfied(path.getStates().back()));
    BOOST_TEST(path.length() < 60);  // not led on for longer than needed
}

/// Who interrupts the program waits for no more than one audit, after a rough measurement.
BOOST_AUTO_TEST_CASE(after_an_interrupt_hardly_anything_is_asked) {
    auto window = testing::windowScene();
    window.problem.outside = Outside{sideNamed("+x")};
    window.problem.start = {{20, 0, 0}, {1, 0, 0, 0}};
    PlanReport report;
    PlanOptions options;
    bool isStopped = false;
    options.isStopped = [&] { return isStopped; };
    const PlanSetup setup = makePlanSetup(window.problem, window.scene, options, report);
    const auto path = pathThrough(setup.si, {window.problem.start, {{50, 0, 0}, {1, 0, 0, 0}}});
    const auto queriesOf = [&](const std::function<void()>& work) {
        const auto before = setup.auditor->counters().queries;
        work();
        return setup.auditor->counters().queries - before;
    };
    const auto ofWidening = [&](bool stops) {
        isStopped = stops;
        auto widened = path;
        WideningLimits limits;
        limits.sweeps = 64;
        limits.isDue = limits.isSpent = [] { return false; };
        return queriesOf([&] {
            const WideningReport room = widenPath(setup, widened, limits);
            BOOST_TEST(room.after >= room.before);
            BOOST_TEST(room.after > 8);
        });
    };
    BOOST_TEST(ofWidening(true) < ofWidening(false));
    const PathAudit audited = audit(path, *setup.auditor);
    const double kept = 0.5 * (audited.lowerClearance + audited.upperClearance);
    BOOST_TEST_REQUIRE(kept > audited.lowerClearance);
    auto finished = path;
    const auto queries = queriesOf([&] {
        const PathAudit found = finish(
            setup, finished, [] { return true; }, kept);
        BOOST_TEST(found.isValid());
        BOOST_TEST(found.lowerClearance == kept);
    });
    BOOST_TEST(queries == queriesOf([&] { audit(path, *setup.auditor); }));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
