#include "build/fit_volumes.h"

#include <boost/test/unit_test.hpp>

#include "build/build.h"
#include "build/check_tree.h"
#include "build/fit_rss.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(fit_volumes_test)

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

Rss rssOf(const WideNode<8>& node, int lane) {
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
        FittedLane fitted{rssOf(node, lane), {}, axesAbove, child < 0};
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

/// Triangles over random points that spread so far along three random axes.
CleanMesh cloud(Random& random, const Vector3& spread, double scale, const Vector3& shift) {
    const Matrix3 axes = random.rotation();
    std::vector<Corners> triangles;
    for (int i = 0; i < 12; ++i) {
        Corners corners;
        for (Vector3& corner : corners)
            corner = scale * (axes * random.inBox(0.3).cwiseProduct(spread) + shift);
        triangles.push_back(corners);
    }
    return cleanMeshOf(triangles);
}

BOOST_AUTO_TEST_CASE(every_point_is_inside_its_volumes_and_they_are_hardly_larger) {
    constexpr std::uint64_t kSeed = 17;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 400; ++round) {
            const double thin = std::pow(10.0, random.uniform(-18, 0));
            const CleanMesh mesh = cloud(random, {1, round % 2 ? 1 : thin, thin}, 1, random.inBox(0.5));
            checkTree(buildTree(mesh, {}), mesh);
            for (const FittedLane& lane : fittedLanes(mesh, "frames")) {
                Box extent;
                for (const Vector3& point : lane.points) extent.extend(lane.volume.axes.transpose() * point);
                BOOST_REQUIRE(lane.volume.radius < 0.5 * extent.sizes().z() + 3e-7);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(any_scale_and_place_keep_the_points_inside_and_the_floats_normal) {
    constexpr std::uint64_t kSeed = 19;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        const auto isFine = [](float value) { return value == 0 || std::isnormal(value); };
        for (int round = 0; round < 40; ++round) {
            for (const double scale : {1.0, 0x1p200, 0x1p-200, 0x1p900, 0x1p-900, 1e-60}) {
                for (const Vector3& shift :
                     {Vector3(0, 0, 0), Vector3(1e9, -3e9, 7e8), Vector3(1e3, 1e-3, 1)}) {
                    const CleanMesh mesh = cloud(random, {1, 0.1, round % 2 ? 1e-9 : 0.2}, scale, shift);
                    const FlatTree tree = buildTree(mesh, {});
                    checkTree(tree, mesh);
                    for (const WideNode<8>& node : tree.nodes<8>()) {
                        for (int lane = 0; lane < 8 && node.child[lane] != kNoChild; ++lane) {
                            const FloatRss volume = volumeOf(node, lane);
                            for (int k = 0; k < 3; ++k)
                                BOOST_REQUIRE((isFine(volume.centre[k]) && isFine(volume.axis0[k]) &&
                                               isFine(volume.axis1[k])));
                            BOOST_REQUIRE((isFine(volume.halfLength0) && isFine(volume.halfLength1) &&
                                           isFine(volume.radius)));
                        }
                    }
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(one_point_has_a_volume_of_radius_zero) {
    const Vector3 point(3, 4, 5);
    const CleanMesh mesh = cleanMeshOf({{point, point, point}});
    const FloatRss stored = volumeOf(buildTree(mesh, {}).nodes<8>()[0], 0);
    BOOST_TEST((stored.centre[0] == 0 && stored.centre[1] == 0 && stored.centre[2] == 0));
    BOOST_TEST((stored.halfLength0 == 0 && stored.halfLength1 == 0 && stored.radius == 0));
}

BOOST_AUTO_TEST_CASE(a_square_is_fitted_flat_to_rounding_in_double) {
    const Vector3 a(0, 0, 0.25), b(0.5, 0, 0.25), c(0.5, 0.5, 0.25), d(0, 0.5, 0.25);
    BOOST_TEST(fittedLanes(cleanMeshOf({{a, b, c}, {a, c, d}}), "frames").back().volume.radius < 1e-14);
}

BOOST_AUTO_TEST_CASE(one_triangle_is_fitted_flat) {
    const CleanMesh mesh = cleanMeshOf({{Vector3(1, 1, 1), Vector3(5, 3, 2), Vector3(2, 4, 7)}});
    BOOST_TEST(fittedLanes(mesh, "frames")[0].volume.radius < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
