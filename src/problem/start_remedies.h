// How to write a problem whose part touches obstacles at its start: `init` and `plan` give the same advice.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// The length to suggest for contact.start, as a share of the part's diagonal.
constexpr double kUsualContact = 0.02;

/// A key of [clearway] that lets the problem begin at its start.
struct StartRemedy {
    std::string key, value;
    std::string effect;  ///< in a few words
};

/// Names of the scene's obstacles that are no farther from the part than their margins. Leaves out those that are ignored at
/// the start, and those with an overlap.
std::vector<std::string> touchedObstacles(const Scene& scene, const Pose& X_environmentPart);

/// touched: names of obstacles, see touchedObstacles. length: for contact.start. mayOverlap: an overlap would be enough.
std::vector<StartRemedy> startRemedies(const Problem& problem, const std::vector<std::string>& touched,
                                       double length, bool mayOverlap);

/// The remedies as the end of a message, which begins with "; ". Many names are left out.
std::string startAdvice(const Problem& problem, const std::vector<std::string>& touched, double length,
                        bool mayOverlap);

/// Advice that ends a refusal to shrink an obstacle in place of the part.
std::string openPartAdvice(const std::string& whyPartIsOpen);

}  // namespace clearway

#pragma GCC visibility pop
