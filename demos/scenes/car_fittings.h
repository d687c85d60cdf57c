// The front of the car body and the fittings of the body: dash panel with its layers, cowl, the pads of the
// instrument carrier, wheel houses, bonnet and front end; seats, springs and brakes, exhaust and tank,
// steering wheel, bolts, lines.
#pragma once

#include "demos/scenes/car_body.h"

namespace clearway::scenes {

void addDash(const CarBody& body, SheetMetal& metal, Random& random);
void addMountings(const CarBody& body, SheetMetal& metal);
void addFrontEnd(const CarBody& body, SheetMetal& metal, Random& random);

/// Adds seats, springs and brakes, exhaust and tank, steering, bolts and lines.
void addFittings(const CarBody& body, SheetMetal& metal, Random& random);

}  // namespace clearway::scenes
