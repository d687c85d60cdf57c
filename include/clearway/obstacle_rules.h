// How the obstacles of an environment count, by their names.
//
// A name stands for the component that is called so; or else for the components whose names begin with it
// and a '/', as all meshes of a node do, and all of a file by its name, with or without its ending, and with
// its last folders where several files have that name. Of several files, components are called FILE/NAME, and
// NAME alone will do where it is in one file only.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace clearway {

/// Obstacles that the assembled part may touch: see ContactZone.
struct ContactRule {
    std::vector<std::string> names;
    double distance = 0;  ///< environment units, > 0
};

struct ObstacleRules {
    /// In place of the margin of all, environment units, >= 0. Of two that name one obstacle the one that
    /// stands for fewer counts.
    std::map<std::string, double> margins;
    std::vector<std::string> ignored;  ///< left out
    bool isAllSolid = false;
    std::vector<std::string> solid;  ///< see Obstacle::solids
    std::optional<ContactRule> startContact, goalContact;
};

}  // namespace clearway
