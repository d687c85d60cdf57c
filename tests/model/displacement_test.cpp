#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <limits>

#include "clearway/model.h"
#include "support/full_run.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(displacement_test)

double largestVertexDistance(const Mesh& mesh, const Vector3& axis) {
    double largest = 0;
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            largest = std::max(largest, axis.normalized().cross(mesh.vertices[vertex]).norm());
        }
    }
    return largest;
}

void checkAxis(const Model& model, const Mesh& mesh, const Vector3& axis) {
    const double exact = largestVertexDistance(mesh, axis), bound = model.radiusAboutAxis(axis);
    BOOST_TEST(bound >= exact * (1 - 1e-14));
    BOOST_TEST(bound <= exact * (1 + 1.001e-3) + 1e-14 * model.radiusAboutOrigin());
    BOOST_TEST(bound <= model.radiusAboutOrigin());
}

BOOST_AUTO_TEST_CASE(no_vertex_is_farther_from_the_axis_and_one_is_as_far_but_for_a_thousandth) {
    for (const int width : {2, 8}) {
        BuildOptions options;
        options.nodeWidth = width;
        for (int seed = 1; seed <= inForm(20, 7); ++seed) {
            Random random(seed);
            const Pose away = random.pose(std::pow(10, random.uniform(-2, 4)));
            const Mesh mesh = transformed(
                seed % 2 == 0 ? cadAssembly(random, 100) : randomSoup(random, 300, 100, 20), away);
            const Model model = Model::build(mesh, options);
            BOOST_TEST_CONTEXT("seed " << seed << ", node width " << width) {
                for (int i = 0; i < 50; ++i) checkAxis(model, mesh, random.direction());
                for (int k = 0; k < 3; ++k) checkAxis(model, mesh, Vector3::Unit(k));
                checkAxis(model, mesh, away.translation);  // right through it
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_bar_reaches_far_across_its_length_and_little_along_it) {
    const Model bar = Model::build(box({500, 3, 4}, 8));
    BOOST_TEST(bar.radiusAboutAxis({1, 0, 0}) == 5, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(bar.radiusAboutAxis({-1e-200, 0, 0}) == 5, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(bar.radiusAboutAxis({0, 0, 1e200}) == std::hypot(500, 3), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_scale_of_the_mesh_does_not_matter) {
    const Mesh mesh = bracket(10, 1, 2, 6);
    const Vector3 axis(1, 2, -3);
    const double radius = Model::build(mesh).radiusAboutAxis(axis);
    for (const int exponent : {-60, -20, 20, 60}) {
        const double scale = std::ldexp(1.0, exponent);
        BOOST_TEST(Model::build(scaledBy(mesh, scale)).radiusAboutAxis(axis) == scale * radius);
    }
}

BOOST_AUTO_TEST_CASE(a_direction_that_is_none_gives_the_radius_about_the_origin) {
    const Model model = Model::build(box({3, 4, 12}));
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    for (const Vector3& none : {Vector3(0, 0, 0), Vector3(nan, 0, 1), Vector3(infinity, 0, 1)}) {
        BOOST_TEST(model.radiusAboutAxis(none) == model.radiusAboutOrigin());
    }
}

double largestVertexDisplacement(const Mesh& mesh, const Pose& from, const Pose& to) {
    long double largest = 0;
    for (const Vector3& v : mesh.vertices) {
        long double squares = 0;
        for (int i = 0; i < 3; ++i) {
            long double away = static_cast<long double>(to.translation[i]) - from.translation[i];
            for (int k = 0; k < 3; ++k) {
                away += (static_cast<long double>(to.rotation(i, k)) - from.rotation(i, k)) * v[k];
            }
            squares += away * away;
        }
        largest = std::max(largest, squares);
    }
    return static_cast<double>(std::sqrt(largest));
}

BOOST_AUTO_TEST_CASE(no_vertex_moves_further_and_one_as_far_but_for_a_millionth) {
    for (const int width : {2, 8}) {
        BuildOptions options;
        options.nodeWidth = width;
        for (int seed = 1; seed <= inForm(20, 7); ++seed) {
            Random random(seed);
            const Mesh mesh = transformed(cadAssembly(random, 100), random.pose(seed % 2 == 0 ? 0 : 1e4));
            const Model model = Model::build(mesh, options);
            for (int i = 0; i < 50; ++i) {
                const Pose from = random.pose(200);
                const Vector3 centre = random.inBox(200);  // of a small turn
                const double angle = std::pow(10, random.uniform(-9, 0.4));
                const Matrix3 turn = Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix();
                Pose to{turn * from.rotation, turn * (from.translation - centre) + centre};
                if (i % 5 == 0) to = random.pose(200);
                const double exact = largestVertexDisplacement(mesh, from, to);
                const double bound = model.displacement(from, to);
                const double rounding =
                    1e-14 * (3 * model.radiusAboutOrigin() + (to.translation - from.translation).norm());
                BOOST_TEST_CONTEXT("seed " << seed << ", motion " << i << ", node width " << width) {
                    BOOST_TEST(bound >= exact);
                    BOOST_TEST(bound <= exact * (1 + 1.001e-6) + rounding);
                    BOOST_TEST(model.displacement(from, to, exact * 1.01) == bound);
                    BOOST_TEST(model.displacement(from, to, exact * 0.99 - rounding) >
                               exact * 0.99 - rounding);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_pose_is_not_away_from_itself) {
    Random random(3);
    const Model model = Model::build(bracket(10, 1, 2, 6));
    const Pose pose = random.pose(1e6);
    BOOST_TEST(model.displacement(pose, pose) == 0);
    BOOST_TEST(model.displacement(pose, pose, 0) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
