#include "problem/start_remedies.h"

#include <algorithm>

#include "clearway/query.h"
#include "core/number.h"
#include "model/triangles_of.h"
#include "problem/config.h"

namespace clearway {
namespace {

constexpr std::size_t kMostTouched = 20;  ///< obstacles in a message

/// The names of a rule and those not yet among them, as a problem file lists them.
std::string listed(std::vector<std::string> names, const std::vector<std::string>& more) {
    for (const std::string& name : more) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return writtenNames(names).value_or("NAMES");
}

/// The triangles of each component that the model holds.
std::vector<Mesh> meshesOf(const Model& model) {
    std::vector<Mesh> meshes(model.components().size());
    eachTriangleOf(model, [&](std::size_t component, const TriangleCorners& corners) {
        Mesh& mesh = meshes[component];
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    });
    return meshes;
}

}  // namespace

std::vector<std::string> touchedObstacles(const Scene& scene, const Pose& X_environmentPart) {
    Workspace workspace;
    std::vector<std::string> names;
    for (const Obstacle& obstacle : scene.obstacles) {
        const auto isTouched = [&](const Model& model) {
            return isWithin(scene.part, model, X_environmentPart, obstacle.margin, workspace);
        };
        if (obstacle.isIgnoredAtStart || obstacle.overlap() > 0 || !isTouched(obstacle.model)) continue;
        const std::vector<Mesh> meshes = meshesOf(obstacle.model);
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!meshes[i].triangles.empty() && isTouched(Model::build(meshes[i])))
                names.push_back(obstacle.model.components()[i].name);
        }
    }
    return names;
}

std::vector<StartRemedy> startRemedies(const Problem& problem, const std::vector<std::string>& touched,
                                       double length, bool mayOverlap) {
    const ObstacleRules& rules = problem.rules;
    const std::optional<ContactRule>& contact = rules.startContact;
    if (contact) length = std::max(length, contact->distance);
    std::vector<StartRemedy> remedies = {
        {"contact.start",
         listed(contact ? contact->names : std::vector<std::string>(), touched) + ", " +
             shortNumber(awayFromZero(length, 3)),
         std::string("ignored until some point of the part has moved so far") +
             (contact ? "; in place of the contact.start that is there" : "")},
        {"ignore", listed(rules.ignored, touched), "left out"}};
    if (mayOverlap) {
        const bool isThere = rules.overlap.common > 0 || !rules.overlap.byName.empty();
        remedies.push_back(
            {"overlap", "X",
             std::string(isThere ? "more than is there: " : "") + "one may reach so deep into the other"});
    }
    return remedies;
}

std::string startAdvice(const Problem& problem, const std::vector<std::string>& touched, double length,
                        bool mayOverlap) {
    const bool areMany = touched.size() > kMostTouched;
    const auto remedies =
        startRemedies(problem, areMany ? std::vector<std::string>{"NAMES"} : touched, length, mayOverlap);
    std::string advice = "; if the parts are assembled so, write in [clearway] ";
    for (std::size_t i = 0; i < remedies.size(); ++i) {
        const bool isLast = i + 1 == remedies.size();
        if (i > 0) advice += !isLast ? ", " : remedies.size() > 2 ? ", or " : " or ";
        advice += remedies[i].key + " = " + remedies[i].value + " (" + remedies[i].effect + ")";
    }
    return advice;
}

std::string openPartAdvice(const std::string& whyPartIsOpen) {
    return "; the part is open, too (" + whyPartIsOpen +
           "), and an overlap needs one of both closed: contact.start lets them touch near the start";
}

}  // namespace clearway
