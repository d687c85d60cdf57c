// Contact zones: which obstacles are ignored, up to which displacement, and how motions across the border are
// judged, compared with the oracle.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "clearway/scene_clearance.h"
#include "support/full_run.h"
#include "support/oracle.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(contact_zone_test)

using planning::MotionReport;
using planning::MotionVerdict;

constexpr double kStartLength = 4, kGoalLength = 6;
constexpr double kBand = 2e-6;  ///< share of the length by which a vertex may seem to have moved further

struct TestObstacle {
    Mesh mesh;
    double margin;
    bool atStart, atGoal;
};

/// A plate rests on a tray, between two rails. Its goal is a shelf beyond a wall.
struct Assembly {
    Assembly() {
        for (const TestObstacle& o : obstacles) {
            scene.obstacles.push_back({Model::build(o.mesh), o.margin});
            scene.obstacles.back().isIgnoredAtStart = o.atStart;
            scene.obstacles.back().isIgnoredAtGoal = o.atGoal;
            oracles.push_back(std::make_unique<const MeshOracle>(part, o.mesh));
        }
        scene.startContact = ContactZone{start, kStartLength};
        scene.goalContact = ContactZone{goal, kGoalLength};
    }

    static double displacement(const Mesh& mesh, const Pose& from, const Pose& to) {
        double largest = 0;
        for (const Vector3& v : mesh.vertices) largest = std::max(largest, (to * v - from * v).norm());
        return largest;
    }

    /// The least distance - margin of the obstacles that count. inBand: whether obstacles whose zone ends
    /// within the band count.
    double clearance(const Pose& X, bool inBand) const {
        const double slack = inBand ? 1 - kBand : 1 + 1e-12;
        const bool isAtStart = displacement(part, start, X) <= kStartLength * slack,
                   isAtGoal = displacement(part, goal, X) <= kGoalLength * slack;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < obstacles.size(); ++i) {
            if ((obstacles[i].atStart && isAtStart) || (obstacles[i].atGoal && isAtGoal)) continue;
            least = std::min(least, oracles[i]->distance(X).distance - obstacles[i].margin);
        }
        return least;
    }

    Mesh part = box({30, 20, 5}, 2);
    Pose start{Matrix3::Identity(), {0, 0, 5}};
    Pose goal{Eigen::AngleAxisd(0.5, Vector3(0, 0, 1)).toRotationMatrix(), {150, 0, 5}};
    std::vector<TestObstacle> obstacles = {
        {translated(box({5, 80, 20}, 2), {75, 0, -15}), 0.5, false, false},  // wall
        {translated(box({40, 30, 5}, 3), {0, 0, -5}), 1, true, false},       // tray
        {joined(translated(box({30, 2, 8}, 2), {0, 23, 0}), translated(box({30, 2, 8}), {0, -23, 0})), 0,
         true, true},                                                      // rails
        {translated(box({40, 40, 5}, 3), {150, 0, -5}), 2, false, true}};  // shelf
    std::vector<std::unique_ptr<const MeshOracle>> oracles;
    Scene scene{Model::build(part)};
};

/// Poses near the assembled pose or on the way, many of them about as far away as the zone reaches.
PartState randomState(const Assembly& assembly, Random& random) {
    const bool isAtStart = random.below(3) > 0;
    const Pose& X = isAtStart ? assembly.start : assembly.goal;
    PartState state;
    const double away = std::pow(10, random.uniform(-1, 1.3));
    state.position = X.translation + random.direction() * away + Vector3(0, 0, random.uniform(0, 3));
    if (random.below(2) == 0) {  // straight off the obstacle it rests on
        state.position = X.translation + Vector3(random.uniform(-1, 1), random.uniform(-0.9, 0.9), away);
    }
    const double angle = random.below(2) * random.uniform(0, 0.12);
    state.rotation =
        Eigen::Quaterniond(Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix() * X.rotation);
    return state;
}

PartState stateOf(const Pose& X) {
    PartState state;
    state.position = X.translation;
    state.rotation = Eigen::Quaterniond(X.rotation);
    return state;
}

BOOST_AUTO_TEST_CASE(an_obstacle_is_ignored_while_no_vertex_is_further_from_the_assembled_pose) {
    const Assembly assembly;
    const PartInSpace space(assembly.scene);
    Random random(71);
    int ignored = 0, valid = 0;
    for (int i = 0; i < inForm(600, 200); ++i) {
        PartState state = randomState(assembly, random);
        if (i % 2 == 0) {  // to the border of the zone
            state.rotation = Eigen::Quaterniond::Identity();
            const double length = kStartLength * (1 + (i % 4 - 1) * 1e-5);
            state.position = assembly.start.translation + random.direction() * length;
        }
        const auto omplState = space.at(state);
        const Pose X = space.checker->pose(omplState.get());
        const double early = assembly.clearance(X, true), late = assembly.clearance(X, false);
        BOOST_TEST_CONTEXT("seed 71, state " << i) {
            BOOST_TEST_REQUIRE((early > 0) == (late > 0));  // none is within the band
            BOOST_TEST(space.checker->isValid(omplState.get()) == (late > 0));
            const double clearance = space.checker->clearance(omplState.get());
            BOOST_TEST((clearance > 0) == (late > 0));
            BOOST_TEST(clearance <= std::max(late, 0.0) + 1e-12);
            if (late > 0 && std::isfinite(late)) BOOST_TEST(clearance >= late * (1 - 1e-9) - 1e-12);
        }
        valid += late > 0;
        ignored += late > 0 && assembly.oracles[1]->collides(X);
    }
    BOOST_TEST(ignored > inForm(30, 10));
    BOOST_TEST(valid > inForm(200, 65));
    BOOST_TEST(space.isValid(assembly.start.translation));
    BOOST_TEST(space.checker->isValid(space.at(stateOf(assembly.goal)).get()));
}

void checkMotion(const Assembly& assembly, const PartInSpace& space, const ob::ScopedState<>& s1,
                 const ob::ScopedState<>& s2, int& valid, int& crossing) {
    ob::ScopedState<> between(space.space);
    const auto clearanceAt = [&](double time, bool inBand) {
        space.space->interpolate(s1.get(), s2.get(), time, between.get());
        return assembly.clearance(space.checker->pose(time < 1 ? between.get() : s2.get()), inBand);
    };
    const bool isValid = space.validator->checkMotion(s1.get(), s2.get());
    std::pair<ob::State*, double> lastValid(nullptr, 1);
    const bool forward = space.validator->checkMotion(s1.get(), s2.get(), lastValid);
    const MotionReport report = space.validator->report(s1.get(), s2.get());
    const bool isReported = report.verdict == MotionVerdict::kValid;
    BOOST_TEST(!report.whyInvalid.isUnusable());
    double least = std::numeric_limits<double>::infinity();
    const double until = isValid || isReported ? 1 : lastValid.second;
    bool wasIn = false, wasOut = false;
    for (int i = 0; i <= 60; ++i) {
        const double clearance = clearanceAt(until * i / 60, false);
        least = std::min(least, clearance);
        const Pose X = space.checker->pose(between.get());
        const bool isIn = Assembly::displacement(assembly.part, assembly.start, X) <= kStartLength;
        (isIn ? wasIn : wasOut) = true;
    }
    BOOST_TEST(((least > 0) || !(isValid || forward || isReported || lastValid.second > 0)));
    if (isReported) {
        BOOST_TEST(report.lowerClearance <= least * (1 + 1e-9));
        BOOST_TEST(report.upperClearance >= report.lowerClearance);
        if (std::isfinite(report.upperClearance)) {
            const double size = 2 * std::sqrt(30 * 30 + 20 * 20 + 5 * 5);
            BOOST_TEST(report.upperClearance - report.lowerClearance <=
                       std::max(0.1 * report.upperClearance, 1e-3 * size));
        }
        BOOST_TEST(
            (report.startContact.has_value() || !wasIn || assembly.clearance(assembly.start, false) < 0));
    }
    if (report.verdict == MotionVerdict::kInvalid && space.si->satisfiesBounds(s2.get())) {
        BOOST_TEST(clearanceAt(report.closestTime, true) <= 0);
    }
    valid += isValid;
    crossing += isValid && wasIn && wasOut;
}

BOOST_AUTO_TEST_CASE(no_motion_called_valid_is_too_close_by_the_oracle_to_what_counts_there) {
    const Assembly assembly;
    const PartInSpace space(assembly.scene);
    int valid = 0, crossing = 0, tried = 0;
    for (int seed = 1; seed <= inForm(150, 75); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto s1 =
            seed % 3 == 0 ? space.at(stateOf(assembly.start)) : space.at(randomState(assembly, random));
        const auto s2 = space.at(randomState(assembly, random));
        if (!space.checker->isValid(s1.get())) continue;
        ++tried;
        BOOST_TEST_CONTEXT("seed " << seed) {
            checkMotion(assembly, space, s1, s2, valid, crossing);
        }
    }
    BOOST_TEST_MESSAGE(tried << " motions, " << valid << " valid, " << crossing
                             << " of these across the border");
    BOOST_TEST(valid > inForm(25, 12));
    BOOST_TEST(crossing > inForm(8, 4));
    BOOST_TEST(valid < tried - inForm(15, 7));
}

BOOST_AUTO_TEST_CASE(a_part_is_lifted_off_its_tray_and_not_slid_along_it) {
    Assembly assembly;
    const PartInSpace space(assembly.scene);
    // Within 4 of the start nothing but the wall counts; the tray's margin is 1.
    BOOST_TEST(space.check({0, 0, 5}, {0, 0, 40}));
    BOOST_TEST(space.check({0, 0, 40}, {0, 0, 5}));
    BOOST_TEST(space.check({0, 0, 5}, {3.9, 0, 5}));
    BOOST_TEST(!space.check({0, 0, 5}, {4.1, 0, 5}));
    BOOST_TEST(!space.check({0, 0, 5}, {35, 0, 5.9}));
    std::pair<ob::State*, double> lastValid(nullptr, 1);
    BOOST_TEST(
        !space.validator->checkMotion(space.at({0, 0, 5}).get(), space.at({10, 0, 5}).get(), lastValid));
    BOOST_TEST(lastValid.second <= 0.4);
    BOOST_TEST(lastValid.second > 0.39);

    const MotionReport report =
        space.validator->report(space.at({0, 0, 5}).get(), space.at({0, 0, 40}).get());
    BOOST_TEST((report.verdict == MotionVerdict::kValid));
    BOOST_TEST(report.lowerClearance <= 1);  // distance from the rails, which begin to count
    BOOST_TEST(report.lowerClearance >= 0.9);
    BOOST_TEST(report.upperClearance >= report.lowerClearance);
    BOOST_REQUIRE(report.startContact.has_value());
    BOOST_TEST(report.startContact->first == 0);
    BOOST_TEST(report.startContact->last == 4.0 / 35, boost::test_tools::tolerance(0.1));
    BOOST_TEST(!report.goalContact.has_value());
}

BOOST_AUTO_TEST_CASE(between_two_zones_the_least_clearance_is_found) {
    Scene scene{Model::build(box({1, 1, 1}))};
    Obstacle floor{Model::build(translated(box({20, 20, 1}), {0, 0, -1}))};
    floor.isIgnoredAtStart = floor.isIgnoredAtGoal = true;
    scene.obstacles.push_back(floor);
    scene.startContact = ContactZone{{Matrix3::Identity(), {0, 0, 7}}, 1};
    scene.goalContact = ContactZone{{Matrix3::Identity(), {4, 0, 7}}, 1};
    const PartInSpace space(scene);
    const auto s1 = space.at({0, 0, 7}), s2 = space.at({4, 0, 7});
    const MotionReport report = space.validator->report(s1.get(), s2.get());
    BOOST_TEST((report.verdict == MotionVerdict::kValid));
    BOOST_TEST(report.upperClearance == 6, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(report.lowerClearance <= 6);
    BOOST_TEST(report.lowerClearance >= 0.98 * 6);
    BOOST_TEST(report.closest.obstacle.value() == 0u);
    const auto near = space.at({0.5, 0, 7});
    BOOST_TEST(std::isinf(space.validator->report(s1.get(), near.get()).lowerClearance));
}

BOOST_AUTO_TEST_CASE(the_last_valid_pose_is_at_the_zones_border_wherever_the_part_has_its_origin) {
    const Vector3 bodyInPart(0, 20000, 0);
    Scene scene{Model::build(translated(box({3, 2, 1}, 2), bodyInPart)),
                Model::build(translated(box({9, 9, 1}, 3), {0, 0, -2}))};
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), -bodyInPart}, 2};
    const PartInSpace space(scene, 1e5);
    const Matrix3 turn = Eigen::AngleAxisd(0.02, Vector3::UnitZ()).toRotationMatrix();
    const auto s1 = space.at(-bodyInPart), s2 = space.at(Vector3(3, 0, 0) - turn * bodyInPart, 0.02);
    ob::ScopedState<> reached(space.space);
    std::pair<ob::State*, double> lastValid(reached.get(), 1);
    BOOST_TEST(!space.validator->checkMotion(s1.get(), s2.get(), lastValid));
    const double moved =
        scene.part.displacement(scene.startContact->X_environmentPart, space.checker->pose(reached.get()));
    BOOST_TEST(moved <= 2);
    BOOST_TEST(moved >= 2 - 10 * space.validator->leastInterval());
}

BOOST_AUTO_TEST_CASE(a_motion_of_less_than_a_least_interval_at_a_zones_border_is_soon_reported) {
    Assembly assembly;
    const PartInSpace space(assembly.scene);
    const double near = kStartLength * (1 - 1e-6);  // too close to the border to be sure
    const auto s1 = space.at({near, 0, 5}), s2 = space.at({near - 1e-7, 0, 5});
    takeQueryTally();
    BOOST_TEST((space.validator->report(s1.get(), s2.get()).verdict == MotionVerdict::kUndecided));
    BOOST_TEST(takeQueryTally().work.triangleTests < 100000u);
}

// The part is far from its own origin: a turn that OMPL leaves out until the end brings it from 9 to 1 from the block.
BOOST_AUTO_TEST_CASE(the_clearance_at_the_end_counts_wherever_the_interpolation_ends) {
    const Vector3 bodyInPart(0, 1e5, 0);
    Scene scene{Model::build(translated(box({1, 1, 1}), bodyInPart)), Model::build(box({10, 20, 10}))};
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), {0, 0, 100}}, 1};
    const PartInSpace space(scene, 2e5);
    const planning::MotionValidator byClearance(
        space.si, planning::SharedScene(scene, planning::stateToPose(*space.space),
                                        planning::displacementBound(*space.space, scene.part)));
    const auto s1 = space.at(Vector3(20, 15, 0) - bodyInPart),
               s2 = space.at(Vector3(20, 0, 0) - bodyInPart, 8e-5);
    const planning::MotionValidator* const validators[] = {space.validator.get(), &byClearance};
    for (const planning::MotionValidator* validator : validators) {
        const MotionReport report = validator->report(s1.get(), s2.get());
        BOOST_TEST((report.verdict == MotionVerdict::kValid));
        BOOST_TEST(report.upperClearance == 1, boost::test_tools::tolerance(1e-3));
        BOOST_TEST(report.lowerClearance <= report.upperClearance);
        BOOST_TEST(report.lowerClearance >= 0.9);
    }
}

// The same turn puts the part onto a plate that is ignored there; the interpolation ends beside the plate.
BOOST_AUTO_TEST_CASE(a_zone_that_only_the_end_itself_is_in_leaves_the_motion_valid) {
    const Vector3 bodyInPart(0, 1e5, 0);
    Scene scene{Model::build(translated(box({1, 1, 1}), bodyInPart)),
                Model::build(translated(box({4, 4, 1}), {0, 0, -2}))};
    scene.obstacles[0].isIgnoredAtGoal = true;
    const PartInSpace anywhere(Scene(scene.part), 2e5);
    const auto s1 = anywhere.at(Vector3(8, 12, 0) - bodyInPart);
    const auto s2 = anywhere.at(Vector3(8, 0, 0) - bodyInPart, 8e-5);
    scene.goalContact = ContactZone{anywhere.checker->pose(s2.get()), 2};
    const PartInSpace space(scene, 2e5);
    const planning::MotionValidator byClearance(
        space.si, planning::SharedScene(scene, planning::stateToPose(*space.space),
                                        planning::displacementBound(*space.space, scene.part)));
    const planning::MotionValidator* const validators[] = {space.validator.get(), &byClearance};
    for (const planning::MotionValidator* validator : validators) {
        std::pair<ob::State*, double> lastValid(nullptr, 1);
        BOOST_TEST(validator->checkMotion(s1.get(), s2.get()));
        BOOST_TEST(validator->checkMotion(s1.get(), s2.get(), lastValid));
    }
}

BOOST_AUTO_TEST_CASE(in_the_plane_zones_count_too) {
    Assembly assembly;
    assembly.obstacles.clear();
    Scene scene(assembly.scene.part);
    scene.obstacles.push_back({Model::build(translated(box({10, 10, 10}), {40, 0, 0})), 1});
    scene.obstacles[0].isIgnoredAtGoal = true;
    scene.goalContact = ContactZone{{Matrix3::Identity(), {0, 0, 0}}, 2};  // the part's end touches the block
    const PartInSpace space(scene, 1000, Space::kSe2);
    BOOST_TEST(space.check({-50, 0, 0}, {-10, 0, 0}));
    BOOST_TEST(space.check({-50, 0, 0}, {-0.5, 0.3, 0}));
    BOOST_TEST(space.check({-0.5, 0, 0}, {-50, 20, 0}));
    BOOST_TEST(!space.check({0, 0, 0}, {0, 30, 0}));  // along the block, beyond the zone
    BOOST_TEST(!space.isValid({0, 2.01, 0}));
    BOOST_TEST(space.isValid({0, 1.99, 0}));
}

BOOST_AUTO_TEST_CASE(zones_that_are_none_are_refused) {
    for (const double length : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Assembly wrong;
        wrong.scene.startContact->distance = length;
        requireRefusedBy([&] { PartInSpace{wrong.scene}; }, {"startContact.distance is "});
    }
    Assembly missing;
    missing.scene.goalContact.reset();
    requireRefusedBy([&] { PartInSpace{missing.scene}; }, {"goalContact, which is not set"});
    Assembly turned;
    turned.scene.goalContact->X_environmentPart.rotation *= 2;
    BOOST_CHECK_THROW(PartInSpace{turned.scene}, std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
