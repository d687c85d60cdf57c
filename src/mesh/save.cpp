// Writes mesh files: .3mf by threeMfOf, .glb by writeGlb, the other formats through assimp's exporter.
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cctype>
#include <filesystem>
#include <ostream>

#include "clearway/errors.h"
#include "clearway/mesh.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "mesh/glb.h"
#include "mesh/three_mf.h"

namespace clearway {

namespace {

struct ExportFormat {
    const char* name;      ///< the file's ending
    const char* assimpId;  ///< null: written by threeMfOf or writeGlb
};
constexpr ExportFormat kExportFormats[] = {{".3mf", nullptr}, {".glb", nullptr}, {".obj", "objnomtl"},
                                           {".ply", "plyb"},  {".stl", "stlb"},  {".dae", "collada"}};

const ExportFormat& formatOf(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    for (char& character : ending)
        character = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
    return rowNamed(kExportFormats, "the ending of mesh file '" + file + "'", ending);
}

aiMesh* makeMesh(const SavePart& part) {
    auto* mesh = new aiMesh;
    mesh->mName.Set(part.name);
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = static_cast<unsigned>(part.vertices.size());
    mesh->mVertices = new aiVector3D[mesh->mNumVertices];
    for (unsigned v = 0; v < mesh->mNumVertices; ++v) {
        mesh->mVertices[v] = aiVector3D(part.vertices[v][0], part.vertices[v][1], part.vertices[v][2]);
    }
    mesh->mNumFaces = static_cast<unsigned>(part.triangles.size());
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
        mesh->mFaces[f].mNumIndices = 3;
        mesh->mFaces[f].mIndices = new unsigned[3];
        std::copy(part.triangles[f].begin(), part.triangles[f].end(), mesh->mFaces[f].mIndices);
    }
    return mesh;
}

/// Fills the scene with a root that has one node with one mesh for each part. The scene owns everything it
/// points to.
void fillScene(const std::vector<SavePart>& parts, aiScene& scene) {
    const auto count = static_cast<unsigned>(parts.size());
    scene.mNumMaterials = 1;
    scene.mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene.mMeshes = new aiMesh*[count];
    scene.mRootNode = new aiNode("root");
    scene.mRootNode->mChildren = new aiNode*[count];
    for (unsigned i = 0; i < count; ++i) {
        scene.mMeshes[scene.mNumMeshes++] = makeMesh(parts[i]);
        auto* node = new aiNode(parts[i].name);
        node->mParent = scene.mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{i};
        scene.mRootNode->mChildren[scene.mRootNode->mNumChildren++] = node;
    }
}

void writeByAssimp(const std::vector<SavePart>& parts, const ExportFormat& format, const std::string& file) {
    aiScene scene;
    fillScene(parts, scene);
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, format.assimpId);
    if (!blob) {
        throw FileError("cannot write mesh '" + file + "': " + exporter.GetErrorString() +
                        ", expected a mesh that assimp can export as " + format.name);
    }
    replaceFile(file, [&](std::ostream& stream) {
        stream.write(static_cast<const char*>(blob->data), static_cast<std::streamsize>(blob->size));
    });
}

}  // namespace

void saveMesh(const Mesh& mesh, const std::string& file) {
    const ExportFormat& format = formatOf(file);
    const std::string stem = std::filesystem::path(file).stem().string();
    if (format.name == std::string(".3mf")) {
        const std::string bytes = threeMfOf(mesh, stem);
        return replaceFile(file, [&](std::ostream& stream) { stream << bytes; });
    }
    const std::vector<SavePart> parts = savePartsOf(mesh, stem);
    if (format.assimpId) {
        writeByAssimp(parts, format, file);
    } else {
        replaceFile(file, [&](std::ostream& stream) { writeGlb(parts, stream); });
    }
}

}  // namespace clearway
