#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cstdint>

#include "clearway/planning/plan.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(interrupted_plan_test)

using Outcome = PlanReport::Outcome;

BOOST_AUTO_TEST_CASE(a_stop_keeps_the_path_of_a_planner_that_would_improve_it) {
    auto window = testing::windowScene();
    window.problem.goal.position = {-60, 30, 0};  // before the wall as the start is
    for (const char* planner : {"RRTstar", "AnytimePathShortening"}) {
        const auto begin = std::chrono::steady_clock::now();
        PlanOptions options;
        options.planner = planner;
        options.objective = "length";
        options.seconds = 1000;
        // Both planners join start and goal straight away, and then go on for all their time.
        options.isStopped = [&] {
            return std::chrono::steady_clock::now() - begin > std::chrono::seconds(1);
        };
        BOOST_TEST_CONTEXT(planner) {
            const PlanReport report = plan(window.problem, window.scene, options);
            BOOST_TEST(report.isStopped);
            BOOST_REQUIRE((report.outcome == Outcome::kFound));
            BOOST_TEST(report.audit.isValid());
            BOOST_TEST(report.path.back().position == window.problem.goal.position);
            BOOST_TEST(report.planningSeconds < 500);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_stop_at_any_time_leaves_a_valid_path_once_there_is_one) {
    const auto window = testing::windowScene();
    const testing::MeshOracle oracle(window.partMesh, window.wallMesh);
    std::uint64_t asked = 0, most = ~std::uint64_t{0};
    PlanOptions options;
    options.iterations = 200000;  // the limit is repeatable, and so is how often the planning asks
    options.isStopped = [&] { return ++asked > most; };
    const PlanReport whole = plan(window.problem, window.scene, options);
    BOOST_REQUIRE((whole.outcome == Outcome::kFound));
    BOOST_TEST(!whole.isStopped);

    const std::uint64_t all = asked;
    int found = 0, none = 0;
    for (int tenths = 0; tenths < 10; ++tenths) {
        asked = 0;
        most = all * static_cast<std::uint64_t>(tenths) / 10;
        const PlanReport report = plan(window.problem, window.scene, options);
        BOOST_TEST(report.isStopped);
        BOOST_TEST_REQUIRE((report.outcome == Outcome::kFound || report.outcome == Outcome::kStopped));
        BOOST_TEST(report.path.empty() == (report.outcome == Outcome::kStopped));
        ++(report.path.empty() ? none : found);
        if (report.path.empty()) continue;
        BOOST_TEST(report.audit.isValid());
        BOOST_TEST(testing::collisionsAlong(oracle, report.path, window.problem, 300) == 0);
        // Making room and shortening ended early: the path keeps less room or is no shorter.
        BOOST_REQUIRE((report.widening && whole.widening));
        BOOST_TEST((report.widening->after < whole.widening->after || report.length >= 0.999 * whole.length));
    }
    BOOST_TEST(none > 0);
    BOOST_TEST(found > 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
