// Motions between states, as OMPL interpolates them: certified only when every pose is free, whichever way OMPL may turn.
#include "scene/interpolated_motion.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "clearway/scene_clearance.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(interpolated_motion_test)

using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;

Model boxModel(const Vector3& least, const Vector3& most) {
    return Model::build(boxMesh({least, most}));
}

const Model kRod = boxModel({-3, -0.1, -0.1}, {3, 0.1, 0.1});

Rotation aboutZ(double angle) {
    return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

PartState turnedAboutZ(double angle) {
    return {Vector3::Zero(), aboutZ(angle)};
}

bool isCertified(const SceneClearance& scene, const PartState& from, const PartState& to) {
    return certifySe3Motion(scene, from, to) == SweepVerdict::kCertified;
}

BOOST_AUTO_TEST_CASE(a_thin_wall_between_two_free_states_is_found) {
    const SceneClearance room(
        Scene(boxModel({-1, -1, -1}, {1, 1, 1}), boxModel({5, -9, -9}, {5.0001, 9, 9})));
    const PartState start{{0, 0, 0}}, before{{3.9, 0, 0}}, behind{{9, 0, 0}}, within{{5, 0, 0}};
    BOOST_TEST((certifySe3Motion(room, start, behind) == SweepVerdict::kContact));
    BOOST_TEST((certifySe3Motion(room, start, within) == SweepVerdict::kContact));
    BOOST_TEST(isCertified(room, start, before));
    BOOST_TEST((certifySe3Motion(room, start, {{4, 0, 0}}) == SweepVerdict::kContact));
    BOOST_TEST((certifySe2Motion(room, {0, 0, 0}, {9, 0, 0}) == SweepVerdict::kContact));
    BOOST_TEST((certifySe2Motion(room, {0, 0, 0}, {3.5, 0, 0.1}) == SweepVerdict::kCertified));
}

BOOST_AUTO_TEST_CASE(a_motion_is_followed_up_to_a_wall) {
    const SceneClearance room(
        Scene(boxModel({-1, -1, -1}, {1, 1, 1}), boxModel({5, -9, -9}, {5.0001, 9, 9})));
    const PartState start{{0, 0, 0}}, within{{5, 0, 0}};
    for (const double end : {4.0, 5.0, 9.0}) {  // touches, is within, is behind
        const MotionAnswer spatial = followSe3Motion(room, start, {{end, 0, 0}});
        const MotionAnswer planar = followSe2Motion(room, {0, 0, 0}, {end, 0, 0});
        for (const MotionAnswer& answer : {spatial, planar}) {
            BOOST_TEST((answer.verdict == SweepVerdict::kContact));
            BOOST_TEST(answer.certifiedUntil < 4 / end);
            BOOST_TEST(answer.certifiedUntil > (4 - 1e-2) / end);
            BOOST_TEST(answer.contactTime.value() >= answer.certifiedUntil);
        }
    }
    BOOST_TEST(followSe3Motion(room, start, {{3.9, 0, 0}}).certifiedUntil == 1);
    BOOST_TEST(followSe3Motion(room, within, start).certifiedUntil == 0);
    BOOST_TEST(followSe3Motion(room, within, within).certifiedUntil == 0);
}

/// A post that one of the two ways from -x to +x meets.
BOOST_AUTO_TEST_CASE(the_turn_goes_the_shorter_way) {
    const SceneClearance post(Scene(kRod, boxModel({-0.1, 2, -1}, {0.1, 2.2, 1})));
    BOOST_TEST(isCertified(post, turnedAboutZ(-1.4), turnedAboutZ(1.4)));
    BOOST_TEST(isCertified(post, turnedAboutZ(1.4), {Vector3::Zero(), Rotation(-aboutZ(-1.4).coeffs())}));
    BOOST_TEST(!isCertified(post, turnedAboutZ(1.4), turnedAboutZ(1.8)));
    const auto inPlane = [&](double from, double to) {
        return certifySe2Motion(post, {0, 0, from}, {0, 0, to}) == SweepVerdict::kCertified;
    };
    BOOST_TEST(inPlane(-1.4, 1.4));
    BOOST_TEST(inPlane(3, -3));
    BOOST_TEST(!inPlane(1.4, 1.8));
}

/// Only the rounding of OMPL's product of the quaternions tells which.
BOOST_AUTO_TEST_CASE(of_two_turns_by_half_a_circle_both_must_be_free) {
    const Model arm = boxModel({0, -0.1, -0.1}, {3, 0.1, 0.1});
    const SceneClearance post(Scene(arm, boxModel({-0.1, 2, -1}, {0.1, 2.2, 1})));
    const PartState start = turnedAboutZ(0.7), end = turnedAboutZ(0.7 + M_PI);
    BOOST_TEST(!isCertified(post, start, end));
    BOOST_TEST(!isCertified(post, start, {Vector3::Zero(), Rotation(-end.rotation.coeffs())}));
    BOOST_TEST(isCertified(post, turnedAboutZ(0), turnedAboutZ(-M_PI + 1e-3)));
}

BOOST_AUTO_TEST_CASE(a_turn_that_ompl_leaves_out_may_happen_or_not) {
    const PartState start = turnedAboutZ(0),
                    end = turnedAboutZ(5e-5);  // the turn moves the rod's end by 1.5e-4
    const auto wallAt = [](double y) { return Scene(kRod, boxModel({2, y, -1}, {2.5, y + 1, 1})); };
    BOOST_TEST(isCertified(SceneClearance(wallAt(0.101)), start, end));
    BOOST_TEST(!isCertified(SceneClearance(wallAt(0.1001)), start, end));
    BOOST_TEST(!isCertified(SceneClearance(wallAt(0.1001)), end, start));
}

BOOST_AUTO_TEST_CASE(quaternions_must_have_unit_length) {
    const SceneClearance room{Scene(kRod)};
    const PartState fine{{0, 0, 0}}, longer{{0, 0, 0}, {1 + 2e-9, 0, 0, 0}};
    testing::requireRefusedBy([&] { certifySe3Motion(room, fine, longer); },
                              {"the quaternion of the second state has length 1.0"});
    BOOST_TEST(isCertified(room, fine, {{0, 0, 0}, {1 + 5e-10, 0, 0, 0}}));
    const PartExtent reach(kRod);
    BOOST_TEST(std::isnan(se3Motion(reach, fine, longer, false).length));
    BOOST_TEST(std::isnan(se3Displacement(fine, longer, 3, [](const Vector3&) { return 3; })));
}

/// The pieces hold the points of the part within their deviation, and no point moves further than the two lengths.
BOOST_AUTO_TEST_CASE(pieces_and_lengths_hold_the_points_of_the_part) {
    const Model arm = boxModel({-0.5, -0.1, -0.2}, {3, 0.3, 0.1});
    const PartExtent reach(arm);
    for (int seed = 1; seed <= 200; ++seed) {
        testing::Random random(seed);
        const Rotation first(random.rotation()), second(random.rotation());
        const PartState from{random.direction() * 3, first}, to{random.direction() * 3, second};
        const bool other = first.dot(second) < 0;
        const SteadyMotion motion = se3Motion(reach, from, to, other);
        const double tight = se3Displacement(from, to, arm.radiusAboutOrigin(),
                                             [&](const Vector3& axis) { return arm.radiusAboutAxis(axis); });
        BOOST_TEST(tight <= motion.length * (1 + 1e-6));
        const auto poseAt = [&](double time) {
            return toPose(Eigen::Quaterniond(first.slerp(time, second).coeffs()),
                          from.position + time * (to.position - from.position));
        };
        const double middle = random.uniform(0.2, 0.8), half = random.uniform(0, 0.2);
        const MotionPiece piece = motion.around(poseAt(middle), half);
        for (int i = 0; i < 8; ++i) {
            const Vector3 point = arm.box().corner(static_cast<Box::CornerType>(i));
            const Vector3 turned = piece.middle.rotation * point;
            const Vector3 straight =
                piece.middle * point + half * (piece.velocity + piece.angularVelocity.cross(turned));
            const Vector3 there = poseAt(middle + half) * point;
            BOOST_TEST((there - straight).norm() <= piece.deviation + piece.deviationAcrossRotation + 1e-12);
            BOOST_TEST((poseAt(1) * point - poseAt(0) * point).norm() <= tight + 1e-12);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
