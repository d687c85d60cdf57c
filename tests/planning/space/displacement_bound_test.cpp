#include "clearway/planning/displacement_bound.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/planning/state_to_pose.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(displacement_bound_test)

namespace ob = ompl::base;

constexpr double kRadius = 450;

std::vector<Vector3> pointsInReach(testing::Random& random) {
    std::vector<Vector3> points;
    for (int i = 0; i < 40; ++i)
        points.push_back(random.direction() * kRadius * (i % 4 == 0 ? random.uniform(0, 1) : 1));
    return points;
}

double largestDisplacement(const Pose& a, const Pose& b, const std::vector<Vector3>& points) {
    double largest = 0;
    for (const Vector3& p : points) largest = std::max(largest, (a * p - b * p).norm());
    return largest;
}

/// Interpolates densely and returns the largest displacement between neighbours, times their number.
double densestDisplacement(const ob::StateSpacePtr& space, const ob::State* from, const ob::State* to,
                           int parts, const std::vector<Vector3>& points) {
    const StateToPose toPose = stateToPose(*space);
    ob::ScopedState<> state(space);
    double largest = 0;
    Pose before = toPose(from);
    for (int i = 1; i < parts; ++i) {
        space->interpolate(from, to, static_cast<double>(i) / parts, state.get());
        const Pose now = toPose(state.get());
        largest = std::max(largest, largestDisplacement(before, now, points));
        before = now;
    }
    return largest * parts;
}

void randomSe3(testing::Random& random, double halfSide, ob::SE3StateSpace::StateType& state) {
    const Pose pose = random.pose(halfSide);
    const Eigen::Quaterniond q(pose.rotation);
    state.setXYZ(pose.translation.x(), pose.translation.y(), pose.translation.z());
    const double norm = 1 + random.uniform(-1e-9, 1e-9);  // as far off as OMPL accepts
    state.rotation().x = q.x() * norm;
    state.rotation().y = q.y() * norm;
    state.rotation().z = q.z() * norm;
    state.rotation().w = q.w() * norm;
}

BOOST_AUTO_TEST_CASE(no_point_moves_further_than_its_share_of_the_bound_in_se3) {
    const auto space = std::make_shared<ob::SE3StateSpace>();
    const DisplacementBound bound = displacementBound(*space, kRadius);
    for (int seed = 1; seed <= 300; ++seed) {
        testing::Random random(seed);
        const auto points = pointsInReach(random);
        ob::ScopedState<ob::SE3StateSpace> a(space), b(space);
        randomSe3(random, 500, *a);
        randomSe3(random, 500, *b);
        // Every third motion is short, down to 1e-5 of the way: there OMPL's angle is ill-conditioned.
        if (seed % 3 == 0) space->interpolate(a.get(), b.get(), std::pow(10, -random.uniform(0, 5)), b.get());
        const double limit = bound(a.get(), b.get());
        const double moved = densestDisplacement(space, a.get(), b.get(), 64, points);
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_TEST(moved <= limit + 64 * 1e-12);  // the poses' own rounding
            BOOST_TEST(largestDisplacement(stateToPose(*space)(a.get()), stateToPose(*space)(b.get()),
                                           points) <= limit + 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(no_vertex_moves_further_than_its_share_of_the_bound_about_the_real_axis) {
    const auto se3 = std::make_shared<ob::SE3StateSpace>();
    const auto se2 = std::make_shared<ob::SE2StateSpace>();
    for (int seed = 1; seed <= 100; ++seed) {
        testing::Random random(seed);
        const Mesh bar = testing::transformed(testing::box({400, 20, 5}), random.pose(50));
        const Model model = Model::build(bar);
        ob::ScopedState<ob::SE3StateSpace> a(se3), b(se3);
        randomSe3(random, 500, *a);
        randomSe3(random, 500, *b);
        if (seed % 3 == 0) se3->interpolate(a.get(), b.get(), std::pow(10, -random.uniform(0, 5)), b.get());
        ob::ScopedState<ob::SE2StateSpace> c(se2), d(se2);
        c->setXY(random.uniform(-500, 500), random.uniform(-500, 500));
        c->setYaw(random.uniform(-M_PI, M_PI));
        d->setYaw(random.uniform(-M_PI, M_PI));
        const DisplacementBound inSpace = displacementBound(*se3, model),
                                inPlane = displacementBound(*se2, model);
        BOOST_TEST_CONTEXT("seed " << seed) {
            const double limit = inSpace(a.get(), b.get());
            BOOST_TEST(densestDisplacement(se3, a.get(), b.get(), 64, bar.vertices) <= limit + 64 * 1e-12);
            BOOST_TEST(limit <= displacementBound(*se3, model.radiusAboutOrigin())(a.get(), b.get()));
            BOOST_TEST(densestDisplacement(se2, c.get(), d.get(), 64, bar.vertices) <=
                       inPlane(c.get(), d.get()) + 64 * 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_bar_that_rolls_moves_by_its_thickness) {
    const auto space = std::make_shared<ob::SE3StateSpace>();
    const DisplacementBound bound = displacementBound(*space, Model::build(testing::box({400, 3, 4})));
    ob::ScopedState<ob::SE3StateSpace> a(space), b(space);
    a->setXYZ(0, 0, 0);
    b->setXYZ(0, 0, 0);
    a->rotation().setAxisAngle(0, 0, 1, M_PI / 2);  // its length along the environment's y
    const Eigen::Quaterniond turned =
        Eigen::AngleAxisd(1.5, Vector3::UnitY()) * Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ());
    b->rotation().x = turned.x();
    b->rotation().y = turned.y();
    b->rotation().z = turned.z();
    b->rotation().w = turned.w();
    BOOST_TEST(bound(a.get(), b.get()) == 1.5 * 5, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_bound_is_reached_where_translation_and_rotation_add_up) {
    const auto space = std::make_shared<ob::SE3StateSpace>();
    const DisplacementBound bound = displacementBound(*space, kRadius);
    ob::ScopedState<ob::SE3StateSpace> a(space), b(space);
    a->setXYZ(0, 0, 0);
    a->rotation().setIdentity();
    b->setXYZ(30, 0, 40);
    b->rotation().setAxisAngle(0, 0, 1, 0.5);
    BOOST_TEST(bound(a.get(), b.get()) == std::hypot(40, 30 + 0.5 * kRadius),
               boost::test_tools::tolerance(2e-7));
    b->rotation().setIdentity();
    BOOST_TEST(bound(a.get(), b.get()) == 50, boost::test_tools::tolerance(2e-7));
    BOOST_TEST(bound(a.get(), a.get()) == 0);
}

BOOST_AUTO_TEST_CASE(no_point_moves_further_than_its_share_of_the_bound_in_se2) {
    const auto space = std::make_shared<ob::SE2StateSpace>();
    const DisplacementBound bound = displacementBound(*space, kRadius);
    for (int seed = 1; seed <= 200; ++seed) {
        testing::Random random(seed);
        const auto points = pointsInReach(random);
        ob::ScopedState<ob::SE2StateSpace> a(space), b(space);
        a->setXY(random.uniform(-500, 500), random.uniform(-500, 500));
        b->setXY(random.uniform(-500, 500), random.uniform(-500, 500));
        a->setYaw(random.uniform(-M_PI, M_PI));
        b->setYaw(random.uniform(-M_PI, M_PI));
        const double moved = densestDisplacement(space, a.get(), b.get(), 64, points);
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_TEST(moved <= bound(a.get(), b.get()) + 64 * 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_space_that_may_interpolate_in_its_own_way_is_refused_by_its_name) {
    const auto dubins = std::make_shared<ob::DubinsStateSpace>();
    dubins->setName("car");
    testing::requireRefusedBy([&] { displacementBound(*dubins, 1); }, {"'car'"});
    BOOST_CHECK_THROW(displacementBound(ob::SE3StateSpace(), -1), std::invalid_argument);
    BOOST_CHECK_THROW(displacementBound(ob::SE3StateSpace(), std::nan("")), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
