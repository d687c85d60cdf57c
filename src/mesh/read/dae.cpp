// Reads COLLADA files: the geometries that the nodes of the visual scene show, each of them as one component.

#include "mesh/components.h"
#include "mesh/read/dae_controller.h"
#include "mesh/read/dae_transform.h"
#include "mesh/read/readers.h"

namespace clearway {
namespace {

using pugi::xml_node;

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
        const Placement X_fileNode = X_fileParent * daeTransformOf(document_, node);
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
