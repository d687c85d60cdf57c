#include "planning/setup/start_cures.h"

#include <algorithm>
#include <exception>
#include <vector>

#include "core/number.h"
#include "problem/config.h"
#include "problem/touched.h"

namespace clearway::planning {
namespace {

constexpr std::size_t kMostNamed = 20;  ///< obstacles in a message

void addNew(const std::vector<std::string>& more, std::vector<std::string>& names) {
    for (const std::string& name : more) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
}

/// Empty when the meshes cannot be read again: a problem's scene may be made without files.
std::vector<std::string> touched(const Problem& problem) {
    try {
        return touchedAtStart(problem, loadPart(problem), obstaclesOf(problem, loadWorlds(problem)));
    } catch (const std::exception&) {
        return {};
    }
}

std::string listed(const std::vector<std::string>& names) {
    if (names.size() > kMostNamed) return "NAMES";
    return writtenNames(names).value_or("NAMES");
}

}  // namespace

std::string startCures(const Problem& problem, const ValidityChecker& checker,
                       const ompl::base::State* start) {
    const Scene& scene = checker.scene();
    const SceneDistance nearest = checker.distance(start);
    std::vector<std::string> all = touched(problem);
    if (all.empty()) all.push_back(meshNames(scene, nearest).environment);
    const std::optional<ContactRule>& contact = problem.rules.startContact;
    std::vector<std::string> ignoredAtStart = contact ? contact->names : std::vector<std::string>();
    addNew(all, ignoredAtStart);
    std::vector<std::string> ignored = problem.rules.ignored;
    addNew(all, ignored);
    double reach = kUsualContact * scene.part.box().diagonal().norm() + 2 * scene.largestMargin();
    if (contact) reach = std::max(reach, contact->distance);
    std::string cures =
        "; if the parts are assembled so, write in [clearway] contact.start = " + listed(ignoredAtStart) +
        ", " + roundedNumber(reach) + " (ignored until some point of the part has moved so far" +
        (contact ? "; in place of the contact.start that is there)" : ")");
    const bool isTouching = nearest.collides() && scene.largestMargin() == 0;
    cures += std::string(isTouching ? ", " : " or ") + "ignore = " + listed(ignored) + " (left out)";
    if (!isTouching) return cures;
    return cures + ", or " +
           (problem.rules.overlap.common > 0 || !problem.rules.overlap.byName.empty() ? "a larger " : "") +
           "overlap = X (may reach so deep into the part; clearway info PROBLEM --lift tells X)";
}

}  // namespace clearway::planning
