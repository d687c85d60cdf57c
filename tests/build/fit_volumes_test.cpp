#include "build/fit_volumes.h"

#include <boost/test/unit_test.hpp>

#include "build/build.h"
#include "build/fit_rss.h"
#include "build/sample_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(fit_volumes_test)

namespace {

constexpr double kFloatRounding = 1e-4;  // relative: frames are compared, and volumes stored, in float
constexpr double kAreaRounding = 1e-5;   // of the mesh's size squared: a radius stored too large by rounding

std::vector<CleanMesh> sampleMeshes() {
    Random random(97);
    return {cleanMeshOf(soup(700, 96)), cleanMeshOf(bentSheet(40, 9)), weldedMesh(cadAssembly(random, 3.0)),
            weldedMesh(torus(3, 1, 12))};
}

struct FittedLane {
    Rss volume;                   ///< tree units
    std::vector<Vector3> points;  ///< distinct, tree units
    Matrix3 axesAbove;            ///< of the wide node's own volume; the model's axes for the root
    bool isLeaf;
};

Rss volumeAt(const WideNode<8>& node, int lane) {
    Rss volume;
    for (int k = 0; k < 3; ++k) {
        volume.centre[k] = node.centre[k][lane];
        volume.axes(k, 0) = node.axis0[k][lane];
        volume.axes(k, 1) = node.axis1[k][lane];
    }
    volume.axes.col(2) = volume.axes.col(0).cross(volume.axes.col(1));
    volume.halfLength0 = node.halfLength0[lane];
    volume.halfLength1 = node.halfLength1[lane];
    volume.radius = node.radius[lane];
    return volume;
}

/// Appends all lanes below a node, and returns the points below it.
std::vector<Vector3> collect(const FlatTree& tree, std::int32_t index, const Matrix3& axesAbove,
                             std::vector<FittedLane>& lanes) {
    const WideNode<8>& node = tree.nodes<8>()[std::size_t(index)];
    std::vector<Vector3> all;
    for (int lane = 0; lane < 8 && node.child[lane] != kNoChild; ++lane) {
        const std::int32_t child = node.child[lane];
        FittedLane fitted{volumeAt(node, lane), {}, axesAbove, child < 0};
        if (child >= 0) {
            fitted.points = collect(tree, child, fitted.volume.axes, lanes);
        } else {
            const auto at = LeafReference(~child);
            for (std::uint32_t i = 0; i < tree.leaf(at).triangleCount; ++i) {
                for (const Vector3& corner : tree.corners({at, i}))
                    fitted.points.push_back((corner - tree.origin) / tree.unit);
            }
        }
        const auto isBefore = [](const Vector3& a, const Vector3& b) {
            return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        };
        std::sort(fitted.points.begin(), fitted.points.end(), isBefore);
        fitted.points.erase(std::unique(fitted.points.begin(), fitted.points.end()), fitted.points.end());
        all.insert(all.end(), fitted.points.begin(), fitted.points.end());
        lanes.push_back(std::move(fitted));
    }
    return all;
}

std::vector<FittedLane> fittedLanes(const CleanMesh& mesh, const std::string& fit) {
    const FlatTree tree = buildTree(mesh, {"sah", "none", 2, 8, fit});
    std::vector<FittedLane> lanes;
    collect(tree, 0, Matrix3::Identity(), lanes);
    return lanes;
}

bool isAtMost(const Rss& a, const Rss& b) {
    return a.area() <= b.area() * (1 + kFloatRounding) + kAreaRounding;
}

BOOST_AUTO_TEST_CASE(no_small_volume_is_larger_than_in_the_frame_of_the_vertices_covariance) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        for (const FittedLane& lane : fittedLanes(mesh, "frames")) {
            // Vertices of large nodes may weigh twice.
            if (lane.points.size() <= 12) BOOST_REQUIRE(isAtMost(lane.volume, fitRss(lane.points)));
        }
    }
}

BOOST_AUTO_TEST_CASE(no_volume_is_larger_than_with_the_axes_above_it) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        for (const FittedLane& lane : fittedLanes(mesh, "frames")) {
            if (!lane.isLeaf) BOOST_REQUIRE(isAtMost(lane.volume, fitRss(lane.points, lane.axesAbove)));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_whole_tree_gets_smaller_than_by_covariance) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        double frames = 0;
        double covariance = 0;
        for (const FittedLane& lane : fittedLanes(mesh, "frames")) frames += lane.volume.area();
        for (const FittedLane& lane : fittedLanes(mesh, "covariance")) covariance += lane.volume.area();
        BOOST_TEST(frames < 0.97 * covariance);
    }
}

BOOST_AUTO_TEST_CASE(the_covariance_fit_is_that_of_all_corners) {
    for (const CleanMesh& mesh : sampleMeshes()) {
        const FittedLane root = fittedLanes(mesh, "covariance").back();
        std::vector<Vector3> corners;
        for (const TriangleIndices& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) corners.push_back(mesh.vertices[vertex]);
        }
        const Vector3 normal = principalFrame(corners).axes.col(2);
        BOOST_TEST(std::abs(normal.dot(root.volume.axes.col(2))) > 0.999);
    }
}

BOOST_AUTO_TEST_CASE(one_triangle_is_fitted_flat) {
    const CleanMesh mesh = cleanMeshOf({{Vector3(1, 1, 1), Vector3(5, 3, 2), Vector3(2, 4, 7)}});
    BOOST_TEST(fittedLanes(mesh, "frames")[0].volume.radius < 1e-6);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
