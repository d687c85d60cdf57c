// Says in words why a pose is not valid.
#include <sstream>
#include <string>

#include "core/number.h"
#include "scene/contact_zones.h"
#include "scene/scene_scratch.h"

namespace clearway {
namespace {

std::string fileName(const Model& model) {
    const std::string& file = model.origin().file;
    return file.empty() ? "unnamed" : file.substr(file.find_last_of('/') + 1);
}

std::string meshName(const Model& model, std::int64_t component) {
    const auto& components = model.components();
    if (component >= 0 && static_cast<std::size_t>(component) < components.size()) {
        const std::string& name = components[static_cast<std::size_t>(component)].name;
        if (!name.empty()) return name;
    }
    return fileName(model);
}

double marginOf(const Scene& scene, const SceneDistance& nearest) {
    return nearest.obstacle ? scene.obstacles[*nearest.obstacle].margin : 0;
}

const ShrunkModel* shrunkFor(const Scene& scene, const SceneDistance& nearest) {
    return nearest.obstacle ? scene.obstacles[*nearest.obstacle].shrunk.get() : nullptr;
}

/// Describes a pair that touches or is closer than the margin.
std::string describePair(const Scene& scene, const SceneDistance& nearest) {
    const double margin = marginOf(scene, nearest);
    const MeshNames names = distinctMeshNames(scene, nearest);
    std::ostringstream message;
    const ShrunkModel* shrunk = shrunkFor(scene, nearest);
    const auto inUnit = [&](double length) { return withUnit(roundedNumber(length), scene.unit); };
    if (shrunk && nearest.collides()) {
        message << "the environment's mesh '" << names.environment << "' reaches more than "
                << inUnit(shrunk->overlap) << " below the surface of the part's mesh '" << names.part
                << "', at triangle " << nearest.witness->environmentTriangle << ", nearest to triangle "
                << nearest.witness->partTriangle << " of the part";
        return message.str();
    }
    message << "triangle " << nearest.witness->partTriangle << " of the part's mesh '" << names.part
            << "' and triangle " << nearest.witness->environmentTriangle << " of the environment's mesh '"
            << names.environment << "' are ";
    if (nearest.collides()) {
        message << "touching, expected a distance above " << inUnit(margin);
    } else {
        message << inUnit(nearest.distance) << " apart, expected more than the margin " << inUnit(margin);
    }
    return message.str();
}

}  // namespace

/// Names the solid and the mesh inside it, of the obstacles that count. Empty when nothing is enclosed.
std::string SceneClearance::describeEnclosure(const Pose& X_environmentPart) const {
    PoseClearance at;
    zones_->findSpares(scene_, X_environmentPart, at);
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (zones_->isIgnored(i, at)) continue;
        const auto found = enclosureBy(i, X_environmentPart);
        if (!found) continue;
        const std::string part = "the part's mesh '" + *found->partMesh + "'",
                          obstacle = "the solid '" + *found->obstacleMesh + "'";
        return found->isPartInside ? part + " is inside " + obstacle : obstacle + " is inside " + part;
    }
    return "";
}

std::string SceneClearance::whyInvalid(const Pose& X_environmentPart) const {
    const PoseClearance found = at(X_environmentPart);
    if (found.isValid()) return "";
    if (found.nearest.collides()) return "in collision: " + describePair(scene_, found.nearest);
    const bool isApart = !found.nearest.witness || found.nearest.lower > marginOf(scene_, found.nearest);
    if (!isApart) return "too close: " + describePair(scene_, found.nearest);
    return "in collision: " + describeEnclosure(X_environmentPart);
}

MeshNames meshNames(const Scene& scene, const SceneDistance& nearest) {
    if (!nearest.witness || !nearest.obstacle) return {};
    const Model& environment = scene.obstacles[*nearest.obstacle].model;
    return {meshName(scene.part, nearest.witness->partComponent),
            meshName(environment, nearest.witness->environmentComponent)};
}

MeshNames distinctMeshNames(const Scene& scene, const SceneDistance& nearest) {
    MeshNames names = meshNames(scene, nearest);
    if (names.part != names.environment || names.part.empty()) return names;
    const Model& environment = scene.obstacles[*nearest.obstacle].model;
    const std::string partFile = scene.part.origin().file, environmentFile = environment.origin().file;
    if (partFile.empty() || environmentFile.empty()) return names;
    const bool isTold = fileName(scene.part) != fileName(environment);
    names.part = (isTold ? fileName(scene.part) : partFile) + "/" + names.part;
    names.environment = (isTold ? fileName(environment) : environmentFile) + "/" + names.environment;
    return names;
}

}  // namespace clearway
