// The engine bay of the scene cembox while it is built, shared by the files that build it. x to the left, y
// to the rear, z up: about 1.4 m wide, 0.9 m long, 0.75 m high.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "demos/scenes/cembox.h"
#include "demos/scenes/random.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

/// The room that a part needs on its way. Pieces around the path stay out of this room.
class KeptFree {
  public:
    /// boxes: in the part's coordinates; together they hold the part.
    explicit KeptFree(std::vector<Box> boxes);

    /// Adds the room within `margin` of the boxes on a planner's interpolation between two states: straight
    /// translation, shortest rotation.
    void addMotion(const PartState& from, const PartState& to, double margin);

    /// True when every triangle of the piece is farther than the margin from the boxes along all motions. May
    /// be false for a piece that is only a little farther than the margin.
    bool isClearOf(const Piece& piece) const;

  private:
    struct Obstacle {  ///< a grown box at a pose on the way
        Pose X_partWorld;
        Box box;      ///< part coordinates
        Box inWorld;  ///< bounds of the box at that pose
    };

    bool meets(const Vector3& a, const Vector3& b, const Vector3& c) const;

    std::vector<Box> boxes_;
    double radius_ = 0;  ///< of a ball about the part's origin that holds the boxes
    std::vector<Obstacle> obstacles_;
    Box all_;
};

/// The room the module needs on its way; everything but rails and buffers stays out of it.
KeptFree keptFreeFor(const CemboxDesign& design);

struct Bay {
    const CemboxDesign& design;
    const KeptFree& keptFree;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    static constexpr double kSlit = 0.3;                                    // mm between neighbours
    static constexpr double kBulkhead = 850;                                // y of its front, without beads
    static constexpr double kHalfWidth = 660;                               // x of the inner wings
    static constexpr double kTowerX = 575, kTowerY = 590, kTowerTop = 690;  // of the strut towers

    /// Adds the piece unless it reaches into the room the module needs.
    void add(const std::string& name, const Piece& piece) {
        if (keptFree.isClearOf(piece)) assembly.add(name, piece);
    }
    void addNumbered(const std::string& stem, const Piece& piece) {
        if (keptFree.isClearOf(piece)) assembly.addNumbered(stem, piece);
    }

    /// Adds the piece with its origin at `at` and its z along `axis`, as standingAt() says.
    void add(const std::string& name, const Piece& piece, const Vector3& at, const Vector3& axis,
             double turn = 0) {
        add(name, placed(piece, standingAt(at, axis, turn)));
    }
    void addNumbered(const std::string& stem, const Piece& piece, const Vector3& at, const Vector3& axis,
                     double turn = 0) {
        addNumbered(stem, placed(piece, standingAt(at, axis, turn)));
    }

    Piece box(const Vector3& low, const Vector3& high, double corner, double edge) const {
        return roundedBox(low, high, corner, edge, quarterFor(corner));
    }
    /// Segments of a circle of that radius (mm), a multiple of 4, and of a quarter of a rounding. Chords grow
    /// with the root of the radius, as with a chord tolerance. Each radius gets its next segment at another
    /// detail, so that the numbers of triangles grow in small steps.
    int segmentsFor(double radius) const;
    int quarterFor(double radius) const;

    Piece turnedRound(const Polyline& outline) const;
    Piece turnedRing(const Polyline& loop) const;
    Piece tube(const Line& line, double radius, double wall) const {
        return pipe(line, radius, wall, segmentsFor(radius));
    }
    Piece bar(const Line& line, double radius) const { return rod(line, radius, segmentsFor(radius)); }
    Piece wavyBar(const Line& line, double radius, const std::function<double(double)>& radiusAt) const {
        return variedRod(line, radiusAt, segmentsFor(radius));
    }
    Polyline rounded(const Polyline& line, const std::vector<double>& radii) const {
        return filleted(line, radii, quarterFor(*std::max_element(radii.begin(), radii.end())));
    }
    std::vector<double> stations(double from, double to) const {
        return stationsBetween(from, to, detail.step);
    }

    /// A sheet with the line in its middle, all its corners rounded by `radius`.
    Section sheet(const Polyline& line, double radius, double thickness) const {
        return sheetSection(rounded(line, std::vector<double>(line.size() - 2, radius)), thickness);
    }

    /// A bolt whose head lies on `at` and points along `axis`, with a washer if the detail is fine enough.
    void addBolt(const Vector3& at, const Vector3& axis, double shank);

    /// A row of evenly spaced bolts from the first to the last point; the detail scales their number.
    void addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double shank, double number);
};

/// The sheet metal of the bay.
void addBody(Bay& bay);
void addWeldStuds(Bay& bay, int studs);
/// Adds front end, chassis, insulation, wing braces, wipers.
void addBayFittings(Bay& bay);
/// Adds the engine with its gearbox and the devices that the belt drives.
void addEngine(Bay& bay);
/// Adds the radiator with its fans, in front of the engine.
void addCooling(Bay& bay);
/// Adds battery, air filter, fluid tanks, brakes and fuse box.
void addAggregates(Bay& bay);
/// Adds hoses, pipes and cables.
void addLines(Bay& bay);

/// Everything around the module, with `studs` weld studs on the bulkhead.
Assembly buildEngineBay(const CemboxDesign& design, const KeptFree& keptFree, const Detail& detail,
                        Random random, int studs);

}  // namespace clearway::scenes
