// Reads files through assimp: as stored where clearway has no reader of its own, and any format with OMPL.app's arithmetic (float, assimp's
// defaults).
#include "mesh/read/assimp.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "mesh/check.h"
#include "mesh/components.h"

namespace clearway {
namespace {

/// Steps that neither alter a coordinate nor drop a triangle: no joining, no search for degenerate faces.
constexpr unsigned kStoredSteps = aiProcess_Triangulate | aiProcess_SortByPType;

/// OMPL.app's steps. None may be left out: joined vertices and collapsed nodes both change the float mean by
/// which OMPL.app centres a robot.
constexpr unsigned kOmplAppSteps = aiProcess_GenNormals | aiProcess_Triangulate |
                                   aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                   aiProcess_OptimizeGraph;

bool isShifted(MeshReading reading) {
    return reading == MeshReading::kOmplAppRobot || reading == MeshReading::kOmplAppPlanarRobot;
}

/// How many nodes show each of the scene's meshes.
void countInstances(const aiNode& node, std::vector<std::size_t>& instances) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) ++instances[node.mMeshes[i]];
    for (unsigned i = 0; i < node.mNumChildren; ++i) countInstances(*node.mChildren[i], instances);
}

std::vector<std::size_t> instancesOf(const aiScene& scene) {
    std::vector<std::size_t> instances(scene.mNumMeshes, 0);
    countInstances(*scene.mRootNode, instances);
    return instances;
}

std::string nameOf(const aiNode& node, const aiMesh& mesh) {
    return componentName(node.mName.C_Str(), mesh.mName.C_Str());
}

/// Names each mesh that only one node shows by its component's name, because collapsing nodes loses the
/// nodes' names.
void nameMeshesByNode(const aiScene& scene, const aiNode& node, const std::vector<std::size_t>& instances) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        if (instances[node.mMeshes[i]] == 1) mesh.mName.Set(nameOf(node, mesh));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) nameMeshesByNode(scene, *node.mChildren[i], instances);
}

/// Refuses nodes that refer to missing meshes or children. assimp's importers pass on the contents of a
/// damaged file, and its later steps trust them or abort. Its reader of raw files leaves out children even of
/// sound files.
void requireSoundNodes(const aiNode& node, const aiScene& scene, const std::string& file) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] < scene.mNumMeshes) continue;
        refuseMeshFile(file, fmt::format("the reader's node '{}' refers to mesh {} of {}", node.mName.C_Str(),
                                         node.mMeshes[i], scene.mNumMeshes));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        if (!node.mChildren[i]) {
            refuseMeshFile(file,
                           fmt::format("the reader left out child {} of node '{}'", i, node.mName.C_Str()));
        }
        requireSoundNodes(*node.mChildren[i], scene, file);
    }
}

void requireSoundFaces(const aiMesh& mesh, const std::string& file) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const auto face = [&] { return fmt::format("face {} of mesh '{}'", f, mesh.mName.C_Str()); };
        if (mesh.mFaces[f].mNumIndices == 0) refuseMeshFile(file, face() + " has no corner");
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
            const unsigned index = mesh.mFaces[f].mIndices[i];
            if (index < mesh.mNumVertices) continue;
            refuseMeshFile(file,
                           fmt::format("{} refers to vertex {} of {}", face(), index, mesh.mNumVertices));
        }
    }
}

void requireSoundScene(const aiScene& scene, const std::string& file) {
    requireSoundNodes(*scene.mRootNode, scene, file);
    const std::vector<std::size_t> instances = instancesOf(scene);
    std::size_t vertices = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        requireSoundFaces(*scene.mMeshes[m], file);
        vertices += instances[m] * scene.mMeshes[m]->mNumVertices;
    }
    if (vertices > std::numeric_limits<std::uint32_t>::max()) {
        refuseMeshFile(file, fmt::format("its {} vertices are more than 2^32 - 1", vertices));
    }
}

bool isFinite(const aiVector3D& vertex) {
    return std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z);
}

/// Whether all vertices that faces use are finite.
bool hasFiniteFaces(const aiScene& scene) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            for (unsigned i = 0; i < face.mNumIndices; ++i) {
                if (!isFinite(mesh.mVertices[face.mIndices[i]])) return false;
            }
        }
    }
    return true;
}

/// The number of points, lines and triangles, where a polygon of n corners counts as n - 2 triangles.
std::size_t countFaces(const aiScene& scene) {
    const std::vector<std::size_t> instances = instancesOf(scene);
    std::size_t count = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const unsigned corners = mesh.mFaces[f].mNumIndices;
            count += instances[m] * (corners >= 3 ? corners - 2 : 1);
        }
    }
    return count;
}

/// One row of an affine map in words: "0.0254 x + 3", without zero terms.
std::string rowText(const float (&row)[4]) {
    const char* const variables[] = {"x", "y", "z", ""};
    std::string text;
    for (int column = 0; column < 4; ++column) {
        const double factor = row[column];
        if (factor == 0) continue;
        if (!text.empty()) {
            text += factor < 0 ? " - " : " + ";
        } else if (factor < 0) {
            text += '-';
        }
        const bool isUnit = column < 3 && std::fabs(factor) == 1;
        if (!isUnit) text += fmt::format("{:.9g}{}", std::fabs(factor), column < 3 ? " " : "");
        text += variables[column];
    }
    return text.empty() ? "0" : text;
}

/// An affine map in words, for `clearway info`: "x' = 0.0254 x, y' = 0.0254 z, z' = -0.0254 y".
std::string affineText(const aiMatrix4x4& transform) {
    const auto row = [&](unsigned i) {
        return rowText({transform[i][0], transform[i][1], transform[i][2], transform[i][3]});
    };
    return fmt::format("x' = {}, y' = {}, z' = {}", row(0), row(1), row(2));
}

bool isCollada(const Assimp::Importer& importer) {
    const aiImporterDesc* description =
        importer.GetImporterInfo(importer.GetPropertyInteger("importerIndex", -1));
    return description && std::string(description->mFileExtensions).find("dae") != std::string::npos;
}

/// Notes the root node's transform, into which assimp's importers put units, up axes and their own conventions. COLLADA's root holds
/// nothing else: then it is returned.
Placement noteRoot(const Assimp::Importer& importer, const aiScene& scene, std::vector<std::string>& notes) {
    const aiMatrix4x4& transform = scene.mRootNode->mTransformation;
    if (transform == aiMatrix4x4()) return {};  // exact comparison; IsIdentity() tolerates 1 %
    const std::string map = affineText(transform);
    if (!isCollada(importer)) {
        notes.push_back(kAssimpsTurn + map);
        return {};
    }
    notes.push_back(kAssimpsUnit + map);
    Placement placement;
    for (unsigned i = 0; i < 3; ++i) {
        for (unsigned k = 0; k < 3; ++k) placement.linear(i, k) = transform[i][k];
        placement.translation[i] = transform[i][3];
    }
    return placement;
}

/// Notes the unit and axes of an FBX file, which assimp's importer passes on without applying them.
void noteDeclaredUnits(const aiScene& scene, std::vector<std::string>& notes) {
    float centimetres = 1;
    std::int32_t axis = 1;
    if (!scene.mMetaData || !scene.mMetaData->Get("UnitScaleFactor", centimetres) ||
        !scene.mMetaData->Get("UpAxis", axis)) {
        return;
    }
    notes.push_back(fmt::format(
        "unit and up axis that the file declares not applied: unit {:g} cm, axis {} up", centimetres, axis));
}

/// Walks the nodes in the file's order, with all arithmetic in Real, and collects the meshes they show.
template <typename Real>
struct Collector {
    using Vector = aiVector3t<Real>;
    using Matrix = aiMatrix4x4t<Real>;

    const aiScene& scene;
    std::vector<std::size_t> instances;
    Mesh mesh;
    Vector sum;  ///< of the vertices of all meshes, including those of lines
    std::size_t summed = 0;

    explicit Collector(const aiScene& given) : scene(given), instances(instancesOf(given)) {}

    void addNode(const aiNode& node, Matrix X_rootNode) {
        X_rootNode *= Matrix(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const unsigned index = node.mMeshes[i];
            const aiMesh& shown = *scene.mMeshes[index];
            addMesh(shown, instances[index] == 1 ? shown.mName.C_Str() : nameOf(node, shown), X_rootNode);
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(*node.mChildren[i], X_rootNode);
    }

    void addMesh(const aiMesh& shown, const std::string& name, const Matrix& X_rootNode) {
        const std::size_t firstVertex = mesh.vertices.size();
        const std::size_t firstTriangle = mesh.triangles.size();
        const bool isPlaced =
            X_rootNode == Matrix();  // a multiplication would spread one NaN to all coordinates
        for (unsigned v = 0; v < shown.mNumVertices; ++v) {
            const Vector vertex =
                isPlaced ? Vector(shown.mVertices[v]) : X_rootNode * Vector(shown.mVertices[v]);
            mesh.vertices.emplace_back(vertex.x, vertex.y, vertex.z);
            sum += vertex;
        }
        summed += shown.mNumVertices;
        addTriangles(shown, firstVertex, X_rootNode.Determinant() < 0);
        const std::size_t count = mesh.triangles.size() - firstTriangle;
        if (count == 0) {
            mesh.vertices.resize(firstVertex);
        } else {
            mesh.components.push_back(
                {name, static_cast<std::uint32_t>(firstTriangle), static_cast<std::uint32_t>(count)});
        }
    }

    /// Adds the triangles. A mirroring transform turns them over, so they are turned back to face the file's
    /// side.
    void addTriangles(const aiMesh& shown, std::size_t firstVertex, bool isMirrored) {
        for (unsigned f = 0; f < shown.mNumFaces; ++f) {
            const aiFace& face = shown.mFaces[f];
            if (face.mNumIndices != 3) continue;
            TriangleIndices triangle;
            for (unsigned i = 0; i < 3; ++i) {
                triangle[i] = static_cast<std::uint32_t>(firstVertex + face.mIndices[i]);
            }
            if (isMirrored) std::swap(triangle[1], triangle[2]);
            mesh.triangles.push_back(triangle);
        }
    }

    /// The centre by OMPL.app's definition: the mean of all the scene's vertices, in OMPL.app's arithmetic.
    Vector3 centre(MeshReading reading) const {
        if (!isShifted(reading)) return Vector3::Zero();
        Vector mean = sum;
        mean /= static_cast<Real>(summed);
        return {mean.x, mean.y, reading == MeshReading::kOmplAppPlanarRobot ? 0 : mean.z};
    }
};

template <typename Real>
Mesh collect(const aiScene& scene, const std::string& file, MeshReading reading) {
    Collector<Real> collector(scene);
    collector.addNode(*scene.mRootNode, {});
    Mesh mesh = std::move(collector.mesh);
    if (mesh.triangles.empty()) refuseMeshFile(file, "it holds no triangle");
    makeNamesDistinct(mesh.components, std::filesystem::path(file).stem().string());
    requireSoundMeshFile(mesh, file);
    if (!isShifted(reading)) return mesh;
    const Vector3 centre = collector.centre(reading);
    for (Vector3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) vertex[i] = static_cast<Real>(vertex[i]) - static_cast<Real>(centre[i]);
    }
    mesh.origin.shift = -centre;
    return mesh;
}

/// Calls assimp, which reports errors as null scenes and some, such as lack of memory, as exceptions.
template <typename Call>
const aiScene& requireScene(const Assimp::Importer& importer, const std::string& file, Call call) {
    const aiScene* scene = nullptr;
    std::string reason;
    try {
        scene = call();
        if (!scene) reason = importer.GetErrorString();
    } catch (const std::exception& error) {
        reason = error.what();
    }
    if (!scene || !scene->mRootNode) refuseMeshFile(file, reason);
    return *scene;
}

/// Removes the reader of glTF 1.0: assimp 5.2 takes wrong indices from sound files and aborts. Such files are
/// then refused. glTF 2.0 has another reader.
void leaveOutGltf1(Assimp::Importer& importer) {
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        if (std::string(importer.GetImporterInfo(i)->mName) != "glTF Importer") continue;
        const std::unique_ptr<Assimp::BaseImporter> reader(importer.GetImporter(i));
        importer.UnregisterLoader(reader.get());
        return;
    }
}

const aiScene& readStored(Assimp::Importer& importer, const std::string& file) {
    leaveOutGltf1(importer);
    // Without this, assimp invents triangles for a file that has only a skeleton.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    const aiScene& scene = requireScene(importer, file, [&] { return importer.ReadFile(file, 0); });
    requireSoundScene(scene, file);
    return scene;
}

const aiScene& runSteps(Assimp::Importer& importer, const std::string& file, MeshReading reading) {
    unsigned steps = readsAsOmplApp(reading) ? kOmplAppSteps : kStoredSteps;
    // Joining treats NaN as equal to everything, which would hide a vertex that must be refused.
    if (!hasFiniteFaces(*importer.GetScene()))
        steps &= ~static_cast<unsigned>(aiProcess_JoinIdenticalVertices);
    return requireScene(importer, file, [&] { return importer.ApplyPostProcessing(steps); });
}

/// The file's ending in upper case, or assimp's name of the format for a file without one.
std::string formatName(const Assimp::Importer& importer, const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    if (ending.size() > 1) {
        ending.erase(0, 1);
        for (char& c : ending) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
        return ending;
    }
    const aiImporterDesc* description =
        importer.GetImporterInfo(importer.GetPropertyInteger("importerIndex", -1));
    return description ? description->mName : "its format";
}

}  // namespace

AssimpMesh readByAssimp(const std::string& file, MeshReading reading) {
    std::vector<std::string> notes;
    Assimp::Importer importer;
    const aiScene& stored = readStored(importer, file);
    const Placement X_root = noteRoot(importer, stored, notes);
    noteDeclaredUnits(stored, notes);
    nameMeshesByNode(stored, *stored.mRootNode, instancesOf(stored));
    const std::size_t faces = countFaces(stored);
    if (faces == 0) refuseMeshFile(file, "it holds no triangle");

    const aiScene& scene = runSteps(importer, file, reading);
    Mesh mesh = readsAsOmplApp(reading) ? collect<float>(scene, file, reading)
                                        : collect<double>(scene, file, reading);
    mesh.origin.file = file;
    mesh.origin.format = formatName(importer, file);
    mesh.origin.isChecked = false;
    mesh.origin.ignoredFaces = faces - mesh.triangles.size();
    if (isShifted(reading)) notes.push_back("moved so that the mean of its vertices is the origin");
    mesh.origin.notes = std::move(notes);
    return {std::move(mesh), X_root};
}

}  // namespace clearway
