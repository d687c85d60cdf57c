#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <memory>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(formats_test)

using namespace testing;

/// A file's ending, its contents and the names of its components.
struct Written {
    const char* ending;
    std::string content;
    std::string name;
};

std::vector<Written> writtenByHand() {
    const Mesh mesh = tetrahedron();
    const std::string node = "<node name=\"bracket\"><instance_geometry url=\"#shape\"/></node>";
    return {{".stl", asciiStl(mesh, "bracket"), "bracket"},
            {".STL", binaryStl(mesh), "part"},
            {".obj", objText(mesh, "bracket"), "bracket"},
            {".ply", plyText(mesh), "part"},
            {".off", offText(mesh), "part"},
            {".dae", daeText(mesh, node), "bracket/shape"},
            {".gltf", gltfText(mesh, "{\"name\":\"bracket\",\"mesh\":0}"), "bracket/shape"}};
}

/// A file's ending and the id of assimp's exporter.
struct Exported {
    const char* ending;
    const char* id;
};
constexpr Exported kExported[] = {{".stl", "stl"},    {".stl", "stlb"},     {".obj", "obj"},
                                  {".ply", "ply"},    {".ply", "plyb"},     {".dae", "collada"},
                                  {".gltf", "gltf2"}, {".glb", "glb2"},     {".fbx", "fbxa"},
                                  {".3mf", "3mf"},    {".assbin", "assbin"}};

/// Shows the mesh once, in a node below the root.
std::unique_ptr<aiScene> sceneOf(const Mesh& mesh) {
    auto scene = std::make_unique<aiScene>();
    scene->mNumMaterials = 1;
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    auto* shown = new aiMesh;
    shown->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    shown->mName.Set("shape");
    shown->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
    shown->mVertices = new aiVector3D[mesh.vertices.size()];
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::Vector3f vertex = mesh.vertices[v].cast<float>();
        shown->mVertices[v] = aiVector3D(vertex.x(), vertex.y(), vertex.z());
    }
    shown->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
    shown->mFaces = new aiFace[mesh.triangles.size()];
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        shown->mFaces[f].mNumIndices = 3;
        shown->mFaces[f].mIndices =
            new unsigned[3]{mesh.triangles[f][0], mesh.triangles[f][1], mesh.triangles[f][2]};
    }
    scene->mNumMeshes = 1;
    scene->mMeshes = new aiMesh* [1] { shown };
    scene->mRootNode = new aiNode("root");
    auto* node = new aiNode("bracket");
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{0};
    scene->mRootNode->addChildren(1, &node);
    return scene;
}

BOOST_AUTO_TEST_CASE(every_format_written_by_hand_brings_the_same_triangles_in_order) {
    const TemporaryFolder folder;
    for (const Written& written : writtenByHand()) {
        BOOST_TEST_CONTEXT(written.ending) {
            const std::string file = folder.write(std::string("part") + written.ending, written.content);
            const Mesh mesh = loadMesh(file);
            BOOST_TEST(mesh.triangles.size() == 4u);
            requireTetrahedron(mesh, 0, unchanged);
            BOOST_REQUIRE(mesh.components.size() == 1u);
            BOOST_TEST(mesh.components[0].name == written.name);
            BOOST_TEST(mesh.components[0].firstTriangle == 0u);
            BOOST_TEST(mesh.components[0].triangleCount == 4u);
            BOOST_TEST(mesh.origin.file == file);
            BOOST_TEST(mesh.origin.scale == 1);
            BOOST_TEST((mesh.origin.shift == Vector3::Zero()));
            BOOST_TEST(mesh.origin.ignoredFaces == 0u);
            BOOST_TEST(mesh.origin.notes.empty());
        }
    }
}

BOOST_AUTO_TEST_CASE(every_format_that_assimp_exports_brings_the_same_triangles_in_order) {
    const TemporaryFolder folder;
    const auto scene = sceneOf(tetrahedron());
    for (const Exported& format : kExported) {
        BOOST_TEST_CONTEXT(format.id) {
            const std::string file = folder.file(std::string(format.id) + "_part" + format.ending);
            Assimp::Exporter exporter;
            BOOST_REQUIRE(exporter.Export(scene.get(), format.id, file) == aiReturn_SUCCESS);
            const Mesh mesh = loadMesh(file);
            BOOST_TEST(mesh.triangles.size() == 4u);
            requireTetrahedron(mesh, 0, unchanged);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_face_whose_index_assimp_does_not_check_is_refused) {
    const TemporaryFolder folder;
    const std::string file = folder.file("part.assbin");
    for (unsigned f = 0; f < 4; ++f) {
        const auto scene = sceneOf(tetrahedron());
        scene->mMeshes[0]->mFaces[f].mIndices[1] = 9;
        Assimp::Exporter exporter;
        BOOST_REQUIRE(exporter.Export(scene.get(), "assbin", file) == aiReturn_SUCCESS);
        requireRefusedBy<std::runtime_error>(
            [&] { loadMesh(file); }, {"face " + std::to_string(f) + " of mesh", " refers to vertex 9 of 4"});
    }
}

BOOST_AUTO_TEST_CASE(the_unit_and_up_axis_that_an_fbx_file_declares_are_said) {
    const TemporaryFolder folder;
    const std::string file = folder.file("part.fbx");
    Assimp::Exporter exporter;
    BOOST_REQUIRE(exporter.Export(sceneOf(tetrahedron()).get(), "fbxa", file) == aiReturn_SUCCESS);
    const Mesh mesh = loadMesh(file);
    BOOST_REQUIRE(mesh.origin.notes.size() == 1u);
    BOOST_TEST(holds(mesh.origin.notes[0], "not applied", "unit 1 cm", "axis 1 up"));
}

BOOST_AUTO_TEST_CASE(gltf_1_is_refused) {
    const TemporaryFolder folder;
    for (const Exported& format : {Exported{".gltf", "gltf"}, Exported{".glb", "glb"}}) {
        const std::string file = folder.file(std::string("old") + format.ending);
        Assimp::Exporter exporter;
        BOOST_REQUIRE(exporter.Export(sceneOf(tetrahedron()).get(), format.id, file) == aiReturn_SUCCESS);
        BOOST_CHECK_THROW(loadMesh(file), std::runtime_error);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
