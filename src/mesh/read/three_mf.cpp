// Reads 3MF files: zip archives of models in XML, whose build places objects made of triangles or of other objects.
// Material that an extension adds (beam lattices, booleans, slices) is refused by name, because it would be missing.
// Source: 3MF Core Specification 1.3, Production Extension 1.1.2, Slice Extension 1.0.2.
#include <fmt/format.h>
#include <Eigen/SVD>
#include <map>
#include <unordered_set>

#include "mesh/read/formats.h"
#include "mesh/read/three_mf_package.h"

namespace clearway {
namespace {

using pugi::xml_attribute;
using pugi::xml_node;

constexpr std::string_view kAlternativesSpace =
    "http://schemas.microsoft.com/3dmanufacturing/production/alternatives/2021/04";

/// The name that a person knows an object or item by.
const char* nameOf(const xml_node& node) {
    const char* const name = node.attribute("name").value();
    return *name ? name : node.attribute("partnumber").value();
}

struct Object {
    ModelPart& part;
    xml_node node;

    std::string text() const {
        return fmt::format("object {} of {}", quote(node.attribute("id").value()), quote(part.name));
    }
};

struct Shape {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
};

class Reader {
  public:
    Reader(std::string_view bytes, MeshCollector& mesh) : package_(bytes, mesh), mesh_(mesh), path_(mesh) {}

    void read() {
        ModelPart& root = package_.root();
        mesh_.setUpAxis('z');
        for (const xml_node build : root.model) {
            if (isCore(build, "build")) placeBuild(root, build);
        }
        noteWhatIsSpecial(root);
    }

  private:
    /// Refuses child elements other than the named ones of the core specification.
    void requireKnown(const xml_node& parent, std::initializer_list<const char*> names,
                      const std::string& what) const {
        for (const xml_node child : parent) {
            const std::string_view space = namespaceOf(child, prefixOf(child.name()));
            const bool isNamed =
                std::find(names.begin(), names.end(), localName(child.name())) != names.end();
            if ((space == kCoreSpace && isNamed) || space == kTriangleSetSpace) continue;
            mesh_.refuse("{} holds <{}>{}, which is not read", what, child.name(),
                         space.empty() ? "" : " of " + quoteNamespace(space));
        }
    }

    void placeBuild(ModelPart& root, const xml_node& build) {
        requireKnown(build, {"item"}, "the build");
        for (const xml_node item : build) {
            const std::string what = fmt::format("item {} of the build", items_++);
            requireKnown(item, {"metadatagroup"}, what);
            unprintable_ += std::string_view(item.attribute("printable").value()) == "0";
            place(target(root, item, what), transformOf(item, what), nameOf(item));
        }
    }

    /// The object that a build item or a component refers to.
    Object target(ModelPart& from, const xml_node& reference, const std::string& what) {
        const xml_attribute path = extensionAttribute(reference, "path", kProductionSpace);
        if (!path &&
            reference.find_attribute([](xml_attribute a) { return localName(a.name()) == "path"; })) {
            mesh_.refuse("{} has a path, expected it in the namespace {}", what,
                         quoteNamespace(kProductionSpace));
        }
        ModelPart& part = path ? package_.part(path.value()) : from;
        const auto found =
            part.objects.find(package_.idIn(reference.attribute("objectid"), "the objectid of " + what));
        if (found == part.objects.end()) {
            mesh_.refuse("{} refers to object {} of {}, which is not there", what,
                         quote(reference.attribute("objectid").value()), quote(part.name));
        }
        return {part, found->second};
    }

    /// 3MF writes matrices for row vectors.
    Placement transformOf(const xml_node& reference, const std::string& what) const {
        const xml_attribute text = reference.attribute("transform");
        if (!text) return {};
        const auto m = numbersIn<double>(text.value(), "the transform of " + what, mesh_);
        if (m.size() != 12) {
            mesh_.refuse("the transform of {} has {} numbers, expected 12", what, m.size());
        }
        Placement placement;
        placement.linear << m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8];
        placement.translation << m[9], m[10], m[11];
        return placement;
    }

    /// outerName: the name of the nearest object or item around it that has one.
    void place(const Object& object, const Placement& X_fileObject, const std::string& outerName) {
        path_.enter(object.node, object.text());
        if (placed_.insert(object.node.hash_value()).second) requireReadable(object);
        const std::string name = *nameOf(object.node) ? nameOf(object.node) : outerName;
        for (const xml_node child : object.node) {
            if (isCore(child, "mesh")) placeMesh(object, child, X_fileObject, name);
            if (isCore(child, "components")) placeComponents(object, child, X_fileObject, name);
        }
        path_.leave();
    }

    void requireReadable(const Object& object) {
        requireKnown(object.node, {"mesh", "components", "metadatagroup"}, object.text());
        const xml_attribute resolution = extensionAttribute(object.node, "meshresolution", kSliceSpace);
        if (resolution && std::string_view(resolution.value()) != "fullres") {
            mesh_.refuse(
                "{} has a meshresolution of {}: its slices, which are not read, are finer than its mesh; "
                "expected 'fullres'",
                object.text(), valueOf(resolution));
        }
        sliced_ += !extensionAttribute(object.node, "slicestackid", kSliceSpace).empty();
        if (extensionAttribute(object.node, "modelresolution", kAlternativesSpace)) {
            mesh_.refuse(object.text() + " has alternatives, which are not read");
        }
        hollow_ += !object.node.first_child();
        const std::string type = object.node.attribute("type").as_string("model");
        if (type != "model") ++types_[type];
    }

    void placeComponents(const Object& object, const xml_node& components, const Placement& X_fileObject,
                         const std::string& name) {
        requireKnown(components, {"component"}, object.text());
        std::size_t number = 0;
        for (const xml_node component : components) {
            const std::string what = fmt::format("component {} of {}", number++, object.text());
            requireKnown(component, {}, what);
            place(target(object.part, component, what), X_fileObject * transformOf(component, what), name);
        }
    }

    void placeMesh(const Object& object, const xml_node& node, const Placement& X_fileObject,
                   const std::string& name) {
        const auto [entry, isNew] = shapes_.try_emplace(node.hash_value());
        if (isNew) entry->second = readShape(object, node);
        const Shape& shape = entry->second;
        const auto first = static_cast<std::uint32_t>(mesh_.vertexCount());
        mesh_.beginComponent(name, deflectionOf(object, X_fileObject));
        for (const Vector3& vertex : shape.vertices) mesh_.addVertex(X_fileObject(vertex));
        const bool isMirrored = X_fileObject.isMirrored();
        for (const TriangleIndices& t : shape.triangles) {
            mesh_.addTriangle(first + t[0], first + t[isMirrored ? 2 : 1], first + t[isMirrored ? 1 : 2]);
        }
    }

    /// In file coordinates; 0 if the object states none.
    double deflectionOf(const Object& object, const Placement& X_fileObject) const {
        for (const xml_node group : object.node) {
            if (!isCore(group, "metadatagroup")) continue;
            const std::optional<std::string> text = clearwayMetadata(group, "deflection");
            double length = 0;
            if (!text) continue;
            if (!isNumber(text->c_str(), length) || !(length >= 0))
                mesh_.refuse("the deflection of {} is {}, expected a number of at least 0", object.text(),
                             quote(*text));
            const double scale = Eigen::JacobiSVD<Matrix3>(X_fileObject.linear).singularValues()[0];
            return std::abs(scale - 1) < 1e-12 ? length : length * scale;  // a rotation's is rounded
        }
        return 0;
    }

    Shape readShape(const Object& object, const xml_node& node) {
        requireKnown(node, {"vertices", "triangles"}, "the mesh of " + object.text());
        Shape shape;
        for (const xml_node list : node) {
            if (isCore(list, "vertices")) readVertices(object, list, shape);
        }
        for (const xml_node list : node) {
            if (isCore(list, "triangles")) readTriangles(object, list, shape);
        }
        if (!shape.triangles.empty()) return shape;
        if (extensionAttribute(object.node, "slicestackid", kSliceSpace)) {
            mesh_.refuse(object.text() + " has slices, which are not read, and no triangle");
        }
        ++hollow_;
        return shape;
    }

    /// what: makes the element's name for a message.
    template <typename Number, typename What>
    Number numberIn(const xml_node& node, const char* attribute, const What& what) const {
        Number value{};
        const xml_attribute text = node.attribute(attribute);
        if (isNumber(text.value(), value)) return value;
        mesh_.refuse("{} of {} is {}, expected {}", attribute, what(), valueOf(text),
                     std::is_integral_v<Number> ? "the number of a vertex" : "a number");
    }

    void readVertices(const Object& object, const xml_node& list, Shape& shape) const {
        const std::string name = std::string(prefixOf(list.name())) + "vertex";
        for (const xml_node node : list) {
            const auto what = [&] {
                return fmt::format("vertex {} of {}", shape.vertices.size(), object.text());
            };
            if (name != node.name()) mesh_.refuse("{} is <{}>, expected <{}>", what(), node.name(), name);
            const auto x = numberIn<double>(node, "x", what);
            const auto y = numberIn<double>(node, "y", what);
            shape.vertices.emplace_back(x, y, numberIn<double>(node, "z", what));
        }
    }

    void readTriangles(const Object& object, const xml_node& list, Shape& shape) const {
        const std::string name = std::string(prefixOf(list.name())) + "triangle";
        for (const xml_node node : list) {
            const auto what = [&] {
                return fmt::format("triangle {} of {}", shape.triangles.size(), object.text());
            };
            if (name != node.name()) mesh_.refuse("{} is <{}>, expected <{}>", what(), node.name(), name);
            TriangleIndices corners{};
            for (std::size_t i = 0; i < 3; ++i) {
                constexpr const char* kCorners[] = {"v1", "v2", "v3"};
                corners[i] = numberIn<std::uint32_t>(node, kCorners[i], what);
                if (corners[i] < shape.vertices.size()) continue;
                mesh_.refuse("{} refers to vertex {} of {}", what(), corners[i], shape.vertices.size());
            }
            shape.triangles.push_back(corners);
        }
    }

    void noteWhatIsSpecial(const ModelPart& root) {
        if (items_ == 0 && !root.objects.empty()) {
            mesh_.refuse("its build has no item, which leaves out all of its {} objects",
                         root.objects.size());
        }
        const auto note = [&](std::size_t count, const std::string& text) {
            if (count > 0) mesh_.note(std::to_string(count) + (count == 1 ? " object" : " objects") + text);
        };
        note(package_.objectCount() - placed_.size(), " left out, which no build item reaches");
        note(hollow_, " read without a triangle");
        note(sliced_, " read as a mesh only, without slices that the file has, too");
        note(unprintable_, " placed by items that are marked as not printable");
        for (const auto& [type, count] : types_)
            note(count, fmt::format(" read of type {}, not 'model'", quote(type)));
        noteSlicerVolumes();
    }

    /// Slicers keep regions that are no material (cuts, other settings) as triangles, and tell them apart elsewhere.
    void noteSlicerVolumes() {
        for (const char* const name : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"}) {
            if (!package_.archive().has(name)) continue;
            const std::string settings = package_.archive().read(name);
            for (const char* const type :
                 {"NegativeVolume", "ParameterModifier", "SupportBlocker", "SupportEnforcer", "negative_part",
                  "modifier_part", "support_blocker", "support_enforcer"}) {
                if (settings.find('"' + std::string(type) + '"') == std::string::npos) continue;
                mesh_.note("a slicer's volumes of type {} are read as if they were solid", quote(type));
            }
        }
    }

    ThreeMfPackage package_;
    MeshCollector& mesh_;
    PlacementPath path_;
    std::unordered_map<std::size_t, Shape> shapes_;  ///< by mesh element
    std::unordered_set<std::size_t> placed_;         ///< objects
    std::map<std::string, std::size_t>
        types_;  ///< how many of the placed objects are of a type other than "model"
    std::size_t items_ = 0;
    std::size_t unprintable_ = 0;
    std::size_t sliced_ = 0;
    std::size_t hollow_ = 0;  ///< without triangles
};

}  // namespace

void read3mf(std::string_view bytes, MeshCollector& mesh) {
    Reader(bytes, mesh).read();
}

}  // namespace clearway
