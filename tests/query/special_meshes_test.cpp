// Meshes at the edge of what a mesh can be: one triangle, segments and points, copies on each other, one
// inside another.
#define BOOST_TEST_MODULE query_special_meshes
#include <boost/test/unit_test.hpp>

#include "support/each_target.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"

using namespace clearway;
using namespace clearway::testing;

namespace {

void checkBothWidths(const QueryCase& queryCase) {
    for (const int width : nodeWidths()) {
        BuildOptions options;
        options.nodeWidth = width;
        const ModelPair models = buildPair(queryCase, options);
        Workspace workspace;
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const Pose& pose = queryCase.poses[i];
            BOOST_TEST_CONTEXT(queryCase.name << ", width " << width << ", pose " << i) {
                const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
                checkDistance(result, queryCase, pose, queryCase.answers[i]);
                BOOST_TEST(collides(models.part, models.environment, pose, workspace) == result.collides());
                if (queryCase.answers[i].distance == 0) BOOST_TEST(result.collides());
            }
        }
    }
}

std::vector<Pose> posesWithin(Random& random, double halfSide, int n) {
    std::vector<Pose> poses;
    for (int i = 0; i < n; ++i) poses.push_back(random.pose(halfSide));
    return poses;
}

Pose shiftedBy(double x, double y, double z) {
    return {Matrix3::Identity(), {x, y, z}};
}

}  // namespace

BOOST_DATA_TEST_CASE(one_triangle_is_a_mesh, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(1);
    const Mesh triangle = randomSoup(random, 1, 1, 5);
    const Mesh many = cadAssembly(random, 30);
    checkBothWidths(makeCase("triangle and triangle", triangle, randomSoup(random, 1, 1, 5),
                             posesWithin(random, 12, 12)));
    checkBothWidths(makeCase("triangle and many", triangle, many, posesWithin(random, 40, 12)));
    checkBothWidths(makeCase("many and triangle", many, triangle, posesWithin(random, 40, 12)));
}

BOOST_DATA_TEST_CASE(segments_and_points_count, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(2);
    const auto degenerate = [&](int triangles, double halfSide) {
        Mesh mesh = randomSoup(random, triangles, halfSide, 6);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            TriangleIndices& t = mesh.triangles[i];
            if (i % 3 == 0) t[2] = t[1];         // an edge of length 0
            if (i % 3 == 1) t[1] = t[2] = t[0];  // a point
            if (i % 3 == 2) {                    // three corners in a row
                mesh.vertices[t[2]] = (mesh.vertices[t[0]] + mesh.vertices[t[1]]) / 2;
            }
        }
        return mesh;
    };
    const Mesh part = degenerate(40, 10), environment = degenerate(150, 40);
    checkBothWidths(makeCase("segments and segments", part, environment, posesWithin(random, 40, 10)));
    checkBothWidths(
        makeCase("segments and faces", part, cadAssembly(random, 60), posesWithin(random, 50, 10)));
}

BOOST_DATA_TEST_CASE(a_mesh_collides_with_its_copy_on_it, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(3);
    for (const Mesh& mesh :
         {cadAssembly(random, 50), torus(20, 5, 8), box({3, 4, 5}, 3), randomSoup(random, 60, 20, 9)}) {
        const QueryCase copies =
            makeCase("copies", mesh, mesh,
                     {Pose{}, shiftedBy(1e-9, 0, 0), shiftedBy(0, 0, 1e-3), shiftedBy(500, 0, 0)});
        BOOST_TEST(copies.answers[0].distance == 0.0);
        checkBothWidths(copies);
    }
}

BOOST_DATA_TEST_CASE(flat_plates_keep_their_gap, eachTarget(), target) {
    // Every pair of facing triangles is a tie.
    const UsingTarget using_(target);
    Random random(4);
    const Mesh plate = randomTerrain(random, 10, 100, 0);
    const Mesh larger = randomTerrain(random, 14, 300, 0);
    const QueryCase plates = makeCase("plates", plate, larger,
                                      {shiftedBy(3, 4, 1), shiftedBy(3, 4, -1e-3), shiftedBy(3, 4, 1e-9),
                                       shiftedBy(3, 4, 0), shiftedBy(230, 0, 0), shiftedBy(0, 100, 1e-12)});
    BOOST_TEST(plates.answers[0].distance == 1.0);
    BOOST_TEST(plates.answers[4].distance == 30.0, boost::test_tools::tolerance(1e-15));
    checkBothWidths(plates);
}

BOOST_DATA_TEST_CASE(surfaces_inside_one_another_are_apart, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(5);
    const Mesh shell = joined(box({10, 10, 10}, 4), box({9, 9, 9}, 4));
    const std::vector<Pose> poses = {Pose{},
                                     shiftedBy(3, 2, 1),
                                     {random.rotation(), {0.5, 0, 0}},
                                     shiftedBy(8, 0, 0),
                                     shiftedBy(7.5, 0, 0)};
    const QueryCase inside = makeCase("part in a shell", sphere(1.5, 8), shell, poses);
    BOOST_TEST(inside.answers[0].distance == 7.5, boost::test_tools::tolerance(1e-15));
    checkBothWidths(inside);
    checkBothWidths(makeCase("obstacle in the part", shell, sphere(1.5, 8), poses));
}

BOOST_DATA_TEST_CASE(interlocked_rings_and_pegs_are_apart_until_they_touch, eachTarget(), target) {
    const UsingTarget using_(target);
    const Matrix3 upright = Eigen::AngleAxisd(1.5707963267948966, Vector3::UnitX()).toRotationMatrix();
    const Mesh ring = torus(20, 4, 12);
    const QueryCase rings = makeCase(
        "interlocked rings", ring, ring,
        {{upright, {20, 0, 0}}, {upright, {14, 0, 0}}, {upright, {12, 0.5, 0.5}}, {upright, {5, 0, 0}}});
    BOOST_TEST(rings.answers[0].distance > 8.0);
    BOOST_TEST(rings.answers[3].distance == 0.0);
    checkBothWidths(rings);
    for (const double clearance : {1e-3, 1e-6, 1e-9}) {
        const Mesh hole = tube(5, 8, 20, 32), peg = tube(3, 5 - clearance, 40, 32);
        checkBothWidths(makeCase("peg in a hole", peg, hole,
                                 {Pose{}, shiftedBy(0, 0, 5), shiftedBy(clearance / 3, 0, 1)}));
    }
}

BOOST_DATA_TEST_CASE(triangles_about_one_centre_are_told_apart, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(6);
    Mesh star;  // every centroid at 0
    for (int i = 0; i < 80; ++i) {
        const Vector3 a = random.inBox(10), b = random.inBox(10);
        const auto first = static_cast<std::uint32_t>(star.vertices.size());
        star.vertices.insert(star.vertices.end(), {a, b, Vector3(-a - b)});
        star.triangles.push_back({first, first + 1, first + 2});
    }
    checkBothWidths(makeCase("star", star, star, posesWithin(random, 40, 10)));
}

BOOST_DATA_TEST_CASE(duplicates_and_flipped_windings_change_nothing, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(7);
    const Mesh part = torus(10, 3, 6), environment = cadAssembly(random, 40);
    const std::vector<Pose> poses = posesWithin(random, 40, 8);
    const QueryCase doubled = makeCase("doubled", shuffled(random, joined(part, part)),
                                       shuffled(random, joined(environment, environment)), poses);
    const MeshOracle single(part, environment);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        BOOST_TEST(doubled.answers[i].distance == single.distance(poses[i]).distance,
                   boost::test_tools::tolerance(1e-14));
    }
    checkBothWidths(doubled);
}
