// Meshes of any vertices, triangles and components are refused if they should be, and otherwise cleaned
// without loss, built, saved and loaded.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "clearway/model.h"
#include "clearway/query.h"
#include "fuzz/bytes.h"
#include "fuzz/soup.h"
#include "mesh/clean.h"
#include "model/model_data.h"
#include "support/temporary_folder.h"
#include "tree/flat_tree.h"

namespace clearway::testing {
namespace {

Mesh takeMesh(Bytes& bytes) {
    SoupReader soup(bytes, bytes.below(2) == 1);
    Mesh mesh;
    for (std::size_t count = bytes.below(24); count > 0; --count) mesh.vertices.push_back(soup.point());
    const auto vertex = [&] {
        const std::uint32_t index = bytes.byte();
        return index < 252 && !mesh.vertices.empty() ? index % std::uint32_t(mesh.vertices.size()) : index;
    };
    for (std::size_t count = bytes.below(32); count > 0; --count) {
        mesh.triangles.push_back({vertex(), vertex(), vertex()});
    }
    std::uint32_t next = 0;
    for (std::size_t count = bytes.below(8) / 3; count > 0; --count) {
        const auto triangles = count == 1 && bytes.below(8) > 0
                                   ? std::uint32_t(mesh.triangles.size()) - next
                                   : std::uint32_t(bytes.below(mesh.triangles.size() + 1));
        mesh.components.push_back({"part", next, triangles});
        next += triangles;
    }
    return mesh;
}

/// Whether Model::build should refuse the mesh; written independently of its code.
bool isSound(const Mesh& mesh) {
    std::uint64_t covered = 0;
    for (const Component& component : mesh.components) {
        if (component.firstTriangle != covered) return false;
        covered += component.triangleCount;
    }
    if (!mesh.components.empty() && covered != mesh.triangles.size()) return false;
    return !mesh.triangles.empty() &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const TriangleIndices& triangle) {
               return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t index) {
                   return index < mesh.vertices.size() && mesh.vertices[index].allFinite();
               });
           });
}

using Corners = std::vector<std::array<double, 3>>;

/// The corners sorted and without negative zeros: equal for equal triangles, whatever their vertices' numbers
/// and order.
Corners cornersOf(const std::vector<Vector3>& vertices, const TriangleIndices& triangle) {
    Corners corners;
    for (const std::uint32_t index : triangle) {
        const Vector3 v = vertices[index] + Vector3::Zero();
        corners.push_back({v[0], v[1], v[2]});
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

void requireCleanedWithoutLoss(const Mesh& mesh) {
    const CleanMesh cleaned = clean(mesh);
    std::vector<Corners> given, kept;
    for (const TriangleIndices& triangle : mesh.triangles)
        given.push_back(cornersOf(mesh.vertices, triangle));
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) {
        kept.push_back(cornersOf(cleaned.vertices, cleaned.triangles[i]));
        require(kept.back() == given.at(cleaned.triangleIds.at(i)),
                "an id is the triangle's place in the mesh");
    }
    require(given.size() == kept.size() + cleaned.report.duplicateTriangles,
            "all triangles are accounted for");
    std::sort(given.begin(), given.end());
    given.erase(std::unique(given.begin(), given.end()), given.end());
    std::sort(kept.begin(), kept.end());
    require(given == kept, "each different triangle is kept once");
}

void requireSoundModel(const Model& model, std::size_t triangles) {
    require(faultOf(treeOf(model), triangles).empty(), "a tree that was built is sound");
    const BuildReport& report = model.report();
    require(report.triangles + report.clean.duplicateTriangles == triangles,
            "the report counts all triangles");
}

/// A mesh at its own place touches itself, unless its coordinates are such that queries refuse them.
void requireTouching(const Model& a, const Model& b) {
    Workspace workspace;
    const Box box = a.box();
    const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    if (largest >= 1e298 || (largest > 0 && largest < 1e-298)) {
        try {
            collides(a, b, {}, workspace);
        } catch (const std::invalid_argument&) {
            return;
        }
        require(false, "coordinates this large or small are refused by queries");
    }
    require(collides(a, b, {}, workspace), "a mesh collides with itself in place");
    require(isWithin(a, b, {}, 0, workspace), "a mesh is within 0 of itself in place");
    const DistanceResult result = distance(a, b, {}, {}, workspace);
    require(result.lower == 0 && result.upper == 0, "a mesh is at distance 0 of itself in place");
}

void requireKeptBySaving(const Model& model, std::size_t triangles) {
    static const TemporaryFolder folder;
    const std::string file = folder.file("model.clearway");
    model.save(file);
    const Model loaded = Model::load(file);
    require(loaded.key() == model.key(), "the key is kept");
    requireSoundModel(loaded, triangles);
    requireTouching(model, loaded);
}

}  // namespace

void fuzzOne(std::string_view input) {
    Bytes bytes(input);
    const bool isSaved = bytes.below(4) == 0;
    const BuildOptions options = takeOptions(bytes);
    const Mesh mesh = takeMesh(bytes);
    if (!isSound(mesh)) {
        try {
            Model::build(mesh, options);
        } catch (const std::invalid_argument&) {
            return;
        }
        require(false, "a mesh that is not sound is refused");
    }
    requireCleanedWithoutLoss(mesh);
    const Model model = Model::build(mesh, options);
    requireSoundModel(model, mesh.triangles.size());
    requireTouching(model, model);
    if (isSaved) requireKeptBySaving(model, mesh.triangles.size());
}

std::vector<std::string> seeds() {
    std::vector<std::string> result;
    for (int step = 1; step < 12; ++step) {  // each step makes other choices everywhere
        std::string bytes;
        for (int i = 0; i < 400; ++i) bytes += static_cast<char>(i * step % 251);
        result.push_back(bytes);
    }
    return result;
}

}  // namespace clearway::testing
