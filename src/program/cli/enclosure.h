// Tells when the part lies inside an obstacle that only counts as a surface, or such an obstacle inside the part.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "core/text.h"
#include "mesh/components.h"
#include "model/obstacle_names.h"
#include "model/solids.h"
#include "problem/config.h"
#include "problem/outside.h"

namespace clearway::cli {

class EnclosureNotes {
  public:
    EnclosureNotes(const Problem& problem, const SceneMeshes& meshes) : part_(meshes.part) {
        for (const ObstacleGroup& group : obstaclesOf(problem, meshes.worlds).groups) {
            if (group.solids || group.overlap > 0) continue;                // then the pose is not valid
            if (group.isIgnoredAtStart || group.isIgnoredAtGoal) continue;  // meant to be there
            for (std::size_t i = 0; i < componentsOf(group.mesh).size(); ++i)
                obstacles_.emplace_back(meshOfComponents(group.mesh, {i}));
        }
    }

    /// Says that a piece of the part, at a pose, is inside a closed obstacle, or obstacles inside a closed component of the part, and which
    /// key helps; otherwise empty.
    std::string at(const Pose& X_environmentPart) {
        std::vector<std::string> inside;
        for (Body& obstacle : obstacles_) {
            if (!movedBox(X_environmentPart, part_.box).intersects(obstacle.box)) continue;
            const bool isAround =
                obstacle.solids().holding({}, part_.solids(), X_environmentPart).has_value();
            const bool isInside =
                part_.solids().holding(X_environmentPart, obstacle.solids(), {}).has_value();
            if (!isAround && !isInside) continue;
            if (collides(part_.model(), obstacle.model(), X_environmentPart, workspace_)) continue;
            if (isAround)
                return "the part is inside '" + obstacle.name() +
                       "', a closed surface; if that is solid, write solid = " + written({obstacle.name()}) +
                       " in [clearway]";
            inside.push_back(obstacle.name());
        }
        if (inside.empty()) return "";
        return listed(inside, kMostNamed) + (inside.size() == 1 ? " is" : " are") +
               " inside the part, a closed surface, which no path changes; for what moves with the part, "
               "write ignore = " +
               written(inside) + " in [clearway]";
    }

  private:
    static constexpr std::size_t kMostNamed = 6;

    /// A mesh, with what queries need: made when it is first needed.
    class Body {
      public:
        explicit Body(Mesh theMesh) : box(boundingBox(theMesh)), mesh_(std::move(theMesh)) {}
        const Solids& solids() { return solids_ ? *solids_ : solids_.emplace(mesh_); }
        const Model& model() { return model_ ? *model_ : model_.emplace(Model::build(mesh_)); }
        const std::string& name() const { return mesh_.components[0].name; }
        const Box box;

      private:
        const Mesh mesh_;
        std::optional<Solids> solids_;
        std::optional<Model> model_;
    };

    static std::string written(const std::vector<std::string>& names) {
        return writtenNames(names).value_or(joined(names));
    }

    Body part_;
    std::list<Body> obstacles_;
    Workspace workspace_;
};

}  // namespace clearway::cli
