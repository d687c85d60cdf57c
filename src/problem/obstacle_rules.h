// The keys of [clearway] that say how obstacles count: margin.NAME, ignore, solid, contact.start and
// contact.goal.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clearway/obstacle_rules.h"
#include "problem/config_values.h"

namespace clearway {

/// Throws std::invalid_argument naming the key when a value is wrong.
ObstacleRules readObstacleRules(ConfigValues& values);

/// Keys and values that readObstacleRules reads back the same. Throws std::invalid_argument when a name
/// cannot be written or a contact's length is none.
std::vector<std::pair<std::string, std::string>> writtenRules(const ObstacleRules& rules);

}  // namespace clearway
