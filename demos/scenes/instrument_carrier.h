// The instrument carrier: a skin over ribs on a beam across the car, with end plates, mounting plates, legs,
// a duct, vents and a glove box.
#pragma once

#include "demos/scenes/car_body.h"

namespace clearway::scenes {

/// The carrier in its place. Studs, each with equally many triangles, lie behind its skin. onlyCount: see
/// SheetMetal.
SheetMetal buildInstrumentCarrier(const CarBody& body, const Detail& detail, Random random, int studs,
                                  bool onlyCount);

}  // namespace clearway::scenes
