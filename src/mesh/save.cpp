// Writes mesh files: .glb by writeGlb, .obj with all digits, the other formats through assimp's exporter.
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "clearway/mesh.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "mesh/glb.h"

namespace clearway {

namespace {

/// assimp's exporter writes fewer digits than a float's double needs.
void writeObj(const std::vector<SavePart>& parts, std::ostream& stream) {
    std::size_t first = 1;
    for (const SavePart& part : parts) {
        stream << "o " << part.name << "\n";
        for (const auto& vertex : part.vertices) {
            stream << "v";
            for (const float coordinate : vertex) stream << ' ' << shortNumber(double(coordinate));
            stream << "\n";
        }
        for (const TriangleIndices& triangle : part.triangles) {
            stream << "f " << first + triangle[0] << ' ' << first + triangle[1] << ' ' << first + triangle[2]
                   << "\n";
        }
        first += part.vertices.size();
    }
}

struct ExportFormat {
    const char* name;  ///< the file's ending
    void (*write)(const std::vector<SavePart>& parts, std::ostream& stream);
    const char* assimpId;  ///< where there is no function
};
constexpr ExportFormat kExportFormats[] = {{".glb", writeGlb, nullptr},
                                           {".obj", writeObj, nullptr},
                                           {".ply", nullptr, "plyb"},
                                           {".stl", nullptr, "stlb"},
                                           {".dae", nullptr, "collada"}};

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
        throw std::runtime_error("cannot write mesh '" + file + "': " + exporter.GetErrorString() +
                                 ", expected a mesh that assimp can export as " + format.name);
    }
    replaceFile(file, [&](std::ostream& stream) {
        stream.write(static_cast<const char*>(blob->data), static_cast<std::streamsize>(blob->size));
    });
}

}  // namespace

void saveMesh(const Mesh& mesh, const std::string& file) {
    const ExportFormat& format = formatOf(file);
    const std::vector<SavePart> parts = savePartsOf(mesh, std::filesystem::path(file).stem().string());
    if (format.write) {
        replaceFile(file, [&](std::ostream& stream) { format.write(parts, stream); });
    } else {
        writeByAssimp(parts, format, file);
    }
}

}  // namespace clearway
