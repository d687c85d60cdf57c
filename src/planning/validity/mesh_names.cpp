#include "planning/validity/mesh_names.h"

#include <sstream>

namespace clearway::planning {

std::string meshName(const Model& model, std::int64_t component) {
    const auto& components = model.components();
    if (component >= 0 && static_cast<std::size_t>(component) < components.size()) {
        const std::string& name = components[static_cast<std::size_t>(component)].name;
        if (!name.empty()) return name;
    }
    const std::string& file = model.origin().file;
    return file.empty() ? "unnamed" : file.substr(file.find_last_of('/') + 1);
}

std::string obstacleName(const Scene& scene, const SceneDistance& nearest) {
    if (nearest.obstacle < 0) return "";
    return meshName(scene.obstacles[static_cast<std::size_t>(nearest.obstacle)].model,
                    nearest.environmentComponent);
}

double marginOf(const Scene& scene, const SceneDistance& nearest) {
    return nearest.obstacle < 0 ? 0 : scene.obstacles[static_cast<std::size_t>(nearest.obstacle)].margin;
}

std::string whyBlocked(const Scene& scene, const SceneDistance& nearest) {
    const double margin = marginOf(scene, nearest);
    std::ostringstream message;
    message << "triangle " << nearest.partTriangle << " of the part's mesh '"
            << meshName(scene.part, nearest.partComponent) << "' and triangle " << nearest.environmentTriangle
            << " of the environment's mesh '" << obstacleName(scene, nearest) << "' are ";
    if (nearest.collides()) {
        message << "touching, expected a distance above " << margin;
    } else {
        message << nearest.distance << " apart, expected more than the margin " << margin;
    }
    return message.str();
}

}  // namespace clearway::planning
