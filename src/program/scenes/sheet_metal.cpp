#include "program/scenes/sheet_metal.h"

namespace clearway::scenes {

namespace {

/// Largest angle between two stations of a bend.
double angleOf(const Detail& detail) {
    return M_PI_2 / (1.5 * detail.segmentsPerQuarter);
}

Piece mirroredInY(Piece piece) {
    for (Vector3& vertex : piece.vertices) vertex.y() = -vertex.y();
    for (TriangleIndices& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
    return piece;
}

}  // namespace

void SheetMetal::add(const std::string& name, Piece piece) {
    assembly_.add(name, mirrored_ ? mirroredInY(std::move(piece)) : std::move(piece));
}

void SheetMetal::panel(const std::string& name, const PanelShape& shape) {
    const Panel panel(shape, {detail_.step / shape.finer, std::max(2, detail_.segmentsPerQuarter)});
    triangles_ += panel.triangleCount();
    if (!onlyCount_) add(name + ending_, panel.piece());
}

void SheetMetal::beam(const std::string& name, const Spine& spine, const Section& section) {
    const std::vector<double> stations = spine.stations(detail_.step, angleOf(detail_));
    std::size_t around = 0;
    for (const auto& loop : section.loops) around += loop.size();
    triangles_ += 2 * around * (stations.size() - 1) + 2 * section.cap.size();
    if (!onlyCount_) add(name + ending_, sweptAlong(spine, section, stations));
}

void SheetMetal::part(const std::string& stem, const Piece& piece) {
    triangles_ += piece.triangles.size();
    if (!onlyCount_) add(assembly_.nextName(stem + ending_), piece);
}

void SheetMetal::turnedPart(const std::string& stem, const Polyline& outline, const Vector3& at,
                            const Vector3& axis) {
    part(stem, placed(turned(outline, detail_.segmentsPerTurn), standingAt(at, axis)));
}

void SheetMetal::include(const std::string& prefix, const SheetMetal& other) {
    triangles_ += other.triangles_;
    if (!onlyCount_) assembly_.include(prefix, other.assembly_);
}

Polyline SheetMetal::rounded(const Polyline& line, double radius) const {
    return filleted(line, std::vector<double>(line.size() - 2, radius), detail_.segmentsPerQuarter);
}

Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const std::vector<std::string>& kept, const BuildSheetMetal& build) {
    const auto countAt = [&](const Detail& detail, int studs) {
        return build(detail, studs, true).triangleCount();
    };
    if (triangles < countAt(coarsestDetail(range), 0)) {
        return buildTo(triangles, option, range, kept, [&](const Detail& detail, int studs) {
            return build(detail, studs, false).assembly();
        });
    }
    const Detail detail =
        finestDetail(triangles, option, range, [&](const Detail& tried) { return countAt(tried, 0); });
    const std::size_t without = countAt(detail, 0), stud = countAt(detail, 1) - without;
    return build(detail, static_cast<int>((triangles - without) / stud), false).assembly().mesh();
}

Polyline hatLine(double width, double height, double flange) {
    const double lean = 0.15 * height, top = width / 2, foot = top + lean;
    return {{foot + flange, 0}, {foot, 0}, {top, height}, {-top, height}, {-foot, 0}, {-foot - flange, 0}};
}

Spine across(double fromY, double toY) {
    Pose start;
    start.rotation.col(0) = Vector3::UnitY();
    start.rotation.col(1) = -Vector3::UnitX();
    start.rotation.col(2) = Vector3::UnitZ();
    start.translation = {0, fromY, 0};
    Spine spine(start);
    spine.straight(toY - fromY);
    return spine;
}

}  // namespace clearway::scenes
