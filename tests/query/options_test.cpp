// Caps and tolerances, and the arguments that are refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/each_target.h"
#include "support/query_cases.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(options_test)

using namespace clearway;
using namespace clearway::testing;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

BOOST_DATA_TEST_CASE(beyond_the_cap_only_the_cap_is_known, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase, ofWidth(width));
        Workspace workspace;
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Pose& pose = queryCase.poses[i];
            const double truth = queryCase.answers[i].distance;
            DistanceOptions options;
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                for (const double share : {0.0, 0.1, 0.5, 0.999}) {
                    options.cap = share * truth;
                    if (truth < 1e-6 * queryCase.oracle->sceneSize()) break;
                    const DistanceResult result =
                        distance(models.part, models.environment, pose, options, workspace);
                    BOOST_TEST(result.lower >= *options.cap);
                    BOOST_TEST(result.lower <= truth);
                    BOOST_TEST(result.upper == kInfinity);
                    BOOST_TEST(result.distance == kInfinity);
                    BOOST_TEST(!result.collides());
                    BOOST_TEST(!result.witness);
                }
                for (const double cap : {truth * 1.001 + 1e-9, truth * 2 + 1, 1e300}) {
                    options.cap = cap;
                    const DistanceResult result =
                        distance(models.part, models.environment, pose, options, workspace);
                    checkDistance(result, queryCase, pose, queryCase.answers[i]);
                }
            }
        }
    }
}

BOOST_DATA_TEST_CASE(tolerances_widen_the_interval_no_further_than_asked, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase, ofWidth(width));
        const double size = queryCase.oracle->sceneSize();
        Workspace workspace;
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            for (const double relative : {0.0, 1e-3, 0.05, 1.0}) {
                for (const double absolute : {0.0, 1e-4, 0.02}) {
                    DistanceOptions options;
                    options.relativeError = relative;
                    options.absoluteError = absolute * size;
                    workspace.forgetWarmStart();
                    const DistanceResult result =
                        distance(models.part, models.environment, queryCase.poses[i], options, workspace);
                    const double width_ = std::max({widestDefault(queryCase, queryCase.poses[i]),
                                                    absolute * size, relative * result.lower});
                    BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i << ", " << relative << ", "
                                                      << absolute) {
                        checkDistance(result, queryCase, queryCase.poses[i], queryCase.answers[i], width_);
                        BOOST_TEST(result.collides() ==
                                   collides(models.part, models.environment, queryCase.poses[i], workspace));
                    }
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_wider_tolerance_saves_work) {
    std::uint64_t tight = 0, loose = 0;
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase);
        for (const Pose& pose : queryCase.poses) {
            Workspace workspace;
            DistanceOptions options;
            tight += distance(models.part, models.environment, pose, options, workspace).counters.volumeTests;
            workspace.forgetWarmStart();
            options.relativeError = 0.5;
            loose += distance(models.part, models.environment, pose, options, workspace).counters.volumeTests;
        }
    }
    BOOST_TEST(loose < tight);
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused_by_name) {
    const QueryCase& queryCase = queryCases()[3];
    const ModelPair models = buildPair(queryCase);
    Workspace workspace;
    const auto ask = [&](double relative, double absolute, double cap) {
        DistanceOptions options;
        options.relativeError = relative;
        options.absoluteError = absolute;
        options.cap = cap;
        return [&, options] {
            distance(models.part, models.environment, queryCase.poses[0], options, workspace);
        };
    };
    requireRefusedBy(ask(-0.25, 0, 1), {"relativeError", "-0.25"});
    requireRefusedBy(ask(kNaN, 0, 1), {"relativeError", "nan"});
    requireRefusedBy(ask(0, -0.25, 1), {"absoluteError", "-0.25"});
    requireRefusedBy(ask(0, kNaN, 1), {"absoluteError", "nan"});
    requireRefusedBy(ask(0, 0, -0.25), {"cap", "-0.25"});
    requireRefusedBy(ask(0, 0, kNaN), {"cap", "nan"});
    for (const double d : {-0.25, -kInfinity, kNaN}) {
        requireRefusedBy([&] { isWithin(models.part, models.environment, queryCase.poses[0], d, workspace); },
                         {std::isnan(d) ? "nan"
                          : d < -1      ? "-inf"
                                        : "-0.25",
                          "expected"});
    }
}

/// Checks that distance, collides and isWithin refuse the models at the pose with all the words.
void requireEachRefuses(const Model& part, const Model& environment, const Pose& pose,
                        const std::vector<std::string>& words) {
    Workspace workspace;
    requireRefusedBy([&] { distance(part, environment, pose, {}, workspace); }, words);
    requireRefusedBy([&] { collides(part, environment, pose, workspace); }, words);
    requireRefusedBy([&] { isWithin(part, environment, pose, 1, workspace); }, words);
}

BOOST_AUTO_TEST_CASE(what_is_no_rotation_is_refused_by_every_query) {
    const ModelPair models = buildPair(queryCases()[3]);
    Pose larger, mirrored, notANumber, farAway;
    larger.rotation *= 1 + 1e-9;
    mirrored.rotation(2, 2) = -1;
    notANumber.rotation(0, 1) = kNaN;
    farAway.translation.x() = kInfinity;
    for (const Pose& pose : {larger, mirrored, notANumber, farAway})
        requireEachRefuses(models.part, models.environment, pose, {"rotation", "expected"});
}

BOOST_DATA_TEST_CASE(sizes_too_far_apart_are_refused_by_every_query, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    Random random(41);
    const Mesh mesh = randomSoup(random, 5, 1, 1);
    for (const int exponent : {-1020, -80, -40, 40, 80, 900}) {
        const QueryCase queryCase =
            makeCase("sizes, seed 41", scaledBy(mesh, std::ldexp(1.0, exponent)), mesh, {Pose{}});
        const auto [part, environment] = buildPair(queryCase, ofWidth(width));
        Workspace workspace;
        BOOST_TEST_CONTEXT("part 2^" << exponent << " times as large") {
            if (std::abs(exponent) < 60) {
                checkDistance(distance(part, environment, Pose{}, {}, workspace), queryCase, Pose{},
                              queryCase.answers[0]);
                continue;
            }
            requireEachRefuses(part, environment, Pose{}, {"the sizes", "expected 2^-60 to 2^60"});
        }
    }
}

BOOST_AUTO_TEST_CASE(a_way_too_long_for_the_sizes_is_refused_by_every_query) {
    const QueryCase& queryCase = queryCases()[3];
    const Model part = Model::build(scaledBy(queryCase.part, 0x1p-20));
    const Model environment = Model::build(scaledBy(queryCase.environment, 0x1p-20));
    for (const double away : {1e20, 1e160, 9e297, 1e300, -1.7e308}) {
        const std::string what =
            std::abs(away) < 1e298 ? "the way between part and environment" : "the largest coordinate";
        requireEachRefuses(part, environment, {Matrix3::Identity(), {0, away, away}}, {what, "expected"});
    }
}

BOOST_DATA_TEST_CASE(a_pose_with_an_accepted_defect_counts_as_the_affine_map_it_is,
                     eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : queryCases()) {
        std::vector<Pose> poses = queryCase.poses;
        for (Pose& pose : poses) pose.rotation *= 1 + 4e-13;
        const QueryCase defective =
            makeCase(queryCase.name + " with a defect", queryCase.part, queryCase.environment, poses);
        const ModelPair models = buildPair(defective, ofWidth(width));
        Workspace workspace;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            BOOST_TEST_CONTEXT(defective.name << ", pose " << i) {
                checkDistance(distance(models.part, models.environment, poses[i], {}, workspace), defective,
                              poses[i], defective.answers[i]);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(models_of_different_node_widths_are_refused) {
    const QueryCase& queryCase = queryCases()[3];
    const Model part = Model::build(queryCase.part, ofWidth(2));
    const Model environment = Model::build(queryCase.environment, ofWidth(8));
    requireEachRefuses(part, environment, queryCase.poses[0], {"nodeWidth", "2", "8"});
}

BOOST_AUTO_TEST_CASE(a_workspace_serves_again_after_a_refusal) {
    const QueryCase& queryCase = queryCases()[3];
    const ModelPair models = buildPair(queryCase);
    Workspace workspace;
    distance(models.part, models.environment, queryCase.poses[0], {}, workspace);
    BOOST_CHECK_THROW(isWithin(models.part, models.environment, queryCase.poses[0], -1, workspace),
                      std::invalid_argument);
    checkDistance(distance(models.part, models.environment, queryCase.poses[1], {}, workspace), queryCase,
                  queryCase.poses[1], queryCase.answers[1]);
}

BOOST_AUTO_TEST_CASE(coordinates_that_would_overflow_are_refused_by_name) {
    const Model part = Model::build(box({1, 1, 1})), far = Model::build(scaledBy(box({1, 1, 1}), 0x1p993));
    Workspace workspace;
    const Pose away{Matrix3::Identity(), {0, 1e300, 0}};
    requireRefusedBy([&] { collides(far, far, Pose{}, workspace); }, {"largest coordinate"});
    requireRefusedBy([&] { distance(part, part, away, {}, workspace); }, {"largest coordinate"});
    const Model large = Model::build(scaledBy(box({1, 1, 1}), 0x1p980));
    BOOST_TEST(distance(large, large, Pose{}, {}, workspace).witness->pointOnPart.allFinite());
}

BOOST_AUTO_TEST_SUITE_END()
