// Shrunk parts against depths found by brute force.
#include "clearway/shrink.h"

#include <boost/test/unit_test.hpp>
#include <functional>
#include <stdexcept>

#include "mesh/topology.h"
#include "model/solids.h"
#include "shrink/surface_depth.h"
#include "support/full_run.h"
#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/winding.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(shrink_test)

namespace {

/// Both meshes, with their components.
Mesh both(const Mesh& a, const Mesh& b) {
    Mesh mesh = joined(a, b);
    mesh.components = a.components;
    for (Component component : b.components) {
        component.firstTriangle += static_cast<std::uint32_t>(a.triangles.size());
        mesh.components.push_back(component);
    }
    return mesh;
}

Mesh pointMeshAt(const Vector3& point) {
    Mesh one;
    one.vertices = {point};
    one.triangles = {{0, 0, 0}};
    return one;
}

/// How deep a point lies below the surface of a part whose triangles all face one way, by brute force.
double depthOf(const Mesh& part, const Vector3& point) {
    const double length = bruteForceDistance(pointMeshAt(point), part, {}).distance;
    const Component all{"", 0, static_cast<std::uint32_t>(part.triangles.size())};
    return std::abs(windingBySolidAngles(part, all, point)) > 0.5 ? length : -length;
}

bool isIn(const Mesh& mesh, const Vector3& point) {
    return Solid(mesh, "shrunk").winding({}, {}, point) > 0;
}

/// Checks what ShrunkPart promises: on its surface, and at points drawn in the part's box. outside: the surface
/// whose depths count.
void checkShrunk(const ShrunkPart& shrunk, const Mesh& outside, int draws) {
    const ShrinkOptions& options = shrunk.options;
    const double least = options.overlap, most = options.overlap + options.tolerance;
    const double rounding = 1e-9 * boundingBox(outside).diagonal().norm();
    Random random(7);
    for (int n = 0; n < draws; ++n) {
        const auto& t = shrunk.mesh.triangles[std::size_t(random.below(int(shrunk.mesh.triangles.size())))];
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const auto& vertices = shrunk.mesh.vertices;
        const Vector3 p = (1 - u - v) * vertices[t[0]] + u * vertices[t[1]] + v * vertices[t[2]];
        const double depth = depthOf(outside, p);
        BOOST_REQUIRE(depth > least - rounding);
        BOOST_REQUIRE_MESSAGE(depth < most + rounding, depth << " at " << p.transpose());
    }
    const Solid solid(shrunk.mesh, "shrunk");
    const Box box = boundingBox(outside);
    int inside = 0;
    for (int n = 0; n < draws; ++n) {
        const auto& t = shrunk.mesh.triangles[std::size_t(random.below(int(shrunk.mesh.triangles.size())))];
        const bool isNear = n % 2 == 0;
        const Vector3 p = isNear ? Vector3(shrunk.mesh.vertices[t[0]] + 2 * most * random.inBox(1))
                                 : Vector3(box.center() + random.inBox(0.5).cwiseProduct(box.sizes()));
        const double depth = depthOf(outside, p);
        const bool isInside = solid.winding({}, {}, p) > 0;
        inside += isInside;
        if (depth > most + rounding) BOOST_REQUIRE(isInside);
        if (depth < least - rounding) BOOST_REQUIRE(!isInside);
    }
    BOOST_REQUIRE(shrunk.partTriangles.size() == shrunk.mesh.triangles.size());
    BOOST_TEST(inside > 0);
    BOOST_TEST(inside < draws);
}

void checkShrunk(const Mesh& part, const ShrinkOptions& options, int draws = inForm(150, 50)) {
    checkShrunk(shrink(part, options), part, draws);
}

std::string refusal(const Mesh& part, const ShrinkOptions& options) {
    try {
        shrink(part, options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

BOOST_AUTO_TEST_CASE(a_box_shrinks_to_a_box) {
    const ShrunkPart shrunk = shrink(box({3, 2, 1}), {0.25, 0.05});
    const Box left = boundingBox(shrunk.mesh);
    for (int axis = 0; axis < 3; ++axis) {
        const double half = axis == 0 ? 3 : axis == 1 ? 2 : 1;
        BOOST_TEST(left.max()[axis] <= half - 0.25);
        BOOST_TEST(left.max()[axis] >= half - 0.30);
        BOOST_TEST(left.min()[axis] == -left.max()[axis], boost::test_tools::tolerance(0.03));
    }
    BOOST_TEST(shrunk.leftOut.empty());
    BOOST_TEST(shrunk.mesh.triangles.size() < 20000u);
}

BOOST_AUTO_TEST_CASE(every_point_of_a_shrunk_part_is_as_deep_as_promised) {
    checkShrunk(box({3, 2, 1}, 3), {0.25, 0.05});
    checkShrunk(tube(2, 3, 6, 12), {0.2, 0.2});
    checkShrunk(translated(box({3, 2, 1}), {1e4, -2e4, 3e4}), {0.25, 0.1});  // far from the origin
    checkShrunk(box({0.02, 1, 1}), {0.01, 0.005});                           // a thin sheet
    checkShrunk(box({0.05, 0.05, 1}), {0.02, 0.01});                         // a needle
    checkShrunk(box({1e-5, 2e-5, 3e-5}), {1e-6, 1e-6});                      // units do not matter
    checkShrunk(box({1e7, 2e7, 3e7}), {1e6, 1e6});
    if (!isFullRun()) return;
    checkShrunk(sphere(2, 8), {0.5, 0.1});
    checkShrunk(torus(4, 1, 8), {0.3, 0.15});
    checkShrunk(tube(2, 3, 6, 24), {0.2, 0.02});
    checkShrunk(sphere(2, 16), {0.5, 0.05});
    checkShrunk(torus(4, 1, 12), {0.3, 0.03});
    checkShrunk(tube(0.5, 0.52, 3, 16), {0.002, 0.002});
}

BOOST_AUTO_TEST_CASE(cavities_grow_and_pieces_stay_apart) {
    const Mesh shell = joined(box({3, 3, 3}), reversed(box({2, 2, 2})));
    Mesh one = shell;
    one.components = {};
    checkShrunk(one, {0.2, 0.1});
    BOOST_TEST(shrink(one, {0.2, 0.1}).leftOut.empty());
    const Mesh two =
        both(named(box({1, 1, 1}), "left"), named(translated(box({1, 1, 1}), {3, 0, 0}), "right"));
    const ShrunkPart shrunk = shrink(two, {0.2, 0.1});
    BOOST_TEST(shrunk.leftOut.empty());
    BOOST_TEST(isIn(shrunk.mesh, {0, 0, 0}));
    BOOST_TEST(isIn(shrunk.mesh, {3, 0, 0}));
    BOOST_TEST(!isIn(shrunk.mesh, {1.5, 0, 0}));
}

BOOST_AUTO_TEST_CASE(a_part_that_faces_inwards_shrinks_alike) {
    const ShrunkPart shrunk = shrink(reversed(box({3, 2, 1})), {0.25, 0.05});
    BOOST_TEST(isIn(shrunk.mesh, {0, 0, 0}));
    BOOST_TEST(boundingBox(shrunk.mesh).max().x() < 2.751);
}

BOOST_AUTO_TEST_CASE(threads_and_scenes_shrink_as_promised) {
    for (const char* name : {"bracket/bracket.stl", "puzzle/puzzle_part.obj"}) {
        const Mesh part = loadMesh(std::string(CLEARWAY_DATA_DIR) + "/" + name);
        const double diagonal = boundingBox(part).diagonal().norm();
        checkShrunk(part, {0.008 * diagonal, 0.008 * diagonal}, inForm(60, 20));
        if (isFullRun()) checkShrunk(part, {0.002 * diagonal, 0.0004 * diagonal}, 60);
    }
}

/// The sides of a prism from z = -1 to 1, whose outline turns left. The lower outline's vertices come first.
Mesh prismSides(const std::vector<Eigen::Vector2d>& outline) {
    Mesh mesh;
    for (const double z : {-1.0, 1.0}) {
        for (const auto& p : outline) mesh.vertices.push_back({p.x(), p.y(), z});
    }
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t next = (k + 1) % n;
        mesh.triangles.push_back({k, next, n + next});
        mesh.triangles.push_back({k, n + next, n + k});
    }
    return mesh;
}

/// A prism from z = -1 to z = 1 whose ends are these triangles.
Mesh prism(const std::vector<Eigen::Vector2d>& outline, const std::vector<TriangleIndices>& end) {
    Mesh mesh = prismSides(outline);
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const auto& [a, b, c] : end) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({n + a, n + b, n + c});
    }
    return mesh;
}

/// Two thick blocks with a web between them, in one surface: a prism whose outline is an H on its side.
Mesh blocksWithWeb(double webThickness) {
    const double w = 0.5 * webThickness;
    const std::vector<Eigen::Vector2d> outline{{-3, -1}, {-1, -1}, {-1, -w}, {1, -w}, {1, -1}, {3, -1},
                                               {3, 1},   {1, 1},   {1, w},   {-1, w}, {-1, 1}, {-3, 1}};
    Mesh mesh = prismSides(outline);
    const std::uint32_t n = 12;
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({a, d, c});
        mesh.triangles.push_back({n + a, n + b, n + c});
        mesh.triangles.push_back({n + a, n + c, n + d});
    };
    quad(0, 1, 2, 11), quad(11, 2, 9, 10), quad(2, 3, 8, 9), quad(3, 4, 5, 8), quad(5, 6, 7, 8);
    // The outline's corners 2 and 9 split block sides, so that no edge has a corner within it.
    mesh.triangles.erase(mesh.triangles.end() - 20, mesh.triangles.end());
    const auto fan = [&](const std::vector<std::uint32_t>& corners) {
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            mesh.triangles.push_back({corners[0], corners[i + 1], corners[i]});
            mesh.triangles.push_back({n + corners[0], n + corners[i], n + corners[i + 1]});
        }
    };
    fan({0, 1, 2, 9, 10, 11});
    fan({2, 3, 8, 9});
    fan({5, 6, 7, 8, 3, 4});
    return named(mesh, "blocks");
}

BOOST_AUTO_TEST_CASE(what_shrinking_leaves_out_is_named) {
    const ShrinkOptions options{0.2, 0.05};
    BOOST_TEST(shrink(blocksWithWeb(1), options).leftOut.empty());
    const std::vector<std::string> cut = shrink(blocksWithWeb(0.3), options).leftOut;
    BOOST_REQUIRE(!cut.empty());
    BOOST_TEST(cut[0] == "shrinking cuts through 'blocks'");
    const Mesh pinAndBlock =
        both(named(box({2, 2, 2}), "block"), named(translated(box({0.1, 0.1, 1}), {5, 0, 0}), "pin"));
    const std::vector<std::string> lost = shrink(pinAndBlock, options).leftOut;
    BOOST_REQUIRE(lost.size() == 1u);
    BOOST_TEST(lost[0] == "nothing is left of 'pin'");
    // One piece falls apart and another one vanishes, which leaves as many pieces as there were.
    const Mesh blocksAndPin =
        named(joined(blocksWithWeb(0.3), translated(box({0.1, 0.1, 1}), {9, 0, 0})), "blocks and pin");
    const std::vector<std::string> both = shrink(blocksAndPin, options).leftOut;
    BOOST_REQUIRE(both.size() >= 2u);
    BOOST_TEST(both[0] == "nothing is left of 1 of the 2 pieces of 'blocks and pin'");
    BOOST_TEST(both[1] == "shrinking cuts through 1 of the 2 pieces of 'blocks and pin'");
}

/// A surface through squares one above another, and its two ends.
Mesh throughSquares(const std::vector<std::pair<double, double>>& halvesAndHeights) {
    Mesh mesh;
    for (const auto& [half, z] : halvesAndHeights) {
        for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
            mesh.vertices.push_back({x, y, z});
    }
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 4);
    for (std::uint32_t level = 0; level < last; level += 4) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t a = level + k, b = level + (k + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
    }
    mesh.triangles.push_back({0, 2, 1});
    mesh.triangles.push_back({0, 3, 2});
    mesh.triangles.push_back({last, last + 1, last + 2});
    mesh.triangles.push_back({last, last + 2, last + 3});
    return mesh;
}

BOOST_AUTO_TEST_CASE(something_thin_is_named_with_its_place) {
    const std::vector<std::string> fin =
        shrink(named(throughSquares({{1, 0}, {1, 2}, {0.1, 2}, {0.1, 5}}), "finned"), {0.2, 0.05}).leftOut;
    BOOST_REQUIRE(fin.size() == 1u);
    BOOST_TEST(fin[0].find("'finned' is too thin at (") == 0u);
    // The bottom of a tray, two triangles whose corners and centres are near its rim.
    const std::vector<std::string> bottom =
        shrink(named(throughSquares({{5, 0}, {5, 3}, {3, 3}, {3, 0.6}}), "tray"), {0.5, 0.5}).leftOut;
    BOOST_REQUIRE(bottom.size() == 1u);
    BOOST_TEST(bottom[0].find("'tray' is too thin at (") == 0u);
}

BOOST_AUTO_TEST_CASE(parts_without_an_inside_and_wrong_lengths_are_refused) {
    const auto has = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };
    Mesh open = named(box({1, 1, 1}), "lid");
    open.triangles.pop_back();
    open.components[0].triangleCount = 11;
    BOOST_TEST(has(refusal(open, {0.1, 0.1}), "'lid' encloses nothing: 3 open edges"));
    Mesh crossed = named(box({1, 1, 1}, 4), "p");  // one corner of the lattice pulled through the far side
    for (Vector3& v : crossed.vertices) {
        if (v == Vector3(1, 0, 0)) v.x() = -3;
    }
    BOOST_TEST(has(refusal(crossed, {0.1, 0.1}), "passes through itself"));
    BOOST_TEST(has(refusal(box({1, 1, 1}), {1.5, 0.1}), "which leaves nothing of the part"));
    BOOST_TEST(has(refusal(box({1, 1, 1}), {0, 0.1}), "overlap is 0, expected a finite number above 0"));
    BOOST_TEST(has(refusal(box({1, 1, 1}), {0.1, -1}), "overlap.tolerance is -1, expected"));
}

/// An upright plus sign of two boxes, one component or two, and its outside as one surface.
Mesh plusOfBoxes(bool isOneComponent) {
    const Mesh across = named(box({3, 1, 1}), "across"), up = named(box({1, 3, 1}), "up");
    return isOneComponent ? named(joined(across, up), "plus") : both(across, up);
}
Mesh plusOutline() {
    Mesh mesh = prismSides({{-3, -1},
                            {-1, -1},
                            {-1, -3},
                            {1, -3},
                            {1, -1},
                            {3, -1},
                            {3, 1},
                            {1, 1},
                            {1, 3},
                            {-1, 3},
                            {-1, 1},
                            {-3, 1}});
    for (const auto& [a, b, c, d] : std::vector<std::array<std::uint32_t, 4>>{
             {0, 1, 10, 11}, {1, 4, 7, 10}, {2, 3, 4, 1}, {4, 5, 6, 7}, {10, 7, 8, 9}}) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
        mesh.triangles.insert(mesh.triangles.end(), {{12 + a, 12 + b, 12 + c}, {12 + a, 12 + c, 12 + d}});
    }
    return mesh;
}

BOOST_AUTO_TEST_CASE(only_the_outside_of_components_that_meet_counts) {
    Random random(5);
    const Pose turned{random.rotation(), {1, -2, 3}};
    const ShrinkOptions options{0.3, isFullRun() ? 0.2 : 0.4};
    const auto check = [&](const Mesh& part, const Mesh& outside) {
        for (const Pose& pose : isFullRun() ? std::vector<Pose>{{}, turned} : std::vector<Pose>{turned}) {
            BOOST_TEST_CONTEXT("component " << part.components.size() << " z " << pose.translation.z()) {
                const ShrunkPart shrunk = shrink(transformed(part, pose), options);
                checkShrunk(shrunk, transformed(outside, pose), 100);
                BOOST_TEST(shrunk.leftOut.empty());
                for (const std::uint32_t t : shrunk.partTriangles) BOOST_REQUIRE(t < part.triangles.size());
            }
        }
    };
    const Mesh cube = box({1, 1, 1}), two = translated(box({2, 1, 1}), {1, 0, 0});
    check(both(named(cube, "a"), named(translated(cube, {2, 0, 0}), "b")), two);         // face on face
    check(both(named(cube, "a"), named(translated(cube, {2 + 1e-7, 0, 0}), "b")), two);  // a gap of rounding
    check(joined(box({3, 3, 3}), cube), box({3, 3, 3}));                                 // one in the other
    check(both(named(cube, "a"), named(cube, "b")), cube);                               // one twice
    check(both(named(two, "a"), named(reversed(translated(cube, {1, 0, 0})), "b")),
          two);  // one faces inwards
    check(plusOfBoxes(true), plusOutline());
    check(plusOfBoxes(false), plusOutline());
    const Mesh shell = named(joined(box({3, 3, 3}), reversed(box({2, 2, 2}))), "shell");
    check(both(shell, named(box({2, 2, 2}), "filling")), box({3, 3, 3}));  // a filled cavity
    check(both(shell, named(cube, "loose")), joined(shell, cube));         // a body loose in a cavity
}

/// A block of 18 x 6 whose upper left part hovers over the lower one: a slot of that height from x = -5 to -1.
Mesh slotted(double height) {
    return prism({{-9, -3}, {9, -3}, {9, 0}, {-5, 0}, {-5, height}, {-1, height}, {-1, 3}, {-9, 3}},
                 {{0, 3, 7}, {0, 1, 3}, {1, 2, 3}, {3, 4, 7}, {4, 5, 7}, {5, 6, 7}});
}

BOOST_AUTO_TEST_CASE(a_slot_that_something_fills_is_no_wall_in_the_part) {
    const double height = 0.01;  // less than the fineness: in front of the slot's wall is the part itself
    const Mesh shim = named(translated(box({2, 0.5 * height, 1}), {-3, 0.5 * height, 0}), "shim");
    Random random(3);
    for (const Pose& pose : {Pose{}, Pose{random.rotation(), {1, -2, 3}}}) {
        const SurfaceDepth filled(transformed(both(named(slotted(height), "block"), shim), pose), 0.1);
        Workspace workspace;
        for (const double x : {-4.9, -4.0, -3.0, -2.0}) {
            for (const double y : {-0.3, 0.5 * height, 0.3}) {
                const double depth = filled.at(pose * Vector3(x, y, 0), workspace).depth;
                BOOST_TEST_CONTEXT("x " << x << " y " << y) {
                    BOOST_TEST(depth > 1 - filled.slack());
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_surface_that_touches_itself_along_edges_shrinks_as_promised) {
    const Mesh touching = named(joined(box({1, 1, 1}), translated(box({1, 1, 1}), {2, 2, 0})), "two");
    checkShrunk(touching, {0.2, 0.1});
    const ShrunkPart shrunk = shrink(touching, {0.2, 0.1});
    BOOST_TEST(shrunk.leftOut == std::vector<std::string>{"shrinking cuts through 'two'"},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_wall_between_boxes_of_one_surface_is_not_outside) {
    // Both sides of the wall are in the mesh, with different diagonals, so that they are no duplicates.
    const Matrix3 turn = Eigen::AngleAxisd(std::acos(-1.0) / 2, Vector3::UnitX()).toRotationMatrix();
    Mesh turned = transformed(box({1, 1, 1}), {turn, {2, 0, 0}});
    for (Vector3& vertex : turned.vertices) vertex = vertex.array().round();
    const Mesh walled = joined(box({1, 1, 1}), turned);
    const SurfaceDepth surface(walled, 0.1);
    Workspace workspace;
    for (const double x : {0.5, 0.9, 1.0, 1.1, 1.5}) {
        const double depth = surface.at({x, 0.1, 0}, workspace).depth;
        BOOST_TEST(depth > 0.9 - surface.slack());
        BOOST_TEST(depth < 0.9 + 1e-9);
    }
    checkShrunk(shrink(walled, {0.3, 0.3}), translated(box({2, 1, 1}), {1, 0, 0}), 40);
}

BOOST_AUTO_TEST_CASE(a_surface_below_its_own_overhang_stays_outside) {
    // The centre of a floor's triangle lies below the overhang; a bolt makes this a part of components that meet.
    Mesh block = slotted(1e-3);
    for (const std::uint32_t v : {5, 6, 13, 14}) block.vertices[v].x() = 1;
    const Mesh bolt = named(translated(box({0.5, 0.5, 0.5}), {-9, -1, 0}), "bolt");
    const SurfaceDepth surface(both(named(block, "block"), bolt), 0.1);
    Workspace workspace;
    for (const double x : {1.1, 2.0, 8.0}) {
        for (const double z : {-0.6, 0.6}) {
            const double depth = surface.at({x, -0.3, z}, workspace).depth;
            BOOST_TEST(depth < 0.3 + 1e-9);
            BOOST_TEST(depth > 0.3 - surface.slack());
        }
    }
}

BOOST_AUTO_TEST_CASE(a_surface_that_runs_into_itself_along_its_own_planes_is_refused_at_once) {
    // A frame whose two ends overlap: all their sides lie in common planes, so that no side passes through another.
    const Mesh frame = prism({{3.5, 6},
                              {0, 6},
                              {0, 0},
                              {6, 0},
                              {6, 6},
                              {2.5, 6},
                              {2.5, 4},
                              {4, 4},
                              {4, 2},
                              {2, 2},
                              {2, 4},
                              {3.5, 4}},
                             {{0, 1, 10},
                              {0, 10, 11},
                              {1, 2, 9},
                              {1, 9, 10},
                              {2, 3, 8},
                              {2, 8, 9},
                              {3, 4, 7},
                              {3, 7, 8},
                              {4, 5, 6},
                              {4, 6, 7}});
    const std::string message = refusal(frame, {0.05, 0.05});
    BOOST_TEST(message.find("it is unclear what is inside the part") != std::string::npos, message);
}

BOOST_AUTO_TEST_CASE(a_shell_that_encloses_nothing_is_no_wall_in_the_part) {
    Mesh flat;
    flat.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    flat.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const Mesh block = box({3, 3, 3});
    for (const Vector3& place : {Vector3(0, 0, 0), Vector3(6, 0, 0)}) {
        checkShrunk(shrink(named(joined(block, translated(flat, place)), "p"), {0.3, 0.2}), block, 60);
    }
}

BOOST_AUTO_TEST_CASE(components_that_meet_are_as_deep_as_their_outside) {
    const double fineness = 0.01;
    const SurfaceDepth surface(plusOfBoxes(false), fineness);
    const Mesh outside = plusOutline();
    BOOST_TEST(surface.bodyNames().size() == 1u);
    Random random(3);
    Workspace workspace;
    for (int n = 0; n < 300; ++n) {
        const Vector3 p = random.inBox(3.2);
        const double depth = surface.at(p, workspace).depth, truth = depthOf(outside, p);
        BOOST_REQUIRE(depth >= truth - surface.slack());
        BOOST_REQUIRE(depth <= truth + 1e-9);
    }
}

/// Whether some component is around the point, by brute force.
bool isInSome(const Mesh& part, const Vector3& point) {
    return std::any_of(part.components.begin(), part.components.end(), [&](const Component& component) {
        return std::abs(windingBySolidAngles(part, component, point)) > 0.5;
    });
}

BOOST_AUTO_TEST_CASE(depths_in_scenes_whose_parts_have_components_that_meet_end_at_their_outside) {
    std::vector<std::string> names = {"tunnel-console-small/tunnel-console_part.obj"};
    if (isFullRun()) names.push_back("apartment/apartment_part.obj");
    for (const std::string& name : names) {
        const Mesh part = loadMesh(std::string(CLEARWAY_DATA_DIR) + "/" + name);
        const double fineness = 0.001 * boundingBox(part).diagonal().norm();
        const SurfaceDepth surface(part, fineness);
        BOOST_TEST(surface.slack() > 0);
        BOOST_TEST(surface.bodyNames().size() < part.components.size());
        Random random(9);
        Workspace workspace;
        for (int n = 0; n < (isFullRun() ? 300 : 1);) {
            const auto& t = part.triangles[std::size_t(random.below(int(part.triangles.size())))];
            const Vector3 p = part.vertices[t[0]] + 10 * fineness * random.inBox(1);
            const SurfaceDepth::Place place = surface.at(p, workspace);
            if (place.depth < 3 * fineness) continue;
            ++n;
            const auto isAway = [&](const Vector3& q) {
                return !isInSome(part, q) && bruteForceDistance(pointMeshAt(q), part, {}).distance > fineness;
            };
            for (int k = 0; k < 10; ++k)
                BOOST_REQUIRE(!isAway(p + place.depth / std::sqrt(3) * random.inBox(1)));
            const Corners3 c = surface.corners(place.triangle);
            Mesh triangle;
            triangle.vertices.assign(c.begin(), c.end());
            triangle.triangles = {{0, 1, 2}};
            const DistanceResult found =
                distance(Model::build(pointMeshAt(p)), Model::build(triangle), {}, {}, workspace);
            const Vector3 end = found.witness->pointOnEnvironment;
            bool hasOutside = false;
            for (int k = 0; k < 400 && !hasOutside; ++k) {
                hasOutside = !isInSome(part, end + surface.slack() * random.inBox(1));
            }
            BOOST_REQUIRE(hasOutside);
        }
    }
}

BOOST_AUTO_TEST_CASE(what_would_take_too_long_is_refused_before_the_work) {
    const Mesh part = torus(4, 1, 8);  // concave within
    BOOST_TEST(refusal(part, {0.1, 1e-7})
                   .find("million points in the part, expected an overlap.tolerance of at least") !=
               std::string::npos);
    Mesh inwards = part;
    for (auto& triangle : inwards.triangles) std::swap(triangle[0], triangle[1]);
    BOOST_TEST(refusal(inwards, {0.1, 1e-7}) == refusal(part, {0.1, 1e-7}));
    BOOST_TEST(shrink(box({1, 1, 1}), {0.1, 1e-7}).mesh.triangles.size() >
               0u);  // nothing of a box is round within
}

BOOST_AUTO_TEST_CASE(shrinking_ends_when_stopped) {
    int asked = 0;
    ShrinkOptions options{0.3, 0.05};
    options.isStopped = [&] { return ++asked > 3; };
    BOOST_CHECK_THROW(shrink(torus(4, 1, 8), options), ShrinkStopped);
    BOOST_TEST(asked < 10);
}

BOOST_AUTO_TEST_CASE(a_shrunk_part_is_the_same_each_time) {
    const Mesh part = torus(4, 1, 8);
    const ShrunkPart a = shrink(part, {0.3, 0.2}), b = shrink(part, {0.3, 0.2});
    BOOST_TEST((a.mesh.triangles == b.mesh.triangles));
    BOOST_TEST((a.mesh.vertices == b.mesh.vertices));
}

BOOST_AUTO_TEST_CASE(depths_are_those_of_brute_force) {
    Random random(11);
    Workspace workspace;
    for (const Mesh& part : {box({1, 2, 3}), torus(4, 1, 8), tube(1, 2, 3, 9), reversed(sphere(2, 8))}) {
        const SurfaceDepth surface(part, 0.01);
        const double half = 1.2 * boundingBox(part).max().maxCoeff();
        for (int n = 0; n < 200; ++n) {
            const Vector3 p = random.inBox(half);
            const SurfaceDepth::Place found = surface.at(p, workspace);
            BOOST_REQUIRE(std::abs(found.depth - depthOf(part, p)) < 1e-9);
            BOOST_REQUIRE(std::abs(distanceToTriangle(p, surface.corners(found.triangle)) -
                                   std::abs(found.depth)) < 1e-9);
        }
    }
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
