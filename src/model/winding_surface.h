// Closed surfaces that wind around a point at one end of its way, and not at the other: it cannot have gone there without
// crossing them.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"

namespace clearway {

/// A point of a part, in the part's coordinates, and its part at both ends of the way; without a goal the way ends outside all
/// surfaces.
struct PointAtEnds {
    Vector3 point;
    Pose start;
    std::optional<Pose> goal;
};

struct WindingSurface {
    std::string name;            ///< of its component, else of its file
    bool isAroundStart = false;  ///< otherwise around the goal
};

Vector3 anyPointOf(const Model& model);  ///< a vertex; mesh coordinates

/// A closed shell of the model that winds around the point at one end alone, decided exactly; the point must be on no surface.
std::optional<WindingSurface> surfaceThatParts(const Model& model, const PointAtEnds& ends);

}  // namespace clearway
