// Shrunk parts against windings and depths found by brute force.
#include "clearway/shrink.h"

#include <boost/test/unit_test.hpp>
#include <map>

#include "mesh/components.h"
#include "model/solids.h"
#include "shrink/certificate.h"
#include "shrink/mitres.h"
#include "support/full_run.h"
#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/winding.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(shrink_test)

Component all(const Mesh& mesh) {
    return {"", 0, static_cast<std::uint32_t>(mesh.triangles.size())};
}

double distanceOf(const Mesh& mesh, const Vector3& point) {
    Mesh one;
    one.vertices = {point};
    one.triangles = {{0, 0, 0}};
    return bruteForceDistance(one, mesh, {}).distance;
}

Vector3 pointOn(const Mesh& mesh, Random& random) {
    const auto& t = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return (1 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] + v * mesh.vertices[t[2]];
}

/// Checks what makes overlaps safe: points that are further from the part's surface than the overlap are inside each shrunk component as
/// often as inside the component. Returns how many such points there were.
int checkWindings(const Mesh& part, double overlap, int draws) {
    const ShrunkPart shrunk = shrink(part, {overlap});
    BOOST_REQUIRE(shrunk.partTriangles.size() == shrunk.mesh.triangles.size());
    for (const std::uint32_t triangle : shrunk.partTriangles) BOOST_REQUIRE(triangle < part.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const TriangleIndices& t : shrunk.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k], to = t[(k + 1) % 3];
            sides[std::minmax({from, to})] += from < to ? 1 : -1;
        }
    }
    for (const auto& [edge, sum] : sides) BOOST_REQUIRE(sum == 0);
    const std::vector<Component> components = componentsOf(part);
    std::vector<Solid> solids;
    std::vector<long> signs;
    for (std::size_t i = 0; i < components.size(); ++i) {
        solids.push_back(Solid::oriented(meshOfComponents(shrunk.mesh, {i})));
        signs.push_back(Solid(meshOfComponents(part, {i}), "component").isTurnedOver() ? -1 : 1);
    }
    Random random(7);
    int deep = 0;
    for (int n = 0; n < draws; ++n) {
        const Mesh& near = n % 2 == 0 ? part : shrunk.mesh;
        const Vector3 point = pointOn(near, random) + 3 * overlap * random.inBox(1);
        const double distance = distanceOf(part, point);
        if (distance < (1 + 1e-9) * overlap) continue;
        ++deep;
        for (std::size_t i = 0; i < components.size(); ++i) {
            const long winding = signs[i] * std::lround(windingBySolidAngles(part, components[i], point));
            BOOST_REQUIRE_MESSAGE(
                solids[i].winding({}, {}, point) == winding,
                "at " << point.transpose() << ", " << distance / overlap << " overlaps from the surface");
        }
    }
    return deep;
}

/// Checks that the shrunk part's surface is inside the part, as deep as a flat contact of 0.73 overlaps needs.
void checkDepths(const Mesh& part, double overlap) {
    const int draws = inForm(300, 60);
    BOOST_TEST(checkWindings(part, overlap, 2 * draws) > 0);
    const ShrunkPart shrunk = shrink(part, {overlap});
    BOOST_TEST(shrunk.thin.count == 0u);
    BOOST_TEST(shrunk.thin.leastOverlap == overlap);
    Random random(8);
    for (int n = 0; n < draws; ++n) {
        const Vector3 point = pointOn(shrunk.mesh, random);
        const double depth = distanceOf(part, point) / overlap;
        BOOST_REQUIRE(std::abs(windingBySolidAngles(part, all(part), point)) > 0.5);
        BOOST_REQUIRE_MESSAGE(depth > 0.73 && depth < 1 + 1e-9,
                              depth << " overlaps at " << point.transpose());
    }
}

/// A box with a pocket from above.
Mesh pocket(double floor, double wall) {
    Mesh mesh;
    const auto addRing = [&](double half, double z) {
        for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            mesh.vertices.emplace_back(half * x, half * y, z);
    };
    addRing(2, -1);
    addRing(2, 1);
    addRing(2 - wall, 1);
    addRing(2 - wall, -1 + floor);
    for (std::uint32_t ring = 0; ring < 12; ring += 4) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t a = ring + k, b = ring + (k + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
    }
    for (const TriangleIndices& t : {TriangleIndices{0, 2, 1}, {0, 3, 2}, {12, 13, 14}, {12, 14, 15}})
        mesh.triangles.push_back(t);
    return mesh;
}

/// A wedge whose edge has an angle of so many degrees.
Mesh knife(double degrees) {
    const double h = std::tan(0.5 * degrees * M_PI / 180);
    Mesh mesh;
    for (const double y : {0.0, 1.0}) {
        for (const Vector3& v : {Vector3(0, y, 0), Vector3(1, y, -h), Vector3(1, y, h)})
            mesh.vertices.push_back(v);
    }
    mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
    return mesh;
}

std::string refusal(const Mesh& part, double overlap) {
    return refusalBy([&] { shrink(part, {overlap}); });
}

BOOST_AUTO_TEST_CASE(a_box_shrinks_to_a_box) {
    const ShrunkPart shrunk = shrink(box({3, 2, 1}), {0.25});
    BOOST_TEST((boundingBox(shrunk.mesh).max() - Vector3(3, 2, 1) + Vector3::Constant(0.1875)).norm() <
               1e-12);
    BOOST_TEST((boundingBox(shrunk.mesh).min() + Vector3(3, 2, 1) - Vector3::Constant(0.1875)).norm() <
               1e-12);
    BOOST_TEST(shrunk.mesh.triangles.size() == 12u);
}

BOOST_AUTO_TEST_CASE(faces_move_by_three_quarters_of_the_overlap_and_corners_no_deeper_than_it) {
    checkDepths(box({3, 2, 1}, 3), 0.25);
    checkDepths(tube(2, 3, 6, 12), 0.2);
    checkDepths(sphere(2, 8), 0.5);
    checkDepths(torus(4, 1, 8), 0.3);
    checkDepths(translated(box({3, 2, 1}), {1e4, -2e4, 3e4}), 0.25);
    checkDepths(box({1e-5, 2e-5, 3e-5}), 1e-6);  // units do not matter
    checkDepths(box({1e7, 2e7, 3e7}), 1e6);
    const Mesh shell = joined(box({3, 3, 3}), reversed(box({2, 2, 2})));
    checkDepths(shell, 0.2);
    checkDepths(reversed(tube(2, 3, 6, 12)), 0.2);
}

BOOST_AUTO_TEST_CASE(odd_shapes_lose_no_point_that_is_deeper_than_the_overlap) {
    const int draws = inForm(2000, 300);
    for (const double overlap : {1e-4, 0.01, 0.1, 0.4}) {
        checkWindings(box({2, 2, 0.05}), overlap, draws);     // a slab
        checkWindings(box({0.05, 0.05, 2}), overlap, draws);  // a needle
        checkWindings(knife(1), overlap, draws);
        checkWindings(pocket(0.05, 0.1), overlap, draws);
        checkWindings(joined(named(box({1, 1, 1}), "a"), translated(named(box({1, 1, 1}), "b"), {2, 0.5, 0})),
                      overlap, draws);
        if (overlap < 0.17)
            checkWindings(sphere(0.1, 6), overlap, draws);  // thinner than two overlaps of 0.1
    }
}

BOOST_AUTO_TEST_CASE(parts_of_scenes_lose_no_point_that_is_deeper_than_the_overlap) {
    for (const char* name :
         {"bracket/bracket.stl", "puzzle/puzzle_part.obj", "tunnel-console-small/tunnel-console_part.obj"}) {
        const Mesh part = loadMesh(std::string(CLEARWAY_DATA_DIR) + "/" + name);
        for (const double share : {1e-4, 0.002, 0.02})
            checkWindings(part, share * boundingBox(part).diagonal().norm(), inForm(400, 60));
    }
}

BOOST_AUTO_TEST_CASE(thin_places_are_told_with_the_overlap_that_is_left) {
    const ShrunkPart slab = shrink(box({2, 2, 0.05}), {0.2});
    BOOST_TEST(slab.thin.count >= 8u);
    BOOST_TEST(slab.thin.leastOverlap < 0.05);
    BOOST_TEST(slab.thin.leastOverlap > 0.02);
    const ShrunkPart hollow = shrink(pocket(0.05, 0.5), {0.1});
    BOOST_TEST(hollow.thin.count > 0u);
    BOOST_TEST(hollow.thin.at.z() < -0.8);
}

BOOST_AUTO_TEST_CASE(parts_without_an_inside_and_wrong_overlaps_are_refused) {
    Mesh sheet = box({1, 1, 1});
    sheet.triangles.pop_back();
    BOOST_TEST(refusal(named(sheet, "sheet"), 0.1).find("'sheet' encloses nothing") != std::string::npos);
    for (const double overlap : {0.0, -1.0, std::nan(""), double(INFINITY)})
        BOOST_TEST(refusal(box({1, 1, 1}), overlap).find("expected a finite number above 0") !=
                   std::string::npos);
    BOOST_TEST(refusal(translated(box({1, 1, 1}), {1e9, 0, 0}), 1e-4).find("rounded by") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(mitres_are_the_shortest_moves_behind_all_faces) {
    const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
    BOOST_TEST((shortestMove({x}, 2).value() + 2 * x).norm() < 1e-12);
    BOOST_TEST((shortestMove({x, y}, 2).value() + 2 * (x + y)).norm() < 1e-12);
    BOOST_TEST((shortestMove({x, y, z, (x + y).normalized()}, 2).value() + 2 * (x + y + z)).norm() < 1e-12);
    BOOST_TEST(!shortestMove({x, (1e-3 * y - x).normalized()}, 2).has_value());
    BOOST_TEST(!shortestMove({x, -x}, 2).has_value());
}

BOOST_AUTO_TEST_CASE(shrinking_ends_when_stopped) {
    BOOST_CHECK_THROW(shrink(box({1, 1, 1}), {0.1, [] { return true; }}), ShrinkStopped);
}

BOOST_AUTO_TEST_CASE(a_shrunk_part_is_the_same_each_time) {
    const Mesh part = torus(4, 1, 8);
    const ShrunkPart one = shrink(part, {0.9}), two = shrink(part, {0.9});
    BOOST_TEST((one.mesh.vertices == two.mesh.vertices));
    BOOST_TEST((one.mesh.triangles == two.mesh.triangles));
}

/// The middle of a face goes 1.5 down through a plate of 2, to 0.5 from the other face: half way it is 1 deep.
BOOST_AUTO_TEST_CASE(a_move_across_the_part_is_shortened_though_it_ends_near_the_surface) {
    const Mesh mesh = box({5, 5, 1}, 2);
    const OrientedSurface plate = orientedSurface(mesh);
    MovedSurface moved;
    std::size_t across = 0;
    for (std::uint32_t v = 0; v < plate.vertices.size(); ++v) {
        const bool isMiddle = plate.vertices[v] == Vector3(0, 0, 1);
        if (isMiddle) across = v;
        moved.places.push_back({v, isMiddle ? Vector3(0, 0, -1.5) : Vector3::Zero()});
    }
    for (std::uint32_t t = 0; t < plate.triangles.size(); ++t)
        moved.triangles.push_back({plate.triangles[t], 3 * t});
    NearestTriangle nearest(Model::build(mesh));
    BOOST_TEST(certifyMoves(plate, nearest, plate, 0.7, moved)[across]);
    BOOST_TEST(moved.places[across].move.norm() <= 0.7);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
