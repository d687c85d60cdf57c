#include "planning/end_states.h"

#include <sstream>
#include <stdexcept>

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

double requireValid(const ValidityChecker& checker, const ompl::base::State* state, const std::string& what) {
    double clearance = 0;
    if (checker.isValid(state, clearance)) return clearance;
    const Scene& scene = checker.scene();
    const DistanceResult d = checker.distance(state);
    std::ostringstream message;
    message << what;
    if (d.collides() || d.upper <= scene.margin || d.lower <= scene.margin) {
        message << " is in collision: triangle " << d.partTriangle << " of the part's mesh '"
                << meshName(scene.part, d.partComponent) << "' and triangle " << d.environmentTriangle
                << " of the environment's mesh '" << meshName(scene.environment, d.environmentComponent)
                << "' are ";
        if (d.collides()) {
            message << "touching, expected a distance above " << scene.margin;
        } else {
            message << d.distance << " apart, expected more than the margin " << scene.margin;
        }
    } else {
        message << " is outside of the bounds of the state space";
    }
    throw std::invalid_argument(message.str());
}

}  // namespace clearway::planning
