// Source: Khronos Group, glTF 2.0 Specification: a JSON chunk that describes the views of one binary chunk.
#include "mesh/glb.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "core/json_text.h"

namespace clearway {

namespace {

constexpr int kFloat = 5126;  // glTF's component types
constexpr int kUnsigned = 5125;
constexpr int kVertexBuffer = 34962;  // and targets of buffer views
constexpr int kIndexBuffer = 34963;

/// z to y and y to -z, column by column. No quaternion of floats turns by exactly 90 degrees: far from the
/// origin readers would find coordinates other than those of the meshes.
constexpr char kUpright[] = "[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]";

template <class Numbers>
std::string list(const Numbers& values) {
    std::ostringstream json;
    json.precision(std::numeric_limits<float>::max_digits10);
    json << '[';
    for (std::size_t i = 0; i < values.size(); ++i) json << (i == 0 ? "" : ",") << values[i];
    json << ']';
    return json.str();
}

template <class Vertices>
std::string bounds(const Vertices& vertices) {
    auto least = vertices[0], most = vertices[0];
    for (const auto& vertex : vertices) {
        for (std::size_t i = 0; i < vertex.size(); ++i) {
            least[i] = std::min(least[i], vertex[i]);
            most[i] = std::max(most[i], vertex[i]);
        }
    }
    return ",\"min\":" + list(least) + ",\"max\":" + list(most);
}

/// A list of the document, whose items are numbered as they come.
class Items {
  public:
    std::size_t add(const std::string& json) {
        text_ += (count_ == 0 ? "" : ",") + json;
        return count_++;
    }
    const std::string& text() const { return text_; }
    bool isEmpty() const { return count_ == 0; }

  private:
    std::string text_;
    std::size_t count_ = 0;
};

/// The description, and the places in memory that the binary chunk is made of. What is added must outlive it.
class Document {
  public:
    /// With a mesh each; returns the number of the node. material: of the mesh, or empty.
    std::size_t addPart(const SavePart& part, const std::string& material = "") {
        const std::size_t positions =
            addAccessor(part.vertices, kFloat, "VEC3", bounds(part.vertices), kVertexBuffer);
        const std::size_t indices = addAccessor(part.triangles, kUnsigned, "SCALAR", "", kIndexBuffer);
        const std::size_t mesh =
            meshes_.add("{\"name\":" + jsonText(part.name) +
                        ",\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(positions) +
                        "},\"indices\":" + std::to_string(indices) + material + "}]}");
        return addNode("{\"name\":" + jsonText(part.name) + ",\"mesh\":" + std::to_string(mesh) + '}');
    }

    std::size_t addNode(const std::string& json) { return nodes_.add(json); }
    void addRoot(std::size_t node) { roots_.add(std::to_string(node)); }
    std::size_t addMaterial(const std::string& json) { return materials_.add(json); }
    void addAnimation(const std::string& json) { animations_.add(json); }

    /// Of arrays of 4-byte numbers. more: further fields. target: 0 for none.
    template <class Rows>
    std::size_t addAccessor(const Rows& rows, int componentType, const std::string& type,
                            const std::string& more, int target) {
        const std::size_t bytes = rows.size() * sizeof(rows[0]);
        const std::size_t view =
            views_.add("{\"buffer\":0,\"byteOffset\":" + std::to_string(binaryBytes_) +
                       ",\"byteLength\":" + std::to_string(bytes) +
                       (target == 0 ? "" : ",\"target\":" + std::to_string(target)) + '}');
        const std::size_t width = type == "SCALAR" ? 4 : sizeof(rows[0]);
        pieces_.push_back({rows.data(), bytes});
        binaryBytes_ += bytes;
        return accessors_.add("{\"bufferView\":" + std::to_string(view) + ",\"componentType\":" +
                              std::to_string(componentType) + ",\"count\":" + std::to_string(bytes / width) +
                              ",\"type\":\"" + type + '"' + more + '}');
    }

    void write(std::ostream& stream) const;

  private:
    std::string json() const;
    struct Piece {
        const void* data;
        std::size_t bytes;
    };
    Items roots_, nodes_, meshes_, accessors_, views_, materials_, animations_;
    std::vector<Piece> pieces_;
    std::uint64_t binaryBytes_ = 0;
};

/// Padded with spaces to whole words of 4 bytes.
std::string Document::json() const {
    std::string json =
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"clearway\"},\"scene\":0,\"scenes\":[{\"nodes\":[" +
        roots_.text() + "]}],\"nodes\":[" + nodes_.text() + "],\"meshes\":[" + meshes_.text() +
        "],\"accessors\":[" + accessors_.text() + "],\"bufferViews\":[" + views_.text() +
        "],\"buffers\":[{\"byteLength\":" + std::to_string(binaryBytes_) + "}]";
    if (!materials_.isEmpty()) json += ",\"materials\":[" + materials_.text() + "]";
    if (!animations_.isEmpty()) json += ",\"animations\":[" + animations_.text() + "]";
    json += '}';
    json.append((4 - json.size() % 4) % 4, ' ');
    return json;
}

void writeWord(std::ostream& stream, std::uint64_t word) {
    const char bytes[4] = {static_cast<char>(word), static_cast<char>(word >> 8),
                           static_cast<char>(word >> 16), static_cast<char>(word >> 24)};
    stream.write(bytes, sizeof bytes);
}

void Document::write(std::ostream& stream) const {
    const std::string description = json();
    const std::uint64_t bytes = 12 + 8 + description.size() + 8 + binaryBytes_;
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("the mesh takes " + std::to_string(bytes) +
                                    " bytes, expected at most 2^32 - 1 for a .glb file");
    }
    writeWord(stream, 0x46546c67);  // "glTF"
    writeWord(stream, 2);
    writeWord(stream, bytes);
    writeWord(stream, description.size());
    writeWord(stream, 0x4e4f534a);  // "JSON"
    stream.write(description.data(), static_cast<std::streamsize>(description.size()));
    writeWord(stream, binaryBytes_);
    writeWord(stream, 0x004e4942);  // "BIN"
    for (const Piece& piece : pieces_)
        stream.write(static_cast<const char*>(piece.data), static_cast<std::streamsize>(piece.bytes));
}

std::string materialOf(const std::string& name, const std::string& colour) {
    return "{\"name\":\"" + name +
           "\",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":" + colour +
           ",\"metallicFactor\":0,\"roughnessFactor\":0.7}}";
}

/// The keys as the format has them: a list for each kind of number.
struct Samples {
    std::vector<float> times;
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 4>> rotations;

    explicit Samples(const std::vector<GlbKey>& keys) {
        for (const GlbKey& key : keys) {
            times.push_back(key.seconds);
            positions.push_back(key.position);
            rotations.push_back(key.rotation);
        }
    }
};

/// A name as a JSON field's value.
std::string animationOf(const std::string& name, std::size_t node, std::size_t times, std::size_t positions,
                        std::size_t rotations) {
    const auto sampler = [&](std::size_t output) {
        return "{\"input\":" + std::to_string(times) +
               ",\"interpolation\":\"LINEAR\",\"output\":" + std::to_string(output) + '}';
    };
    const auto channel = [&](int number, const char* path) {
        return "{\"sampler\":" + std::to_string(number) + ",\"target\":{\"node\":" + std::to_string(node) +
               ",\"path\":\"" + path + "\"}}";
    };
    return "{\"name\":" + name + ",\"channels\":[" + channel(0, "translation") + ',' +
           channel(1, "rotation") + "],\"samplers\":[" + sampler(positions) + ',' + sampler(rotations) + "]}";
}

}  // namespace

void writeGlb(const std::vector<SavePart>& parts, std::ostream& stream) {
    Document document;
    for (const SavePart& part : parts) document.addRoot(document.addPart(part));
    document.write(stream);
}

void writeMovingGlb(const GlbMotion& motion, std::ostream& stream) {
    Document document;
    const auto addParts = [&](const std::vector<SavePart>& parts, std::size_t material) {
        Items nodes;
        for (const SavePart& part : parts)
            nodes.add(std::to_string(document.addPart(part, ",\"material\":" + std::to_string(material))));
        return nodes.text();
    };
    std::string stillNodes =
        addParts(motion.still, document.addMaterial(materialOf("environment", "[0.55,0.56,0.58,1]")));
    const std::string movingNodes =
        addParts(motion.moving, document.addMaterial(materialOf("part", "[0.95,0.45,0.05,1]")));
    const GlbKey& first = motion.keys.front();
    const std::string name = jsonText(motion.name);
    const std::size_t mover =
        document.addNode("{\"name\":" + name + ",\"translation\":" + list(first.position) +
                         ",\"rotation\":" + list(first.rotation) + ",\"children\":[" + movingNodes + "]}");
    if (!stillNodes.empty()) stillNodes += ',';
    document.addRoot(document.addNode("{\"name\":\"scene\",\"matrix\":" + std::string(kUpright) +
                                      ",\"children\":[" + stillNodes + std::to_string(mover) + "]}"));
    const Samples samples(motion.keys);
    const std::array<float, 1> last{samples.times.back()};
    const std::size_t times =
        document.addAccessor(samples.times, kFloat, "SCALAR", ",\"min\":[0],\"max\":" + list(last), 0);
    const std::size_t positions = document.addAccessor(samples.positions, kFloat, "VEC3", "", 0);
    const std::size_t rotations = document.addAccessor(samples.rotations, kFloat, "VEC4", "", 0);
    document.addAnimation(animationOf(name, mover, times, positions, rotations));
    document.write(stream);
}

}  // namespace clearway
