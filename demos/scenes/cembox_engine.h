// The engine across the bay with its gearbox and the devices that the belt drives, and the radiator with its
// fans in front of the engine.
#pragma once

#include "demos/scenes/cembox_bay.h"

namespace clearway::scenes {

void addEngine(Bay& bay);
void addCooling(Bay& bay);

}  // namespace clearway::scenes
