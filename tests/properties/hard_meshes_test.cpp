// The hard cases of meshes, one test per case (see hard_cases.md), on every instruction set, with every leaf
// split and node width, in all three queries.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/each_target.h"
#include "support/exact_check.h"
#include "support/full_run.h"
#include "support/hard_triangles.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(hard_meshes_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 137;
constexpr double kPi = 3.14159265358979323846;

Pose shiftedBy(double x, double y, double z) {
    return {Matrix3::Identity(), {x, y, z}};
}

/// Checks all queries and returns the distance.
double checkAt(const std::string& name, const Mesh& part, const Mesh& environment, const Pose& pose) {
    const ExactCase exact = exactCase(name + ", seed " + std::to_string(kSeed), part, environment, pose);
    checkEveryBuild(exact);
    return static_cast<double>(exact.truth.rounded());
}

void checkPoses(const std::string& name, const Mesh& part, const Mesh& environment,
                const std::vector<Pose>& poses) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        checkAt(name + ", pose " + std::to_string(i), part, environment, poses[i]);
    }
}

std::vector<Pose> posesWithin(Random& random, double halfSide, int n) {
    std::vector<Pose> poses;
    for (int i = 0; i < n; ++i) poses.push_back(random.pose(halfSide));
    return poses;
}

Mesh flipped(Mesh mesh) {
    for (TriangleIndices& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// Degenerate triangles in turn: a segment, a point, three corners in a row.
Mesh segmentsAndPoints(Random& random, int triangles, double halfSide) {
    Mesh mesh = randomSoup(random, triangles, halfSide, 6);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        TriangleIndices& t = mesh.triangles[i];
        if (i % 3 == 0) t[2] = t[1];
        if (i % 3 == 1) t[1] = t[2] = t[0];
        if (i % 3 == 2) mesh.vertices[t[2]] = (mesh.vertices[t[0]] + mesh.vertices[t[1]]) / 2;
    }
    return mesh;
}

BOOST_AUTO_TEST_CASE(case_04_parallel_plates_of_many_triangles_keep_their_gap) {
    Random random(kSeed);
    const Mesh plate = randomTerrain(random, 5, 100, 0), larger = randomTerrain(random, 7, 300, 0);
    for (const double gap : {1.0, 1e-3, 1e-9, 0.0}) {
        BOOST_TEST(checkAt("plates", plate, larger, shiftedBy(3, 4, gap)) == gap);
        BOOST_TEST(checkAt("plates", plate, larger, shiftedBy(3, 4, -gap)) == gap);
    }
    BOOST_TEST(checkAt("in one plane", plate, larger, shiftedBy(230, 0, 0)) == 30.0);
}

BOOST_AUTO_TEST_CASE(case_18_a_mesh_touches_its_copy_on_it) {
    Random random(kSeed);
    for (const Mesh& mesh : {torus(20, 5, 4), box({3, 4, 5}, 3), randomSoup(random, 60, 20, 9)}) {
        BOOST_TEST(checkAt("copies", mesh, mesh, Pose{}) == 0.0);
        checkPoses("copies", mesh, mesh,
                   {shiftedBy(1e-9, 0, 0), shiftedBy(0, 0, 1e-3), shiftedBy(500, 0, 0)});
    }
}

BOOST_AUTO_TEST_CASE(case_24_segments_25_points_and_26_edges_of_no_length_count_in_meshes) {
    Random random(kSeed);
    const Mesh part = segmentsAndPoints(random, 30, 10), environment = segmentsAndPoints(random, 60, 30);
    checkPoses("segments and segments", part, environment, posesWithin(random, 30, 4));
    checkPoses("segments and faces", part, plateWithHole(30, 2, 6, 10), posesWithin(random, 20, 4));
}

BOOST_AUTO_TEST_CASE(case_25_meshes_that_are_both_one_point_have_any_scale) {
    const auto point = [](const Vector3& p) { return meshOf({p, p, p}); };
    Random random(kSeed);
    for (const int exponent : {-900, -500, -100, -60, 0, 60, 100, 500, 900}) {
        const double scale = std::ldexp(1.0, exponent);
        const Vector3 place = scale * random.inBox(1), far = scale * Vector3(2, 3, 6);
        checkAt("points", point(place), point(scale * random.inBox(1)), Pose{});
        BOOST_TEST(checkAt("points", point(Vector3::Zero()), point(far), Pose{}) == 7 * scale);
        BOOST_TEST(checkAt("points", point(far), point(far), Pose{}) == 0.0);
        checkAt("points", point(place), point(place + 1e-12 * far), Pose{});
    }
}

BOOST_AUTO_TEST_CASE(case_31_meshes_of_tiny_size_are_answered_like_any_or_refused_by_name) {
    Random random(kSeed);
    for (const double unit : {0x1p-1074, 0x1p-1060, 0x1p-1022, 0x1p-1000, 0x1p-985}) {
        const auto pointIn = [&](int end) {
            return Vector3(random.below(end), random.below(end), random.below(end));
        };
        const auto soup = [&](int triangles) {
            Mesh mesh;
            for (int i = 0; i < triangles; ++i) {
                const Vector3 place = pointIn(12);
                mesh = joined(mesh, meshOf({place, place + pointIn(4), place + pointIn(4)}));
            }
            return scaledBy(mesh, unit);
        };
        const Mesh part = soup(6), environment = soup(9);
        for (int draw = 0; draw < 6; ++draw) {
            const Vector3 way = unit * (3 * pointIn(9) - Vector3::Constant(12));
            const Pose pose{Matrix3::Identity(), way};
            if (unit == 0x1p-985) {
                checkAt("tiny", part, environment, pose);
                continue;
            }
            Workspace workspace;
            requireRefusedBy(
                [&] { collides(Model::build(part), Model::build(environment), pose, workspace); },
                {"largest coordinate"});
        }
    }
}

BOOST_AUTO_TEST_CASE(case_32_a_vertex_that_is_not_finite_is_refused) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
        Mesh mesh = box({1, 2, 3}, 2);
        mesh.vertices[mesh.triangles[7][1]].y() = wrong;
        BOOST_CHECK_THROW(Model::build(mesh), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(case_36_tessellated_spheres_at_a_gap) {
    Random random(kSeed);
    const Mesh small = sphere(3, 6), large = sphere(10, 8);
    for (const double gap : {5.0, 1e-1, 1e-3}) {
        const Pose pose{random.rotation(), (13 + gap) * random.direction()};
        const double distance = checkAt("spheres", small, large, pose);
        // Inside the balls, and no deeper below their surface than the middle of a face.
        BOOST_TEST(distance >= gap * (1 - 1e-12));
        BOOST_TEST(distance <= gap + 3 * (1 - std::pow(std::cos(kPi / 12), 2)) +
                                   10 * (1 - std::pow(std::cos(kPi / 16), 2)));
    }
}

BOOST_AUTO_TEST_CASE(case_37_boxes_at_any_gap) {
    const Vector3 a(1, 2, 3), b(4, 5, 6);
    for (const Vector3& place :
         {Vector3(5 + 1e-9, 0, 0), Vector3(5.5, 7.25, 0), Vector3(0.25, -9, 10), Vector3(5, 7, 9),
          Vector3(-6, -8, -11), Vector3(0, 7 + 1e-3, 0), Vector3(5, 0.5, 0.5), Vector3(4.5, 0, 0)}) {
        const Vector3 gap = (place.cwiseAbs() - a - b).cwiseMax(0);
        const double distance =
            checkAt("boxes", box(a, 1), box(b, 2), shiftedBy(place.x(), place.y(), place.z()));
        BOOST_TEST(std::abs(distance - gap.norm()) <= 16 * kUnitRoundoff * 11);
    }
}

BOOST_AUTO_TEST_CASE(case_38_a_peg_in_a_hole_has_its_clearance) {
    constexpr int kSides = 12;
    for (const double clearance : {1e-3, 1e-6, 1e-9}) {
        const Mesh hole = tube(5, 8, 20, kSides), peg = tube(3, 5 - clearance, 40, kSides);
        const double distance = checkAt("peg", peg, hole, shiftedBy(0, 0, 2));
        BOOST_TEST(std::abs(distance - clearance * std::cos(kPi / kSides)) <= 64 * kUnitRoundoff * 20);
        checkAt("peg off the axis", peg, hole, shiftedBy(clearance / 3, 0, 1));
        BOOST_TEST(checkAt("peg against the wall", peg, hole, shiftedBy(2 * clearance, 0, 1)) == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(case_39_interlocked_tori_and_a_chain_of_them) {
    const Matrix3 upright = Eigen::AngleAxisd(kPi / 2, Vector3::UnitX()).toRotationMatrix();
    const Mesh ring = torus(20, 4, 5);
    BOOST_TEST(checkAt("rings", ring, ring, {upright, {20, 0, 0}}) > 6.0);
    checkPoses("rings", ring, ring, {{upright, {14, 0, 0}}, {upright, {12, 0.5, 0.5}}});
    BOOST_TEST(checkAt("rings", ring, ring, {upright, {5, 0, 0}}) == 0.0);
    const Mesh chain = joined(ring, transformed(ring, shiftedBy(40, 0, 0)));
    BOOST_TEST(checkAt("a link between two", ring, chain, {upright, {20, 0, 0}}) > 4.0);
}

BOOST_AUTO_TEST_CASE(case_40_a_part_inside_a_hollow_obstacle_is_apart_from_its_inner_shell) {
    const Mesh shell = joined(box({10, 10, 10}, 2), flipped(box({9, 9, 9}, 2)));
    const Mesh part = box({1.5, 1.5, 1.5}, 2);
    BOOST_TEST(checkAt("in a shell", part, shell, Pose{}) == 7.5);
    BOOST_TEST(checkAt("in a shell", part, shell, shiftedBy(3, 2, 1)) == 4.5);
    BOOST_TEST(checkAt("against the inner shell", part, shell, shiftedBy(7.5, 0, 0)) == 0.0);
    BOOST_TEST(checkAt("through the inner shell", part, shell, shiftedBy(8, 0, 0)) == 0.0);
}

BOOST_AUTO_TEST_CASE(case_41_a_part_inside_a_solid_is_apart_from_its_surface) {
    Random random(kSeed);
    const Mesh solid = box({10, 10, 10}, 3), part = sphere(1.5, 6);
    BOOST_TEST(checkAt("inside", part, solid, Pose{}) >= 8.5);
    BOOST_TEST(checkAt("inside", part, solid, {random.rotation(), {3, 2, 1}}) > 5.0);
}

BOOST_AUTO_TEST_CASE(case_42_an_obstacle_inside_the_part_is_apart_from_its_surface) {
    Random random(kSeed);
    const Mesh part = box({10, 10, 10}, 3), obstacle = sphere(1.5, 6);
    BOOST_TEST(checkAt("around", part, obstacle, Pose{}) >= 8.5);
    BOOST_TEST(checkAt("around", part, obstacle, {random.rotation(), {3, 2, 1}}) > 3.0);
}

BOOST_AUTO_TEST_CASE(case_43_duplicates_and_flipped_windings_change_nothing) {
    Random random(kSeed);
    const Mesh part = torus(10, 3, 4), environment = plateWithHole(40, 2, 6, 8);
    const Mesh doubled = shuffled(random, joined(part, flipped(part)));
    const Mesh turned = shuffled(random, joined(flipped(environment), environment));
    for (const Pose& pose : posesWithin(random, 20, 4)) {
        const ExactDistance once = exactMeshDistance(part, environment, pose);
        BOOST_TEST(once.compare(exactMeshDistance(doubled, turned, pose)) == 0);
        checkAt("doubled", doubled, turned, pose);
        checkAt("flipped", flipped(part), flipped(environment), pose);
    }
}

BOOST_AUTO_TEST_CASE(case_44_one_triangle_is_a_mesh_and_none_is_refused) {
    Random random(kSeed);
    const Mesh triangle = randomSoup(random, 1, 1, 5), many = torus(12, 4, 5);
    checkPoses("triangle and triangle", triangle, randomSoup(random, 1, 1, 5), posesWithin(random, 6, 6));
    checkPoses("triangle and many", triangle, many, posesWithin(random, 20, 4));
    checkPoses("many and triangle", many, triangle, posesWithin(random, 20, 4));
    requireRefusedBy([&] { Model::build(Mesh{}); }, {"0 triangles"});
}

BOOST_AUTO_TEST_CASE(case_45_triangles_about_one_centre_are_told_apart) {
    Random random(kSeed);
    Mesh star;
    for (int i = 0; i < inForm(60, 25); ++i) {
        const Vector3 a = random.inBox(10), b = random.inBox(10);
        star = joined(star, meshOf({a, b, Vector3(-a - b)}));
    }
    checkPoses("star", star, star, posesWithin(random, 30, 4));
    checkPoses("copies of one triangle",
               joined(meshOf({star.vertices[0], star.vertices[1], star.vertices[2]}), star), star,
               posesWithin(random, 30, 2));
}

BOOST_AUTO_TEST_CASE(case_46_volumes_without_width_sides_or_radius) {
    Random random(kSeed);
    const auto onLine = [&](int n) {
        Mesh mesh;
        for (int i = 0; i < n; ++i) {
            const double x = random.below(40), y = random.below(40);
            mesh = joined(mesh, meshOf({Vector3(x, 0, 0), Vector3(y, 0, 0), Vector3(y + 1, 0, 0)}));
        }
        return mesh;
    };
    const Mesh line = onLine(20), flat = randomTerrain(random, 4, 40, 0);
    const Mesh point = meshOf({Vector3(3, 4, 5), Vector3(3, 4, 5), Vector3(3, 4, 5)});
    for (const Mesh* part : {&line, &flat, &point}) {
        for (const Mesh* environment : {&line, &flat, &point}) {
            checkPoses("flat", *part, *environment, {Pose{}, shiftedBy(0, 0.5, 0), random.pose(30)});
        }
    }
    BOOST_TEST(checkAt("line over line", line, line, shiftedBy(0, 3, 4)) == 5.0);
}

BOOST_AUTO_TEST_CASE(case_47_turned_against_each_other_by_next_to_nothing) {
    Random random(kSeed);
    const Mesh part = box({4, 3, 0.5}, 2), environment = box({6, 5, 0.25}, 2);
    for (int power = 1; power <= 9; ++power) {
        const Matrix3 turn = Eigen::AngleAxisd(std::pow(10.0, -power), random.direction()).toRotationMatrix();
        checkPoses("nearly parallel", part, environment,
                   {{turn, {0.5, 0.25, 1}}, {turn, {11, 1, 0.125}}, {turn, {1, 1, 0.75}}});
    }
}

BOOST_AUTO_TEST_CASE(case_48_shared_coordinates_far_from_the_origin) {
    Random random(kSeed);
    for (const double away : {1e3, 1e6, 1e9}) {
        const Pose place{Matrix3::Identity(), away * random.direction()};
        const Mesh part = transformed(box({1, 2, 3}, 2), place);
        const Mesh environment = transformed(torus(12, 3, 5), place);
        checkPoses("far away", part, environment,
                   {shiftedBy(4, 0, 0), shiftedBy(0, 0, 8), place * random.pose(10) * inverse(place)});
        BOOST_TEST(checkAt("touching far away", part, part, shiftedBy(2, 0, 0)) <= 8 * kUnitRoundoff * away);
    }
}

BOOST_AUTO_TEST_SUITE_END()
