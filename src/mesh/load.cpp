// Reads mesh files: with the readers of read/ where they know the format, else with assimp. The readings as OMPL.app
// use assimp, unless assimp would change no vertex.
#include <fmt/format.h>
#include <algorithm>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <cmath>
#include <new>
#include <string_view>
#include <tuple>
#include <vector>

#include "clearway/errors.h"
#include "clearway/mesh.h"
#include "core/hash.h"
#include "core/number.h"
#include "mesh/check.h"
#include "mesh/read/assimp.h"
#include "mesh/read/formats.h"

namespace clearway {
namespace {

namespace interprocess = boost::interprocess;

/// A file's bytes, while it lives. Pages that were read count as memory of the file, not of the process.
class MappedFile {
  public:
    explicit MappedFile(const std::string& file)
        : mapping_(file.c_str(), interprocess::read_only), region_(mapping_, interprocess::read_only) {
        region_.advise(interprocess::mapped_region::advice_sequential);
    }

    std::string_view bytes() const {
        return {static_cast<const char*>(region_.get_address()), region_.get_size()};
    }

  private:
    interprocess::file_mapping mapping_;
    interprocess::mapped_region region_;
};

/// Whether two different vertices are within 1e-5 of each other, so that assimp may join them. Vertices that share a cell of a grid are
/// compared; one near a border of its cell belongs to the cells beyond it, too.
bool hasNearVertices(const Mesh& mesh) {
    constexpr double kJoined = 1.01e-5, kCell = 32 * kJoined;
    using CellVertex = std::tuple<std::uint64_t, double, double, double>;  // the cell's hash, the vertex
    std::vector<CellVertex> entries;
    for (const Vector3& vertex : mesh.vertices) {
        if (!vertex.allFinite()) continue;  // no triangle uses it, or the mesh is refused
        const Vector3 least = ((vertex.array() - kJoined) / kCell).floor(),
                      most = ((vertex.array() + kJoined) / kCell).floor();
        for (int corner = 0; corner < 8; ++corner) {
            Hash hash;
            bool isNew = true;  // a corner of the vertex's surroundings in a cell of its own
            for (int axis = 0; axis < 3; ++axis) {
                const bool isUpper = (corner >> axis & 1) != 0;
                isNew = isNew && !(isUpper && most[axis] == least[axis]);
                hash.add(isUpper ? most[axis] : least[axis]);
            }
            if (isNew) entries.emplace_back(hash.value(), vertex.x(), vertex.y(), vertex.z());
        }
    }
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    const auto pointOf = [](const CellVertex& entry) {
        return Vector3(std::get<1>(entry), std::get<2>(entry), std::get<3>(entry));
    };
    for (std::size_t i = 0; i < entries.size(); ++i) {
        for (std::size_t j = i + 1; j < entries.size() && std::get<0>(entries[j]) == std::get<0>(entries[i]);
             ++j) {
            if ((pointOf(entries[j]) - pointOf(entries[i])).norm() <= kJoined) return true;
        }
    }
    return false;
}

void roundToFloat(Mesh& mesh) {
    for (Vector3& vertex : mesh.vertices) vertex = vertex.cast<float>().cast<double>();
}

/// Throws FileError when assimp finds another number of triangles or another box than clearway's reader. theirs:
/// assimp's mesh; ours: that of clearway's reader.
void requireSameSurface(const AssimpMesh& theirs, const Mesh& ours, const std::string& file) {
    const std::size_t count = theirs.mesh.triangles.size();
    // assimp fills faces that cross themselves.
    const std::size_t most =
        ours.triangles.size() + (ours.origin.crossingFaces > 0 ? ours.origin.ignoredFaces : 0);
    if (count < ours.triangles.size() || count > most) {
        throw FileError(
            fmt::format("cannot read mesh '{}' as OMPL.app does: its reader (assimp) finds {} triangles, the "
                        "file holds {}, expected reading = stored",
                        file, count, ours.triangles.size()));
    }
    constexpr double kTolerance = 1e-4;  // of the largest coordinate; float and its text are finer
    Box expected;
    for (const TriangleIndices& triangle : ours.triangles) {
        for (const std::uint32_t vertex : triangle) expected.extend(theirs.applied(ours.vertices[vertex]));
    }
    const Box found = boundingBox(theirs.mesh).translate(-theirs.mesh.origin.shift);
    const double size = std::max(expected.min().cwiseAbs().maxCoeff(), expected.max().cwiseAbs().maxCoeff());
    const double difference = std::max((expected.min() - found.min()).cwiseAbs().maxCoeff(),
                                       (expected.max() - found.max()).cwiseAbs().maxCoeff());
    if (difference <= kTolerance * size) return;
    const auto text = [](const Box& box) {
        return roundedPoint(box.min()) + " to " + roundedPoint(box.max());
    };
    throw FileError("cannot read mesh '" + file + "' as OMPL.app does: its reader (assimp) finds the box " +
                    text(found) + ", the file holds " + text(expected) + ", expected reading = stored");
}

/// Reads a mesh as OMPL.app does. An environment whose format has no transforms and whose vertices lie apart comes
/// from clearway's reader, rounded to float, because assimp would change no vertex. All other meshes come from
/// assimp: a robot is shifted by the mean of assimp's vertices.
Mesh readAsOmplApp(const MeshFormat* format, const std::string& file, std::string_view bytes,
                   MeshReading reading) {
    if (!format) return readByAssimp(file, reading).mesh;
    Mesh ours = readMesh(*format, file, bytes);
    requireSoundMeshFile(ours, file);
    if (reading == MeshReading::kOmplAppEnvironment && !format->hasNodes) {
        roundToFloat(ours);
        if (!hasNearVertices(ours)) return ours;
    }
    AssimpMesh theirs = readByAssimp(file, reading);
    requireSameSurface(theirs, ours, file);
    MeshOrigin &origin = theirs.mesh.origin, &stored = ours.origin;
    origin.format = format->name;
    origin.isChecked = true;
    origin.unitMetres = stored.unitMetres;
    origin.upAxis = stored.upAxis;
    origin.bentFaces = stored.bentFaces;
    origin.bentBy = stored.bentBy;
    origin.deflection = stored.deflection;
    origin.notes.insert(origin.notes.end(), stored.notes.begin(), stored.notes.end());
    if (theirs.mesh.triangles.size() == ours.triangles.size()) {
        origin.crossingFaces = stored.crossingFaces;
    } else {
        origin.notes.push_back(
            fmt::format("{} faces whose outlines cross themselves are filled as OMPL.app fills them",
                        stored.crossingFaces));
    }
    return std::move(theirs.mesh);
}

}  // namespace

Mesh loadMesh(const std::string& file, const LoadOptions& options) {
    if (!(options.scale > 0) || !std::isfinite(options.scale)) {
        throw ArgumentError(fmt::format("scale is {:g}, expected a finite number above 0", options.scale));
    }
    requireReadableMeshFile(file);
    const MappedFile mapped(file);
    const MeshFormat* const format = meshFormatOf(file, mapped.bytes());
    Mesh mesh;
    try {
        if (readsAsOmplApp(options.reading)) {
            mesh = readAsOmplApp(format, file, mapped.bytes(), options.reading);
        } else {
            mesh =
                format ? readMesh(*format, file, mapped.bytes()) : readByAssimp(file, options.reading).mesh;
        }
    } catch (const std::bad_alloc&) {
        throw FileError("cannot read mesh '" + file + "': it takes more memory than there is");
    }
    requireSoundMeshFile(mesh, file);
    mesh.origin.warnings = readingWarnings(mesh);
    mesh.origin.scale = options.scale;
    mesh.origin.shift *= options.scale;
    if (options.scale == 1) return mesh;
    for (Vector3& vertex : mesh.vertices) vertex *= options.scale;
    for (Component& component : mesh.components) component.deflection *= options.scale;
    requireSoundMeshFile(mesh, file);
    return mesh;
}

}  // namespace clearway
