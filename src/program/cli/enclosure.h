// Tells when a part lies inside an obstacle that only counts as a surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "model/solids.h"

namespace clearway::cli {

class EnclosureNotes {
  public:
    explicit EnclosureNotes(const SceneMeshes& meshes) : meshes_(meshes) {}

    /// Says that a piece of the part, at a pose, is inside a closed component of one of the worlds, and which key makes
    /// that a collision; otherwise empty. The part must touch nothing at the pose.
    std::string at(const Pose& X_environmentPart);

  private:
    const SceneMeshes& meshes_;
    std::optional<Solids> part_;  ///< made when it is first needed, as are those of the worlds
    std::vector<Solids> worlds_;
};

}  // namespace clearway::cli
