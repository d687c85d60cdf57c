#include "program/scenes/tunnel_body.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

Piece TunnelBody::swept(const Section& section, double from, double to) const {
    std::vector<double> stations;  // the straight part needs none between its ends
    if (from < 0) stations.push_back(from);
    if (to <= 0) stations.push_back(to);
    if (to > 0) {
        const std::vector<double> bent = stationsBetween(std::max(from, 0.0), to, metal.detail().step);
        stations.insert(stations.end(), bent.begin(), bent.end());
    }
    return placed(sweep(section, stations),
                  [this](const Vector3& p) { return design.screw.bendAfterStart(p); });
}

Piece TunnelBody::rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const {
    const Piece standing = placed(piece, standingAt(Vector3::Zero(), axis));
    // Before the mouth all is straight.
    if (at.x() < 0) {
        const Vector3 foot = bend(at.x(), at.y(), at.z());
        return placed(standing, [foot](const Vector3& p) -> Vector3 { return p + foot; });
    }
    return placed(standing, rigidAt(design.screw, at));
}

Piece TunnelBody::boss(const BossShape& shape) const {
    return turned(bossOutline(shape, metal.detail().segmentsPerQuarter), metal.detail().segmentsPerTurn);
}

void TunnelBody::addBolt(const std::string& stem, const Vector3& at, const Vector3& axis, double shank) {
    BoltShape shape;
    shape.shank = shank;
    shape.head = 1.7 * shank;
    shape.height = 1.6 * shank;
    shape.length = 4 * shank;
    metal.part(stem, rigid(bolt(shape, metal.detail().segmentsPerTurn), at, axis));
}

Line TunnelBody::along(double from, double to, const std::function<Vector2(double s)>& place) const {
    Line line;
    for (const double s : stationsBetween(from, to, std::min(2 * metal.detail().step, 30.0))) {
        const Vector2 across = place(s);
        line.push_back(bend(s, across.x(), across.y()));
    }
    return line;
}

SheetMetal buildTunnelBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                           bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    TunnelBody body{design, metal, random};
    body.addFloors();
    body.addWalls();
    body.addRibs();
    body.addSupports();
    body.addDuct();
    body.addUnderbody();
    body.addLines();
    body.addFasteners();
    body.addStuds(studs);
    return metal;
}

}  // namespace clearway::scenes
