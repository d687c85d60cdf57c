// The measures of the scene large-environment: a slot between two beaded sheets under a car's
// roof, and the tray of a sliding roof that fills it. Millimetres; the coordinates are the car's, see
// car_body.h.
#pragma once

#include "clearway/problem.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/sheet_metal.h"

namespace clearway::scenes {

/// All sheets of the roof are one profile across the car, turned about an axis parallel to y far below it. So
/// the tray can follow the roof along the car, its beads in those of the sheets above and below, at a
/// constant distance.
struct RoofSlot {
    double clearance = 10;
    double gap = 11.2;  ///< between the tray's sheets and the facing ones; leaves `clearance`

    double radius = 7000;  ///< of the roof's skin, at y = 0
    double middle = 2450;  ///< x of the axis and of the roof's highest line
    double top = 1420;     ///< z of that line
    double crown = 45;     ///< drop of the roof at y = 620
    double beadDepth = 6;
    double embossing = 2.2;  ///< height, away from the slot

    // Depths below the skin of the middles of the gaps above and below the tray.
    double upper = 52;
    double lower = 113;

    // The tray in its place, along and across the car; and the slot.
    double trayFront = 1590, trayRear = 2470, trayHalf = 440;
    double slotFront = 1500, slotRear = 2940, slotHalf = 520;

    /// The line across the roof, up positive. Every facing sheet has the profile's corners among its grid
    /// lines, so that facing sheets are parallel however coarse they are.
    Polyline profile;
    Polyline mitre;  ///< motion of each corner when the line is offset upwards by 1
    std::vector<double> keptULines;

    /// A point of the profile `depth` below the skin, offset upwards from there; u is x along the car's
    /// middle, v is y.
    Vector3 at(double u, double v, double depth, double offset) const;

    /// A point without beads: u, v and the height above the line `depth` below the skin.
    Vector3 smoothAt(double u, double v, double depth, double height) const;

    /// The height of the embossing, 0 to `embossing`.
    double embossed(double u, double v) const;

    /// The extra distance of the tray's sheets from the facing ones, compared with the middle in front of the
    /// opening, where they are nearest.
    double receding(double u, double v) const;

    /// The state of the tray moved along the roof to the rear.
    PartState moved(double along) const;

    /// The path from the tray's place to behind the car.
    std::vector<PartState> path() const;
};

/// Makes the measures. Throws std::invalid_argument for a clearance out of range.
RoofSlot designRoofSlot(const SceneOptions& options);

/// The tray in its place: two beaded sheets around an opening, between them a frame, ribs, hat sections,
/// guides, cables, hoses and a motor. Studs, each with equally many triangles, lie inside it. onlyCount: see
/// SheetMetal.
SheetMetal buildRoofTray(const RoofSlot& roof, const Detail& detail, Random random, int studs,
                         bool onlyCount);

}  // namespace clearway::scenes
