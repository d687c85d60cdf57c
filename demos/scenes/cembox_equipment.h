// The equipment around the engine: battery, air filter, fluid tanks, brakes and fuse box; hoses, pipes and
// cables.
#pragma once

#include "demos/scenes/cembox_bay.h"

namespace clearway::scenes {

void addAggregates(Bay& bay);
void addLines(Bay& bay);

}  // namespace clearway::scenes
