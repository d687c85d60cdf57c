#include "mesh/read/three_mf_package.h"

#include <fmt/format.h>

#include "mesh/three_mf.h"

namespace clearway {

using pugi::xml_attribute;
using pugi::xml_node;

namespace {

constexpr std::string_view kRead[] = {kCoreSpace, kProductionSpace, kMaterialSpace, kSliceSpace,
                                      kTriangleSetSpace};
constexpr std::string_view kSharedBeginning = "http://schemas.microsoft.com/3dmanufacturing/";
constexpr std::string_view kModelRelationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view kModelEnding = ".model";

}  // namespace

std::string_view prefixOf(std::string_view name) {
    return name.substr(0, name.find(':') + 1);
}

std::string_view localName(std::string_view name) {
    return name.substr(name.find(':') + 1);
}

std::string_view namespaceOf(xml_node node, std::string_view prefix) {
    std::string declaration = "xmlns";
    if (!prefix.empty()) declaration.append(":").append(prefix.substr(0, prefix.size() - 1));
    for (; node; node = node.parent()) {
        if (const xml_attribute bound = node.attribute(declaration.c_str())) return bound.value();
    }
    return {};
}

std::string quoteNamespace(std::string_view space) {
    const bool isShared = space.substr(0, kSharedBeginning.size()) == kSharedBeginning;
    return quote(isShared ? space.substr(kSharedBeginning.size()) : space);
}

bool isCore(const xml_node& node, std::string_view name) {
    return localName(node.name()) == name && namespaceOf(node, prefixOf(node.name())) == kCoreSpace;
}

xml_attribute extensionAttribute(const xml_node& node, std::string_view name, std::string_view space) {
    for (const xml_attribute attribute : node.attributes()) {
        const std::string_view prefix = prefixOf(attribute.name());
        const bool isNamed = !prefix.empty() && localName(attribute.name()) == name;
        if (isNamed && namespaceOf(node, prefix) == space) return attribute;
    }
    return {};
}

std::optional<std::string> clearwayMetadata(const xml_node& parent, std::string_view name) {
    for (const xml_node node : parent) {
        if (!isCore(node, "metadata")) continue;
        const std::string_view whole = node.attribute("name").value();
        const bool isNamed = whole != localName(whole) && localName(whole) == name;
        if (isNamed && namespaceOf(node, prefixOf(whole)) == kClearwaySpace) return node.child_value();
    }
    return std::nullopt;
}

ModelPart& ThreeMfPackage::root() {
    std::map<std::string, std::string> names;  // as the archive compares them, and as written
    if (archive_.has("_rels/.rels")) {
        std::string bytes = archive_.read("_rels/.rels");
        pugi::xml_document document;
        const xml_node relationships = parseXml(document, bytes, "part '_rels/.rels'", mesh_);
        for (const xml_node relationship : relationships) {
            if (relationship.attribute("Type").value() != kModelRelationship) continue;
            const std::string target = relationship.attribute("Target").value();
            names.emplace(ZipArchive::partName(target), target);
        }
    }
    for (const std::string& name : names.empty() ? archive_.names() : std::vector<std::string>()) {
        const std::size_t stem = name.size() - std::min(name.size(), kModelEnding.size());
        if (name.substr(stem) == kModelEnding) names.emplace(name, name);
    }
    if (names.size() == 1) return part(names.begin()->second);
    mesh_.refuse("the archive starts at {} 3D models, expected one", names.size());
}

ModelPart& ThreeMfPackage::part(const std::string& name) {
    std::unique_ptr<ModelPart>& entry = parts_[ZipArchive::partName(name)];
    if (entry) return *entry;
    entry = std::make_unique<ModelPart>();
    ModelPart& part = *entry;
    part.name = name;
    part.bytes = archive_.read(name);
    part.model = parseXml(part.document, part.bytes, "part " + quote(name), mesh_);
    if (!isCore(part.model, "model")) {
        mesh_.refuse("part {} begins with <{}> of {}, expected <model> of {}", quote(name), part.model.name(),
                     quoteNamespace(namespaceOf(part.model, prefixOf(part.model.name()))),
                     quoteNamespace(kCoreSpace));
    }
    requireKnownExtensions(part);
    requireSameUnit(part);
    for (const xml_node resources : part.model) {
        if (isCore(resources, "resources")) indexObjects(part, resources);
    }
    return part;
}

std::size_t ThreeMfPackage::objectCount() const {
    std::size_t count = 0;
    for (const auto& part : parts_) count += part.second->objects.size();
    return count;
}

std::int64_t ThreeMfPackage::idIn(const xml_attribute& attribute, const std::string& what) const {
    std::int64_t id = 0;
    if (isNumber(attribute.value(), id)) return id;
    mesh_.refuse("{} is {}, expected a whole number", what, valueOf(attribute));
}

void ThreeMfPackage::requireKnownExtensions(const ModelPart& part) const {
    for (const std::string_view prefix : words(part.model.attribute("requiredextensions").value())) {
        const std::string_view space = namespaceOf(part.model, std::string(prefix) + ":");
        if (std::find(std::begin(kRead), std::end(kRead), space) != std::end(kRead)) continue;
        mesh_.refuse(
            "part {} requires the extension {}, {}", quote(part.name), quote(prefix),
            space.empty() ? "a prefix that is not bound" : quoteNamespace(space) + ", which is not read");
    }
}

void ThreeMfPackage::requireSameUnit(const ModelPart& part) {
    const std::string unit = part.model.attribute("unit").as_string("millimeter");
    const auto known = std::find_if(std::begin(kThreeMfUnits), std::end(kThreeMfUnits),
                                    [&](const ThreeMfUnit& row) { return unit == row.name; });
    const std::string what =
        fmt::format("the unit of part {} is {}, expected ", quote(part.name), quote(unit));
    if (known == std::end(kThreeMfUnits)) mesh_.refuse("{}one of {}", what, joined(namesOf(kThreeMfUnits)));
    if (unit_.empty()) {
        unit_ = unit;
        mesh_.setUnit(clearwayMetadata(part.model, "unit") == "none" ? 0 : known->metres);
    }
    if (unit != unit_) mesh_.refuse("{}{} as in the first part", what, quote(unit_));
}

void ThreeMfPackage::indexObjects(ModelPart& part, const xml_node& resources) const {
    for (const xml_node node : resources) {
        if (!isCore(node, "object")) continue;
        const std::int64_t id =
            idIn(node.attribute("id"), fmt::format("the id of object {}", part.objects.size()));
        if (part.objects.emplace(id, node).second) continue;
        mesh_.refuse("id {} of {} names two objects", id, quote(part.name));
    }
}

}  // namespace clearway
