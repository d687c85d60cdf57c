#include "program/scenes/cembox_bay.h"

#include <algorithm>
#include <cmath>

#include "program/scenes/loft.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

constexpr double kWithWashers = 0.6;  // richness, below which bolts have none

/// Grows as the detail's numbers of segments do, without their steps.
double cuts(const Detail& detail) {
    return std::pow(detail.richness, 0.75 / 0.7);
}

}  // namespace

void Bay::add(const std::string& name, const Piece& piece) {
    if (keptFree.isClearOf(piece)) assembly.add(name, piece);
}

void Bay::addNumbered(const std::string& stem, const Piece& piece) {
    if (keptFree.isClearOf(piece)) assembly.addNumbered(stem, piece);
}

Piece Bay::box(const Vector3& low, const Vector3& high, double corner, double edge) const {
    return roundedBox(low, high, corner, edge, quarterFor(corner));
}

int Bay::segmentsFor(double radius) const {
    const double relative = std::clamp(std::sqrt(radius / 15), 0.5, 3.0);
    return 4 * std::max(2, static_cast<int>(std::lround(relative * (1.5 * cuts(detail) + 1))));
}

int Bay::quarterFor(double radius) const {
    const double relative = std::clamp(std::sqrt(radius / 8), 0.5, 2.0);
    return std::max(1, static_cast<int>(std::lround(1.6 * relative * cuts(detail))));
}

Piece Bay::turnedRound(const Polyline& outline) const {
    double radius = 0;
    for (const Vector2& p : outline) radius = std::max(radius, p.x());
    return turned(outline, segmentsFor(radius));
}

Piece Bay::turnedRing(const Polyline& loop) const {
    double radius = 0;
    for (const Vector2& p : loop) radius = std::max(radius, p.x());
    return ring(loop, segmentsFor(radius));
}

Piece Bay::tube(const Line& line, double radius, double wall) const {
    return pipe(line, radius, wall, segmentsFor(radius));
}

Piece Bay::bar(const Line& line, double radius) const {
    return rod(line, radius, segmentsFor(radius));
}

Piece Bay::wavyBar(const Line& line, double radius, const std::function<double(double)>& radiusAt) const {
    return variedRod(line, radiusAt, segmentsFor(radius));
}

Polyline Bay::rounded(const Polyline& line, const std::vector<double>& radii) const {
    return filleted(line, radii, quarterFor(*std::max_element(radii.begin(), radii.end())));
}

std::vector<double> Bay::stations(double from, double to) const {
    return stationsBetween(from, to, detail.step);
}

Section Bay::sheet(const Polyline& line, double radius, double thickness) const {
    return sheetSection(rounded(line, std::vector<double>(line.size() - 2, radius)), thickness);
}

void Bay::addBolt(const Vector3& at, const Vector3& axis, double shank) {
    const double washer = 0.5 * shank;
    BoltShape shape;
    shape.shank = shank;
    shape.length = 4 * shank;
    shape.head = 1.7 * shank;
    shape.height = 1.4 * shank;
    const Vector3 up = axis.normalized();
    addNumbered("bolt", placed(bolt(shape, segmentsFor(2 * shank)),
                               standingAt(at + up * (washer + kSlit), axis, random.between(0, M_PI))));
    if (detail.richness < kWithWashers) return;
    const Polyline section{
        {1.15 * shank, 0}, {2.6 * shank, 0}, {2.6 * shank, washer}, {1.15 * shank, washer}};
    addNumbered("washer", placed(turnedRing(section), standingAt(at, axis)));
}

void Bay::addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double shank,
                     double number) {
    const int bolts = std::max(2, detail.count(number));
    for (int i = 0; i < bolts; ++i) {
        addBolt(from + (to - from) * (static_cast<double>(i) / (bolts - 1)), axis, shank);
    }
}

Assembly buildEngineBay(const CemboxDesign& design, const KeptFree& keptFree, const Detail& detail,
                        Random random, int studs, bool withFittings) {
    Bay bay{design, keptFree, detail, random};
    addSlot(bay);
    addBody(bay);
    addEngine(bay);
    addCooling(bay);
    addAggregates(bay);
    addLines(bay);
    if (withFittings) addBayFittings(bay);
    addWeldStuds(bay, studs);
    return bay.assembly;
}

}  // namespace clearway::scenes
