// Planning with the environment cut to its range gives the path that planning with the whole environment
// gives.
#include "clearway/planning/plan.h"

#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(planning_range_test)

/// The wall with a window, and a second such wall far behind it.
struct TwoWalls {
    explicit TwoWalls(double margin = 0) {
        problem.margin = margin;
        environment = testing::joined(window.wallMesh, testing::translated(window.wallMesh, {1000, 0, 0}));
    }

    Scene scene(const std::optional<QueryRange>& range = std::nullopt) const {
        return {window.scene.part, Model::build(environment, {}, range), problem.margin};
    }
    std::optional<QueryRange> range(const PlanOptions& options = {}) const {
        return planningRange(problem, options, window.scene.part, boundingBox(environment));
    }

    testing::WindowScene window = testing::windowScene();
    Problem problem = window.problem;
    Mesh environment;
};

/// For a planner that asks for verdicts only, and quick: sliding planners and bands go by distances whose last digits
/// differ from tree to tree.
PlanOptions withIterations(std::uint64_t iterations, std::uint32_t seed = 1) {
    PlanOptions options;
    options.planner = "RRTConnect";
    options.quick = true;
    options.iterations = iterations;
    options.seed = seed;
    return options;
}

void checkSame(const PlanReport& whole, const PlanReport& reduced) {
    BOOST_TEST((whole.outcome == reduced.outcome));
    BOOST_REQUIRE(whole.path.size() == reduced.path.size());
    for (std::size_t i = 0; i < whole.path.size(); ++i) {
        BOOST_TEST(whole.path[i].position == reduced.path[i].position);
        BOOST_TEST(whole.path[i].rotation.coeffs() == reduced.path[i].rotation.coeffs());
    }
    if (whole.path.empty()) return;
    BOOST_TEST((whole.audit.verdict == reduced.audit.verdict));
    BOOST_TEST(whole.audit.lowerClearance <= reduced.audit.upperClearance);
    BOOST_TEST(reduced.audit.lowerClearance <= whole.audit.upperClearance);
    BOOST_TEST(whole.audit.segments[whole.audit.closest].environmentMesh ==
               reduced.audit.segments[reduced.audit.closest].environmentMesh);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_path_with_and_without_what_is_out_of_range) {
    for (const double margin : {0.0, 2.0}) {
        const TwoWalls walls(margin);
        const Scene whole = walls.scene(), reduced = walls.scene(walls.range());
        BOOST_TEST(reduced.obstacles[0].model.report().unreachableTriangles == 4 * 108u);
        for (const std::uint32_t seed : {1u, 2u}) {
            BOOST_TEST_CONTEXT("margin " << margin << ", seed " << seed) {
                PlanOptions options = withIterations(200000, seed);
                const PlanReport report = plan(walls.problem, whole, options);
                BOOST_TEST((report.outcome == PlanReport::Outcome::kFound));
                checkSame(report, plan(walls.problem, reduced, options));
                options = withIterations(300, seed);  // a search that need not find a path
                options.planner = "KPIECE1";
                checkSame(plan(walls.problem, whole, options), plan(walls.problem, reduced, options));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_planar_problem_has_its_range_in_the_plane) {
    TwoWalls walls;
    walls.problem.space = Space::kSe2;
    walls.problem.start.rotation = walls.problem.goal.rotation = Eigen::Quaterniond::Identity();
    walls.problem.volume = Box(Vector3(-80, -80, 0), Vector3(80, 80, 0));
    const std::optional<QueryRange> range = walls.range();
    BOOST_REQUIRE(range.has_value());
    BOOST_TEST(range->positions.sizes().z() < 1e-6);
    const Scene reduced = walls.scene(range);
    BOOST_TEST(reduced.obstacles[0].model.report().unreachableTriangles > 0u);
    const PlanOptions options = withIterations(200000);
    checkSame(plan(walls.problem, walls.scene(), options), plan(walls.problem, reduced, options));
}

BOOST_AUTO_TEST_CASE(the_range_holds_the_bounds_and_the_cap_all_that_planning_asks_with_the_part_on_top) {
    TwoWalls walls(3);
    const double radius = walls.window.scene.part.radiusAboutOrigin();
    const QueryRange range = walls.range().value();
    BOOST_TEST(range.positions.contains(*walls.problem.volume));
    BOOST_TEST(range.positions.min().x() < -80);  // a state at the border is within OMPL's bounds by rounding
    BOOST_TEST(range.positions.sizes().x() < 160 * (1 + 1e-6));
    BOOST_TEST(range.partRadius == radius);
    BOOST_TEST(range.cap == 3 + 1 + 2 * radius);
    walls.problem.fineness = 7;
    BOOST_TEST(walls.range()->cap == 3 + 7 + 2 * radius);
    walls.problem.fineness.reset();
    BOOST_TEST(walls.range()->cap == 3 + Vector3(60, 40, 10).norm() / 500 + 2 * radius,
               boost::test_tools::tolerance(1e-12));
    walls.problem.planning.objective = "max_min_clearance";
    BOOST_TEST(!walls.range());  // clearances of any size count
    PlanOptions options;
    options.objective = "length_with_clearance";
    options.wantedClearance = 20;
    BOOST_TEST(walls.range(options)->cap == 3 + 20 + 2 * radius);
    walls.problem.planning.sampler = "max_clearance";
    BOOST_TEST(!walls.range());
}

BOOST_AUTO_TEST_CASE(bounds_that_are_the_environments_box_leave_nothing_out) {
    TwoWalls walls;
    walls.problem.volume.reset();
    BOOST_TEST(walls.scene(walls.range()).obstacles[0].model.report().unreachableTriangles == 0u);
}

BOOST_AUTO_TEST_CASE(a_path_that_meets_nothing_tells_the_cap_and_no_meshes) {
    TwoWalls walls;
    walls.environment = testing::translated(walls.window.wallMesh, {1000, 0, 0});
    const PlanReport report = plan(walls.problem, walls.scene(walls.range()), withIterations(200000));
    BOOST_REQUIRE((report.outcome == PlanReport::Outcome::kFound));
    BOOST_TEST(report.audit.lowerClearance <= walls.range()->cap);
    BOOST_TEST(report.audit.lowerClearance >= 0.99 * walls.range()->cap - 1e-3 * 73);
    BOOST_TEST(std::isinf(report.audit.upperClearance));
    const SegmentAudit& closest = report.audit.segments.at(report.audit.closest);
    BOOST_TEST(closest.partMesh == "");
    BOOST_TEST(closest.environmentMesh == "");
}

BOOST_AUTO_TEST_CASE(an_environment_of_too_small_a_range_is_refused) {
    TwoWalls walls(2);
    const QueryRange right = walls.range().value();
    const auto planWith = [&](const QueryRange& range) {
        plan(walls.problem, walls.scene(range), withIterations(10));
    };
    BOOST_CHECK_NO_THROW(planWith(right));
    QueryRange wrong = right;
    wrong.positions.max().y() = 39;
    testing::requireRefusedBy([&] { planWith(wrong); }, {"leaves out positions within the bounds"});
    wrong = right;
    wrong.cap = 2.5;  // the margin is 2, the fineness 1
    testing::requireRefusedBy([&] { planWith(wrong); },
                              {"cap is 2.5, expected at least the margin and the fineness, 3"});
    wrong = right;
    wrong.partRadius = 30;
    testing::requireRefusedBy([&] { planWith(wrong); }, {"the part's radius about its origin"});
}

struct CheckerFixture {
    explicit CheckerFixture(double margin) : walls(margin) {}
    ob::ScopedState<> at(const Vector3& position) const {
        PartState state = walls.problem.start;
        state.position = position;
        return toOmpl(space, Space::kSe3, state);
    }
    TwoWalls walls;
    ob::StateSpacePtr space = makeSpace(Space::kSe3, *walls.problem.volume, 1);
    ob::SpaceInformationPtr si = std::make_shared<ob::SpaceInformation>(space);
};

BOOST_AUTO_TEST_CASE(a_checker_tells_clearance_up_to_the_cap_and_its_sign_always) {
    for (const double margin : {0.0, 2.0}) {
        const CheckerFixture f(margin);
        QueryRange range = f.walls.range().value();
        range.cap = 5;
        const ValidityChecker checker(f.si, f.walls.scene(range)), whole(f.si, f.walls.scene());
        for (const double x : {-78.0, -60.0, -40.0, -36.0, -35.0, -34.5, -34.0, -33.0, -20.0}) {
            const auto state = f.at({x, 0, 0});
            BOOST_TEST(checker.isValid(state.get()) == whole.isValid(state.get()), "x " << x);
            BOOST_TEST(checker.clearance(state.get()) == std::min(whole.clearance(state.get()), 5 - margin),
                       boost::test_tools::tolerance(1e-12));
            BOOST_TEST((checker.clearance(state.get()) > 0) == whole.isValid(state.get()));
        }
    }
    const CheckerFixture f(5);
    QueryRange range = f.walls.range().value();
    range.cap = 5;  // no more than the margin itself
    const ValidityChecker checker(f.si, f.walls.scene(range));
    BOOST_TEST(checker.clearance(f.at({-60, 0, 0}).get()) == std::numeric_limits<double>::denorm_min());
    BOOST_TEST(!checker.isValid(f.at({-36, 0, 0}).get()));
    range.cap = 4.9;
    testing::requireRefusedBy([&] { ValidityChecker(f.si, f.walls.scene(range)); },
                              {"d is 5, expected at most 4.9"});
}

BOOST_AUTO_TEST_CASE(a_state_out_of_bounds_and_range_is_out_of_bounds_and_not_without_a_pose) {
    for (const double margin : {0.0, 2.0}) {
        const CheckerFixture f(margin);
        const ValidityChecker checker(f.si, f.walls.scene(f.walls.range()));
        const auto state = f.at({-81, 0, 0});
        BOOST_TEST(!checker.isValid(state.get()));
        BOOST_TEST(checker.clearance(state.get()) == -margin);
        BOOST_TEST(checker.counters().outOfBounds == 2u);
        BOOST_TEST(checker.counters().unusable == 0u);
        BOOST_CHECK_THROW(checker.distance(state.get()), std::invalid_argument);
        BOOST_TEST(checker.isValid(f.at({-80, 40, -40}).get()));  // on the border
    }
}

BOOST_AUTO_TEST_CASE(positions_may_lie_anywhere_off_the_origin) {
    const CheckerFixture f(0);
    QueryRange range = f.walls.range().value();
    range.positions = Box(Vector3(40, 30, 20), Vector3(80, 40, 40));
    const ValidityChecker checker(f.si, f.walls.scene(range));
    BOOST_TEST(checker.isValid(f.at({60, 35, 30}).get()));
    ompl::msg::noOutputHandler();
    BOOST_TEST(!checker.isValid(f.at({-60, 0, 0}).get()));  // within the bounds, but out of the range
    ompl::msg::restorePreviousOutputHandler();
    BOOST_TEST(checker.counters().unusable == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
