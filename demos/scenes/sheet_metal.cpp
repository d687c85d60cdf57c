#include "demos/scenes/sheet_metal.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kSame = 1e-3;      // mm; lines nearer than this are one
constexpr double kSharp = 1e6;      // squareness from which an opening is a rectangle and bends no point
constexpr double kLeastGap = 0.12;  // least distance of two lines, as a share of the step
constexpr double kAtLarge = 5;      // mm; upper limit of that distance at large openings
constexpr double kLarge =
    100;  // mm; least half width of large openings, which are never left out for coarseness
// mm; greatest width around an opening that is bent to the opening's shape.
constexpr double kMostMargin = 30;

double marginOf(const Opening& opening) {
    return std::min(0.5 * opening.half.minCoeff(), kMostMargin);
}

void addLine(std::vector<double>& lines, double at, double leastGap) {
    const auto next = std::lower_bound(lines.begin(), lines.end(), at);
    if (next == lines.begin() || next == lines.end()) return;
    if (*next - at >= leastGap && at - *std::prev(next) >= leastGap) lines.insert(next, at);
}

std::vector<double> filledUp(const std::vector<double>& lines, double step) {
    std::vector<double> all{lines.front()};
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const double from = lines[i - 1], gap = lines[i] - from;
        const int spans = std::max(1, static_cast<int>(std::ceil(gap / step - 1e-9)));
        for (int k = 1; k <= spans; ++k) all.push_back(from + gap * k / spans);
    }
    return all;
}

int nearest(const std::vector<double>& lines, double at) {
    const auto next = std::lower_bound(lines.begin(), lines.end(), at);
    if (next == lines.begin()) return 0;
    if (next == lines.end()) return static_cast<int>(lines.size()) - 1;
    const int index = static_cast<int>(next - lines.begin());
    return *next - at < at - *std::prev(next) ? index : index - 1;
}

/// The largest angle between two stations of a bend.
double angleOf(const Detail& detail) {
    return M_PI_2 / (1.5 * detail.segmentsPerQuarter);
}

Piece mirroredInY(Piece piece) {
    for (Vector3& vertex : piece.vertices) vertex.y() = -vertex.y();
    for (TriangleIndices& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
    return piece;
}

}  // namespace

Panel::Panel(PanelShape shape, const PanelDetail& detail) : shape_(std::move(shape)) {
    const double leastGap = kLeastGap * detail.step;
    for (int axis = 0; axis < 2; ++axis) {
        assert(shape_.low[axis] < shape_.high[axis]);
        std::vector<double> lines{shape_.low[axis], shape_.high[axis]};
        for (const double at : axis == 0 ? shape_.keptULines : shape_.keptVLines) addLine(lines, at, kSame);
        for (const Opening& opening : shape_.openings) {
            const double middle = opening.centre[axis], half = opening.half[axis];
            const double atEdges = opening.half.minCoeff() < kLarge ? leastGap : std::min(leastGap, kAtLarge);
            for (const double side : {-1.0, 1.0}) {
                addLine(lines, middle + side * half, atEdges);
                addLine(lines, middle + side * (half + marginOf(opening)), atEdges);
            }
            for (int k = 1; k < detail.holeSpans; ++k) {
                addLine(lines, middle + half * (2.0 * k / detail.holeSpans - 1), leastGap);
            }
        }
        for (const double at : axis == 0 ? shape_.uLines : shape_.vLines) addLine(lines, at, leastGap);
        lines_[axis] = filledUp(lines, detail.step);
    }
    for (const Opening& opening : shape_.openings) place(opening);
}

void Panel::place(const Opening& opening) {
    Block block;
    block.squareness = opening.squareness;
    for (int axis = 0; axis < 2; ++axis) {
        const std::vector<double>& lines = lines_[axis];
        const double middle = opening.centre[axis], half = opening.half[axis],
                     outer = half + marginOf(opening);
        block.low[axis] = nearest(lines, middle - half);
        block.high[axis] = nearest(lines, middle + half);
        block.outerLow[axis] = std::min(nearest(lines, middle - outer), block.low[axis] - 1);
        block.outerHigh[axis] = std::max(nearest(lines, middle + outer), block.high[axis] + 1);
        if (block.low[axis] >= block.high[axis]) return;
        if (block.outerLow[axis] < 0 || block.outerHigh[axis] > cells(axis)) return;
    }
    // An opening must not bend a line that is kept straight.
    const double from = lines_[1][block.outerLow[1]], to = lines_[1][block.outerHigh[1]];
    const auto isBent = [&](double at) { return at > from + kSame && at < to - kSame; };
    if (opening.squareness < kSharp &&
        std::any_of(shape_.keptVLines.begin(), shape_.keptVLines.end(), isBent))
        return;
    const auto meets = [&](const Block& other) {
        return block.outerLow[0] < other.outerHigh[0] && other.outerLow[0] < block.outerHigh[0] &&
               block.outerLow[1] < other.outerHigh[1] && other.outerLow[1] < block.outerHigh[1];
    };
    if (std::none_of(blocks_.begin(), blocks_.end(), meets)) blocks_.push_back(block);
}

bool Panel::isMissing(int i, int j) const {
    if (i < 0 || j < 0 || i >= cells(0) || j >= cells(1)) return true;
    return std::any_of(blocks_.begin(), blocks_.end(), [&](const Block& block) {
        return i >= block.low[0] && i < block.high[0] && j >= block.low[1] && j < block.high[1];
    });
}

/// Points of a block's border move straight towards its middle, onto the opening's outline; towards the outer
/// border the motion fades to zero. The order of points along each ray from the middle stays, so no cell
/// turns over.
Vector2 Panel::bentToOpenings(int i, int j) const {
    const Vector2 at(lines_[0][i], lines_[1][j]);
    const int index[2] = {i, j};
    for (const Block& block : blocks_) {
        if (i <= block.outerLow[0] || i >= block.outerHigh[0] || j <= block.outerLow[1] ||
            j >= block.outerHigh[1])
            continue;
        Vector2 middle, q;
        double faded = 0;
        for (int axis = 0; axis < 2; ++axis) {
            const std::vector<double>& lines = lines_[axis];
            const double low = lines[block.low[axis]], high = lines[block.high[axis]];
            middle[axis] = (low + high) / 2;
            q[axis] = (at[axis] - middle[axis]) / ((high - low) / 2);
            if (index[axis] < block.low[axis]) {
                const double outer = lines[block.outerLow[axis]];
                faded = std::max(faded, (low - at[axis]) / (low - outer));
            } else if (index[axis] > block.high[axis]) {
                const double outer = lines[block.outerHigh[axis]];
                faded = std::max(faded, (at[axis] - high) / (outer - high));
            }
        }
        const double p = block.squareness, most = q.cwiseAbs().maxCoeff();
        if (most == 0) return at;
        const double rounded =
            std::pow(std::pow(std::abs(q.x()) / most, p) + std::pow(std::abs(q.y()) / most, p), 1 / p);
        const double shrink = (1 - faded) / rounded + faded;
        return middle + shrink * (at - middle);
    }
    return at;
}

std::size_t Panel::triangleCount() const {
    std::size_t faces = static_cast<std::size_t>(cells(0)) * cells(1);
    std::size_t rim = 2 * static_cast<std::size_t>(cells(0) + cells(1));
    for (const Block& block : blocks_) {
        const std::size_t wide = block.high[0] - block.low[0], deep = block.high[1] - block.low[1];
        faces -= wide * deep;
        rim += 2 * (wide + deep);
    }
    return 4 * faces + 2 * rim;
}

/// The points of both sides at a point of the surface.
std::pair<Vector3, Vector3> Panel::sides(const Vector2& at) const {
    constexpr double kDelta = 0.02;  // mm
    const auto& f = shape_.surface;
    const Vector3 du = f(at.x() + kDelta, at.y()) - f(at.x() - kDelta, at.y());
    const Vector3 dv = f(at.x(), at.y() + kDelta) - f(at.x(), at.y() - kDelta);
    const Vector3 normal = du.cross(dv).normalized(), middle = f(at.x(), at.y()) + shape_.offset * normal;
    return {middle + shape_.thickness / 2 * normal, middle - shape_.thickness / 2 * normal};
}

Piece Panel::piece() const {
    Piece piece;
    const int rows = cells(1) + 1;
    std::vector<std::uint32_t> top(static_cast<std::size_t>(cells(0) + 1) *
                                   rows);  // the point below comes next
    for (int i = 0; i <= cells(0); ++i) {
        for (int j = 0; j < rows; ++j) {
            if (isMissing(i, j) && isMissing(i - 1, j) && isMissing(i, j - 1) && isMissing(i - 1, j - 1))
                continue;
            top[i * rows + j] = static_cast<std::uint32_t>(piece.vertices.size());
            const auto [above, below] = sides(bentToOpenings(i, j));
            piece.vertices.push_back(above);
            piece.vertices.push_back(below);
        }
    }
    for (int i = 0; i < cells(0); ++i) {
        for (int j = 0; j < cells(1); ++j) {
            if (isMissing(i, j)) continue;
            const std::uint32_t corners[4] = {top[i * rows + j], top[(i + 1) * rows + j],
                                              top[(i + 1) * rows + j + 1], top[i * rows + j + 1]};
            const bool open[4] = {isMissing(i, j - 1), isMissing(i + 1, j), isMissing(i, j + 1),
                                  isMissing(i - 1, j)};
            const auto [a, b, c, d] = corners;
            piece.triangles.insert(piece.triangles.end(),
                                   {{a, b, c}, {a, c, d}, {a + 1, c + 1, b + 1}, {a + 1, d + 1, c + 1}});
            for (int side = 0; side < 4; ++side) {
                if (!open[side]) continue;
                const std::uint32_t from = corners[side], to = corners[(side + 1) % 4];
                piece.triangles.push_back({from + 1, to + 1, to});
                piece.triangles.push_back({from + 1, to, from});
            }
        }
    }
    return piece;
}

double smoothStep(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double beadAt(double x, double middle, double half, double flank) {
    return 1 - smoothStep(std::abs(x - middle), half, half + flank);
}

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

void SheetMetal::include(const std::string& prefix, const SheetMetal& other) {
    triangles_ += other.triangles_;
    if (!onlyCount_) assembly_.include(prefix, other.assembly_);
}

Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const BuildSheetMetal& build) {
    const auto countAt = [&](const Detail& detail, int studs) {
        return build(detail, studs, true).triangleCount();
    };
    const Detail detail =
        finestDetail(triangles, option, range, [&](const Detail& tried) { return countAt(tried, 0); });
    const std::size_t without = countAt(detail, 0), stud = countAt(detail, 1) - without;
    return build(detail, static_cast<int>((triangles - without) / stud), false).assembly().mesh();
}

Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const std::vector<std::string>& kept, const BuildSheetMetal& build) {
    if (triangles >= build(coarsestDetail(range), 0, true).triangleCount())
        return sheetMetalTo(triangles, option, range, build);
    return buildTo(triangles, option, range, kept,
                   [&](const Detail& detail, int studs) { return build(detail, studs, false).assembly(); });
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
