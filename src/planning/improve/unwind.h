// Takes needless turns out of a path.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// Length of the path of the part's origin plus `radius` times the angle turned: about how far a point of the part moves
/// that is so far out. Of paths that keep as much clearance the one with less is the better one. Environment units.
double windingLength(const ompl::geometric::PathGeometric& path, double radius);

/// A path, and the clearance that all its motions keep.
struct WidePath {
    std::shared_ptr<ompl::geometric::PathGeometric> path;
    double clearance = 0;
};

/// Whether a path is the better one of two: it keeps clearly more clearance (3 %), or about as much and winds less.
/// radius: see windingLength.
bool isBetterPath(const WidePath& way, const WidePath& other, double radius);

/// Replaces the rotations along stretches of the path by one turn from the stretch's first rotation to its last, where
/// that saves turns and all new motions keep the floor (MotionValidator::keepsClearance). Positions stay. The stretches
/// are the whole path, then halves, quarters and so on. isSpent may be empty; true ends the unwinding. Paths in other
/// spaces than OMPL's SE(3) and SE(2) stay as they are.
void unwind(ompl::geometric::PathGeometric& path, const MotionValidator& validator, double floor,
            const std::function<bool()>& isSpent);

}  // namespace clearway::planning
