#include "mesh/clean.h"

#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "mesh/components.h"
#include "support/processor_time.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(clean_test)

using testing::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Mesh oneTriangle() {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

void requireRefused(const Mesh& mesh, const std::vector<std::string>& words) {
    testing::requireRefusedBy([&] { clean(mesh); }, words);
}

using Coordinates = std::tuple<double, double, double>;
Coordinates coordinates(const Vector3& vertex) {
    return {vertex.x() + 0.0, vertex.y() + 0.0, vertex.z() + 0.0};
}

/// A triangle regardless of the order of its vertices.
using Corners = std::multiset<Coordinates>;
Corners cornersOf(const std::vector<Vector3>& vertices, const TriangleIndices& triangle) {
    return {coordinates(vertices[triangle[0]]), coordinates(vertices[triangle[1]]),
            coordinates(vertices[triangle[2]])};
}

/// Triangles on a coarse grid, so that there are many equal vertices and repeated and degenerate triangles.
/// Vertices are not shared, some zeros are negative and some vertices unused.
Mesh gridSoup(Random& random, int triangles) {
    Mesh mesh;
    for (int i = 0; i < 3 * triangles + 10; ++i) {
        const auto coordinate = [&] { return random.below(2) ? 1.0 : (random.below(2) ? 0.0 : -0.0); };
        const double x = coordinate(), y = coordinate(), z = random.below(3);
        mesh.vertices.emplace_back(x, y, z);
    }
    for (int i = 0; i < triangles; ++i) {
        const auto first = static_cast<std::uint32_t>(3 * i);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

BOOST_AUTO_TEST_CASE(a_sound_mesh_comes_through_unchanged) {
    const CleanMesh cleaned = clean(oneTriangle());
    BOOST_TEST((cleaned.vertices == oneTriangle().vertices));
    BOOST_TEST((cleaned.triangles == oneTriangle().triangles));
    BOOST_TEST((cleaned.triangleIds == std::vector<std::uint32_t>{0}));
    const CleanReport& report = cleaned.report;
    BOOST_TEST(report.weldedVertices + report.unusedVertices + report.degenerateTriangles +
                   report.duplicateTriangles ==
               0u);
}

BOOST_AUTO_TEST_CASE(what_is_kept_agrees_with_a_plain_search) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        BOOST_TEST_CONTEXT("seed " << seed) {
            Random random(seed);
            const Mesh mesh = gridSoup(random, 500);
            const CleanMesh cleaned = clean(mesh);

            std::map<Corners, std::uint32_t> firstIds;
            std::set<Coordinates> distinct;
            for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
                firstIds.try_emplace(cornersOf(mesh.vertices, mesh.triangles[id]), id);
                for (const std::uint32_t v : mesh.triangles[id])
                    distinct.insert(coordinates(mesh.vertices[v]));
            }
            BOOST_TEST(cleaned.vertices.size() == distinct.size());
            BOOST_TEST(cleaned.report.unusedVertices == 10u);
            BOOST_TEST(cleaned.report.weldedVertices == mesh.vertices.size() - 10 - distinct.size());
            BOOST_TEST(cleaned.report.duplicateTriangles == mesh.triangles.size() - firstIds.size());
            BOOST_REQUIRE(cleaned.triangles.size() == firstIds.size());
            BOOST_TEST(std::is_sorted(cleaned.triangleIds.begin(), cleaned.triangleIds.end()));
            for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) {
                const Corners corners = cornersOf(cleaned.vertices, cleaned.triangles[i]);
                BOOST_REQUIRE(firstIds.at(corners) == cleaned.triangleIds[i]);
                for (int k = 0; k < 3; ++k) {  // the order of the corners is kept too
                    const std::uint32_t given = mesh.triangles[cleaned.triangleIds[i]][k];
                    BOOST_REQUIRE((cleaned.vertices[cleaned.triangles[i][k]] == mesh.vertices[given]));
                }
            }
        }
    }
}

// Only the order of the vertices differs.
BOOST_AUTO_TEST_CASE(each_component_is_cleaned_as_a_mesh_of_its_own) {
    Random random(31);
    for (int round = 0; round < 50; ++round) {
        Mesh mesh = gridSoup(random, 60);
        const auto first = std::uint32_t(random.below(30)), second = std::uint32_t(30 + random.below(30));
        mesh.components = {
            {"a", 0, first}, {"b", first, 0}, {"c", first, second - first}, {"d", second, 60 - second}};
        const std::vector<CleanMesh> cleaned = cleanComponents(mesh);
        BOOST_REQUIRE(cleaned.size() == 4u);
        for (std::size_t i = 0; i < cleaned.size(); ++i) {
            if (mesh.components[i].triangleCount == 0) {
                BOOST_TEST(cleaned[i].triangles.empty());
                continue;
            }
            const CleanMesh alone = clean(meshOfComponents(mesh, {i}));
            BOOST_TEST(cleaned[i].vertices.size() == alone.vertices.size());
            BOOST_TEST(cleaned[i].report.duplicateTriangles == alone.report.duplicateTriangles);
            BOOST_REQUIRE(cleaned[i].triangleIds == alone.triangleIds);
            for (std::size_t t = 0; t < alone.triangles.size(); ++t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    BOOST_TEST(cleaned[i].vertices[cleaned[i].triangles[t][k]] ==
                               alone.vertices[alone.triangles[t][k]]);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(signed_zeros_are_one_vertex_and_come_out_positive) {
    Mesh mesh = oneTriangle();
    mesh.vertices.insert(mesh.vertices.end(), {{-0.0, 0, -0.0}, {1, -0.0, 0}, {0, 1, 1}});
    mesh.triangles.push_back({3, 4, 5});
    const CleanMesh cleaned = clean(mesh);
    BOOST_TEST(cleaned.report.weldedVertices == 2u);
    BOOST_TEST(cleaned.vertices.size() == 4u);
    for (const Vector3& vertex : cleaned.vertices) {
        for (int i = 0; i < 3; ++i) BOOST_TEST(!std::signbit(vertex[i]));
    }
}

BOOST_AUTO_TEST_CASE(vertices_that_differ_in_the_last_bit_stay_apart) {
    Mesh mesh = oneTriangle();
    mesh.vertices.insert(mesh.vertices.end(), {{std::nextafter(1, 2), 0, 0}, {0, 1e-300, 0}, {0, 1, 0}});
    mesh.triangles.push_back({3, 4, 5});
    const CleanMesh cleaned = clean(mesh);
    BOOST_TEST(cleaned.vertices.size() == 5u);
    BOOST_TEST(cleaned.report.weldedVertices == 1u);
}

BOOST_AUTO_TEST_CASE(a_duplicate_in_any_order_is_dropped_and_the_first_id_kept) {
    Mesh mesh = oneTriangle();
    mesh.vertices.emplace_back(0, 0, 1);
    mesh.vertices.emplace_back(0, 1, 0);  // equals vertex 2
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {2, 1, 0}, {1, 4, 0}, {0, 2, 3}};
    const CleanMesh cleaned = clean(mesh);
    BOOST_TEST((cleaned.triangleIds == std::vector<std::uint32_t>{0, 1, 4}));
    BOOST_TEST((cleaned.triangles[1] == TriangleIndices{0, 1, 2}));
    BOOST_TEST(cleaned.report.duplicateTriangles == 2u);
}

BOOST_AUTO_TEST_CASE(a_segment_and_a_point_are_kept_and_counted) {
    const Vector3 a(0.1, 0.2, 0.3);
    const Vector3 b(5, -7, 11);
    Mesh mesh;
    mesh.vertices = {a, b, {1, 0, 0}};
    mesh.triangles = {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 1, 2}};
    const CleanMesh cleaned = clean(mesh);
    BOOST_TEST(cleaned.triangles.size() == 4u);
    BOOST_TEST(cleaned.report.degenerateTriangles == 3u);
    BOOST_TEST(cleaned.report.duplicateTriangles == 0u);
}

BOOST_AUTO_TEST_CASE(a_vertex_that_is_not_finite_is_refused_naming_the_first_such_triangle) {
    Mesh mesh = testing::box({1, 1, 1}, 2);
    mesh.components = {{"lid", 0, 10}, {"floor", 10, std::uint32_t(mesh.triangles.size() - 10)}};
    mesh.origin.file = "box.stl";
    const auto bad = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const double value : {kNan, kInfinity, -kInfinity}) {
        for (int i = 0; i < 3; ++i) {
            Mesh broken = mesh;
            broken.vertices.emplace_back(1, 2, 3);
            broken.vertices[bad][i] = value;
            BOOST_CHECK_NO_THROW(clean(broken));  // no triangle uses it
            broken.triangles[20][1] = bad;
            broken.triangles[13][2] = bad;
            requireRefused(broken, {"triangle 13", "'floor'", "'box.stl'", "a vertex at (", "finite"});
        }
    }
}

BOOST_AUTO_TEST_CASE(an_index_out_of_range_and_a_mesh_without_triangles_are_refused) {
    Mesh mesh = oneTriangle();
    mesh.triangles.push_back({0, 3, 1});
    requireRefused(mesh, {"triangle 1 refers to vertex 3", "below 3"});
    mesh.triangles.clear();
    mesh.origin.file = "cloud.ply";
    requireRefused(mesh, {"'cloud.ply' holds 0 triangles", "at least 1"});
}

BOOST_AUTO_TEST_CASE(components_that_do_not_cover_the_triangles_in_order_are_refused) {
    Mesh mesh = oneTriangle();
    mesh.triangles.resize(5, {0, 1, 2});
    const auto refused = [&](std::vector<Component> components, const std::vector<std::string>& words) {
        mesh.components = std::move(components);
        requireRefused(mesh, words);
    };
    mesh.components = {{"a", 0, 2}, {"none", 2, 0}, {"b", 2, 3}};
    BOOST_CHECK_NO_THROW(clean(mesh));
    refused({{"a", 0, 2}, {"b", 2, 2}}, {"4 triangles", "expected 5"});
    refused({{"a", 0, 2}, {"b", 2, 4}}, {"6 triangles", "expected 5"});
    refused({{"a", 0, 2}, {"b", 3, 2}}, {"component 1 ('b')", "triangle 3", "expected 2"});
    refused({{"b", 2, 3}, {"a", 0, 2}}, {"component 0 ('b')", "triangle 2", "expected 0"});
    const std::uint32_t wrapping = std::numeric_limits<std::uint32_t>::max();
    refused({{"a", 0, wrapping}, {"b", wrapping, 6}}, {"4294967301 triangles", "expected 5"});
}

BOOST_AUTO_TEST_CASE(the_triangle_of_each_component_is_found) {
    Mesh mesh = oneTriangle();
    mesh.triangles.resize(6, {0, 1, 2});
    BOOST_TEST(componentOf(mesh, 5) == 0u);
    mesh.components = {{"a", 0, 2}, {"none", 2, 0}, {"b", 2, 1}, {"c", 3, 3}, {"nothing", 6, 0}};
    const std::size_t expected[] = {0, 0, 2, 3, 3, 3};
    for (std::size_t id = 0; id < 6; ++id) BOOST_TEST(componentOf(mesh, id) == expected[id]);
}

BOOST_AUTO_TEST_CASE(the_box_holds_the_used_vertices_only) {
    Mesh mesh = oneTriangle();
    mesh.vertices.emplace_back(100, 100, 100);
    const Box box = boundingBox(mesh);
    BOOST_TEST((box.min() == Vector3(0, 0, 0)));
    BOOST_TEST((box.max() == Vector3(1, 1, 0)));
    BOOST_TEST(boundingBox(Mesh{}).isEmpty());
}

BOOST_AUTO_TEST_CASE(unshared_vertices_of_a_large_mesh_are_welded_without_quadratic_work) {
    // Unshared vertices as in an STL file, on a lattice whose coordinates share most of their bits: a weak
    // hash is slow here.
    Mesh mesh;
    constexpr int kSide = 400;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const Vector3 corner(i, j, 0);
            for (const Vector3& step : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0),
                                        Vector3(0, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0)}) {
                mesh.vertices.push_back(corner + step);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first + 3, first + 4, first + 5});
        }
    }
    CleanMesh cleaned;
    const double seconds = testing::processorSecondsOf([&] { cleaned = clean(mesh); });
    BOOST_TEST(cleaned.vertices.size() == std::size_t((kSide + 1) * (kSide + 1)));
    BOOST_TEST(cleaned.triangles.size() == mesh.triangles.size());
    BOOST_TEST(seconds < 10);  // usually 0.03; with one long chain of collisions it takes minutes
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
