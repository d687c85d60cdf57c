// COLLADA controllers: skins, which bend a mesh by joints, and morphs, which blend meshes.
#pragma once

#include "mesh/read/dae_geometry.h"

namespace clearway {

/// The shapes of geometries and controllers.
class DaeShapes {
  public:
    explicit DaeShapes(const DaeDocument& document) : document_(document) {}

    /// The shape of a <geometry>, or of a <controller>: a skin in its bind pose, a morph with its weights. Each is read once.
    const DaeShape& of(const pugi::xml_node& element) { return of(element, 0); }

    /// Whether a controller, or the chain of them, is a skin.
    bool hasSkin(pugi::xml_node controller) const;

    /// The <geometry> that a controller, or a chain of them, changes.
    pugi::xml_node geometryOf(pugi::xml_node controller) const;

    /// How many geometries have been read.
    std::size_t geometryCount() const { return geometries_; }

  private:
    const DaeShape& of(const pugi::xml_node& element, std::size_t depth);
    pugi::xml_node contentOf(const pugi::xml_node& controller) const;
    pugi::xml_node sourceOf(const pugi::xml_node& controller) const;
    DaeShape skinned(const pugi::xml_node& skin, DaeShape shape) const;
    DaeShape morphed(const pugi::xml_node& morph, DaeShape shape, std::size_t depth);

    const DaeDocument& document_;
    std::unordered_map<std::size_t, DaeShape> shapes_;  ///< by element
    std::size_t geometries_ = 0;
};

}  // namespace clearway
