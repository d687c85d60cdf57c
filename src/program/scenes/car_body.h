// The measures of the scene large-environment: the surfaces a car body's sheets follow and where the
// instrument carrier sits in it. Millimetres; x to the rear from the front end, y to the right, z up from the
// ground.
#pragma once

#include "program/scenes/random.h"
#include "program/scenes/sheet_metal.h"

namespace clearway::scenes {

struct CarBody {
    double clearance = 4;
    double gap = 4.5;  ///< at the mounting pads, so that `clearance` is left

    // The carrier in its place; all of it lies within.
    double carrierHalf = 540;   ///< half its width: the outer faces of its end plates
    double carrierFront = 955;  ///< front faces of its mounting plates, the foremost of it
    double carrierFoot = 430;   ///< undersides of its feet
    double approach = 0.14;     ///< radians: it arrives from the rear and, so much, from above
    double entry = 0.24;        ///< radians, turned about z while it passes the door opening

    // What varies with the seed.
    double beadDepth = 7;
    double tunnelHeight = 140;
    double crown = 45;  ///< of the roof, from its middle to its edges

    /// Half the width of the body's outer skin.
    double halfWidth(double x, double z) const;
    double floorZ(double x, double y) const;
    double roofZ(double x, double y) const;
    double bonnetZ(double x, double y) const;

    /// The skin of the right side; v is z but for wheel arches, u is x but for the leaning windscreen pillar.
    /// Its upper side is the inner one.
    Vector3 side(double u, double v) const;
    /// The wheel arches cut it.
    double sideLowerEdge(double u) const;

    /// The dash panel; u is y, v goes up along it from the tunnel or the floor. Its upper side is the
    /// cabin's.
    Vector3 dash(double u, double v) const;
    Spine dashProfile() const;
};

constexpr double kFrontWheel = 480, kRearWheel = 3080;  // x
constexpr double kWheelHeight = 200, kWheelArch = 365;  // z of the arches' centres, their radius

/// Throws std::invalid_argument for a clearance that cannot be.
CarBody designCarBody(std::uint64_t seed, double clearance);

/// The carrier in its place. Studs, each of the same number of triangles, lie behind its skin.
SheetMetal buildInstrumentCarrier(const CarBody& body, const Detail& detail, Random random, int studs,
                                  bool onlyCount);

/// Everything around it. Studs stand on the floor.
SheetMetal buildCarBody(const CarBody& body, const Detail& detail, Random random, int studs, bool onlyCount);

// Its groups.
void addFloor(const CarBody& body, SheetMetal& metal, Random& random);
void addUnderbody(const CarBody& body, SheetMetal& metal);
void addSides(const CarBody& body, SheetMetal& metal, Random& random);
void addDash(const CarBody& body, SheetMetal& metal, Random& random);
void addMountings(const CarBody& body, SheetMetal& metal);
void addFrontEnd(const CarBody& body, SheetMetal& metal, Random& random);
void addRoof(const CarBody& body, SheetMetal& metal);
void addRear(const CarBody& body, SheetMetal& metal, Random& random);
void addFloorStuds(const CarBody& body, SheetMetal& metal, int studs);

/// Only in version 2: seats, springs and brakes, exhaust and tank, steering, bolts and lines.
void addFittings(const CarBody& body, SheetMetal& metal, Random& random);

}  // namespace clearway::scenes
