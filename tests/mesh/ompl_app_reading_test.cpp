#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <boost/test/unit_test.hpp>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

// A mesh read as OMPL.app reads it has the floats that OMPL.app passes to its checker. The test computes
// these floats directly: assimp's defaults, OMPL.app's steps, one recursion.
namespace clearway {
BOOST_AUTO_TEST_SUITE(ompl_app_reading_test)

using namespace testing;

struct Reference {
    std::vector<aiVector3D> vertices;  ///< of all meshes, also those of lines
    std::vector<aiVector3D> corners;   ///< three for each triangle

    explicit Reference(const std::string& file) {
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(file, aiProcess_GenNormals | aiProcess_Triangulate |
                                                           aiProcess_JoinIdenticalVertices |
                                                           aiProcess_SortByPType | aiProcess_OptimizeGraph);
        BOOST_REQUIRE(scene);
        add(*scene, *scene->mRootNode, aiMatrix4x4());
    }

    void add(const aiScene& scene, const aiNode& node, const aiMatrix4x4& X_rootParent) {
        const aiMatrix4x4 X_rootNode = X_rootParent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
            for (unsigned v = 0; v < mesh.mNumVertices; ++v)
                vertices.push_back(X_rootNode * mesh.mVertices[v]);
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
                const aiFace& face = mesh.mFaces[f];
                for (unsigned i = 0; face.mNumIndices == 3 && i < 3; ++i) {
                    corners.push_back(X_rootNode * mesh.mVertices[face.mIndices[i]]);
                }
            }
        }
        for (unsigned c = 0; c < node.mNumChildren; ++c) add(scene, *node.mChildren[c], X_rootNode);
    }

    aiVector3D mean() const {
        aiVector3D sum(0, 0, 0);
        for (const aiVector3D& vertex : vertices) sum += vertex;
        return sum / static_cast<float>(vertices.size());
    }
};

/// Nested nodes with rotations that float cannot represent, lines beside the triangles, z up, inches.
std::string awkwardFile(std::uint64_t seed) {
    Random random(seed);
    Mesh mesh = box({70, 30, 110}, 3);  // corners that triangles share, to be joined within each face
    for (Vector3& vertex : mesh.vertices) vertex += Vector3(500, -200, 30) + random.inBox(3);
    mesh.triangles.resize(mesh.triangles.size() - 5);
    std::string nodes;
    for (int i = 0; i < 4; ++i) {
        const Vector3 axis = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), 0.7).normalized();
        const std::string turn =
            "<rotate>" + words(axis) + " " + std::to_string(random.uniform(-180, 180)) + "</rotate>";
        const std::string step = "<translate>" + words(random.inBox(300)) + "</translate>";
        const std::string show = "<instance_geometry url=\"#shape\"/>";
        nodes += "<node name=\"arm" + std::to_string(i) + "\">" + step + turn + (i % 2 ? show : "") +
                 "<node name=\"hand\">" + turn + step + show + "</node></node>";
    }
    return daeText(mesh, nodes, "<unit meter=\"0.0254\"/><up_axis>Z_UP</up_axis>", true);
}

Mesh load(const std::string& file, MeshReading reading) {
    LoadOptions options;
    options.reading = reading;
    return loadMesh(file, options);
}

void requireCorners(const Mesh& mesh, const Reference& reference, const aiVector3D& shift) {
    BOOST_REQUIRE(3 * mesh.triangles.size() == reference.corners.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < reference.corners.size(); ++i) {
        const aiVector3D corner = reference.corners[i] - shift;
        if (mesh.vertices[mesh.triangles[i / 3][i % 3]] != Vector3(corner.x, corner.y, corner.z)) ++different;
    }
    BOOST_TEST(different == 0u);
}

BOOST_AUTO_TEST_CASE(every_reading_gives_the_floats_of_ompl_app_bit_for_bit) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        BOOST_TEST_CONTEXT("seed " << seed) {
            const TemporaryFolder folder;
            const std::string file = folder.write("awkward.dae", awkwardFile(seed));
            const Reference reference(file);
            const aiVector3D mean = reference.mean();
            requireCorners(load(file, MeshReading::kOmplAppEnvironment), reference, aiVector3D(0, 0, 0));
            const Mesh robot = load(file, MeshReading::kOmplAppRobot);
            requireCorners(robot, reference, mean);
            BOOST_TEST((robot.origin.shift == Vector3(-mean.x, -mean.y, -mean.z)));
            const Mesh planar = load(file, MeshReading::kOmplAppPlanarRobot);
            requireCorners(planar, reference, aiVector3D(mean.x, mean.y, 0));
            BOOST_TEST((planar.origin.shift == Vector3(-mean.x, -mean.y, 0)));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_names_survive_the_collapse_of_the_nodes) {
    const TemporaryFolder folder;
    const Mesh mesh = load(folder.write("awkward.dae", awkwardFile(5)), MeshReading::kOmplAppEnvironment);
    std::vector<std::string> names;
    for (const Component& component : mesh.components) names.push_back(component.name);
    std::sort(names.begin(), names.end());
    BOOST_TEST(names == (std::vector<std::string>{"arm1/shape", "arm3/shape", "hand/shape", "hand/shape#2",
                                                  "hand/shape#3", "hand/shape#4"}));
}

BOOST_AUTO_TEST_CASE(a_shared_corner_counts_once_in_the_mean_and_an_unshared_one_as_often_as_it_stands) {
    // Flat: the corners of both triangles agree in position and normal, and are joined.
    const TemporaryFolder folder;
    const std::string flat =
        folder.write("flat.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 8 4 0\nf 1 2 3\nf 2 4 3\n");
    BOOST_TEST((load(flat, MeshReading::kOmplAppRobot).origin.shift == Vector3(-3, -2, 0)));
    // Folded: normals differ along the fold, whose two corners count twice.
    const std::string folded =
        folder.write("fold.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 6\nf 1 2 3\nf 2 4 3\n");
    BOOST_TEST((load(folded, MeshReading::kOmplAppRobot).origin.shift == Vector3(-2, -2, -1)));
    const Mesh robot = load(folded, MeshReading::kOmplAppRobot);
    BOOST_REQUIRE(robot.origin.notes.size() == 1u);
    BOOST_TEST(robot.origin.notes[0] == "moved so that the mean of its vertices is the origin");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
