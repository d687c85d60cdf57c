#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/errors.h"
#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(save_test)

using namespace testing;
namespace data = boost::unit_test::data;

/// Several named components whose coordinates are floats made by `coordinate`. They have degenerate and
/// repeated triangles, vertices that several components share, and vertices very close together.
template <typename Coordinate>
Mesh namedMesh(Random& random, Coordinate coordinate) {
    Mesh mesh;
    for (int i = 0; i < 300; ++i) {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        mesh.vertices.emplace_back(x, y, z);
        mesh.vertices.emplace_back(std::nextafter(x, 1e30f), y, z);
    }
    for (const char* const name : {"floor_pan", "rib.2", "boss-3", "bracket#2", "sheet"}) {
        const int count = 1 + random.below(200);
        mesh.components.push_back(
            {name, static_cast<std::uint32_t>(mesh.triangles.size()), static_cast<std::uint32_t>(count)});
        for (int i = 0; i < count; ++i) {
            const auto corner = [&] { return static_cast<std::uint32_t>(random.below(600)); };
            const std::uint32_t a = corner(), b = corner(), c = corner();
            mesh.triangles.push_back({a, b, i % 50 == 7 ? a : c});
            if (i % 50 == 9) mesh.triangles.back() = mesh.triangles[mesh.triangles.size() - 2];
        }
    }
    return mesh;
}

std::size_t differingCorners(const Mesh& loaded, const Mesh& saved) {
    BOOST_REQUIRE(loaded.triangles.size() == saved.triangles.size());
    std::size_t different = 0;
    for (std::size_t id = 0; id < saved.triangles.size(); ++id) {
        for (int i = 0; i < 3; ++i) {
            if (loaded.vertices[loaded.triangles[id][i]] != saved.vertices[saved.triangles[id][i]])
                ++different;
        }
    }
    return different;
}

void requireSameComponents(const Mesh& loaded, const Mesh& saved) {
    BOOST_REQUIRE(loaded.components.size() == saved.components.size());
    for (std::size_t i = 0; i < saved.components.size(); ++i) {
        BOOST_TEST(loaded.components[i].name == saved.components[i].name);
        BOOST_TEST(loaded.components[i].firstTriangle == saved.components[i].firstTriangle);
        BOOST_TEST(loaded.components[i].triangleCount == saved.components[i].triangleCount);
    }
}

Mesh savedAndLoaded(const Mesh& mesh, const std::string& name) {
    const TemporaryFolder folder;
    saveMesh(mesh, folder.file(name));
    BOOST_TEST(folder.names() == std::vector<std::string>{name});  // nothing beside it
    return loadMesh(folder.file(name));
}

const char* const kEndings[] = {".3mf", ".glb", ".obj", ".dae", ".ply", ".stl"};

BOOST_AUTO_TEST_CASE(glb_brings_back_any_floats_order_and_names) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        BOOST_TEST_CONTEXT("seed " << seed) {
            Random random(seed);
            const Mesh mesh = namedMesh(random, [&] {
                return std::ldexp(static_cast<float>(random.uniform(-1, 1)), random.below(200) - 100);
            });
            const Mesh loaded = savedAndLoaded(mesh, "part.glb");
            BOOST_TEST(differingCorners(loaded, mesh) == 0u);
            requireSameComponents(loaded, mesh);
            BOOST_TEST(loaded.origin.notes.empty());
        }
    }
}

BOOST_DATA_TEST_CASE(coordinates_in_millimetres_come_back_the_same_in_order, data::make(kEndings), ending) {
    const bool keepsComponents = ending == std::string(".3mf") || ending == std::string(".glb") ||
                                 ending == std::string(".obj") || ending == std::string(".dae");
    for (const std::uint64_t seed : {4, 5}) {
        BOOST_TEST_CONTEXT("seed " << seed) {
            Random random(seed);
            const Mesh mesh =
                namedMesh(random, [&] { return static_cast<float>(random.uniform(-3000, 3000)); });
            Mesh loaded = savedAndLoaded(mesh, std::string("part") + ending);
            if (ending == std::string(".obj") || ending == std::string(".dae")) {
                // Their text tells floats apart, with fewer digits than doubles need.
                for (Vector3& vertex : loaded.vertices) vertex = vertex.cast<float>().cast<double>();
            }
            BOOST_TEST(differingCorners(loaded, mesh) == 0u);
            if (keepsComponents) {
                requireSameComponents(loaded, mesh);
            } else {
                BOOST_TEST(loaded.components.size() == 1u);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(texts_keep_nine_digits) {
    for (const char* const name : {"a.obj", "a.dae"}) {
        Random random(7);
        BOOST_TEST_CONTEXT(name << ", seed 7") {
            const Mesh mesh = namedMesh(random, [&] {
                return std::ldexp(static_cast<float>(random.uniform(0.5, 1)), random.below(160) - 80);
            });
            const Mesh loaded = savedAndLoaded(mesh, name);
            BOOST_REQUIRE(loaded.triangles.size() == mesh.triangles.size());
            double worst = 0;
            for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
                for (int i = 0; i < 3; ++i) {
                    const Vector3& saved = mesh.vertices[mesh.triangles[id][i]];
                    const Vector3 error = loaded.vertices[loaded.triangles[id][i]] - saved;
                    worst = std::max(worst, error.cwiseAbs().cwiseQuotient(saved).maxCoeff());
                }
            }
            BOOST_TEST(worst <= 1e-8);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_glb_reads_the_same_as_ompl_app_reads_it) {
    Random random(6);
    const Mesh mesh = namedMesh(random, [&] { return static_cast<float>(random.uniform(-3000, 3000)); });
    const TemporaryFolder folder;
    saveMesh(mesh, folder.file("world.glb"));
    LoadOptions options;
    options.reading = MeshReading::kOmplAppEnvironment;
    const Mesh loaded = loadMesh(folder.file("world.glb"), options);
    BOOST_TEST(differingCorners(loaded, mesh) == 0u);
    requireSameComponents(loaded, mesh);
}

BOOST_AUTO_TEST_CASE(a_3mf_brings_back_any_doubles_order_names_deflections_and_unit) {
    for (const double unit : {1e-6, 1e-3, 1e-2, 0.0254, 0.3048, 1.0, 0.0}) {
        BOOST_TEST_CONTEXT("unit of " << unit << " m") {
            Random random(8);
            Mesh mesh = namedMesh(random, [] { return 0.f; });
            for (Vector3& vertex : mesh.vertices) {
                for (double& x : vertex) x = std::ldexp(random.uniform(-1, 1), random.below(2000) - 1000);
            }
            mesh.vertices[0] = {-0.0, 1e-320, 1.7e308};
            mesh.origin.unitMetres = unit;
            mesh.components[1].name = "<Träger> & \"rib\"";
            mesh.components[1].deflection = 0.1;
            mesh.components[3].deflection = 1.0 / 3;
            const Mesh loaded = savedAndLoaded(mesh, "part.3mf");
            BOOST_TEST(differingCorners(loaded, mesh) == 0u);
            requireSameComponents(loaded, mesh);
            BOOST_TEST(loaded.origin.unitMetres == unit);
            BOOST_TEST(loaded.origin.deflection == 1.0 / 3);
            for (std::size_t i = 0; i < mesh.components.size(); ++i)
                BOOST_TEST(loaded.components[i].deflection == mesh.components[i].deflection);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_3mf_states_the_unit_of_scaled_coordinates) {
    const TemporaryFolder folder;
    Mesh mesh = tetrahedron();
    mesh.components = {{"a", 0, 4, 0.5}};
    mesh.origin.unitMetres = 1e-2;
    saveMesh(mesh, folder.file("a.3mf"));
    LoadOptions options;
    options.scale = 10;
    const Mesh scaled = loadMesh(folder.file("a.3mf"), options);
    BOOST_TEST(scaled.components[0].deflection == 5);
    BOOST_TEST(scaled.origin.deflection == 0.5);
    saveMesh(scaled, folder.file("b.3mf"));
    const Mesh loaded = loadMesh(folder.file("b.3mf"));
    BOOST_TEST(loaded.origin.unitMetres == 1e-3);
    BOOST_TEST(loaded.origin.deflection == 5);
}

BOOST_AUTO_TEST_CASE(a_3mf_is_refused_where_it_would_say_something_else) {
    const TemporaryFolder folder;
    Mesh mesh = tetrahedron();
    mesh.origin.unitMetres = 1000;
    BOOST_CHECK_THROW(saveMesh(mesh, folder.file("a.3mf")), ArgumentError);
    mesh.origin.unitMetres = 0;
    mesh.components = {{"tab\there", 0, 4}};
    BOOST_CHECK_THROW(saveMesh(mesh, folder.file("a.3mf")), ArgumentError);
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_CASE(doubles_are_rounded_to_the_nearest_float) {
    Mesh mesh = tetrahedron();
    mesh.vertices[0].x() = 0.1;
    mesh.vertices[1].y() = 1e-60;
    mesh.vertices[2].z() = -0.0;
    const Mesh loaded = savedAndLoaded(mesh, "a.glb");
    BOOST_TEST(loaded.vertices[loaded.triangles[0][0]].x() == double(0.1f));
    BOOST_TEST(loaded.vertices[loaded.triangles[0][1]].y() == 0);
    BOOST_TEST(std::signbit(loaded.vertices[loaded.triangles[0][2]].z()));
}

BOOST_DATA_TEST_CASE(a_mesh_without_components_is_named_by_its_file, data::make(kEndings), ending) {
    const Mesh loaded = savedAndLoaded(tetrahedron(), std::string("bracket") + ending);
    BOOST_REQUIRE(loaded.components.size() == 1u);
    BOOST_TEST(loaded.components[0].name == "bracket");
}

BOOST_AUTO_TEST_CASE(glb_keeps_names_of_any_characters) {
    Mesh mesh = tetrahedron();
    mesh.components = {
        {"a \"quoted\" one\\", 0, 1}, {"tab\there", 1, 1}, {"Trägerblech", 2, 1}, {"a/b", 3, 1}};
    requireSameComponents(savedAndLoaded(mesh, "a.glb"), mesh);
}

BOOST_AUTO_TEST_CASE(names_in_glb_and_3mf_are_utf8_whatever_the_bytes_they_came_in) {
    Mesh mesh = tetrahedron();
    mesh.components = {{"Tr\xe4ger", 0, 4}};  // Latin-1
    for (const char* const name : {"a.glb", "a.3mf"})
        BOOST_TEST(savedAndLoaded(mesh, name).components.at(0).name == "Träger");
}

BOOST_AUTO_TEST_CASE(empty_components_are_left_out) {
    Mesh mesh = tetrahedron();
    mesh.components = {{"a", 0, 1}, {"none", 1, 0}, {"b", 1, 3}};
    const Mesh loaded = savedAndLoaded(mesh, "a.glb");
    BOOST_REQUIRE(loaded.components.size() == 2u);
    BOOST_TEST(loaded.components[1].name == "b");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written_is_refused_and_leaves_nothing) {
    const TemporaryFolder folder;
    const auto refused = [&](const Mesh& mesh, const std::string& name,
                             const std::vector<std::string>& words) {
        requireRefusedBy([&] { saveMesh(mesh, folder.file(name)); }, words);
    };
    refused(tetrahedron(), "a.xyz", {"a.xyz", "'.xyz'", ".3mf, .glb, .obj, .ply, .stl, .dae"});
    refused(tetrahedron(), "glb", {"is '', expected"});
    for (const char* const ending : kEndings) {
        const std::string name = std::string("a") + ending;
        refused(Mesh{}, name, {"0 triangles", "at least 1"});
        Mesh mesh = tetrahedron();
        mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
        refused(mesh, name, {"triangle 1", "(6, nan, -8)"});
        BOOST_CHECK_THROW(saveMesh(tetrahedron(), folder.file("no/such/folder/" + name)), std::runtime_error);
        mesh.vertices[3].y() = 1e39;
        if (ending == std::string(".3mf")) continue;  // which holds doubles
        refused(mesh, name, {"triangle 1", "(6, 1e+39, -8)"});
    }
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
