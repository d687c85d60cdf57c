// The apartment's measures, and what stands in it. Millimetres; z is up from the floor.
#pragma once

#include "program/scenes/detail.h"
#include "program/scenes/random.h"

namespace clearway::scenes {

struct Apartment {
    double doorHalf = 340;                       ///< of both doors' openings, between their frames
    double firstDoor = 1500, secondDoor = 4700;  ///< y of their middles

    // Rooms: the living room on the left, the corridor, the music room and the kitchen on the right.
    double width = 9000, depth = 6500, height = 2500, wall = 120;
    double corridorLow = 4320, corridorHigh = 6080;  ///< x
    double kitchenTop = 3180;                        ///< y
    double leaf = 40;                                ///< thickness of doors

    // The piano.
    double pianoLength = 1500, pianoDepth = 600, pianoHeight = 1200;
};

/// `studs` books lie on the living room's shelves.
Assembly buildApartment(const Apartment& apartment, const Detail& detail, Random random, int studs);

/// The piano, its middle at x = y = 0, its castors on z = 0, the player on the side of -y. `studs` tuning
/// pins.
Assembly buildPiano(const Apartment& apartment, const Detail& detail, int studs);

}  // namespace clearway::scenes
