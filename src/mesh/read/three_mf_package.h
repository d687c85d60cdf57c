// The models in a 3MF package: which parts of the zip archive they are, and the namespaces of their elements.
// Source: 3MF Core Specification 1.3, Production Extension 1.1.2.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "mesh/read/xml.h"
#include "mesh/read/zip_archive.h"

namespace clearway {

/// The extensions that a model may require: they add no material to a mesh, apart from the slices of kSliceSpace.
constexpr std::string_view kCoreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProductionSpace =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kMaterialSpace = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kSliceSpace = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";
constexpr std::string_view kTriangleSetSpace =
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";

/// "p:" of "p:path", "" of "path".
std::string_view prefixOf(std::string_view name);
std::string_view localName(std::string_view name);

/// The namespace that a prefix, with its colon, is bound to at a node; empty if it is not bound.
std::string_view namespaceOf(pugi::xml_node node, std::string_view prefix);

/// A namespace for messages, without the beginning that all those of 3MF share.
std::string quoteNamespace(std::string_view space);

bool isCore(const pugi::xml_node& node, std::string_view name);

/// The attribute with a prefix that is bound to the namespace.
pugi::xml_attribute extensionAttribute(const pugi::xml_node& node, std::string_view name,
                                       std::string_view space);

/// The text of clearway's own metadata of this name among the node's children.
std::optional<std::string> clearwayMetadata(const pugi::xml_node& parent, std::string_view name);

struct ModelPart {
    std::string name;
    std::string bytes;
    pugi::xml_document document;
    pugi::xml_node model;
    std::unordered_map<std::int64_t, pugi::xml_node> objects;  ///< by id
};

class ThreeMfPackage {
  public:
    ThreeMfPackage(std::string_view bytes, MeshCollector& mesh) : archive_(bytes, mesh), mesh_(mesh) {}

    /// The model that the package starts at: the one that its relationships name, or the only one.
    ModelPart& root();

    /// A model; each is parsed once. Refuses one that requires an unknown extension, or whose unit is not that of the root.
    ModelPart& part(const std::string& name);

    /// How many objects the parsed models have.
    std::size_t objectCount() const;

    /// The number that an attribute states. what: names the attribute in messages.
    std::int64_t idIn(const pugi::xml_attribute& attribute, const std::string& what) const;

    ZipArchive& archive() { return archive_; }

  private:
    void requireKnownExtensions(const ModelPart& part) const;
    void requireSameUnit(const ModelPart& part);
    void indexObjects(ModelPart& part, const pugi::xml_node& resources) const;

    ZipArchive archive_;
    MeshCollector& mesh_;
    std::map<std::string, std::unique_ptr<ModelPart>> parts_;
    std::string unit_;
};

}  // namespace clearway
