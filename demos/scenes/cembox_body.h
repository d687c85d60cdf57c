// The sheet metal of the engine bay, and the chassis below it.
#pragma once

#include "demos/scenes/cembox_bay.h"

namespace clearway::scenes {

void addBody(Bay& bay);
void addWeldStuds(Bay& bay, int studs);

/// Adds front end, chassis, insulation, wing braces, wipers.
void addBayFittings(Bay& bay);

}  // namespace clearway::scenes
