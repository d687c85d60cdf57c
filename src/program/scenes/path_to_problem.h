// From a part, what is around it and a path out, as a generator designs them, to a problem planners can take.
#pragma once

#include "program/scenes/generated_scene.h"

namespace clearway::scenes {

/// Moves the part so that the mean of its vertices, to a whole unit, becomes its origin, about which planners
/// turn it, and changes the path's states so that its surface stays where it is.
void centrePart(GeneratedScene& scene);

/// The problem starts at the path's first state and ends at its last; its volume holds all states with `room`
/// around them.
void setProblem(GeneratedScene& scene, double room);

/// Both.
void statePathAsProblem(GeneratedScene& scene, double room);

}  // namespace clearway::scenes
