// Shortens a path by cutting corners that the motion validator allows.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

namespace clearway::planning {

/// Rounds of OMPL's vertex removal and shortcuts, until they stop paying or isSpent says so. Every motion
/// that it makes has passed checkMotion of the path's own space information in one direction; the caller
/// looks at the result once more (OMPL's simplified paths have collided).
void shorten(ompl::geometric::PathGeometric& path, const std::function<bool()>& isSpent);

}  // namespace clearway::planning
