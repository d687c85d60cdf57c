// glTF 2.0: the nodes of a scene, placed in double. Each node that shows a mesh, and each of its instances, is a component.
// Source: Khronos Group, glTF 2.0 Specification.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/number.h"
#include "core/text.h"
#include "mesh/components.h"
#include "mesh/read/formats.h"
#include "mesh/read/gltf_accessor.h"
#include "mesh/read/gltf_primitive.h"

namespace clearway {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Extensions that a file may require: those that are read, and those that change no triangle. A star stands for any end.
constexpr std::string_view kExtensions[] = {"KHR_mesh_quantization",
                                            "EXT_mesh_gpu_instancing",
                                            "KHR_node_visibility",
                                            "KHR_materials_*",
                                            "KHR_texture_*",
                                            "KHR_lights_punctual",
                                            "KHR_xmp*",
                                            "KHR_animation_pointer",
                                            "KHR_technique*",
                                            "EXT_texture_*",
                                            "EXT_lights_*",
                                            "EXT_mesh_features",
                                            "EXT_instance_features",
                                            "EXT_structural_metadata",
                                            "MSFT_texture_*",
                                            "MSFT_packing_*",
                                            "MSFT_lod",
                                            "ADOBE_materials_*",
                                            "CESIUM_primitive_outline",
                                            "FB_ngon_encoding"};

/// Tolerances of the length of a rotation's quaternion, 1: for floats, and for normalized bytes.
constexpr double kUnitLength = 1e-3, kUnitLengthOfBytes = 1e-2;

/// Tolerance of the last row of a matrix, 0 0 0 1, for inverses in float.
constexpr double kAffine = 1e-6;

bool isKnown(const std::string& extension) {
    return std::any_of(std::begin(kExtensions), std::end(kExtensions), [&](std::string_view known) {
        if (known.back() != '*') return extension == known;
        known.remove_suffix(1);
        return extension.compare(0, known.size(), known) == 0;
    });
}

void requireKnownExtensions(const GltfItem& root) {
    for (const std::string& extension : root.texts("extensionsRequired")) {
        if (!isKnown(extension))
            root.refuse("requires the extension {}, which is not read", quote(extension));
    }
    // It moves the whole scene, though files do not require it.
    if (root.extension("CESIUM_RTC")) root.refuse("uses the extension CESIUM_RTC, which is not read");
}

/// Column by column.
Placement placementOf(const double* matrix, const GltfItem& item) {
    Placement placement;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) placement.linear(row, column) = matrix[4 * column + row];
        placement.translation[column] = matrix[12 + column];
    }
    for (int column = 0; column < 4; ++column) {
        const double last = matrix[4 * column + 3];
        if (std::fabs(last - (column == 3)) <= kAffine) continue;
        item.refuse("has a matrix with {} in its last row, expected 0 0 0 1", shortNumber(last));
    }
    return placement;
}

/// quaternion: x y z w.
Matrix3 rotationOf(const double* quaternion, double tolerance, const GltfItem& item) {
    const Eigen::Quaterniond rotation(quaternion[3], quaternion[0], quaternion[1], quaternion[2]);
    const double length = rotation.norm();
    if (!(std::fabs(length - 1) <= tolerance)) {
        item.refuse("has a rotation whose quaternion has length {}, expected 1", shortNumber(length));
    }
    return rotation.normalized().toRotationMatrix();
}

/// From coordinates of the node to those of its parent.
Placement localPlacement(const GltfItem& node) {
    const std::vector<double> matrix = node.numbers("matrix", 16), scale = node.numbers("scale", 3),
                              rotation = node.numbers("rotation", 4),
                              translation = node.numbers("translation", 3);
    if (!matrix.empty()) {
        if (scale.empty() && rotation.empty() && translation.empty()) return placementOf(matrix.data(), node);
        node.refuse("has a matrix besides scale, rotation or translation");
    }
    Placement placement;
    if (!rotation.empty()) placement.linear = rotationOf(rotation.data(), kUnitLength, node);
    if (!scale.empty()) placement.linear *= Vector3(scale.data()).asDiagonal();
    if (!translation.empty()) placement.translation = Vector3(translation.data());
    return placement;
}

/// All rows of an accessor.
std::vector<double> allNumbers(const GltfAccessor& accessor) {
    std::vector<double> numbers(accessor.count * accessor.width);
    accessor.read(0, accessor.count, numbers.data());
    return numbers;
}

class GltfScene {
  public:
    GltfScene(std::string_view bytes, MeshCollector& mesh) : file_(bytes, mesh), mesh_(mesh) {}

    void read() {
        requireKnownExtensions(file_.root());
        linkNodes();
        placeNodes();
        const std::vector<std::size_t> shown = nodesBelow(shownRoots());
        for (const std::size_t number : shown) showNode(node(number), number);
        noteOmissions(shown);
    }

  private:
    GltfItem node(std::size_t number) const { return file_.item("nodes", number, file_.root()); }

    void linkNodes() {
        const std::size_t count = file_.count("nodes");
        parents_.assign(count, kNone);
        children_.resize(count);
        for (std::size_t parent = 0; parent < count; ++parent) {
            const GltfItem item = node(parent);
            children_[parent] = item.wholeNumbers("children");
            for (const std::size_t child : children_[parent]) {
                const GltfItem childItem = file_.item("nodes", child, item);
                if (parents_[child] != kNone) {
                    childItem.refuse("is a child of node {} and of node {}, expected one parent",
                                     parents_[child], parent);
                }
                parents_[child] = parent;
            }
        }
    }

    std::vector<std::size_t> roots() const {
        std::vector<std::size_t> numbers;
        for (std::size_t number = 0; number < parents_.size(); ++number) {
            if (parents_[number] == kNone) numbers.push_back(number);
        }
        return numbers;
    }

    /// Depth first, in the file's order.
    std::vector<std::size_t> nodesBelow(const std::vector<std::size_t>& roots) const {
        std::vector<std::size_t> found, open(roots.rbegin(), roots.rend());
        while (!open.empty()) {
            const std::size_t number = open.back();
            open.pop_back();
            found.push_back(number);
            open.insert(open.end(), children_[number].rbegin(), children_[number].rend());
        }
        return found;
    }

    void placeNodes() {
        X_fileNode_.resize(parents_.size());
        std::vector<bool> isPlaced(parents_.size());
        for (const std::size_t number : nodesBelow(roots())) {
            const Placement X_parentNode = localPlacement(node(number));
            const std::size_t parent = parents_[number];
            X_fileNode_[number] = parent == kNone ? X_parentNode : X_fileNode_[parent] * X_parentNode;
            isPlaced[number] = true;
        }
        const auto lost = std::find(isPlaced.begin(), isPlaced.end(), false);
        if (lost == isPlaced.end()) return;
        std::size_t number = std::size_t(lost - isPlaced.begin());
        for (std::size_t step = 0; step < parents_.size(); ++step)
            number = parents_[number];  // into the circle
        node(number).refuse("is below itself");
    }

    std::vector<std::size_t> shownRoots() {
        const GltfItem& root = file_.root();
        const std::optional<std::size_t> stated = root.number("scene");
        const std::size_t scenes = file_.count("scenes");
        if (!stated && scenes == 0) return roots();
        const GltfItem scene = file_.item("scenes", stated.value_or(0), root);
        if (scenes > 1) mesh_.note("{} is read, one of {} scenes", scene.name, scenes);
        const std::vector<std::size_t> numbers = scene.wholeNumbers("nodes");
        std::vector<bool> isListed(parents_.size());
        for (const std::size_t number : numbers) {
            const GltfItem item = file_.item("nodes", number, scene);
            if (parents_[number] != kNone) {
                item.refuse("is in {} and a child of node {}, expected a node without parent", scene.name,
                            parents_[number]);
            }
            if (isListed[number]) item.refuse("is in {} twice", scene.name);
            isListed[number] = true;
        }
        return numbers;
    }

    void noteOmissions(const std::vector<std::size_t>& shown) {
        std::size_t unseen = 0, hidden = 0;
        for (std::size_t number = 0; number < parents_.size(); ++number)
            unseen += node(number).find("mesh") != nullptr;
        for (const std::size_t number : shown) {
            const GltfItem item = node(number);
            unseen -= item.find("mesh") != nullptr;
            const std::optional<GltfItem> visibility = item.extension("KHR_node_visibility");
            hidden += visibility && visibility->find("visible") && !visibility->flag("visible");
        }
        if (unseen > 0) mesh_.note("nodes with meshes outside of the scene left out: {}", unseen);
        if (hidden > 0) mesh_.note("nodes that the file hides are read, with those below them: {}", hidden);
        const std::size_t animations = file_.count("animations");
        if (animations > 0) mesh_.note("animations not applied: {}", animations);
    }

    GltfShowing showingOf(const GltfItem& node, const GltfItem& mesh) {
        GltfShowing showing;
        showing.weights = (node.find("weights") ? node : mesh).numbers("weights");
        const std::optional<std::size_t> number = node.number("skin");
        if (!number) return showing;
        const GltfItem skin = file_.item("skins", *number, node);
        showing.skin = skin.name;
        const std::vector<std::size_t> joints = skin.wholeNumbers("joints");
        if (joints.empty()) skin.refuse("has no joints");
        std::vector<double> inverses;
        if (const std::optional<std::size_t> bind = skin.number("inverseBindMatrices")) {
            const GltfAccessor accessor = file_.accessor(*bind, "MAT4", skin);
            if (accessor.count < joints.size()) {
                skin.refuse("has {} joints and {} inverseBindMatrices", joints.size(), accessor.count);
            }
            inverses = allNumbers(accessor);
        }
        std::size_t mirrored = 0;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            file_.item("nodes", joints[i], skin);
            Placement X_fileMesh = X_fileNode_[joints[i]];
            if (!inverses.empty()) X_fileMesh = X_fileMesh * placementOf(&inverses[16 * i], skin);
            mirrored += X_fileMesh.isMirrored();
            showing.joints.push_back(X_fileMesh);
        }
        showing.isMirrored = mirrored == joints.size();
        if (mirrored > 0 && !showing.isMirrored) {
            mesh_.note("triangles not turned over although joints mirror: {} of {}", mirrored, skin.name);
        }
        return showing;
    }

    void showNode(const GltfItem& node, std::size_t number) {
        const std::optional<std::size_t> meshNumber = node.number("mesh");
        if (!meshNumber) return;
        const GltfItem mesh = file_.item("meshes", *meshNumber, node);
        const std::vector<GltfItem> primitives = mesh.objects("primitives", "primitive");
        if (primitives.empty()) mesh.refuse("has no primitives");
        GltfShowing showing = showingOf(node, mesh);
        std::vector<Placement> placements(1);
        if (const std::optional<GltfItem> instancing = node.extension("EXT_mesh_gpu_instancing")) {
            if (!showing.skin.empty()) instancing->refuse("shows a mesh with a skin, expected one without");
            placements = instancesOf(*instancing);
        }
        const std::string name =
            componentName(node.text("name").value_or(""), mesh.text("name").value_or(""));
        for (const Placement& X_nodeMesh : placements) {
            showing.X_fileMesh = X_fileNode_[number] * X_nodeMesh;
            if (showing.skin.empty()) showing.isMirrored = showing.X_fileMesh.isMirrored();
            mesh_.beginComponent(name);
            addGltfPrimitives(file_, showing, primitives, mesh_);
        }
    }

    std::vector<Placement> instancesOf(const GltfItem& instancing) {
        const std::optional<GltfItem> attributes = instancing.object("attributes");
        if (!attributes) instancing.refuse("has no attributes");
        const std::vector<double> moves = instanceNumbers(*attributes, "TRANSLATION", 3),
                                  turns = instanceNumbers(*attributes, "ROTATION", 4),
                                  scales = instanceNumbers(*attributes, "SCALE", 3);
        const std::size_t count = std::max({moves.size() / 3, turns.size() / 4, scales.size() / 3});
        for (const std::size_t rows : {moves.size() / 3, turns.size() / 4, scales.size() / 3}) {
            if (rows == count || rows == 0) continue;
            attributes->refuse("have {} and {} rows, expected equal counts", rows, count);
        }
        if (count == 0) attributes->refuse("have no TRANSLATION, ROTATION or SCALE");
        std::vector<Placement> placements(count);
        for (std::size_t i = 0; i < count; ++i) {
            Placement& placement = placements[i];
            if (!turns.empty()) placement.linear = rotationOf(&turns[4 * i], kUnitLengthOfBytes, *attributes);
            if (!scales.empty()) placement.linear *= Vector3(&scales[3 * i]).asDiagonal();
            if (!moves.empty()) placement.translation = Vector3(&moves[3 * i]);
        }
        return placements;
    }

    std::vector<double> instanceNumbers(const GltfItem& attributes, const char* name, std::size_t width) {
        const std::optional<std::size_t> number = attributes.number(name);
        if (!number) return {};
        return allNumbers(file_.accessor(*number, width == 3 ? "VEC3" : "VEC4", attributes));
    }

    GltfFile file_;
    MeshCollector& mesh_;
    std::vector<std::size_t> parents_;  ///< of the nodes; kNone for a root
    std::vector<std::vector<std::size_t>> children_;
    std::vector<Placement> X_fileNode_;
};

}  // namespace

void readGltf(std::string_view bytes, MeshCollector& mesh) {
    mesh.setUnit(1);
    mesh.setUpAxis('y');
    GltfScene(bytes, mesh).read();
}

}  // namespace clearway
