#include "mesh/read/gltf_primitive.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>

#include "core/number.h"

namespace clearway {
namespace {

/// Vertices or corners that are read at a time; divisible by 6, as triangles and the turns of strips need.
constexpr std::size_t kBlock = 1536;

/// Tolerance of the sum of a vertex's skin weights, 1: exporters round them. They are divided by the sum.
constexpr double kWeightSum = 1e-2;

enum Mode : std::size_t { kPoints, kLines, kLineLoop, kLineStrip, kTriangles, kStrip, kFan };

/// How many points or segments the mode makes.
std::size_t countLines(std::size_t mode, std::size_t corners) {
    if (mode == kLines) return corners / 2;
    return mode == kLineStrip ? corners - std::min<std::size_t>(corners, 1) : corners;
}

void requireCount(const GltfAccessor& accessor, const char* role, std::size_t vertices,
                  const GltfItem& item) {
    if (accessor.count == vertices) return;
    item.refuse("has {} rows of {} in accessor {}, expected {} as its primitive has vertices", accessor.count,
                role, accessor.number, vertices);
}

/// Without data, an accessor's numbers are 0, unless an extension has them.
void requireData(const GltfAccessor& accessor, const GltfItem& primitive) {
    const std::string extensions = accessor.hasData() ? "" : primitive.extensionNames();
    if (extensions.empty()) return;
    primitive.refuse("has the data of accessor {} only in an extension, which is not read: {}",
                     accessor.number, extensions);
}

/// Adds the primitives of one component. Primitives that have equal vertices share them.
class GltfComponent {
  public:
    GltfComponent(GltfFile& file, const GltfShowing& showing, MeshCollector& mesh)
        : file_(file), showing_(showing), mesh_(mesh) {}

    void add(const GltfItem& primitive) {
        const std::optional<GltfItem> attributes = primitive.object("attributes");
        if (!attributes || !attributes->find("POSITION")) primitive.refuse("has no POSITION");
        const Vertices vertices = verticesOf(primitive, *attributes);
        const Corners corners = cornersOf(primitive, vertices);
        if (corners.mode < kTriangles) return mesh_.ignoreFaces(countLines(corners.mode, corners.count));
        std::vector<std::size_t> key = {vertices.positions.number, vertices.joints.size()};
        for (std::size_t set = 0; set < vertices.joints.size(); ++set) {
            key.insert(key.end(), {vertices.joints[set].number, vertices.weights[set].number});
        }
        for (const Target& target : vertices.targets)
            key.insert(key.end(), {target.position, target.moves.number});
        if (mesh_.vertexCount() == 0) mesh_.reserve(vertices.positions.count, corners.triangles());
        Added& added = added_[key];
        // Many meshes may share one long list of vertices. A mesh that uses few of them adds these alone.
        if (!added.isWhole && corners.count >= vertices.positions.count / 2) addVertices(vertices, added);
        addTriangles(vertices, corners, added);
    }

  private:
    struct Target {
        std::size_t position;  ///< among the primitive's targets
        GltfAccessor moves;
        double weight;
    };
    /// The vertices of a primitive.
    struct Vertices {
        GltfAccessor positions;
        std::vector<Target> targets;
        std::vector<GltfAccessor> joints, weights;  ///< sets of four
        std::string name;                           ///< of the primitive
    };
    /// The places of vertices in the collector.
    struct Added {
        bool isWhole = false;
        std::uint32_t first = 0;                                  ///< if all vertices are there
        std::unordered_map<std::uint32_t, std::uint32_t> places;  ///< otherwise
    };
    struct Corners {
        std::size_t mode, count;
        std::optional<GltfAccessor> indices;

        std::size_t triangles() const { return mode == 4 ? count / 3 : count; }  ///< at most
    };

    Vertices verticesOf(const GltfItem& primitive, const GltfItem& attributes) {
        Vertices vertices;
        vertices.name = primitive.name;
        vertices.positions = file_.accessor(attributes.requiredNumber("POSITION"), "VEC3", primitive);
        requireData(vertices.positions, primitive);
        findTargets(vertices, primitive);
        if (!showing_.skin.empty()) findJoints(vertices, attributes);
        return vertices;
    }

    void findTargets(Vertices& vertices, const GltfItem& primitive) {
        const std::vector<double>& weights = showing_.weights;
        if (weights.empty()) return;
        const std::vector<GltfItem> targets = primitive.objects("targets", "target");
        if (weights.size() != targets.size()) {
            primitive.refuse("has {} morph targets, its mesh or node has {} weights", targets.size(),
                             weights.size());
        }
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const std::optional<std::size_t> number = targets[i].number("POSITION");
            if (weights[i] == 0 || !number) continue;
            vertices.targets.push_back({i, file_.accessor(*number, "VEC3", targets[i]), weights[i]});
            requireCount(vertices.targets.back().moves, "POSITION", vertices.positions.count, targets[i]);
        }
    }

    void findJoints(Vertices& vertices, const GltfItem& attributes) {
        for (std::size_t set = 0;; ++set) {
            const std::string joints = fmt::format("JOINTS_{}", set),
                              weights = fmt::format("WEIGHTS_{}", set);
            const std::optional<std::size_t> jointsNumber = attributes.number(joints.c_str());
            const std::optional<std::size_t> weightsNumber = attributes.number(weights.c_str());
            if (!jointsNumber && !weightsNumber && set > 0) return;
            if (!jointsNumber || !weightsNumber) {
                attributes.refuse("lack {}, which {} needs", jointsNumber ? weights : joints, showing_.skin);
            }
            vertices.joints.push_back(file_.accessor(*jointsNumber, "VEC4", attributes));
            vertices.weights.push_back(file_.accessor(*weightsNumber, "VEC4", attributes));
            requireCount(vertices.joints.back(), joints.c_str(), vertices.positions.count, attributes);
            requireCount(vertices.weights.back(), weights.c_str(), vertices.positions.count, attributes);
        }
    }

    Corners cornersOf(const GltfItem& primitive, const Vertices& vertices) {
        Corners corners{primitive.number("mode").value_or(kTriangles), vertices.positions.count, {}};
        if (corners.mode > kFan) primitive.refuse("has mode {}, expected 0 to 6", corners.mode);
        if (const std::optional<std::size_t> number = primitive.number("indices")) {
            corners.indices = file_.accessor(*number, "SCALAR", primitive);
            const std::size_t type = corners.indices->componentType;
            if (type != 5121 && type != 5123 && type != 5125) {
                primitive.refuse(
                    "has indices of componentType {} in accessor {}, expected 5121, 5123 or 5125", type,
                    *number);
            }
            corners.indices->isNormalized = false;
            requireData(*corners.indices, primitive);
            corners.count = corners.indices->count;
        }
        const bool isCut =
            corners.mode == kTriangles ? corners.count % 3 != 0 : corners.count == 1 || corners.count == 2;
        if (corners.mode >= kTriangles && isCut) {
            primitive.refuse(
                "has {} corners, expected {}", corners.count,
                corners.mode == kTriangles ? "three for each triangle" : "at least 3 in a strip or fan");
        }
        return corners;
    }

    void read(const Vertices& vertices, std::size_t first, std::size_t rows, Vector3* points) const {
        vertices.positions.read(first, rows, points->data());
        std::vector<Vector3> moves(vertices.targets.empty() ? 0 : rows);
        for (const Target& target : vertices.targets) {
            target.moves.read(first, rows, moves.data()->data());
            for (std::size_t i = 0; i < rows; ++i) points[i] += target.weight * moves[i];
        }
        if (!showing_.skin.empty()) return bend(vertices, first, rows, points);
        const Placement& X_fileMesh = showing_.X_fileMesh;
        // A product with the identity would change -0, and spread one NaN to all coordinates.
        if (X_fileMesh.linear == Matrix3::Identity() && X_fileMesh.translation == Vector3::Zero()) return;
        for (std::size_t i = 0; i < rows; ++i) points[i] = X_fileMesh(points[i]);
    }

    void bend(const Vertices& vertices, std::size_t first, std::size_t rows, Vector3* points) const {
        std::vector<double> sums(rows), joints(4 * rows), weights(4 * rows);
        std::vector<Vector3> bent(rows, Vector3::Zero());
        for (std::size_t set = 0; set < vertices.joints.size(); ++set) {
            vertices.joints[set].read(first, rows, joints.data());
            vertices.weights[set].read(first, rows, weights.data());
            for (std::size_t i = 0; i < 4 * rows; ++i) {
                if (weights[i] == 0) continue;
                if (!(joints[i] >= 0 && joints[i] < double(showing_.joints.size()) && weights[i] > 0)) {
                    mesh_.refuse(
                        "vertex {} of {} has joint {} with weight {}, expected one of the {} joints of {} "
                        "and a "
                        "weight above 0",
                        first + i / 4, vertices.name, shortNumber(joints[i]), shortNumber(weights[i]),
                        showing_.joints.size(), showing_.skin);
                }
                sums[i / 4] += weights[i];
                bent[i / 4] +=
                    weights[i] * showing_.joints[static_cast<std::size_t>(joints[i])](points[i / 4]);
            }
        }
        for (std::size_t i = 0; i < rows; ++i) {
            if (!(std::fabs(sums[i] - 1) <= kWeightSum)) {
                mesh_.refuse("vertex {} of {} has skin weights whose sum is {}, expected 1", first + i,
                             vertices.name, shortNumber(sums[i]));
            }
            points[i] = bent[i] / sums[i];
        }
    }

    void addVertices(const Vertices& vertices, Added& added) {
        added.isWhole = true;
        added.first = static_cast<std::uint32_t>(mesh_.vertexCount());
        std::vector<Vector3> points(kBlock);
        for (std::size_t first = 0; first < vertices.positions.count; first += kBlock) {
            const std::size_t rows = std::min(kBlock, vertices.positions.count - first);
            read(vertices, first, rows, points.data());
            for (std::size_t i = 0; i < rows; ++i) mesh_.addVertex(points[i]);
        }
    }

    /// Adds the vertex unless it is there.
    std::uint32_t placeOf(const Vertices& vertices, std::uint32_t vertex, Added& added) {
        const auto [place, isNew] = added.places.try_emplace(vertex, 0);
        if (isNew) {
            Vector3 point;
            read(vertices, vertex, 1, &point);
            place->second = mesh_.addVertex(point);
        }
        return place->second;
    }

    /// The places of corners first to first + rows - 1.
    void readCorners(const Vertices& vertices, const Corners& corners, std::size_t first, std::size_t rows,
                     Added& added, std::uint32_t* places) {
        std::vector<double> indices(rows);
        std::iota(indices.begin(), indices.end(), double(first));
        if (corners.indices) corners.indices->read(first, rows, indices.data());
        const double count = double(vertices.positions.count);
        for (std::size_t i = 0; i < rows; ++i) {
            if (!(indices[i] < count)) {
                mesh_.refuse("{} has index {} at position {} of accessor {}, it has {} vertices",
                             vertices.name, shortNumber(indices[i]), first + i, corners.indices->number,
                             shortNumber(count));
            }
            const auto index = static_cast<std::uint32_t>(indices[i]);
            places[i] = added.isWhole ? added.first + index : placeOf(vertices, index, added);
        }
    }

    void addTriangles(const Vertices& vertices, const Corners& corners, Added& added) {
        const bool isMirrored = showing_.isMirrored;
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            isMirrored ? mesh_.addTriangle(a, c, b) : mesh_.addTriangle(a, b, c);
        };
        std::vector<std::uint32_t> block(kBlock);
        std::uint32_t start = 0, beforeLast = 0, last = 0;  // corners of a strip or fan
        for (std::size_t first = 0; first < corners.count; first += kBlock) {
            const std::size_t rows = std::min(kBlock, corners.count - first);
            readCorners(vertices, corners, first, rows, added, block.data());
            if (first == 0) start = block[0];
            for (std::size_t i = 0; corners.mode == kTriangles && i < rows; i += 3)
                add(block[i], block[i + 1], block[i + 2]);
            for (std::size_t i = 0; corners.mode != kTriangles && i < rows; ++i) {
                const std::uint32_t corner = block[i];
                if (first + i < 2) {
                } else if (corners.mode == kFan) {
                    add(last, corner, start);
                } else if (i % 2 == 0) {
                    add(beforeLast, last, corner);
                } else {  // every other triangle of a strip runs the other way around
                    add(beforeLast, corner, last);
                }
                beforeLast = last;
                last = corner;
            }
        }
    }

    GltfFile& file_;
    const GltfShowing& showing_;
    MeshCollector& mesh_;
    /// By the numbers of all accessors that the vertices depend on.
    std::map<std::vector<std::size_t>, Added> added_;
};

}  // namespace

void addGltfPrimitives(GltfFile& file, const GltfShowing& showing, const std::vector<GltfItem>& primitives,
                       MeshCollector& mesh) {
    GltfComponent component(file, showing, mesh);
    for (const GltfItem& primitive : primitives) component.add(primitive);
}

}  // namespace clearway
