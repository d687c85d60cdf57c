// Rules that say, by name, how the obstacles of an environment count.
//
// A name stands for the component of this name. If there is none, it stands for all components whose names
// begin with the name and a '/' (as those of all meshes of a node do), or for all components of the file of
// this name. A file may be named with or without its ending, and with its last folders if several files have
// the name. With several files, components are called FILE/NAME; NAME alone is enough if only one file has
// it. Otherwise a name with * (any text) or ? (any character) stands for all components whose FILE/NAME or NAME it matches.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

/// Obstacles that the assembled part may touch; see ContactZone.
struct ContactRule {
    std::vector<std::string> names;  ///< of the obstacles; a name as above may stand for several
    double distance = 0;             ///< ContactZone::distance: environment units, > 0
};

/// How deep obstacles may reach below the part's surface; see shrink().
struct OverlapRules {
    double common = 0;  ///< of obstacles that no name stands for, environment units, >= 0
    /// Overlaps that replace the common one, by name; environment units, >= 0. If two names stand for one
    /// obstacle, the name that stands for fewer components counts.
    std::map<std::string, double> byName;
};

/// All rules of a problem.
struct ObstacleRules {
    /// Margins that replace the common margin, by name; environment units, >= 0. If two names stand for one
    /// obstacle, the name that stands for fewer components counts.
    std::map<std::string, double> margins;
    std::vector<std::string> ignored;         ///< names of obstacles to leave out
    bool isAllSolid = false;                  ///< whether all obstacles are solid, also those not in `solid`
    std::vector<std::string> solid;           ///< names of solid obstacles; see Obstacle::solids
    std::optional<ContactRule> startContact;  ///< obstacles that the part may touch around the start
    std::optional<ContactRule> goalContact;   ///< obstacles that the part may touch around the goal
    OverlapRules overlap;  ///< for obstacles that may reach into the part, or an open part into them
    /// Names of components that become an obstacle of their own each, so that a scene can be looked at without them.
    /// Problem files have no key for it.
    std::vector<std::string> apart;
};

}  // namespace clearway

#pragma GCC visibility pop
