// The measures of the scene large-environment, version 2: a slot between two beaded sheets under a car's
// roof, and the tray of a sliding roof that fills it. Millimetres; the car's coordinates, see car_body.h.
#pragma once

#include "clearway/problem.h"
#include "program/scenes/random.h"
#include "program/scenes/scene_options.h"
#include "program/scenes/sheet_metal.h"

namespace clearway::scenes {

/// All sheets of the roof are one profile across the car, turned about an axis parallel to y far below it.
/// So the tray can follow the roof along the car, its beads in those of the sheets above and below it,
/// without coming nearer to them.
struct RoofSlot {
    double clearance = 10;
    double gap = 11.2;  ///< between the tray's sheets and those that face them, so that `clearance` is left

    double radius = 7000;  ///< of the roof's skin, in its middle
    double middle = 2450;  ///< x of the axis and of the roof's highest line
    double top = 1420;     ///< z of that line
    double crown = 45;     ///< lower at 620 mm beside it
    double beadDepth = 6;
    double embossing = 2.2;  ///< away from the slot

    // Depths below the skin of the middles of both gaps, above and below the tray.
    double upper = 52;
    double lower = 113;

    // The tray in its place, along the car and across it; and the slot.
    double trayFront = 1590, trayRear = 2470, trayHalf = 440;
    double slotFront = 1500, slotRear = 2940, slotHalf = 520;

    /// Across the roof and upwards: every facing sheet has its corners among its grid's lines, so that facing
    /// sheets are parallel however coarse they are.
    Polyline profile;
    Polyline mitre;  ///< how far a corner moves when the line is offset upwards by 1
    std::vector<double> keptULines;

    /// u is x along the car's middle, v is y: the profile `depth` below the skin, offset upwards from there.
    Vector3 at(double u, double v, double depth, double offset) const;

    /// Without beads: u, v and the height above the line `depth` below the skin.
    Vector3 smoothAt(double u, double v, double depth, double height) const;

    /// 0 or up to `embossing`.
    double embossed(double u, double v) const;

    /// How much farther the tray's sheets are from those that face them than in the middle before the
    /// opening, where they are nearest.
    double receding(double u, double v) const;

    /// The tray moved along the roof to the rear.
    PartState moved(double along) const;

    /// From its place to behind the car.
    std::vector<PartState> path() const;
};

/// Throws std::invalid_argument for a clearance that cannot be.
RoofSlot designRoofSlot(const SceneOptions& options);

/// The tray in its place. Studs, each of the same number of triangles, lie inside it.
SheetMetal buildRoofTray(const RoofSlot& roof, const Detail& detail, Random random, int studs,
                         bool onlyCount);

/// The roof from its skin to its lining, and what lies between them.
void addRoofLayers(const RoofSlot& roof, SheetMetal& metal, Random& random);

}  // namespace clearway::scenes
