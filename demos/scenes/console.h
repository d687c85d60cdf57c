// The console: one pressed shell with its openings, cup holders, a bin with its lid, a gear
// lever's gate and boot, and the parts that hold and stiffen it inside.
#pragma once

#include "demos/scenes/random.h"
#include "demos/scenes/sheet_metal.h"
#include "demos/scenes/tunnel_console.h"

namespace clearway::scenes {

/// The console, its middle at s = 0. onlyCount: see SheetMetal.
SheetMetal buildConsoleBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                            bool onlyCount);

}  // namespace clearway::scenes
