// The car body of the scene large-environment: its measures, the surfaces its sheets follow, and its floor,
// sides and rear. Millimetres; x to the rear from the front end, y to the right, z up from the ground.
#pragma once

#include "demos/scenes/random.h"
#include "demos/scenes/sheet_metal.h"

namespace clearway::scenes {

struct CarBody {
    double clearance = 4;
    double gap = 4.5;  ///< at the mounting pads; leaves `clearance`

    // The bounds of the instrument carrier in its place.
    double carrierHalf = 540;   ///< half its width: the outer faces of its end plates
    double carrierFront = 955;  ///< front faces of its mounting plates, its foremost ones
    double carrierFoot = 430;   ///< undersides of its feet

    // The quantities that vary with the seed.
    double beadDepth = 7;
    double tunnelHeight = 140;

    /// Half the width of the body's outer skin.
    double halfWidth(double x, double z) const;
    double floorZ(double x, double y) const;
    double bonnetZ(double x, double y) const;

    /// The skin of the right side; v is z except at the wheel arches, u is x except at the leaning windscreen
    /// pillar. The upper side of its sheets is the inner one.
    Vector3 side(double u, double v) const;
    /// The lower edge of the side, cut by the wheel arches.
    double sideLowerEdge(double u) const;

    /// The dash panel; u is y, v goes up along it from the tunnel or the floor. The upper side of its sheets
    /// faces the cabin.
    Vector3 dash(double u, double v) const;
    Spine dashProfile() const;
};

constexpr double kFrontWheel = 480, kRearWheel = 3080;  // x
constexpr double kWheelHeight = 200, kWheelArch = 365;  // z of the arches' centres, their radius

/// Makes the measures. Throws std::invalid_argument for a clearance out of range.
CarBody designCarBody(std::uint64_t seed, double clearance);

void addFloor(const CarBody& body, SheetMetal& metal, Random& random);
void addUnderbody(const CarBody& body, SheetMetal& metal);
void addSides(const CarBody& body, SheetMetal& metal, Random& random);
void addRear(const CarBody& body, SheetMetal& metal, Random& random);
void addDash(const CarBody& body, SheetMetal& metal, Random& random);
/// Adds the pads of the instrument carrier.
void addMountings(const CarBody& body, SheetMetal& metal);
/// Adds wheel houses, bonnet and front end.
void addFrontEnd(const CarBody& body, SheetMetal& metal, Random& random);
/// Adds seats, springs and brakes, exhaust and tank, steering, bolts and lines.
void addFittings(const CarBody& body, SheetMetal& metal, Random& random);
void addFloorStuds(const CarBody& body, SheetMetal& metal, int studs);

}  // namespace clearway::scenes
