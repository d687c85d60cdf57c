#include "clearway/planning/simplify.h"

#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>

#include "support/motion_scene.h"
#include "support/motion_window.h"

namespace clearway::planning {

namespace {

constexpr unsigned kSeedOfShortcuts = 5;

/// OMPL's shortcuts are random; its seed can be set once.
struct SeededShortcuts {
    SeededShortcuts() { ompl::RNG::setSeed(kSeedOfShortcuts); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(simplify_test, *boost::unit_test::fixture<SeededShortcuts>())

using testing::MotionScene;

SimplifyOptions withFloor(double floor) {
    SimplifyOptions options;
    options.floor = floor;
    return options;
}

/// A zigzag of valid motions along a scene's own path. Nothing when the random draws give fewer than three
/// states.
std::optional<og::PathGeometric> zigzag(const MotionScene& scene, testing::Random& random, double off) {
    og::PathGeometric path(scene.si);
    for (int i = 0; i < 200 && path.getStateCount() < 12; ++i) {
        const auto next = scene.state(scene.nearPath(random, off, 0.02 * off));
        const auto count = static_cast<unsigned int>(path.getStateCount());
        if (count == 0 ? scene.checker->isValid(next.get())
                       : scene.close->checkMotion(path.getState(count - 1), next.get())) {
            path.append(next.get());
        }
    }
    if (path.getStateCount() < 3) return std::nullopt;
    return path;
}

double lengthOf(const og::PathGeometric& path) {
    return og::PathGeometric(path).length();
}

/// Asks the oracle about evenly spread poses of each motion.
double trueLeast(const MotionScene& scene, const og::PathGeometric& path) {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int k = 0; k + 1 < path.getStateCount(); ++k) {
        least = std::min(least, scene.leastTrueClearance(path.getState(k), path.getState(k + 1), 1, 100, 2));
    }
    return least;
}

BOOST_AUTO_TEST_CASE(the_least_clearance_never_falls_below_the_floor_or_what_it_was) {
    int shortened = 0, tight = 0;
    for (const auto& scene : testing::motionScenes()) {
        testing::Random random(kSeedOfShortcuts);
        const double size = scene->scene.part.box().diagonal().norm();
        for (int round = 0; round < 6; ++round) {
            const auto before = zigzag(*scene, random, 0.01 * size * (round % 3));
            const double floor = size * std::pow(10, random.uniform(-4, -1.5));
            if (!before) continue;
            og::PathGeometric path = *before;
            const PathAudit was = audit(path, *scene->close);
            const PathAudit is = simplify(path, *scene->close, withFloor(floor));
            const double kept = std::min(floor, was.lowerClearance);
            BOOST_TEST_CONTEXT(scene->name << ", seed " << kSeedOfShortcuts << ", round " << round
                                           << ", floor " << floor << ", was " << was.lowerClearance) {
                BOOST_TEST(was.isValid());
                BOOST_TEST(is.isValid());
                BOOST_TEST(is.upperClearance >= kept);
                BOOST_TEST(is.lowerClearance >= 0.89 * kept - 1e-9 * size);  // as accurate as audits are
                BOOST_TEST(trueLeast(*scene, path) >= kept * (1 - 1e-9) - 1e-12 * size);
                BOOST_TEST(lengthOf(path) <= lengthOf(*before) * (1 + 1e-9));
                BOOST_TEST(scene->space->equalStates(path.getState(0), before->getState(0)) == true);
                const auto last = [](const og::PathGeometric& of) {
                    return of.getState(static_cast<unsigned int>(of.getStateCount()) - 1);
                };
                BOOST_TEST(scene->space->equalStates(last(path), last(*before)) == true);
                BOOST_TEST(is.segments.size() + 1 == path.getStateCount());
            }
            shortened += lengthOf(path) < 0.99 * lengthOf(*before);
            tight += was.lowerClearance < floor;
        }
    }
    BOOST_TEST(shortened > 12);
    BOOST_TEST(tight > 4);
}

using Fixture = testing::MotionWindow;

BOOST_AUTO_TEST_CASE(a_tight_start_does_not_let_the_rest_come_closer) {
    // The wall's face is at x = -2 and the plate reaches 30, so that at -32.01 it nearly touches.
    const Fixture f;
    auto path =
        pathOf(f, {f.at({-32.01, 0, 30}), f.at({-36, -5, 30}), f.at({-40, 5, 30}), f.at({-50, -20, 30}),
                   f.at({-50, 20, 0}), f.at({-50, 0, -20}), f.at({-36, 0, -40})});
    const PathAudit is = simplify(path, *f.validator, withFloor(2));
    BOOST_TEST(is.isValid());
    BOOST_TEST(path.getStateCount() < 7u);
    BOOST_TEST(is.upperClearance == 0.01, boost::test_tools::tolerance(1e-6));
    for (unsigned int k = 1; k < path.getStateCount(); ++k) {
        const MotionReport motion = f.validator->report(path.getState(k - 1), path.getState(k));
        // The rest of the first motion, or a motion in its place, leads away from the wall.
        if (k > 1) BOOST_TEST(motion.upperClearance >= 2);
    }
    const Pose exit = f.validator->pose(path.getState(1));
    BOOST_TEST(exit.translation.x() <= -34);
}

BOOST_AUTO_TEST_CASE(where_the_floor_cannot_be_kept_a_quarter_of_it_is_tried) {
    // The window leaves 11 above and below the plate, so that 12 cannot be kept and 3 can.
    const Fixture f;
    auto path =
        pathOf(f, {f.at({-60, 0, 0}), f.at({-34, 0, 0}), f.at({-20, 0, 10.99}), f.at({-10, 0, -10.99}),
                   f.at({0, 0, 10.99}), f.at({10, 0, -10.99}), f.at({20, 0, 10.99}), f.at({60, 0, 0})});
    BOOST_TEST(audit(path, *f.validator).upperClearance <= 0.0101);
    const PathAudit is = simplify(path, *f.validator, withFloor(12));
    BOOST_TEST(is.isValid());
    BOOST_TEST(is.upperClearance >= 3);
}

BOOST_AUTO_TEST_CASE(a_path_that_is_not_valid_is_left_as_it_was) {
    const Fixture f;
    auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 10, 0}), f.at({-60, 20, 0}), f.at({60, 0, 30})});
    const PathAudit is = simplify(path, *f.validator, withFloor(1));
    BOOST_TEST((is.notValid == std::vector<std::size_t>{2}));
    BOOST_TEST(path.getStateCount() == 4u);
}

BOOST_AUTO_TEST_CASE(a_spent_budget_leaves_a_valid_path) {
    const Fixture f;
    auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 10, 0}), f.at({-60, 20, 0})});
    SimplifyOptions options;
    options.isSpent = [] { return true; };
    BOOST_TEST(simplify(path, *f.validator, options).isValid());
    BOOST_TEST(path.getStateCount() == 3u);
}

/// An audit of a path that slides along a face may take tens of seconds.
BOOST_AUTO_TEST_CASE(a_spent_budget_costs_one_audit) {
    const Fixture f;
    auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 10, 0}), f.at({-60, 20, 0})});
    std::atomic<int> asked{0};  // several threads ask
    MotionOptions motions;
    motions.isStopped = [&] { return ++asked < 0; };
    const MotionValidator counting(f.si, f.validator->scene(), motions);
    audit(path, counting);
    const int once = asked.exchange(0);
    SimplifyOptions options = withFloor(1e3);
    options.isSpent = [] { return true; };
    BOOST_TEST(simplify(path, counting, options).isValid());
    BOOST_TEST(once > 0);
    BOOST_TEST(asked == once);
}

BOOST_AUTO_TEST_CASE(wrong_floors_and_paths_are_refused) {
    const Fixture f;
    auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 10, 0})});
    for (const double floor : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        BOOST_CHECK_THROW(simplify(path, *f.validator, withFloor(floor)), std::invalid_argument);
    }
    og::PathGeometric empty(f.si);
    BOOST_CHECK_THROW(simplify(empty, *f.validator, withFloor(0)), std::invalid_argument);
    const Fixture flat(0, {}, Space::kSe2);
    auto planar = pathOf(flat, {flat.at({-60, 0, 0})});
    BOOST_CHECK_THROW(simplify(planar, *f.validator, withFloor(0)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
