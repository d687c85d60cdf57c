#include "mesh/read/dae_document.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace clearway {

using pugi::xml_attribute;
using pugi::xml_node;

namespace {

bool isOneOf(const char* name, std::initializer_list<const char*> kinds) {
    return std::find(kinds.begin(), kinds.end(), std::string_view(name)) != kinds.end();
}

/// The next element in the document's order, without those inside <extra>, which are no part of the format.
xml_node nextNode(xml_node node) {
    if (node.first_child() && std::string_view(node.name()) != "extra") return node.first_child();
    while (node && !node.next_sibling()) node = node.parent();
    return node.next_sibling();
}

}  // namespace

DaeDocument::DaeDocument(std::string& bytes, MeshCollector& mesh) : mesh_(mesh) {
    root_ = parseXml(document_, bytes, "the file", mesh);
    if (std::string_view(root_.name()) != "COLLADA") {
        mesh.refuse("its root element is <{}>, expected <COLLADA>", root_.name());
    }
    const std::string_view version = root_.attribute("version").value();
    if (version.substr(0, 3) != "1.4" && version.substr(0, 3) != "1.5") {
        mesh.refuse("its COLLADA version is {}, expected 1.4.x or 1.5.x", quote(version));
    }
    readAsset();
    index();
}

std::string DaeDocument::textOf(const xml_node& element) {
    const xml_attribute id = element.attribute("id");
    return fmt::format("{} {}", element.name(), quote((id ? id : element.attribute("name")).value()));
}

void DaeDocument::readAsset() {
    const xml_node asset = root_.child("asset");
    if (const xml_attribute meter = asset.child("unit").attribute("meter")) {
        double metres = 0;
        if (isNumber(meter.value(), metres) && metres > 0 && std::isfinite(metres)) {
            unitMetres_ = metres;
            mesh_.setUnit(metres);
        } else {
            mesh_.note("its unit is {} metres, which is no number above 0", valueOf(meter));
        }
    }
    const std::string_view axis = trimmed(asset.child_value("up_axis"));
    if (!axis.empty()) {
        upAxis_ = axis;
        if (!isOneOf(upAxis_.c_str(), {"X_UP", "Y_UP", "Z_UP"})) {
            mesh_.refuse("its up_axis is {}, expected X_UP, Y_UP or Z_UP", quote(upAxis_));
        }
        mesh_.setUpAxis(static_cast<char>(upAxis_[0] - 'X' + 'x'));
    }
}

void DaeDocument::requireSameAsset(const xml_node& asset) const {
    const std::string what = "the asset of " + textOf(asset.parent());
    const xml_attribute meter = asset.child("unit").attribute("meter");
    double metres = 0;
    if (meter && (!isNumber(meter.value(), metres) || metres != unitMetres_)) {
        mesh_.refuse("{} has a unit of {} metres, expected the file's, {}", what, valueOf(meter),
                     shortNumber(unitMetres_));
    }
    const std::string_view axis = trimmed(asset.child_value("up_axis"));
    if (!axis.empty() && axis != upAxis_) {
        mesh_.refuse("{} has the up_axis {}, expected the file's, {}", what, quote(axis), upAxis_);
    }
}

void DaeDocument::index() {
    for (xml_node node = root_; node; node = nextNode(node)) {
        if (const xml_attribute id = node.attribute("id")) elements_[id.value()].push_back(node);
        const bool isPlaced = isOneOf(node.parent().name(),
                                      {"library_geometries", "geometry", "library_controllers", "controller",
                                       "library_nodes", "node", "library_visual_scenes", "visual_scene"});
        if (isPlaced && std::string_view(node.name()) == "asset") requireSameAsset(node);
    }
}

xml_node DaeDocument::find(const xml_attribute& reference, std::initializer_list<const char*> kinds,
                           const std::string& what, const xml_node& scope) const {
    const std::string_view text = trimmed(reference.value());
    if (text.empty() || text[0] != '#') {
        mesh_.refuse("{} refers to {}, expected '#' and the id of an element of this file", what,
                     valueOf(reference));
    }
    const std::string id(text.substr(1));
    for (const xml_node child : scope) {
        if (id == child.attribute("id").value() && isOneOf(child.name(), kinds)) return child;
    }
    return named(id, kinds, what);
}

xml_node DaeDocument::named(const std::string& id, std::initializer_list<const char*> kinds,
                            const std::string& what) const {
    xml_node found;
    const std::string expected = fmt::format("{} refers to {}, expected the id of a <{}>", what, quote(id),
                                             joined({kinds.begin(), kinds.end()}, "> or <"));
    const auto elements = elements_.find(id);
    if (elements == elements_.end()) mesh_.refuse(expected + ", which none has");
    for (const xml_node element : elements->second) {
        if (!isOneOf(element.name(), kinds)) continue;
        if (found) mesh_.refuse(expected + ", which two have");
        found = element;
    }
    if (!found) mesh_.refuse(expected + ", which none has");
    return found;
}

xml_node DaeDocument::sourceOf(const xml_node& element, const char* semantic, const xml_node& scope) const {
    xml_node found;
    const std::string what = fmt::format("input {} of {}", semantic, textOf(element));
    for (const xml_node input : element.children("input")) {
        if (std::string_view(input.attribute("semantic").value()) != semantic) continue;
        if (found) mesh_.refuse(what + " is there twice");
        found = find(input.attribute("source"), {"source"}, what, scope);
    }
    if (!found) mesh_.refuse(what + " is missing");
    return found;
}

std::size_t DaeDocument::countIn(const xml_node& element, const char* attribute, const std::string& what,
                                 const std::size_t* missing) const {
    const xml_attribute text = element.attribute(attribute);
    std::size_t count = 0;
    if (!text && missing) return *missing;
    if (!isNumber(text.value(), count)) {
        mesh_.refuse("{} of {} is {}, expected a whole number, 0 or more", attribute, what, valueOf(text));
    }
    return count;
}

std::vector<std::size_t> DaeDocument::columnsOf(const xml_node& accessor, std::size_t width,
                                                const std::string& what) const {
    std::vector<std::size_t> named, all;
    std::vector<std::string> names;
    for (const xml_node param : accessor.children("param")) {
        const bool isMatrix = std::string_view(param.attribute("type").value()) == "float4x4";
        for (std::size_t i = 0; i < (isMatrix ? 16 : 1); ++i) {
            if (*param.attribute("name").value()) {
                named.push_back(all.size());
                names.emplace_back(param.attribute("name").value());
            }
            all.push_back(all.size());
        }
    }
    const std::size_t one = 1;
    const std::size_t stride = countIn(accessor, "stride", "the accessor of " + what, &one);
    if (all.empty() && stride == width) {
        for (std::size_t i = 0; i < width; ++i) all.push_back(i);
    }
    // Parameters without a name are skipped, but some exporters name none.
    std::vector<std::size_t> columns = named.size() == width ? named : all;
    if (columns.size() != width || columns.back() >= stride) {
        mesh_.refuse("the accessor of {} has a stride of {} and {} params, expected {}", what, stride,
                     columns.size(), width);
    }
    for (std::size_t i = 0; i < 3 && width == 3 && named.size() == 3; ++i) {
        const auto at = std::find(names.begin(), names.end(), std::string(1, "XYZ"[i]));
        if (at != names.end()) columns[i] = named[static_cast<std::size_t>(at - names.begin())];
    }
    return columns;
}

std::vector<double> DaeDocument::numbersOf(const xml_node& source, std::size_t width) const {
    const std::string what = textOf(source);
    const xml_node accessor = source.child("technique_common").child("accessor");
    if (!accessor) mesh_.refuse(what + " has no accessor");
    const xml_node array =
        find(accessor.attribute("source"), {"float_array"}, "the accessor of " + what, source);
    std::string joinedText;
    const auto numbers = numbersIn<double>(clearway::textOf(array, joinedText), textOf(array), mesh_);
    const std::size_t stated = countIn(array, "count", textOf(array));
    if (numbers.size() != stated) {
        mesh_.refuse("{} holds {} numbers, expected its count, {}", textOf(array), numbers.size(), stated);
    }
    const std::size_t none = 0, one = 1;
    const std::size_t count = countIn(accessor, "count", "the accessor of " + what);
    if (count == 0) return {};
    const std::vector<std::size_t> columns = columnsOf(accessor, width, what);
    const std::size_t stride = countIn(accessor, "stride", "the accessor of " + what, &one);
    const std::size_t offset = countIn(accessor, "offset", "the accessor of " + what, &none);
    const std::size_t last = *std::max_element(columns.begin(), columns.end());
    // Written as a division, because a product could overflow.
    const bool fits =
        (offset < stated && last < stated - offset && (stated - offset - last - 1) / stride >= count - 1);
    if (!fits) {
        mesh_.refuse("the accessor of {} takes {} rows of {} numbers after {} from {}", what, count, stride,
                     offset, stated);
    }
    std::vector<double> rows;
    rows.reserve(count * width);
    for (std::size_t row = 0; row < count; ++row) {
        for (const std::size_t column : columns) rows.push_back(numbers[offset + row * stride + column]);
    }
    return rows;
}

std::vector<std::string> DaeDocument::wordsOf(const xml_node& source) const {
    for (const xml_node array : source) {
        if (!isOneOf(array.name(), {"Name_array", "IDREF_array", "SIDREF_array"})) continue;
        std::string joinedText;
        std::vector<std::string> all;
        for (const std::string_view word : words(clearway::textOf(array, joinedText))) all.emplace_back(word);
        const std::size_t stated = countIn(array, "count", textOf(array));
        if (all.size() == stated) return all;
        mesh_.refuse("{} holds {} names, expected its count, {}", textOf(array), all.size(), stated);
    }
    mesh_.refuse(textOf(source) + " holds no names");
}

}  // namespace clearway
