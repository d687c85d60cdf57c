// Swept volumes against dense poses, both ways.
#include "clearway/swept_volume.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "clearway/model.h"
#include "mesh/topology.h"
#include "model/solids.h"
#include "support/full_run.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(swept_volume_test)

/// The pose at a time, by the definition of RigidMotion.
Pose poseAt(const RigidMotion& motion, double t) {
    const double angle = t * motion.rotation.norm();
    Pose pose = motion.start;
    if (angle > 0) {
        pose.rotation =
            motion.start.rotation * Eigen::AngleAxisd(angle, motion.rotation.normalized()).toRotationMatrix();
    }
    pose.translation += t * motion.translation;
    return pose;
}

Vector3 pointOn(Random& random, const Mesh& mesh) {
    const auto& [a, b, c] = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return (1 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c];
}

double distanceTo(const Model& part, const Pose& X_environmentPart, const Vector3& point) {
    Mesh one;
    one.vertices = {point};
    one.triangles = {{0, 0, 0}};
    Workspace workspace;
    return distance(part, Model::build(one), X_environmentPart, {}, workspace).distance;
}

void checkSwept(const Mesh& part, const std::vector<RigidMotion>& motions, double fineTolerance) {
    const double tolerance = (isFullRun() ? 1 : 3) * fineTolerance;
    SweptVolumeOptions options;
    options.tolerance = tolerance;
    const Mesh swept = sweptVolume(part, motions, options);
    const EdgeReport edges = checkEdges(swept.triangles);
    BOOST_TEST(edges.isClosed());
    BOOST_TEST(edges.overfullEdges == 0u);
    const Solid solid(swept, "swept");
    BOOST_TEST(!solid.isTurnedOver());
    Random random(5);
    const int draws = isFullRun() ? 3000 : 300;
    for (int n = 0; n < draws; ++n) {
        const RigidMotion& motion = motions[std::size_t(random.below(int(motions.size())))];
        const Vector3 point = poseAt(motion, random.uniform(0, 1)) * pointOn(random, part);
        BOOST_REQUIRE_MESSAGE(solid.winding({}, {}, point) > 0, point.transpose());
    }
    // Dense poses: between two of them no point of the part moves further than this.
    constexpr int kPoses = 400;
    const Model model = Model::build(part);
    const double radius = model.radiusAboutOrigin();
    for (int n = 0; n < draws / 10; ++n) {
        const Vector3 point = pointOn(random, swept);
        double least = std::numeric_limits<double>::infinity();
        for (const RigidMotion& motion : motions) {
            const double step = (motion.translation.norm() + radius * motion.rotation.norm()) / kPoses;
            for (int i = 0; i <= kPoses; ++i) {
                const double found = distanceTo(model, poseAt(motion, double(i) / kPoses), point);
                BOOST_REQUIRE_GT(found, 0);
                least = std::min(least, found - step);
            }
        }
        BOOST_REQUIRE_MESSAGE(least <= tolerance, least << " at " << point.transpose());
    }
}

BOOST_AUTO_TEST_CASE(a_swept_volume_holds_all_places_and_little_else) {
    const Pose start{Matrix3::Identity(), {1, 2, 3}};
    checkSwept(box({1, 0.5, 0.25}), {{start, {3, 0, 0}, {0, 0, 0}}}, 0.2);
    checkSwept(translated(box({1, 0.5, 0.25}), {2, 0, 0}), {{start, {0, 0, 0}, {0, 0, 2}}}, 0.2);
    Random random(3);
    const Pose turned{random.rotation(), {-2, 0, 1}};
    const RigidMotion first{turned, {1, 2, 0}, {0.3, -1, 2}};
    checkSwept(torus(1, 0.3, 8), {first, {poseAt(first, 1), {0, 0, 2}, {0, 1, 0}}}, 0.15);
    checkSwept(sphere(1, 6), {{start, {0, 0, 0}, {0, 0, 0}}}, 0.3);  // it stands still
}

BOOST_AUTO_TEST_CASE(open_parts_sweep_a_layer_around_their_surface) {
    Mesh sheet = box({1, 1, 0.2});
    sheet.triangles.resize(10);
    checkSwept(sheet, {{{}, {1, 0, 0}, {0, 0, 0.5}}}, 0.2);
}

/// A triangle that cuts a corner of the hole may be near the part at one of its own corners and too far from it elsewhere.
BOOST_AUTO_TEST_CASE(all_of_a_surface_in_a_narrow_hole_is_near_the_part) {
    Mesh part;
    for (const double side : {-1.0, 1.0}) {
        part = joined(part, translated(box({0.8, 2.5, 3}), {side * 1.7, 0, 0}));
        part = joined(part, translated(box({0.9, 0.8, 3}), {0, side * 1.7, 0}));
    }
    Random random(2);
    const Pose place{random.rotation(), {0, 0, 0}};
    SweptVolumeOptions options;
    options.tolerance = 0.5;
    const Mesh swept = sweptVolume(part, {{place, {0, 0, 0}, {0, 0, 0}}}, options);
    const Model model = Model::build(part);
    double most = 0;
    for (const auto& [a, b, c] : swept.triangles) {
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
            if (from > to) continue;
            const Vector3 middle = 0.5 * (swept.vertices[from] + swept.vertices[to]);
            most = std::max(most, distanceTo(model, place, middle));
        }
    }
    BOOST_TEST(most <= options.tolerance);
}

BOOST_AUTO_TEST_CASE(only_rooms_that_the_part_never_enters_are_cavities) {
    SweptVolumeOptions options;
    options.tolerance = isFullRun() ? 0.2 : 0.5;
    const std::vector<RigidMotion> stays = {{{}, {0, 0, 0}, {0, 0, 0}}};
    const auto shellsOf = [&](const Mesh& part) {
        return findShells(sweptVolume(part, stays, options).triangles).count;
    };
    const Mesh block = box({2, 2, 2});
    Mesh hole = box({1, 1, 1});
    for (TriangleIndices& t : hole.triangles) std::swap(t[1], t[2]);
    BOOST_TEST(shellsOf(block) == 1u);
    BOOST_TEST(shellsOf(joined(block, hole)) == 2u);
    const Pose aside{Matrix3::Identity(), {10, 0, 0}};
    const std::vector<RigidMotion> twoPlaces = {stays[0], {aside, {0, 0, 0}, {0, 0, 0}}};
    BOOST_TEST(findShells(sweptVolume(block, twoPlaces, options).triangles).count == 2u);
    const std::vector<RigidMotion> fills = {{{}, {1.9, 0, 0}, {0, 0, 0}}};  // the walls pass all of the hole
    BOOST_TEST(findShells(sweptVolume(joined(block, hole), fills, options).triangles).count == 1u);
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused_and_work_can_be_stopped) {
    const Mesh part = box({1, 1, 1});
    const std::vector<RigidMotion> motions = {{{}, {1, 0, 0}, {0, 0, 0}}};
    SweptVolumeOptions options;
    for (const double tolerance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        options.tolerance = tolerance;
        BOOST_CHECK_THROW(sweptVolume(part, motions, options), std::invalid_argument);
    }
    options.tolerance = 0.1;
    BOOST_CHECK_THROW(sweptVolume(part, {}, options), std::invalid_argument);
    options.poseError = 0.05;
    BOOST_CHECK_THROW(sweptVolume(part, motions, options), std::invalid_argument);
    options.poseError = 0;
    options.isStopped = [] { return true; };
    BOOST_TEST(sweptVolume(part, motions, options).triangles.empty());
    options.isStopped = nullptr;
    options.tolerance = 1e-4;
    if (isFullRun())
        BOOST_CHECK_THROW(sweptVolume(part, motions, options), std::invalid_argument);  // takes a minute
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
