// The keys of [clearway] with rules for obstacles: margin.NAME, ignore, solid, contact.start and
// contact.goal.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clearway/obstacle_rules.h"
#include "problem/config.h"

namespace clearway {

/// Reads a list of names. Empty without the key. Throws ArgumentError naming the key when the value is no list.
std::vector<std::string> readNames(ConfigValues& values, const std::string& key);

/// A text that readNames reads back. Throws ArgumentError that names the key when a name cannot be written.
std::string namesOf(const std::string& key, const std::vector<std::string>& names);

/// Reads the rules. Throws ArgumentError naming the key when a value is wrong.
ObstacleRules readObstacleRules(ConfigValues& values);

/// Keys and values that readObstacleRules reads back to equal rules. Throws ArgumentError when a name
/// cannot be written, or a margin or a contact's distance is not allowed.
std::vector<std::pair<std::string, std::string>> writtenRules(const ObstacleRules& rules);

}  // namespace clearway
