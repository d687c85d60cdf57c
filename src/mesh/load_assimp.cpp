// Reads mesh files through assimp, as they are or with the arithmetic of OMPL.app (float, assimp's defaults).
#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "clearway/mesh.h"
#include "mesh/check.h"
#include "mesh/component_names.h"
#include "mesh/readable_file.h"
#include "mesh/transform_text.h"

namespace clearway {

namespace {

/// Nothing that alters a coordinate or drops a triangle: no joining, no search for degenerate faces.
constexpr unsigned kStoredSteps = aiProcess_Triangulate | aiProcess_SortByPType;

/// OMPL.app's steps. The joined vertices and the collapsed nodes both enter the float mean it centres a robot
/// by, so none may be left out.
constexpr unsigned kOmplAppSteps = aiProcess_GenNormals | aiProcess_Triangulate |
                                   aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                   aiProcess_OptimizeGraph;

bool readsAsOmplApp(MeshReading reading) {
    return reading != MeshReading::kAsStored;
}

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

/// Collapsing nodes loses their names, so a mesh that one node shows takes the component's name with it.
void nameMeshesByNode(const aiScene& scene, const aiNode& node, const std::vector<std::size_t>& instances) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        if (instances[node.mMeshes[i]] == 1) mesh.mName.Set(nameOf(node, mesh));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) nameMeshesByNode(scene, *node.mChildren[i], instances);
}

/// assimp's importers hand on what stands in a damaged file, and its later steps trust it or abort. Its
/// reader of raw files leaves children out of sound ones.
void requireSoundNodes(const aiNode& node, const aiScene& scene, const std::string& file) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] < scene.mNumMeshes) continue;
        refuseMeshFile(file, "the reader's node '" + std::string(node.mName.C_Str()) + "' refers to mesh " +
                                 std::to_string(node.mMeshes[i]) + " of " + std::to_string(scene.mNumMeshes));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        if (!node.mChildren[i]) {
            refuseMeshFile(file, "the reader left out child " + std::to_string(i) + " of node '" +
                                     node.mName.C_Str() + "'");
        }
        requireSoundNodes(*node.mChildren[i], scene, file);
    }
}

void requireSoundFaces(const aiMesh& mesh, const std::string& file) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const auto face = [&] {
            return "face " + std::to_string(f) + " of mesh '" + mesh.mName.C_Str() + "'";
        };
        if (mesh.mFaces[f].mNumIndices == 0) refuseMeshFile(file, face() + " has no corner");
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
            const unsigned index = mesh.mFaces[f].mIndices[i];
            if (index < mesh.mNumVertices) continue;
            refuseMeshFile(file, face() + " refers to vertex " + std::to_string(index) + " of " +
                                     std::to_string(mesh.mNumVertices));
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
        refuseMeshFile(file, "its " + std::to_string(vertices) + " vertices are more than 2^32 - 1");
    }
}

bool isFinite(const aiVector3D& vertex) {
    return std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z);
}

/// Of the vertices that faces use.
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

/// The triangles that polygons of n corners make when each gives n - 2, and the points and lines.
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

std::string textOf(const aiMatrix4x4& transform) {
    Eigen::Matrix<double, 3, 4> map;
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 4; ++column) map(row, column) = transform[row][column];
    }
    return transformText(map);
}

bool isCollada(const Assimp::Importer& importer) {
    const aiImporterDesc* description =
        importer.GetImporterInfo(importer.GetPropertyInteger("importerIndex", -1));
    return description && std::string(description->mFileExtensions).find("dae") != std::string::npos;
}

/// The root node is where assimp's importers fold in units, up axes and their own conventions. COLLADA's root
/// holds nothing else, so there a file can be read as stored by leaving it out.
void settleRoot(const Assimp::Importer& importer, const aiScene& scene, MeshReading reading,
                std::vector<std::string>& notes) {
    aiMatrix4x4& transform = scene.mRootNode->mTransformation;
    if (transform == aiMatrix4x4()) return;  // exactly; IsIdentity() lets 1 % pass
    const std::string map = textOf(transform);
    if (!isCollada(importer)) {
        notes.push_back("transform of the root node applied: " + map);
    } else if (readsAsOmplApp(reading)) {
        notes.push_back("unit and up axis that the file declares applied: " + map);
    } else {
        notes.push_back("unit and up axis that the file declares not applied: " + map);
        transform = aiMatrix4x4();
    }
}

/// assimp's FBX importer passes on what the file says about its unit and axes, and applies neither.
void noteDeclaredUnits(const aiScene& scene, std::vector<std::string>& notes) {
    float centimetres = 1;
    std::int32_t axis = 1;
    if (!scene.mMetaData || !scene.mMetaData->Get("UnitScaleFactor", centimetres) ||
        !scene.mMetaData->Get("UpAxis", axis)) {
        return;
    }
    std::ostringstream note;
    note << "unit and up axis that the file declares not applied: unit " << centimetres << " cm, axis "
         << axis << " up";
    notes.push_back(note.str());
}

/// Walks the nodes in the file's order with all arithmetic in Real and collects what they show.
template <typename Real>
struct Collector {
    using Vector = aiVector3t<Real>;
    using Matrix = aiMatrix4x4t<Real>;

    const aiScene& scene;
    std::vector<std::size_t> instances;
    Mesh mesh;
    Vector sum;  ///< of the vertices of all meshes, those of lines too
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
        const bool isPlaced = X_rootNode == Matrix();  // multiplied, one NaN would spread to all coordinates
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

    /// A mirroring transform turns triangles over; turned back, they face the side the file says.
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

    /// What OMPL.app calls the centre: the mean, in its arithmetic, of all the scene's vertices.
    Vector3 centre(MeshReading reading) const {
        if (!isShifted(reading)) return Vector3::Zero();
        Vector mean = sum;
        mean /= static_cast<Real>(summed);
        return {mean.x, mean.y, reading == MeshReading::kOmplAppPlanarRobot ? 0 : mean.z};
    }
};

/// Refuses what cannot be built from, so that the first bad triangle is named before a shift spreads what is
/// not finite.
void requireSound(const Mesh& mesh, const std::string& file) {
    try {
        requireSoundMesh(mesh);
    } catch (const std::invalid_argument& error) {
        throw std::runtime_error("cannot read mesh '" + file + "': " + error.what());
    }
}

template <typename Real>
Mesh collect(const aiScene& scene, const std::string& file, const LoadOptions& options) {
    Collector<Real> collector(scene);
    collector.addNode(*scene.mRootNode, {});
    Mesh mesh = std::move(collector.mesh);
    if (mesh.triangles.empty()) refuseMeshFile(file, "it holds no triangle");
    makeNamesDistinct(mesh.components, std::filesystem::path(file).stem().string());
    requireSound(mesh, file);
    const Vector3 centre = collector.centre(options.reading);
    for (Vector3& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) {
            vertex[i] = options.scale * double(static_cast<Real>(vertex[i]) - static_cast<Real>(centre[i]));
        }
    }
    requireSound(mesh, file);
    if (isShifted(options.reading)) mesh.origin.shift = -options.scale * centre;
    return mesh;
}

/// Calls assimp, whose errors come as null scenes and, out of memory for one, as exceptions.
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

/// assimp 5.2 takes wrong indices from sound files of glTF 1.0 and aborts. Without that reader they are
/// refused; glTF 2.0 has its own.
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
    // A file with only a skeleton would otherwise be given made-up triangles.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    const aiScene& scene = requireScene(importer, file, [&] { return importer.ReadFile(file, 0); });
    requireSoundScene(scene, file);
    return scene;
}

const aiScene& runSteps(Assimp::Importer& importer, const std::string& file, MeshReading reading) {
    unsigned steps = readsAsOmplApp(reading) ? kOmplAppSteps : kStoredSteps;
    // Joining compares so that a NaN equals everything; it would hide what is to be refused.
    if (!hasFiniteFaces(*importer.GetScene()))
        steps &= ~static_cast<unsigned>(aiProcess_JoinIdenticalVertices);
    return requireScene(importer, file, [&] { return importer.ApplyPostProcessing(steps); });
}

}  // namespace

Mesh loadMesh(const std::string& file, const LoadOptions& options) {
    if (!(options.scale > 0) || !std::isfinite(options.scale)) {
        std::ostringstream message;
        message << "scale is " << options.scale << ", expected a finite number above 0";
        throw std::invalid_argument(message.str());
    }
    requireReadableMeshFile(file);
    std::vector<std::string> notes;
    Assimp::Importer importer;
    const aiScene& stored = readStored(importer, file);
    settleRoot(importer, stored, options.reading, notes);
    noteDeclaredUnits(stored, notes);
    nameMeshesByNode(stored, *stored.mRootNode, instancesOf(stored));
    const std::size_t faces = countFaces(stored);
    if (faces == 0) refuseMeshFile(file, "it holds no triangle");

    const aiScene& scene = runSteps(importer, file, options.reading);
    Mesh mesh = readsAsOmplApp(options.reading) ? collect<float>(scene, file, options)
                                                : collect<double>(scene, file, options);
    mesh.origin.file = file;
    mesh.origin.scale = options.scale;
    mesh.origin.ignoredFaces = faces - mesh.triangles.size();
    if (isShifted(options.reading)) notes.push_back("moved so that the mean of its vertices is the origin");
    mesh.origin.notes = std::move(notes);
    return mesh;
}

}  // namespace clearway
