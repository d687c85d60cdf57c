#include <boost/test/unit_test.hpp>

#include "clearway/planning/plan.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/processor_time.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(tunnel_console_plan_test)

using planning::PlanReport;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSeconds = 400;  // enough under a sanitizer
#else
constexpr double kSeconds = 30;
#endif

// tests/bench/plan_success.cpp runs any number of seeds.
BOOST_AUTO_TEST_CASE(the_small_tunnel_console_is_solved_in_30_seconds_and_the_path_is_free_by_the_oracle) {
    const Problem problem = readProblem(CLEARWAY_DATA_DIR "/tunnel-console-small/tunnel-console.cfg");
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
    const Scene scene{Model::build(loadPart(problem)), Model::build(loadEnvironment(problem)),
                      problem.margin};
    planning::PlanOptions options;
    PlanReport report;
    const double seconds = secondsOnAllProcessors([&] {
        report = withProcessorTime(kSeconds, [&](double limit) {
            options.seconds = limit;
            return plan(problem, scene, options);
        });
    });
    BOOST_TEST_CONTEXT("seed " << options.seed << ", found by " << report.foundBy) {
        BOOST_REQUIRE((report.outcome == PlanReport::Outcome::kFound));
        BOOST_TEST(seconds < kSeconds);
        BOOST_TEST(report.warnings.empty());
        BOOST_TEST(report.path.front().position == problem.start.position);
        BOOST_TEST(report.path.back().position == problem.goal.position);
        BOOST_TEST(collisionsAlong(oracle, report.path, problem, 1000) == 0);
        BOOST_TEST(report.audit.isValid());
        const planning::SegmentAudit& closest = report.audit.segments[report.audit.closest];
        BOOST_TEST(closest.partMesh != "");
        BOOST_TEST(closest.environmentMesh != "");
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
