#include "mesh/read/dae_geometry.h"

#include <fmt/format.h>
#include <map>

namespace clearway {
namespace {

using pugi::xml_node;

/// Takes the corners of one polygon, strip or list and appends polygons to the shape.
using Filler = void (*)(const std::vector<std::uint32_t>& corners, DaeShape& shape);

void addPolygon(DaeShape& shape, std::initializer_list<std::uint32_t> corners) {
    shape.corners.insert(shape.corners.end(), corners);
    shape.cornerCounts.push_back(static_cast<std::uint32_t>(corners.size()));
}

void fillTriangles(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    for (std::size_t i = 0; i + 2 < c.size(); i += 3) addPolygon(shape, {c[i], c[i + 1], c[i + 2]});
}

void fillPolygon(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    shape.corners.insert(shape.corners.end(), c.begin(), c.end());
    shape.cornerCounts.push_back(static_cast<std::uint32_t>(c.size()));
}

void fillStrip(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    for (std::size_t i = 0; i + 2 < c.size(); ++i) {
        const bool isOdd = i % 2 == 1;
        addPolygon(shape, {c[i + isOdd], c[i + 1 - isOdd], c[i + 2]});
    }
}

void fillFan(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    for (std::size_t i = 1; i + 1 < c.size(); ++i) addPolygon(shape, {c[0], c[i], c[i + 1]});
}

void fillLines(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    shape.lines += c.size() / 2;
}

void fillLineStrip(const std::vector<std::uint32_t>& c, DaeShape& shape) {
    shape.lines += c.size() - 1;
}

struct Primitive {
    const char* name;
    Filler fill;
    std::size_t corners;  ///< of one of `count`; 0: each <p> is one of `count`
    std::size_t least;    ///< corners of one <p>
};
constexpr Primitive kPrimitives[] = {{"triangles", fillTriangles, 3, 0}, {"lines", fillLines, 2, 0},
                                     {"polygons", fillPolygon, 0, 1},    {"tristrips", fillStrip, 0, 3},
                                     {"trifans", fillFan, 0, 3},         {"linestrips", fillLineStrip, 0, 2}};

class GeometryReader {
  public:
    GeometryReader(const DaeDocument& document, const xml_node& geometry)
        : document_(document), mesh_(document.mesh()), geometry_(DaeDocument::textOf(geometry)) {
        for (const xml_node child : geometry) {
            const std::string_view name = child.name();
            if (name == "asset" || name == "extra") continue;
            const xml_node hull = child.attribute("convex_hull_of") ? child : xml_node();
            if ((name != "mesh" && name != "convex_mesh") || hull) {
                mesh_.refuse("{} is a <{}{}>, which is not read, expected a <mesh>", geometry_, child.name(),
                             hull ? " convex_hull_of" : "");
            }
            content_ = child;
            for (const xml_node part : child) readPart(part);
        }
        if (!content_) return;  // some exporters leave empty geometries
        if (!shape_.vertices.empty()) return;
        // Morphs blend with vertices that need no primitives.
        std::size_t count = 0;
        for (const xml_node vertices : content_.children("vertices")) {
            if (!primitives_ && !content_.find_node([](const xml_node& n) {
                    return std::string_view(n.name()) == "accessor";
                }))
                continue;
            addVertices(vertices, count);
        }
    }

    DaeShape take() { return std::move(shape_); }

  private:
    /// Where a primitive's indices of vertices are among its other indices, and which vertices they count.
    struct Indices {
        std::size_t offset = 0;
        std::size_t stride = 1;
        std::size_t firstVertex = 0;
        std::size_t vertexCount = 0;
    };

    void readPart(const xml_node& part) {
        const std::string_view name = part.name();
        if (name == "source" || name == "vertices" || name == "extra") return;
        const std::string what =
            fmt::format("primitive {} (<{}>) of {}", primitives_++, part.name(), geometry_);
        const bool isLine = name == "lines" || name == "linestrips";  // whose count some exporters leave out
        const std::size_t count =
            part.attribute("count") || !isLine ? document_.countIn(part, "count", what) : kUncounted;
        if (count == 0 && !part.child("p") && !part.child("ph")) return;
        if (part.child("ph")) mesh_.refuse(what + " has a polygon with holes (<ph>), which is not read");
        if (name == "polylist") return readPolygonList(part, count, what);
        for (const Primitive& primitive : kPrimitives) {
            if (name == primitive.name) return readPrimitive(part, primitive, count, what);
        }
        mesh_.refuse("{} is not read, expected {} or polylist", what, joined(namesOf(kPrimitives)));
    }

    void readPrimitive(const xml_node& part, const Primitive& primitive, std::size_t count,
                       const std::string& what) {
        const Indices indices = indicesOf(part, what);
        std::size_t found = 0;
        for (const xml_node list : part.children("p")) {
            const std::vector<std::uint32_t> corners = cornersOf(list, indices, what);
            if (corners.size() < primitive.least ||
                (primitive.corners && corners.size() % primitive.corners != 0)) {
                mesh_.refuse("<p> {} of {} has {} corners, expected {}", found, what, corners.size(),
                             primitive.corners ? fmt::format("a multiple of {}", primitive.corners)
                                               : fmt::format("{} or more", primitive.least));
            }
            primitive.fill(corners, shape_);
            found += primitive.corners ? corners.size() / primitive.corners : 1;
        }
        requireCount(found, count, what);
    }

    void readPolygonList(const xml_node& part, std::size_t count, const std::string& what) {
        const Indices indices = indicesOf(part, what);
        std::string joinedText;
        const auto counts = numbersIn<std::uint32_t>(textOf(part.child("vcount"), joinedText),
                                                     "the vcount of " + what, mesh_);
        requireCount(counts.size(), count, what);
        const xml_node list = part.child("p");
        if (list.next_sibling("p")) mesh_.refuse(what + " has a second <p>, expected one");
        const std::vector<std::uint32_t> corners = cornersOf(list, indices, what);
        std::size_t sum = 0;
        for (const std::uint32_t corner : counts) sum += corner;
        if (sum != corners.size()) {
            mesh_.refuse("{} has {} corners in <p>, expected the sum of its vcount, {}", what, corners.size(),
                         sum);
        }
        shape_.corners.insert(shape_.corners.end(), corners.begin(), corners.end());
        shape_.cornerCounts.insert(shape_.cornerCounts.end(), counts.begin(), counts.end());
    }

    void requireCount(std::size_t found, std::size_t count, const std::string& what) const {
        if (found == count || count == kUncounted) return;
        mesh_.refuse("{} holds {}, expected its count, {}", what, found, count);
    }

    Indices indicesOf(const xml_node& part, const std::string& what) {
        Indices indices;
        bool isFound = false;
        for (const xml_node input : part.children("input")) {
            const std::string name = "an input of " + what;
            const std::size_t offset = document_.countIn(input, "offset", name);
            if (offset > kMostInputs) mesh_.refuse("{} has the offset {}", name, offset);
            indices.stride = std::max(indices.stride, offset + 1);
            if (std::string_view(input.attribute("semantic").value()) != "VERTEX") continue;
            if (isFound) mesh_.refuse(what + " has two inputs VERTEX, expected one");
            isFound = true;
            indices.offset = offset;
            const xml_node vertices = document_.find(input.attribute("source"), {"vertices"}, name, content_);
            indices.firstVertex = addVertices(vertices, indices.vertexCount);
        }
        if (!isFound) mesh_.refuse(what + " has no input VERTEX");
        return indices;
    }

    /// Returns the position of the first one; all primitives of a mesh share its vertices.
    std::size_t addVertices(const xml_node& vertices, std::size_t& count) {
        const auto [entry, isNew] = firstVertices_.try_emplace(vertices.hash_value());
        if (isNew) {
            const std::vector<double> numbers =
                document_.numbersOf(document_.sourceOf(vertices, "POSITION", content_), 3);
            entry->second = {shape_.vertices.size(), numbers.size() / 3};
            for (std::size_t i = 0; i < numbers.size(); i += 3) {
                shape_.vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
            }
        }
        count = entry->second.second;
        return entry->second.first;
    }

    std::vector<std::uint32_t> cornersOf(const xml_node& list, const Indices& indices,
                                         const std::string& what) const {
        std::string joinedText;
        const auto numbers = numbersIn<std::uint32_t>(textOf(list, joinedText), "<p> of " + what, mesh_);
        if (numbers.size() % indices.stride != 0) {
            mesh_.refuse("<p> of {} has {} indices, expected a multiple of {}", what, numbers.size(),
                         indices.stride);
        }
        std::vector<std::uint32_t> corners;
        corners.reserve(numbers.size() / indices.stride);
        for (std::size_t i = indices.offset; i < numbers.size(); i += indices.stride) {
            if (numbers[i] >= indices.vertexCount) {
                mesh_.refuse("index {} in <p> of {} refers to vertex {} of {}", i, what, numbers[i],
                             indices.vertexCount);
            }
            corners.push_back(static_cast<std::uint32_t>(indices.firstVertex + numbers[i]));
        }
        return corners;
    }

    static constexpr std::size_t kMostInputs = 1000;
    static constexpr std::size_t kUncounted = std::size_t(-1);

    const DaeDocument& document_;
    const MeshCollector& mesh_;
    std::string geometry_;
    xml_node content_;
    DaeShape shape_;
    std::map<std::size_t, std::pair<std::size_t, std::size_t>> firstVertices_;  ///< and counts, by <vertices>
    std::size_t primitives_ = 0;
};

}  // namespace

DaeShape readDaeGeometry(const DaeDocument& document, const xml_node& geometry) {
    return GeometryReader(document, geometry).take();
}

}  // namespace clearway
