// Formats of other projects, which benchmarks read: BYU meshes and the problems of PPL.
#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/byu_mesh.h"
#include "support/ppl_scene.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(other_formats_test)

namespace {

const std::string kTwoParts = "2 4 2 7\n1 1\n2 2\n1 1 1 2 1 1\n1 2 1 1 1 3\n1 2 -3\n1 2 3 -4\n";
const std::string kEnv =
    "Boundary Box [-2:2 ; -3:3 ; -10:10]\n\nMultibodies\n1\n\nPassive\n# yellow\no.g -c(1 1 0 1) 2.5 2 -1  0 "
    "0 0\n";
const std::string kRobot = "1\nr.g Volumetric Rotational\nConnections\n0\n";
const std::string kQuery = "0 1 2 3 0.5 0 1\n0 4 5 6 0 0 0.25\n\n";

/// The text with a piece of it replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

BOOST_AUTO_TEST_CASE(a_byu_mesh_has_its_parts_and_fans_of_its_polygons) {
    const TemporaryFolder folder;
    const Mesh mesh = readByuMesh(folder.write("m.g", kTwoParts));
    BOOST_TEST(mesh.vertices.size() == 4u);
    BOOST_TEST((mesh.vertices[3] == Vector3(1, 1, 3)));
    const std::vector<TriangleIndices> expected{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}};
    BOOST_TEST((mesh.triangles == expected));
    BOOST_REQUIRE(mesh.components.size() == 2u);
    BOOST_TEST(mesh.components[1].name == "part_2");
    BOOST_TEST(mesh.components[1].firstTriangle == 1u);
    BOOST_TEST(mesh.components[1].triangleCount == 2u);
}

BOOST_AUTO_TEST_CASE(a_damaged_byu_mesh_is_refused_by_line_and_value) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& from, const std::string& to,
                             const std::vector<std::string>& words) {
        const std::string file = folder.write("m.g", changed(kTwoParts, from, to));
        requireRefusedBy([&] { readByuMesh(file); }, words);
    };
    refused("2 4 2 7", "2 x 2 7", {"m.g:1:", "'x'", "the number of vertices"});
    refused("2 4 2 7", "2 4000000000 2 7", {"'4000000000'", "the number of vertices"});
    refused("1 2 -3", "1 5 -3", {"m.g:6:", "'5'", "a corner, from 1"});
    refused("1 2 -3", "1 0 -3", {"a corner is 0"});
    refused("1 2 3 -4", "1 2 3 4", {"the file ends", "a corner"});
    refused("1 2 3 -4", "1 2 -4", {"6 corners"});
    refused("2 2\n", "3 3\n", {"m.g:3:", "'3'", "the part's first polygon"});
}

BOOST_AUTO_TEST_CASE(a_ppl_scene_has_its_bounds_files_and_poses) {
    const TemporaryFolder folder;
    const std::string env = folder.write("a.env", kEnv), query = folder.write("a.query", kQuery);
    const PplScene scene = readPplScene(env, folder.write("a.robot", kRobot), query);
    BOOST_TEST(scene.robotFile == folder.file("r.g"));
    BOOST_TEST(scene.obstacleFile == folder.file("o.g"));
    BOOST_TEST((scene.obstaclePosition == Vector3(2.5, 2, -1)));
    BOOST_TEST((scene.bounds.min() == Vector3(-2, -3, -10)));
    BOOST_TEST((scene.start.position == Vector3(1, 2, 3)));
    // Half a turn about z follows a quarter turn about x.
    const Matrix3 start = scene.start.rotation.toRotationMatrix();
    BOOST_TEST((start * Vector3::UnitY() - Vector3::UnitZ()).norm() < 1e-12);
    BOOST_TEST((start * Vector3::UnitX() + Vector3::UnitX()).norm() < 1e-12);
    const std::string both = folder.write("both.env", "Active\n" + kRobot + kEnv);
    BOOST_TEST(readPplScene(both, both, query).robotFile == folder.file("r.g"));
}

BOOST_AUTO_TEST_CASE(ppl_scenes_of_other_kinds_are_refused) {
    const TemporaryFolder folder;
    const std::string query = folder.write("a.query", kQuery), robot = folder.write("a.robot", kRobot);
    const auto refused = [&](const std::string& env, const std::string& robotFile,
                             const std::string& queryFile, const std::vector<std::string>& words) {
        const std::string file = folder.write("b.env", env);
        requireRefusedBy([&] { readPplScene(file, robotFile, queryFile); }, words);
    };
    refused(changed(kEnv, "-3:3", "3:-3"), robot, query, {"Boundary Box [a:b ; c:d ; e:f] with a < b"});
    refused(changed(kEnv, "Boundary Box", "Boundary Sphere"), robot, query, {"b.env:1: "});
    refused(changed(kEnv, "0 0 0\n", "20 10 40\n"), robot, query, {"three angles of 0"});
    refused(changed(kEnv, "Passive", "Passivo"), robot, query, {"Passive"});
    refused(kEnv, folder.write("two.robot", "2\nr.g Volumetric Rotational\n"), query,
            {"a robot of one body"});
    refused(kEnv, robot, folder.write("one.query", "0 1 2 3 0 0 0\n"), {"1 lines", "two"});
}

BOOST_AUTO_TEST_CASE(ppl_meshes_are_centred_on_the_mean_of_their_files_vertices) {
    const TemporaryFolder folder;
    const Mesh byu = loadPplMesh(folder.write("m.g", kTwoParts));
    BOOST_TEST((byu.origin.shift + Vector3(1.25, 1.25, 1.5)).norm() < 1e-15);
    BOOST_TEST((byu.vertices[1] - Vector3(0.75, -0.25, -0.5)).norm() < 1e-15);
    // Three triangles share the vertex at the origin; it counts once.
    const Mesh obj =
        loadPplMesh(folder.write("m.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\nf 1 3 4\n"));
    BOOST_TEST((obj.origin.shift + Vector3(1, 1, 1)).norm() < 1e-15);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
