// Tells when a part lies inside an obstacle that only counts as a surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "model/solids.h"
#include "problem/config.h"

namespace clearway::cli {

class EnclosureNotes {
  public:
    explicit EnclosureNotes(const SceneMeshes& meshes) : meshes_(meshes) {}

    /// Says that a piece of the part, at a pose, is inside a closed component of one of the worlds, and which key makes
    /// that a collision; otherwise empty. The part must touch nothing at the pose.
    std::string at(const Pose& X_environmentPart) {
        if (!part_) part_.emplace(meshes_.part);
        for (std::size_t i = 0; i < meshes_.worlds.size(); ++i) {
            if (i == worlds_.size()) worlds_.emplace_back(meshes_.worlds[i]);
            const auto found = worlds_[i].holding({}, *part_, X_environmentPart);
            if (!found) continue;
            const std::string name = writtenNames({*found->outer}).value_or(*found->outer);
            return "the part is inside '" + *found->outer +
                   "', a closed surface; if that is solid, write solid = " + name + " in [clearway]";
        }
        return "";
    }

  private:
    const SceneMeshes& meshes_;
    std::optional<Solids> part_;  ///< made when it is first needed, as are those of the worlds
    std::vector<Solids> worlds_;
};

}  // namespace clearway::cli
