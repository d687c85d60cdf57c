// Finds why a pose is not valid, and says in words why a pose or a motion is not.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

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

/// Every kind and its name.
constexpr std::pair<WhyInvalid::Kind, const char*> kKindNames[] = {
    {WhyInvalid::Kind::kValid, "valid"},
    {WhyInvalid::Kind::kOutOfBounds, "out of bounds"},
    {WhyInvalid::Kind::kCollides, "collides"},
    {WhyInvalid::Kind::kTooDeep, "too deep"},
    {WhyInvalid::Kind::kInSolid, "inside a solid"},
    {WhyInvalid::Kind::kTooClose, "too close"},
    {WhyInvalid::Kind::kNoPose, "no pose"},
    {WhyInvalid::Kind::kOutOfRange, "out of range"},
    {WhyInvalid::Kind::kUnusable, "unusable"},
    {WhyInvalid::Kind::kUndecided, "undecided"},
};

/// Returns the rule that an invalid pose breaks. A solid is the reason where the nearest surfaces are farther apart
/// than the margin.
WhyInvalid::Kind brokenRule(const Scene& scene, const SceneDistance& nearest) {
    if (!nearest.obstacle || !nearest.witness) return WhyInvalid::Kind::kInSolid;
    const Obstacle& obstacle = scene.obstacles[*nearest.obstacle];
    if (nearest.collides())
        return obstacle.overlap() > 0 ? WhyInvalid::Kind::kTooDeep : WhyInvalid::Kind::kCollides;
    return nearest.lower > obstacle.margin ? WhyInvalid::Kind::kInSolid : WhyInvalid::Kind::kTooClose;
}

std::string pairWords(const WhyInvalid& why) {
    return fmt::format("triangle {} of the part's mesh '{}' and triangle {} of the environment's mesh '{}'",
                       why.nearest.witness->partTriangle, why.partMesh,
                       why.nearest.witness->environmentTriangle, why.environmentMesh);
}

std::string tooDeepWords(const WhyInvalid& why, const std::string& overlap) {
    const std::string part = "the part's mesh '" + why.partMesh + "'",
                      obstacle = "the environment's mesh '" + why.environmentMesh + "'";
    if (!why.nearest.witness)
        return fmt::format("in collision: {} is inside {}, and may be deeper than the overlap {}",
                           why.isPartInside ? part : obstacle, why.isPartInside ? obstacle : part, overlap);
    if (why.isPartInside)
        return fmt::format(
            "in collision: {} may reach deeper into {} than the overlap {}, at triangle {}, nearest to "
            "triangle {} of the environment",
            part, obstacle, overlap, why.nearest.witness->partTriangle,
            why.nearest.witness->environmentTriangle);
    return fmt::format(
        "in collision: {} may reach deeper into {} than the overlap {}, at triangle {}, nearest to triangle "
        "{} of the part",
        obstacle, part, overlap, why.nearest.witness->environmentTriangle, why.nearest.witness->partTriangle);
}

std::string boundWords(const WhyInvalid::Coordinate& at) {
    return fmt::format(": {} is {}, expected from {} to {}", at.name, roundedNumber(at.value),
                       roundedNumber(at.least), roundedNumber(at.most));
}

std::string enclosureWords(const WhyInvalid& why) {
    const std::string part = "the part's mesh '" + why.partMesh + "'",
                      solid = "the solid '" + why.environmentMesh + "'";
    return why.isPartInside ? part + " is inside " + solid : solid + " is inside " + part;
}

}  // namespace

std::string nameOf(WhyInvalid::Kind kind) {
    const auto row = std::find_if(std::begin(kKindNames), std::end(kKindNames),
                                  [&](const auto& each) { return each.first == kind; });
    assert(row != std::end(kKindNames));
    return row->second;
}

std::string WhyInvalid::words() const {
    const bool hasPair = kind == Kind::kCollides || kind == Kind::kTooClose;
    if (hasPair && !nearest.witness) return nameOf(kind);  // a value that no query made
    const auto inUnit = [&](double length) { return withUnit(roundedNumber(length), unit); };
    switch (kind) {
        case Kind::kValid:
            return "";
        case Kind::kOutOfBounds:
            return "outside of the bounds of the state space" + (coordinate ? boundWords(*coordinate) : "");
        case Kind::kCollides:
            return fmt::format("in collision: {} are touching, expected a distance above {}",
                               pairWords(*this), inUnit(limit));
        case Kind::kTooDeep:
            return tooDeepWords(*this, inUnit(limit));
        case Kind::kInSolid:
            return "in collision: " + enclosureWords(*this);
        case Kind::kTooClose:
            return fmt::format("too close: {} are {} apart, expected more than the margin {}",
                               pairWords(*this), inUnit(nearest.distance), inUnit(limit));
        case Kind::kUndecided:
            return "undecided: closer than can be told";
        case Kind::kNoPose:
        case Kind::kOutOfRange:
        case Kind::kUnusable:
            break;
    }
    return "unusable: " + reason;
}

WhyInvalid SceneClearance::whyInvalid(const Pose& X_environmentPart) const {
    try {
        return whyInvalid(X_environmentPart, at(X_environmentPart));
    } catch (const std::invalid_argument& error) {
        WhyInvalid why;
        why.kind = !(rotationDefect(X_environmentPart) <= kPoseDefect) ? WhyInvalid::Kind::kNoPose
                   : isOutOfRange(X_environmentPart)                   ? WhyInvalid::Kind::kOutOfRange
                                                                       : WhyInvalid::Kind::kUnusable;
        why.reason = error.what();
        return why;
    }
}

WhyInvalid SceneClearance::whyInvalid(const Pose& X_environmentPart, const PoseClearance& found) const {
    WhyInvalid why;
    if (found.isValid()) return why;
    why.unit = scene_.unit;
    const SceneDistance& nearest = found.nearest;
    why.kind = brokenRule(scene_, nearest);
    if (why.kind == WhyInvalid::Kind::kInSolid) {
        findEnclosure(X_environmentPart, found, why);
        return why;
    }
    why.nearest = nearest;
    why.obstacle = nearest.obstacle;
    const Obstacle& obstacle = scene_.obstacles[*why.obstacle];
    why.limit = why.kind == WhyInvalid::Kind::kTooDeep ? obstacle.overlap() : obstacle.margin;
    why.isPartInside = why.kind == WhyInvalid::Kind::kTooDeep && obstacle.shrunkBy > 0;
    const MeshNames names = distinctMeshNames(scene_, nearest);
    why.partMesh = names.part;
    why.environmentMesh = names.environment;
    return why;
}

/// Names the solid and the mesh inside it, of the obstacles that count.
void SceneClearance::findEnclosure(const Pose& X_environmentPart, const PoseClearance& at,
                                   WhyInvalid& why) const {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (zones_->isIgnored(i, at)) continue;
        const auto found = enclosureBy(i, X_environmentPart);
        if (!found) continue;
        why.obstacle = i;
        why.partMesh = *found->partMesh;
        why.environmentMesh = *found->obstacleMesh;
        why.isPartInside = found->isPartInside;
        // Such a mesh touches nothing of the other, shrunk one, and has all its points inside.
        const Obstacle& obstacle = scene_.obstacles[i];
        if (why.isPartInside ? obstacle.shrunkBy > 0 : obstacle.shrunk != nullptr) {
            why.kind = WhyInvalid::Kind::kTooDeep;
            why.limit = obstacle.overlap();
        }
        return;
    }
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
