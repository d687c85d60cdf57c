// Reads COLLADA files: the geometries that the nodes of the visual scene show, each of them as one component.
#include <fmt/format.h>
#include <cmath>

#include "mesh/components.h"
#include "mesh/read/dae_geometry.h"
#include "mesh/read/formats.h"

namespace clearway {
namespace {

using pugi::xml_node;

std::vector<double> numbersOf(const DaeDocument& document, const xml_node& element, std::size_t count) {
    std::string joinedText;
    const std::string what = fmt::format("<{}> of {}", element.name(), DaeDocument::textOf(element.parent()));
    std::vector<double> numbers = numbersIn<double>(textOf(element, joinedText), what, document.mesh());
    if (numbers.size() == count) return numbers;
    document.mesh().refuse("{} has {} numbers, expected {}", what, numbers.size(), count);
}

void requireDirection(const DaeDocument& document, const xml_node& node, const Vector3& direction,
                      const char* element) {
    if (direction.norm() > 0) return;
    document.mesh().refuse("{} of {} has no direction, expected one that is not 0", element,
                           DaeDocument::textOf(node));
}

/// Quarter turns are exact, so that boxes stay boxes.
Placement rotationOf(const std::vector<double>& numbers) {
    const double degrees = std::remainder(numbers[3], 360.0);
    const double radians = degrees * (std::acos(-1.0) / 180);
    const bool isQuarter = std::remainder(degrees, 90.0) == 0;
    const double sine = isQuarter ? std::round(std::sin(radians)) : std::sin(radians);
    const double cosine = isQuarter ? std::round(std::cos(radians)) : std::cos(radians);
    const Vector3 given(numbers[0], numbers[1], numbers[2]);
    if (degrees == 0) return {};  // some exporters write no axis then
    const Vector3 axis = given / given.norm();
    Matrix3 cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    Placement placement;
    placement.linear = cosine * Matrix3::Identity() + (1 - cosine) * axis * axis.transpose() + sine * cross;
    return placement;
}

/// Moves the origin to the eye and turns -z towards the point of interest.
Placement lookAtOf(const std::vector<double>& numbers) {
    const Vector3 eye(numbers[0], numbers[1], numbers[2]), interest(numbers[3], numbers[4], numbers[5]);
    const Vector3 up(numbers[6], numbers[7], numbers[8]);
    const Vector3 back = (eye - interest).normalized();
    const Vector3 right = up.cross(back).normalized();
    Placement placement;
    placement.linear << right, back.cross(right), back;
    placement.translation = eye;
    return placement;
}

/// The 16 numbers of an element's text, row by row. Refuses a last row other than 0 0 0 1.
Placement matrixOf(const DaeDocument& document, const xml_node& element) {
    const std::vector<double> m = numbersOf(document, element, 16);
    constexpr double kRounding = 1e-6;  // of texts with few digits
    if (std::abs(m[12]) + std::abs(m[13]) + std::abs(m[14]) + std::abs(m[15] - 1) > kRounding) {
        document.mesh().refuse("<{}> of {} has another last row than 0 0 0 1", element.name(),
                               DaeDocument::textOf(element.parent()));
    }
    Placement placement;
    placement.linear << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    placement.translation << m[3], m[7], m[11];
    return placement;
}

/// The product of a node's transform elements in the document's order. Refuses <skew>.
Placement transformOf(const DaeDocument& document, const xml_node& node) {
    Placement placement;
    for (const xml_node element : node) {
        const std::string_view name = element.name();
        Placement step;
        if (name == "matrix") {
            step = matrixOf(document, element);
        } else if (name == "translate") {
            const std::vector<double> numbers = numbersOf(document, element, 3);
            step.translation << numbers[0], numbers[1], numbers[2];
        } else if (name == "scale") {
            const std::vector<double> numbers = numbersOf(document, element, 3);
            step.linear.diagonal() << numbers[0], numbers[1], numbers[2];
        } else if (name == "rotate") {
            const std::vector<double> numbers = numbersOf(document, element, 4);
            if (numbers[3] != 0)
                requireDirection(document, node, Vector3(numbers[0], numbers[1], numbers[2]), "<rotate>");
            step = rotationOf(numbers);
        } else if (name == "lookat") {
            const std::vector<double> numbers = numbersOf(document, element, 9);
            const Vector3 view(numbers[0] - numbers[3], numbers[1] - numbers[4], numbers[2] - numbers[5]);
            requireDirection(document, node, Vector3(numbers[6], numbers[7], numbers[8]).cross(view),
                             "<lookat>");
            step = lookAtOf(numbers);
        } else if (name == "skew") {
            document.mesh().refuse(DaeDocument::textOf(node) + " has a <skew>, which is not read");
        } else {
            continue;
        }
        placement = placement * step;
    }
    return placement;
}

/// Controllers that change one another: usually a skin changes a morph.
constexpr std::size_t kLongestChain = 16;
constexpr const char* kTooLong = " is in a chain of more than 16 controllers, or refers to itself";

void turnOver(DaeShape& shape) {
    std::uint32_t* first = shape.corners.data();
    for (const std::uint32_t count : shape.cornerCounts) {
        if (count > 1) std::reverse(first + 1, first + count);
        first += count;
    }
}

/// The shapes of geometries and controllers: skins, which bend a mesh by joints, and morphs, which blend meshes.
class DaeShapes {
  public:
    explicit DaeShapes(const DaeDocument& document) : document_(document) {}

    /// The shape of a <geometry>, or of a <controller>: a skin in its bind pose, a morph with its weights. Each is read once.
    const DaeShape& of(const xml_node& element, std::size_t depth = 0) {
        const auto found = shapes_.find(element.hash_value());
        if (found != shapes_.end()) return found->second;
        if (depth > kLongestChain) document_.mesh().refuse(DaeDocument::textOf(element) + kTooLong);
        DaeShape shape;
        if (std::string_view(element.name()) == "geometry") {
            shape = readDaeGeometry(document_, element);
            ++geometries_;
        } else {
            const xml_node content = contentOf(element);
            const DaeShape& source = of(sourceOf(element), depth + 1);
            shape = std::string_view(content.name()) == "skin" ? skinned(content, source)
                                                               : morphed(content, source, depth);
        }
        return shapes_.emplace(element.hash_value(), std::move(shape)).first->second;
    }

    /// Whether a controller, or the chain of them, is a skin.
    bool hasSkin(xml_node controller) const {
        for (std::size_t length = 0;
             std::string_view(controller.name()) == "controller" && length <= kLongestChain;
             controller = sourceOf(controller), ++length) {
            if (controller.child("skin")) return true;
        }
        return false;
    }

    /// The <geometry> that a controller, or a chain of them, changes.
    xml_node geometryOf(xml_node controller) const {
        for (std::size_t length = 0; std::string_view(controller.name()) == "controller";
             controller = sourceOf(controller)) {
            if (++length > kLongestChain) document_.mesh().refuse(DaeDocument::textOf(controller) + kTooLong);
        }
        return controller;
    }

    /// How many geometries have been read.
    std::size_t geometryCount() const { return geometries_; }

  private:
    xml_node contentOf(const xml_node& controller) const {
        if (const xml_node skin = controller.child("skin")) return skin;
        if (const xml_node morph = controller.child("morph")) return morph;
        document_.mesh().refuse(DaeDocument::textOf(controller) + " holds neither <skin> nor <morph>");
    }

    xml_node sourceOf(const xml_node& controller) const {
        return document_.find(contentOf(controller).attribute("source"), {"geometry", "controller"},
                              DaeDocument::textOf(controller));
    }

    DaeShape skinned(const xml_node& skin, DaeShape shape) const {
        const xml_node matrix = skin.child("bind_shape_matrix");
        if (!matrix) return shape;
        const Placement X_bindShape = matrixOf(document_, matrix);
        for (Vector3& vertex : shape.vertices) vertex = X_bindShape(vertex);
        if (X_bindShape.isMirrored()) turnOver(shape);
        return shape;
    }

    DaeShape morphed(const xml_node& morph, DaeShape shape, std::size_t depth) {
        const std::string what = "the morph of " + DaeDocument::textOf(morph.parent());
        const std::string method = morph.attribute("method").as_string("NORMALIZED");
        const xml_node targets = morph.child("targets");
        const auto names = document_.wordsOf(document_.sourceOf(targets, "MORPH_TARGET", morph));
        const auto weights = document_.numbersOf(document_.sourceOf(targets, "MORPH_WEIGHT", morph), 1);
        if (method != "NORMALIZED" && method != "RELATIVE")
            document_.mesh().refuse("{} has the method {}", what, quote(method));
        if (names.size() != weights.size()) {
            document_.mesh().refuse("{} has {} targets and {} weights", what, names.size(), weights.size());
        }
        const std::vector<Vector3> base = shape.vertices;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (weights[i] == 0) continue;
            const DaeShape& target =
                of(document_.named(names[i], {"geometry", "controller"}, what), depth + 1);
            if (target.vertices.size() != base.size()) {
                document_.mesh().refuse("{} blends {} vertices with the {} of {}", what, base.size(),
                                        target.vertices.size(), quote(names[i]));
            }
            for (std::size_t v = 0; v < base.size(); ++v) {
                const Vector3 origin = method == "RELATIVE" ? Vector3(Vector3::Zero()) : base[v];
                shape.vertices[v] += weights[i] * (target.vertices[v] - origin);
            }
        }
        return shape;
    }

    const DaeDocument& document_;
    std::unordered_map<std::size_t, DaeShape> shapes_;  ///< by element
    std::size_t geometries_ = 0;
};

class SceneReader {
  public:
    SceneReader(const DaeDocument& document, MeshCollector& mesh)
        : document_(document), mesh_(mesh), shapes_(document), path_(mesh) {}

    void read() {
        const std::vector<xml_node> geometries = all("library_geometries", "geometry");
        const xml_node scene = shownScene();
        if (scene) {
            placeNode(scene, {});
        } else {
            for (const xml_node geometry : geometries) placeShape(geometry, geometry, {}, {});
            if (!geometries.empty()) mesh_.note("the file has no scene: all of its geometries are read");
        }
        if (hasSkins_) mesh_.note("its skins are read in their bind pose");
        const std::size_t animations = all("library_animations", "animation").size();
        if (animations > 0) mesh_.note("animations not applied: {}", animations);
        const std::size_t shown = shapes_.geometryCount();
        if (shown >= geometries.size()) return;
        mesh_.note("{} of its {} geometries left out, which no node shows", geometries.size() - shown,
                   geometries.size());
    }

  private:
    std::vector<xml_node> all(const char* library, const char* element) const {
        std::vector<xml_node> found;
        for (const xml_node group : document_.root().children(library)) {
            for (const xml_node child : group.children(element)) found.push_back(child);
        }
        return found;
    }

    /// The scene that the file tells to show; else its only one. Empty if it has none.
    xml_node shownScene() const {
        const xml_node instance = document_.root().child("scene").child("instance_visual_scene");
        if (instance.next_sibling("instance_visual_scene"))
            mesh_.refuse("its <scene> shows two visual scenes, expected one");
        if (instance)
            return document_.find(instance.attribute("url"), {"visual_scene"}, "instance_visual_scene");
        const std::vector<xml_node> scenes = all("library_visual_scenes", "visual_scene");
        if (scenes.size() > 1) {
            mesh_.refuse("it has {} visual scenes, expected a <scene> that tells which to show",
                         scenes.size());
        }
        return scenes.empty() ? xml_node() : scenes[0];
    }

    /// The children of a node that show nothing by themselves.
    static bool isLeftOut(std::string_view name) {
        constexpr std::string_view kNames[] = {
            "node",      "instance_node", "instance_camera", "instance_light", "asset", "extra", "matrix",
            "translate", "rotate",        "scale",           "evaluate_scene", "skew",  "lookat"};
        return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
    }

    /// The scene itself counts as a node: some exporters let it show other nodes.
    void placeNode(const xml_node& node, const Placement& X_fileParent) {
        const std::string what = DaeDocument::textOf(node);
        path_.enter(node, what);
        const Placement X_fileNode = X_fileParent * transformOf(document_, node);
        for (const xml_node child : node) {
            const std::string_view name = child.name();
            const pugi::xml_attribute url = child.attribute("url");
            if (name == "instance_geometry") {
                const xml_node geometry = document_.find(url, {"geometry"}, what);
                placeShape(geometry, geometry, node, X_fileNode);
            } else if (name == "instance_controller") {
                const xml_node controller = document_.find(url, {"controller"}, what);
                // Joints place a skin, the node does not. In the bind pose they leave it where the bind shape matrix puts it.
                const bool isSkin = shapes_.hasSkin(controller);
                placeShape(controller, shapes_.geometryOf(controller), node,
                           isSkin ? Placement() : X_fileNode);
                hasSkins_ = hasSkins_ || isSkin;
            } else if (!isLeftOut(name)) {
                mesh_.refuse("{} holds <{}>, which is not read", what, child.name());
            }
        }
        for (const xml_node child : node) {
            const std::string_view name = child.name();
            if (name == "node") placeNode(child, X_fileNode);
            if (name == "instance_node")
                placeNode(document_.find(child.attribute("url"), {"node"}, what), X_fileNode);
        }
        path_.leave();
    }

    /// shown: a geometry or a controller of it.
    void placeShape(const xml_node& shown, const xml_node& geometry, const xml_node& node,
                    const Placement& X_fileNode) {
        const DaeShape& shape = shapes_.of(shown);
        const pugi::xml_attribute name = geometry.attribute("name");
        const pugi::xml_attribute meshName = *name.value() ? name : geometry.attribute("id");
        mesh_.beginComponent(componentName(node.attribute("name").value(), meshName.value()));
        const auto first = static_cast<std::uint32_t>(mesh_.vertexCount());
        for (const Vector3& vertex : shape.vertices) mesh_.addVertex(X_fileNode(vertex));
        const bool isMirrored = X_fileNode.isMirrored();
        std::vector<std::uint32_t> corners;
        const std::uint32_t* next = shape.corners.data();
        for (const std::uint32_t count : shape.cornerCounts) {
            corners.assign(next, next + count);
            for (std::uint32_t& corner : corners) corner += first;
            if (isMirrored && count > 1) std::reverse(corners.begin() + 1, corners.end());
            mesh_.addFace(corners.data(), count);
            next += count;
        }
        mesh_.ignoreFaces(shape.lines);
    }

    const DaeDocument& document_;
    MeshCollector& mesh_;
    DaeShapes shapes_;
    PlacementPath path_;
    bool hasSkins_ = false;
};

}  // namespace

void readDae(std::string_view bytes, MeshCollector& mesh) {
    std::string text(bytes);
    const DaeDocument document(text, mesh);
    SceneReader(document, mesh).read();
}

}  // namespace clearway
