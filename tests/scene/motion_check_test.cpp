// Rigid motions among a scene's obstacles: certified only when every pose is free.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "clearway/scene_clearance.h"

BOOST_AUTO_TEST_SUITE(motion_check_test)

using namespace clearway;

Mesh box(const Vector3& least, const Vector3& most) {
    return boxMesh({least, most});
}

Model boxModel(const Vector3& least, const Vector3& most) {
    return Model::build(box(least, most));
}

Pose at(double x, double y, double z) {
    return {Matrix3::Identity(), Vector3(x, y, z)};
}

Pose turned(double angle, const Vector3& axis) {
    return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), Vector3::Zero()};
}

const Model kCube = boxModel({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});

BOOST_AUTO_TEST_CASE(a_thin_wall_between_two_free_poses_is_found) {
    const SceneClearance room(Scene(kCube, boxModel({5, -9, -9}, {5.0001, 9, 9}), 0.25));
    const MotionAnswer through = room.check(motionBetween(at(0, 0, 0), at(10, 0, 0)));
    BOOST_TEST((through.verdict == SweepVerdict::kContact));
    BOOST_TEST(std::abs(through.certifiedUntil - 0.425) < 1e-4);
    BOOST_TEST(through.certifiedUntil < 0.425);
    BOOST_TEST(through.contactTime.value() >= 0.425);
    const MotionAnswer before = room.check(motionBetween(at(0, 0, 0), at(4.2, 0, 0)));
    BOOST_TEST((before.verdict == SweepVerdict::kCertified));
    BOOST_TEST(before.certifiedUntil == 1);
    BOOST_TEST(
        (room.check(motionBetween(at(0, 0, 0), at(4.2, 0, 0)), 0.06).verdict != SweepVerdict::kCertified));
    BOOST_TEST((room.check(motionBetween(at(5, 0, 0), at(0, 0, 0))).contactTime == 0));
}

BOOST_AUTO_TEST_CASE(a_turn_that_meets_a_post_half_way_is_found) {
    const Model rod = boxModel({-3, -0.1, -0.1}, {3, 0.1, 0.1});
    const Vector3 up = Vector3::UnitZ();
    const RigidMotion quarter = motionBetween(turned(0, up), turned(1.5, up));
    BOOST_TEST((quarter.rotation - 1.5 * up).norm() < 1e-14);
    const double corner = 2 / std::sqrt(2.0);
    const SceneClearance met(Scene(rod, boxModel({corner, corner, -1}, {corner + 0.01, corner + 0.01, 1})));
    BOOST_TEST(met.isFree(turned(0, up)));
    BOOST_TEST(met.isFree(turned(1.5, up)));
    BOOST_TEST((met.check(quarter).verdict == SweepVerdict::kContact));
    const SceneClearance missed(Scene(rod, boxModel({2.2, 2.2, -1}, {2.3, 2.3, 1})));
    BOOST_TEST((missed.check(quarter).verdict == SweepVerdict::kCertified));
}

BOOST_AUTO_TEST_CASE(the_motion_between_two_poses_ends_at_the_second) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> entry(-1, 1);
    for (int draw = 0; draw < 200; ++draw) {
        const auto pose = [&] {
            return toPose(Eigen::Quaterniond(entry(random), entry(random), entry(random), entry(random)),
                          Vector3(entry(random), entry(random), entry(random)));
        };
        const Pose from = pose(), to = pose();
        const RigidMotion motion = motionBetween(from, to);
        BOOST_TEST(motion.rotation.norm() <= 3.1416);
        const Pose end = piecesOf(motion, kCube)(1, 1).middle;
        BOOST_TEST((end.rotation - to.rotation).norm() < 1e-14);
        BOOST_TEST((end.translation - to.translation).norm() < 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(a_part_of_one_point_and_a_motion_that_rests_are_answered) {
    Mesh point;
    point.vertices = {{0, 0, 0}};
    point.triangles = {{0, 0, 0}};
    const SceneClearance room(Scene(Model::build(point), boxModel({1, -1, -1}, {2, 1, 1})));
    const RigidMotion rest = motionBetween(at(0, 0, 0), at(0, 0, 0));
    BOOST_TEST((room.check(rest).verdict == SweepVerdict::kCertified));
    // A point passes a surface at one time of its motion, which no double need be: it is undecided there.
    const MotionAnswer through = room.check(motionBetween(at(0, 0, 0), at(3, 0, 0)));
    BOOST_TEST((through.verdict != SweepVerdict::kCertified));
    BOOST_TEST(through.certifiedUntil <= 1 / 3.0);
    BOOST_TEST(through.certifiedUntil > 0.333);
    for (const double poseError : {-1.0, -1e-30, std::nan("")}) {
        BOOST_CHECK_THROW(room.check(rest, poseError), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(inside_a_solid_no_motion_is_free) {
    const Mesh part = box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), block = box({-5, -5, -5}, {5, 5, 5});
    Scene scene(kCube, Model::build(block));
    scene.obstacles[0].solids = makeSolids(block).solids;
    scene.partSolids = makeSolids(part).solids;
    const RigidMotion within = motionBetween(at(0, 0, 0), at(1, 0, 0));
    BOOST_TEST((SceneClearance(scene).check(within).verdict == SweepVerdict::kContact));
    const RigidMotion beside = motionBetween(at(0, 7, 0), at(1, 7, 0));
    BOOST_TEST((SceneClearance(scene).check(beside).verdict == SweepVerdict::kCertified));
    scene.obstacles[0].solids = nullptr;
    BOOST_TEST((SceneClearance(scene).check(within).verdict == SweepVerdict::kCertified));
}

/// The part is far from its origin. In the middle of its turn it stands still, but the arc leads it out of the zone and through the plate.
BOOST_AUTO_TEST_CASE(an_arc_that_leads_out_of_a_contact_zone_is_followed) {
    Scene scene(boxModel({-0.1, 99.9, -0.1}, {0.1, 100.1, 0.1}), boxModel({-1, 98.9, -1}, {1, 99, 1}));
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{at(0, 0, 0), 0.5};
    const double angle = 0.2, aside = 100 * std::sin(angle);
    const Pose from{turned(-angle, Vector3::UnitZ()).rotation, {-aside, 0, 0}},
        to{turned(angle, Vector3::UnitZ()).rotation, {aside, 0, 0}};
    BOOST_TEST(SceneClearance(scene).isFree(from));
    BOOST_TEST((SceneClearance(scene).check(motionBetween(from, to)).verdict == SweepVerdict::kContact));
}

/// The cube slides along the floor, closer than poses are known, and then meets the block.
BOOST_AUTO_TEST_CASE(a_collision_behind_a_stretch_that_is_too_close_to_tell_is_found) {
    const double apart = 1e-7, poseError = 1e-6;
    Scene scene(kCube, boxModel({-20, -20, -2}, {20, 20, -0.5 - apart}));
    scene.obstacles.push_back({boxModel({4, -1, -0.4}, {5, 1, 0.4})});
    const SceneClearance room(scene);
    BOOST_TEST(
        (room.check(motionBetween(at(0, 0, 0), at(3, 0, 0)), poseError).verdict == SweepVerdict::kUndecided));
    const MotionAnswer atEnd = room.check(motionBetween(at(0, 0, 0), at(4, 0, 0)), poseError);
    BOOST_TEST((atEnd.verdict == SweepVerdict::kContact));
    BOOST_TEST(!room.isFree(at(4 * atEnd.contactTime.value(), 0, 0)));
    const MotionAnswer onTheWay = room.check(motionBetween(at(0, 0, 0), at(9, 0, 0)), poseError);
    BOOST_TEST((onTheWay.verdict == SweepVerdict::kContact));
    BOOST_TEST(!room.isFree(at(9 * onTheWay.contactTime.value(), 0, 0)));
    BOOST_TEST(onTheWay.certifiedUntil == 0);
}

BOOST_AUTO_TEST_SUITE_END()
