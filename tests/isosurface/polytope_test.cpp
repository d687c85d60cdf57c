#include "isosurface/polytope.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "clearway/model.h"
#include "clearway/query.h"
#include "support/random_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(polytope_test)

namespace {

struct Plane {
    Vector3 normal;
    double offset;
    double height(const Vector3& p) const { return normal.dot(p) - offset; }
};

/// The weights of a point in a tetrahedron; all at least 0 inside.
Eigen::Vector4d weightsOf(const std::array<Vector3, 4>& corners, const Vector3& point) {
    Eigen::Matrix4d columns;
    for (int k = 0; k < 4; ++k) columns.col(k) << corners[k], 1;
    Eigen::Vector4d p;
    p << point, 1;
    return columns.fullPivLu().solve(p);
}

bool isInside(const std::array<Vector3, 4>& corners, const std::vector<Plane>& planes, const Vector3& p,
              double slack) {
    const Eigen::Vector4d weights = weightsOf(corners, p);
    if (weights.minCoeff() < -slack) return false;
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Plane& plane) { return plane.height(p) >= -slack; });
}

/// The largest height of the polytope's corners along a direction.
double support(const Polytope& polytope, const Vector3& direction) {
    double most = -1e300;
    for (const auto& corner : polytope.corners()) most = std::max(most, direction.dot(corner.point));
    return most;
}

BOOST_AUTO_TEST_CASE(the_corners_of_a_cut_body_span_its_points_and_no_others) {
    Random random(3);
    int bodies = 0;
    for (int n = 0; n < 300; ++n) {
        std::array<Vector3, 4> corners;
        for (Vector3& corner : corners) corner = random.inBox(1);
        Polytope body(corners);
        std::vector<Plane> planes;
        for (int k = 0; k < 4 && !body.isEmpty(); ++k) {
            const Plane plane{random.direction(), random.uniform(-0.2, 0.2)};
            body = body.above([&](const Vector3& p) { return plane.height(p); });
            planes.push_back(plane);
        }
        for (const auto& corner : body.corners()) {
            BOOST_REQUIRE(isInside(corners, planes, corner.point, 1e-9));
        }
        bool hasPoint = false;
        for (int k = 0; k < 200; ++k) {
            Eigen::Vector4d w(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1),
                              random.uniform(0, 1));
            w /= w.sum();
            const Vector3 p = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] + w[3] * corners[3];
            if (!isInside(corners, planes, p, 0)) continue;
            hasPoint = true;
            const Vector3 direction = random.direction();
            BOOST_REQUIRE(direction.dot(p) <= support(body, direction) + 1e-9);
        }
        bodies += hasPoint;
        if (hasPoint) BOOST_REQUIRE(!body.isEmpty());
    }
    BOOST_TEST(bodies > 30);
}

BOOST_AUTO_TEST_CASE(the_surface_of_a_cut_body_encloses_its_middle) {
    const std::array<Vector3, 4> corners{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0),
                                         Vector3(0, 0, 1)};
    const Polytope wedge = Polytope(corners).above([](const Vector3& p) { return p.x() + p.y() - 0.25; });
    BOOST_TEST(wedge.corners().size() == 6u);
    Workspace workspace;
    const Model surface = Model::build(wedge.surface());
    Random random(5);
    for (int n = 0; n < 200; ++n) {  // from the middle every ray crosses the surface
        Mesh ray;
        ray.vertices = {wedge.centre(), wedge.centre() + 2 * random.direction()};
        ray.triangles = {{0, 0, 1}};
        BOOST_TEST(collides(Model::build(ray), surface, {}, workspace));
    }
}

BOOST_AUTO_TEST_CASE(a_plane_that_misses_leaves_all_or_nothing) {
    const Polytope body({Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)});
    BOOST_TEST(body.above([](const Vector3& p) { return p.x() + 1; }).corners().size() == 4u);
    BOOST_TEST(body.above([](const Vector3& p) { return p.x() - 2; }).isEmpty());
    const auto height = [](const Vector3& p) { return -p.x(); };
    BOOST_TEST(body.above(height).isFlat(height));
    BOOST_TEST(!body.isFlat(height));
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
