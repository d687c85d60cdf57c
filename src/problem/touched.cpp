#include "problem/touched.h"

#include "clearway/query.h"
#include "mesh/components.h"

namespace clearway {

std::vector<std::string> touchedAtStart(const Problem& problem, const Mesh& part,
                                        const ObstacleGroups& obstacles) {
    const Model model = Model::build(part);
    const Pose X_environmentPart = poseOf(problem.start);
    Workspace workspace;
    std::vector<std::string> names;
    for (const ObstacleGroup& group : obstacles.groups) {
        if (group.isIgnoredAtStart || group.overlap > 0) continue;
        const std::vector<Component> components = componentsOf(group.mesh);
        for (std::size_t i = 0; i < components.size(); ++i) {
            if (components[i].triangleCount == 0) continue;
            const Model obstacle = Model::build(meshOfComponents(group.mesh, {i}));
            if (isWithin(model, obstacle, X_environmentPart, group.margin, workspace))
                names.push_back(components[i].name);
        }
    }
    return names;
}

}  // namespace clearway
