// Writes .glb: a JSON chunk that describes the views of one binary chunk.
// Source: Khronos Group, glTF 2.0 Specification.
#include "mesh/glb.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "clearway/errors.h"
#include "core/json.h"
#include "mesh/check.h"
#include "mesh/components.h"
#include "mesh/renumber.h"

namespace clearway {

namespace {

constexpr int kFloat = 5126;  // glTF's component types
constexpr int kUnsigned = 5125;
constexpr int kVertexBuffer = 34962;  // targets of buffer views
constexpr int kIndexBuffer = 34963;

/// The rotation of z to y and y to -z, column by column. A quaternion of floats cannot turn by exactly 90
/// degrees: far from the origin, readers would then find coordinates that differ from the meshes'.
constexpr int kUpright[] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};

/// The least and the largest value of each coordinate, as fields of an accessor.
template <class Vertices>
FloatJson boundsOf(const Vertices& vertices) {
    auto least = vertices[0], most = vertices[0];
    for (const auto& vertex : vertices) {
        for (std::size_t i = 0; i < vertex.size(); ++i) {
            least[i] = std::min(least[i], vertex[i]);
            most[i] = std::max(most[i], vertex[i]);
        }
    }
    return {{"min", least}, {"max", most}};
}

void writeWord(std::ostream& stream, std::uint64_t word) {
    const char bytes[4] = {static_cast<char>(word), static_cast<char>(word >> 8),
                           static_cast<char>(word >> 16), static_cast<char>(word >> 24)};
    stream.write(bytes, sizeof bytes);
}

/// The JSON description and pointers to the data of the binary chunk. Added data must outlive the document.
class Document {
  public:
    /// Appends the item to one of the description's lists and returns its position there.
    std::size_t add(const char* list, FloatJson item) {
        json_[list].push_back(std::move(item));
        return json_[list].size() - 1;
    }

    /// Adds a node with one mesh and returns the number of the node. primitive: further fields of the mesh.
    std::size_t addPart(const SavePart& part, FloatJson primitive = {}) {
        primitive["attributes"]["POSITION"] =
            addAccessor(part.vertices, kFloat, "VEC3", kVertexBuffer, boundsOf(part.vertices));
        primitive["indices"] = addAccessor(part.triangles, kUnsigned, "SCALAR", kIndexBuffer);
        const std::size_t mesh =
            add("meshes", {{"name", part.name}, {"primitives", FloatJson::array({std::move(primitive)})}});
        return add("nodes", {{"name", part.name}, {"mesh", mesh}});
    }

    void addRoot(std::size_t node) { json_["scenes"][0]["nodes"].push_back(node); }

    /// Adds rows of 4-byte numbers. target: 0 for none. accessor: further fields.
    template <class Rows>
    std::size_t addAccessor(const Rows& rows, int componentType, const std::string& type, int target,
                            FloatJson accessor = {}) {
        const std::size_t bytes = rows.size() * sizeof(rows[0]);
        const std::size_t width = type == "SCALAR" ? 4 : sizeof(rows[0]);
        FloatJson view = {{"buffer", 0}, {"byteOffset", binaryBytes_}, {"byteLength", bytes}};
        if (target != 0) view["target"] = target;
        pieces_.push_back({rows.data(), bytes});
        binaryBytes_ += bytes;
        accessor["bufferView"] = add("bufferViews", std::move(view));
        accessor["componentType"] = componentType;
        accessor["count"] = bytes / width;
        accessor["type"] = type;
        return add("accessors", std::move(accessor));
    }

    void write(std::ostream& stream) {
        json_["buffers"][0]["byteLength"] = binaryBytes_;
        std::string text = jsonText(json_);
        text.append((4 - text.size() % 4) % 4, ' ');  // whole words
        const std::uint64_t bytes = 12 + 8 + text.size() + 8 + binaryBytes_;
        if (bytes > std::numeric_limits<std::uint32_t>::max()) {
            throw ArgumentError(
                fmt::format("the mesh takes {} bytes, expected at most 2^32 - 1 for a .glb file", bytes));
        }
        writeWord(stream, 0x46546c67);  // "glTF"
        writeWord(stream, 2);
        writeWord(stream, bytes);
        writeWord(stream, text.size());
        writeWord(stream, 0x4e4f534a);  // "JSON"
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        writeWord(stream, binaryBytes_);
        writeWord(stream, 0x004e4942);  // "BIN"
        for (const Piece& piece : pieces_)
            stream.write(static_cast<const char*>(piece.data), static_cast<std::streamsize>(piece.bytes));
    }

  private:
    struct Piece {
        const void* data;
        std::size_t bytes;
    };
    FloatJson json_ = {{"asset", {{"version", "2.0"}, {"generator", "clearway"}}}, {"scene", 0}};
    std::vector<Piece> pieces_;
    std::uint64_t binaryBytes_ = 0;
};

FloatJson materialOf(const std::string& name, const std::array<float, 4>& colour) {
    return {{"name", name},
            {"doubleSided", true},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", colour}, {"metallicFactor", 0}, {"roughnessFactor", 0.7}}}};
}

/// Colours of movers, which take turns.
constexpr std::array<float, 4> kMoverColours[] = {{0.95f, 0.45f, 0.05f, 1}, {0.02f, 0.35f, 0.80f, 1},
                                                  {0.10f, 0.50f, 0.15f, 1}, {0.65f, 0.05f, 0.30f, 1},
                                                  {0.80f, 0.65f, 0.05f, 1}, {0.05f, 0.55f, 0.60f, 1}};

/// A mover's keys as the format stores them: one list for each kind of number.
struct Samples {
    std::vector<float> times;
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 4>> rotations;
    std::vector<float> showTimes;
    std::vector<std::array<float, 3>> scales;

    explicit Samples(const GlbMover& mover) {
        for (const GlbKey& key : mover.keys) {
            times.push_back(key.seconds);
            positions.push_back(key.position);
            rotations.push_back(key.rotation);
        }
        if (mover.hiddenFrom < 0) return;
        showTimes = {0, mover.hiddenFrom};
        scales = {{1, 1, 1}, {0, 0, 0}};
    }
};

/// Adds the channels of one mover, the node, to an animation.
void addChannels(const Samples& samples, std::size_t node, Document& document, FloatJson& animation) {
    const auto addTimes = [&](const std::vector<float>& times) {
        return document.addAccessor(
            times, kFloat, "SCALAR", 0,
            {{"min", FloatJson::array({times.front()})}, {"max", FloatJson::array({times.back()})}});
    };
    const auto add = [&](const char* path, std::size_t input, std::size_t output, const char* interpolation) {
        const std::size_t sampler = animation["samplers"].size();
        animation["samplers"].push_back(
            {{"input", input}, {"interpolation", interpolation}, {"output", output}});
        animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    };
    const std::size_t times = addTimes(samples.times);
    add("translation", times, document.addAccessor(samples.positions, kFloat, "VEC3", 0), "LINEAR");
    add("rotation", times, document.addAccessor(samples.rotations, kFloat, "VEC4", 0), "LINEAR");
    if (samples.showTimes.empty()) return;
    const std::size_t showTimes = addTimes(samples.showTimes);
    add("scale", showTimes, document.addAccessor(samples.scales, kFloat, "VEC3", 0), "STEP");
}

std::array<float, 3> rounded(const Mesh& mesh, std::size_t triangle, const Vector3& vertex) {
    if (vertex.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
        throw ArgumentError(fmt::format(
            "{} has a vertex at ({:g}, {:g}, {:g}), expected coordinates within a float's range to write",
            nameOfTriangle(mesh, triangle), vertex.x(), vertex.y(), vertex.z()));
    }
    return {static_cast<float>(vertex.x()), static_cast<float>(vertex.y()), static_cast<float>(vertex.z())};
}

SavePart partOf(const Mesh& mesh, const Component& component, FirstUseOrder& numberOf) {
    SavePart part;
    part.name = component.name;
    part.triangles.reserve(component.triangleCount);
    const std::size_t end = std::size_t(component.firstTriangle) + component.triangleCount;
    for (std::size_t id = component.firstTriangle; id < end; ++id) {
        TriangleIndices triangle = mesh.triangles[id];
        for (std::uint32_t& vertex : triangle) {
            vertex = numberOf(vertex, [&](std::uint32_t used) {
                part.vertices.push_back(rounded(mesh, id, mesh.vertices[used]));
            });
        }
        part.triangles.push_back(triangle);
    }
    return part;
}

}  // namespace

std::vector<SavePart> savePartsOf(const Mesh& mesh, const std::string& namelessName) {
    requireSoundMesh(mesh);
    FirstUseOrder numberOf(mesh.vertices.size());
    std::vector<SavePart> parts;
    for (const Component& component : componentsOf(mesh)) {
        if (component.triangleCount == 0) continue;
        numberOf.restart();
        parts.push_back(partOf(mesh, component, numberOf));
        if (parts.back().name.empty()) parts.back().name = namelessName;
    }
    return parts;
}

void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream) {
    Document document;
    for (const SavePart& part : parts) document.addRoot(document.addPart(part));
    document.write(stream);
}

void writeMovingGlb(const std::vector<SavePart>& still, const std::vector<GlbMover>& movers, double metres,
                    std::ostream& stream) {
    Document document;
    const auto addParts = [&](const std::vector<SavePart>& parts, const FloatJson& material) {
        FloatJson nodes = FloatJson::array();
        if (parts.empty()) return nodes;
        const std::size_t number = document.add("materials", material);
        for (const SavePart& part : parts) nodes.push_back(document.addPart(part, {{"material", number}}));
        return nodes;
    };
    FloatJson nodes = addParts(still, materialOf("environment", {0.55f, 0.56f, 0.58f, 1}));
    FloatJson animation = {{"name", movers.size() == 1 ? movers[0].name : "moving parts"}};
    const std::vector<Samples> samples(movers.begin(), movers.end());  // outlives the document
    for (std::size_t i = 0; i < movers.size(); ++i) {
        const GlbKey& first = movers[i].keys.front();
        const auto& colour = kMoverColours[i % std::size(kMoverColours)];
        const std::size_t node =
            document.add("nodes", {{"name", movers[i].name},
                                   {"translation", first.position},
                                   {"rotation", first.rotation},
                                   {"children", addParts(movers[i].parts, materialOf("part", colour))}});
        nodes.push_back(node);
        addChannels(samples[i], node, document, animation);
    }
    FloatJson root = FloatJson::array();
    for (int i = 0; i < 16; ++i) root.push_back(i < 15 ? metres * kUpright[i] : kUpright[i]);
    document.addRoot(document.add("nodes", {{"name", "scene"}, {"matrix", root}, {"children", nodes}}));
    if (!movers.empty()) document.add("animations", animation);
    document.write(stream);
}

}  // namespace clearway
