// The engine bay of the scene cembox while it is built, shared by the files that build it. x to the left, y
// to the rear, z up: about 1.4 m wide, 0.9 m long, 0.75 m high.
#pragma once

#include <string>

#include "program/scenes/cembox_design.h"
#include "program/scenes/curve.h"

namespace clearway::scenes {

struct Bay {
    const CemboxDesign& design;
    const KeptFree& keptFree;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    static constexpr double kSlit = 0.3;                                    // mm between neighbours
    static constexpr double kBulkhead = 850;                                // y of its front, beads aside
    static constexpr double kHalfWidth = 660;                               // x of the inner wings
    static constexpr double kTowerX = 575, kTowerY = 590, kTowerTop = 690;  // of the strut towers

    /// Adds the piece unless it reaches into the room the module needs.
    void add(const std::string& name, const Piece& piece);
    void addNumbered(const std::string& stem, const Piece& piece);

    Piece box(const Vector3& low, const Vector3& high, double corner, double edge) const;
    /// Of a circle of that radius (mm), a multiple of 4, and of a rounding: chords grow with the root of the
    /// radius, as by a chord tolerance. As each radius gets its next segment at another detail, numbers of
    /// triangles grow in small steps.
    int segmentsFor(double radius) const;
    int quarterFor(double radius) const;

    Piece turnedRound(const Polyline& outline) const;
    Piece turnedRing(const Polyline& loop) const;
    Piece tube(const Line& line, double radius, double wall) const;
    Piece bar(const Line& line, double radius) const;
    Piece wavyBar(const Line& line, double radius, const std::function<double(double)>& radiusAt) const;
    Polyline rounded(const Polyline& line, const std::vector<double>& radii) const;
    std::vector<double> stations(double from, double to) const;

    /// A sheet with the line in its middle, all its corners rounded alike.
    Section sheet(const Polyline& line, double radius, double thickness) const;

    /// A bolt whose head lies on `at` and looks along `axis`, with a washer where detail allows.
    void addBolt(const Vector3& at, const Vector3& axis, double shank);

    /// Bolts evenly between two points, both included, as many as the detail asks for.
    void addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double shank, double number);
};

void addSlot(Bay& bay);        // what holds the module
void addBody(Bay& bay);        // sheet metal
void addEngine(Bay& bay);      // block, gearbox, and what is bolted to them
void addCooling(Bay& bay);     // radiator and fan
void addAggregates(Bay& bay);  // battery, tanks, boxes, brakes
void addLines(Bay& bay);       // hoses, pipes, cables
void addWeldStuds(Bay& bay, int studs);

void addBayFittings(Bay& bay);  // only in version 2

}  // namespace clearway::scenes
