#include "mesh/read/dae_controller.h"

#include <algorithm>

#include "mesh/read/dae_transform.h"

namespace clearway {

using pugi::xml_node;

namespace {

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

}  // namespace

const DaeShape& DaeShapes::of(const xml_node& element, std::size_t depth) {
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

xml_node DaeShapes::contentOf(const xml_node& controller) const {
    if (const xml_node skin = controller.child("skin")) return skin;
    if (const xml_node morph = controller.child("morph")) return morph;
    document_.mesh().refuse(DaeDocument::textOf(controller) + " holds neither <skin> nor <morph>");
}

xml_node DaeShapes::sourceOf(const xml_node& controller) const {
    return document_.find(contentOf(controller).attribute("source"), {"geometry", "controller"},
                          DaeDocument::textOf(controller));
}

bool DaeShapes::hasSkin(xml_node controller) const {
    for (std::size_t length = 0;
         std::string_view(controller.name()) == "controller" && length <= kLongestChain;
         controller = sourceOf(controller), ++length) {
        if (controller.child("skin")) return true;
    }
    return false;
}

xml_node DaeShapes::geometryOf(xml_node controller) const {
    for (std::size_t length = 0; std::string_view(controller.name()) == "controller";
         controller = sourceOf(controller)) {
        if (++length > kLongestChain) document_.mesh().refuse(DaeDocument::textOf(controller) + kTooLong);
    }
    return controller;
}

DaeShape DaeShapes::skinned(const xml_node& skin, DaeShape shape) const {
    const xml_node matrix = skin.child("bind_shape_matrix");
    if (!matrix) return shape;
    const Placement X_bindShape = daeMatrixOf(document_, matrix);
    for (Vector3& vertex : shape.vertices) vertex = X_bindShape(vertex);
    if (X_bindShape.isMirrored()) turnOver(shape);
    return shape;
}

DaeShape DaeShapes::morphed(const xml_node& morph, DaeShape shape, std::size_t depth) {
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
        const DaeShape& target = of(document_.named(names[i], {"geometry", "controller"}, what), depth + 1);
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

}  // namespace clearway
