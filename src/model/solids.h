// What the closed components of a mesh enclose, and where each of its connected pieces is.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/scene.h"
#include "model/solid.h"

namespace clearway {

class Solids {
  public:
    /// Takes the closed components as solids, and one vertex of each connected piece of all of them. Names
    /// those that enclose nothing, with the reason, and those that were turned over. Throws
    /// std::invalid_argument as Model::build does.
    explicit Solids(const Mesh& mesh);

    const std::vector<std::string>& refusals() const { return refusals_; }
    const std::vector<std::string>& turnedOver() const { return turnedOver_; }

    /// A component of one mesh that holds a piece of the other.
    struct Enclosure {
        const std::string* outer;
        const std::string* inner;
    };

    /// Whether a piece of `inner` lies inside one of the solids, both moved, where no two of their surfaces
    /// touch. Exact, and allocates nothing.
    std::optional<Enclosure> holding(const Pose& X_aThis, const Solids& inner, const Pose& X_aInner) const;

  private:
    struct NamedSolid {
        Solid solid;
        std::size_t component;
    };
    struct Piece {
        Vector3 vertex;
        std::size_t component;
    };
    void addPieces(const Mesh& component, std::size_t number);

    std::vector<std::string> names_;  ///< of the components
    std::vector<NamedSolid> solids_;
    std::vector<Piece> pieces_;
    Vector3 centre_ = Vector3::Zero();  ///< of the pieces' vertices
    double radius_ = 0;                 ///< of these about it
    std::vector<std::string> refusals_, turnedOver_;
};

}  // namespace clearway
