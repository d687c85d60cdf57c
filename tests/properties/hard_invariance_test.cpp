// Changes that must not change an answer, and changes that may move it in one direction only, checked in
// exact arithmetic on the hard pairs of triangles.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/each_target.h"
#include "support/exact_check.h"
#include "support/hard_triangles.h"

BOOST_AUTO_TEST_SUITE(hard_invariance_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 139;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Some draws of every family whose sizes a query accepts, as drawn and at a pose; made once.
const std::vector<ExactCase>& cases() {
    static const std::vector<ExactCase> made = [] {
        std::vector<ExactCase> result;
        Random random(kSeed);
        for (const TriangleFamily& family : hardTriangleFamilies()) {
            if (family.name == "denormals") continue;
            for (int draw = 0; draw < 20; ++draw) {
                const TrianglePair pair = family.make(random);
                const Pose pose = draw % 2 == 1 ? poseFor(random, pair) : Pose{};
                const std::string name =
                    family.name + ", seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw);
                result.push_back(exactCase(name, meshOf(pair.a), meshOf(pair.b), pose));
            }
        }
        return result;
    }();
    return made;
}

/// Denormal coordinates lose digits when they are scaled down.
bool isScalable(const ExactCase& exact) {
    for (const Mesh* mesh : {&exact.part, &exact.environment}) {
        for (const Vector3& vertex : mesh->vertices) {
            for (const double x : vertex) {
                if (x != 0 && std::abs(x) < 1e-200) return false;
            }
        }
    }
    return true;
}

DistanceResult distanceOf(const ModelPair& models, const Pose& pose, const DistanceOptions& options = {}) {
    Workspace workspace;
    return distance(models.part, models.environment, pose, options, workspace);
}

bool isWithinOf(const ModelPair& models, const Pose& pose, double d) {
    Workspace workspace;
    return isWithin(models.part, models.environment, pose, d, workspace);
}

BOOST_AUTO_TEST_CASE(exchanging_part_and_environment_keeps_distance_and_verdicts) {
    for (const ExactCase& exact : cases()) {
        if (exact.pose.translation != Vector3::Zero()) continue;  // the inverse of a pose is rounded
        const ExactCase exchanged = exactCase(exact.name, exact.environment, exact.part, exact.pose);
        BOOST_TEST(exchanged.truth.compare(exact.truth) == 0, exact.name);
        Workspace workspace;
        checkExactly(exchanged, buildPair(exchanged, BuildOptions{}), workspace);
    }
}

BOOST_AUTO_TEST_CASE(moving_both_keeps_the_distance_but_for_the_rounding_of_their_corners) {
    Random random(kSeed);
    for (const ExactCase& exact : cases()) {
        const Pose motion = random.pose(exact.sceneSize);
        ExactCase moved =
            exactCase(exact.name, exact.part, transformed(exact.environment, motion), motion * exact.pose);
        const double M = std::max(exact.largestCoordinate, moved.largestCoordinate);
        const double before = static_cast<double>(exact.truth.rounded()),
                     after = static_cast<double>(moved.truth.rounded());
        BOOST_TEST(std::abs(after - before) <= 64 * kUnitRoundoff * M, exact.name);
        Workspace workspace;
        checkExactly(moved, buildPair(moved, BuildOptions{}), workspace);
    }
}

BOOST_DATA_TEST_CASE(scaling_by_a_power_of_two_scales_every_answer_exactly, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const ExactCase& exact : cases()) {
        if (!isScalable(exact)) continue;
        const ModelPair models = buildPair(exact, BuildOptions{});
        const DistanceResult before = distanceOf(models, exact.pose);
        const Enclosing around = enclosing(exact.truth);
        for (const int exponent : {-60, -20, 20, 60}) {
            const double factor = std::ldexp(1.0, exponent);
            const ModelPair scaled = {Model::build(scaledBy(exact.part, factor)),
                                      Model::build(scaledBy(exact.environment, factor))};
            const Pose pose{exact.pose.rotation, exact.pose.translation * factor};
            const DistanceResult after = distanceOf(scaled, pose);
            BOOST_TEST_CONTEXT(exact.name << " times 2^" << exponent) {
                BOOST_TEST(after.lower == before.lower * factor);
                BOOST_TEST(after.upper == before.upper * factor);
                BOOST_TEST(after.distance == before.distance * factor);
                BOOST_TEST(after.witness->pointOnPart == Vector3(before.witness->pointOnPart * factor));
                BOOST_TEST(after.witness->pointOnEnvironment ==
                           Vector3(before.witness->pointOnEnvironment * factor));
                BOOST_TEST(isWithinOf(scaled, pose, around.above * factor));
                if (around.below >= 0) BOOST_TEST(!isWithinOf(scaled, pose, around.below * factor));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(more_triangles_never_increase_the_distance) {
    for (std::size_t i = 0; i + 1 < cases().size(); ++i) {
        const ExactCase &exact = cases()[i], &other = cases()[i + 1];
        const double ratio = exact.sceneSize / other.sceneSize;
        if (!(ratio > 1e-12 && ratio < 1e12)) continue;
        const ModelPair models = buildPair(exact, BuildOptions{});
        const ModelPair more = {models.part, Model::build(joined(exact.environment, other.environment))};
        BOOST_TEST_CONTEXT(exact.name << ", and " << other.name) {
            BOOST_TEST(distanceOf(more, exact.pose).lower <= distanceOf(models, exact.pose).upper);
            BOOST_TEST(isWithinOf(more, exact.pose, enclosing(exact.truth).above));
            if (exact.truth.isZero()) BOOST_TEST(distanceOf(more, exact.pose).collides());
        }
    }
}

BOOST_AUTO_TEST_CASE(distance_changes_by_no_more_than_the_part_moves) {
    Random random(kSeed);
    for (const ExactCase& exact : cases()) {
        const ModelPair models = buildPair(exact, BuildOptions{});
        for (const double share : {1e-12, 1e-6, 0.1}) {
            const Pose step{Eigen::AngleAxisd(share, random.direction()).toRotationMatrix(),
                            share * exact.sceneSize * random.direction()};
            const Pose next = exact.pose * step;
            double moved = 0;
            for (const Vector3& vertex : exact.part.vertices) {
                moved = std::max(moved, (next * vertex - exact.pose * vertex).stableNorm());
            }
            moved += 16 * kUnitRoundoff * exact.largestCoordinate;  // rounding of the two places
            const DistanceResult before = distanceOf(models, exact.pose), after = distanceOf(models, next);
            BOOST_TEST_CONTEXT(exact.name << ", moved by " << moved) {
                BOOST_TEST(after.lower <= before.upper + moved);
                BOOST_TEST(before.lower <= after.upper + moved);
                BOOST_TEST(isWithinOf(models, next, (before.upper + moved) * (1 + 1e-15)));
            }
        }
    }
}

BOOST_DATA_TEST_CASE(a_cap_is_told_only_where_the_distance_is_not_below, eachWidth(), width) {
    BuildOptions build;
    build.nodeWidth = width;
    for (const ExactCase& exact : cases()) {
        const ModelPair models = buildPair(exact, build);
        const Enclosing around = enclosing(exact.truth);
        for (const double cap : {0.0, 0.5 * around.above, around.below, around.above, 2 * around.above}) {
            if (cap < 0) continue;
            DistanceOptions options;
            options.cap = cap;
            const DistanceResult result = distanceOf(models, exact.pose, options);
            BOOST_TEST_CONTEXT(exact.name << ", cap " << cap << ", distance " << exact.truth.rounded()) {
                BOOST_TEST(exact.truth.compare(result.lower) >= 0);
                BOOST_TEST(exact.truth.compare(result.upper) <= 0);
                if (exact.truth.compare(cap) <= 0) {
                    BOOST_TEST(result.upper < kInfinity);
                } else if (result.upper == kInfinity) {
                    BOOST_TEST(result.lower >= cap);
                } else {  // the distance is within an interval's width of the cap
                    BOOST_TEST(result.lower < cap);
                }
            }
        }
    }
}

BOOST_DATA_TEST_CASE(a_million_away_the_interval_holds_the_distance_of_what_is_stored, eachTarget(), target) {
    // Meshes of a few metres, a million metres out, with coordinates rounded there. That rounding, in units
    // of M, makes up nearly all of the interval's width; the sizes add little.
    const UsingTarget using_(target);
    Random random(kSeed);
    for (int draw = 0; draw < 12; ++draw) {
        const Pose place{Matrix3::Identity(), 1e6 * random.direction()};
        const Mesh part = transformed(randomSoup(random, 12, 3, 2), place);
        const Mesh environment = transformed(randomSoup(random, 20, 6, 2), place);
        const Pose pose = draw % 2 == 0 ? Pose{Matrix3::Identity(), random.inBox(6)}
                                        : place * random.pose(6) * inverse(place);
        const ExactCase exact = exactCase("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw),
                                          part, environment, pose);
        Workspace workspace;
        const DistanceResult result = checkExactly(exact, buildPair(exact, BuildOptions{}), workspace);
        BOOST_TEST(result.upper - result.lower <= 32 * kUnitRoundoff * exact.largestCoordinate, exact.name);
    }
}

BOOST_AUTO_TEST_SUITE_END()
