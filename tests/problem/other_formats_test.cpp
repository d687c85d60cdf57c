// Formats of other projects, which benchmarks read: BYU meshes, and meshes as PPL places them.
#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/byu_mesh.h"
#include "support/ppl_mesh.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(other_formats_test)

const std::string kTwoParts = "2 4 2 7\n1 1\n2 2\n1 1 1 2 1 1\n1 2 1 1 1 3\n1 2 -3\n1 2 3 -4\n";

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

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
