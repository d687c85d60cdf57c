#include "demos/scenes/assembly.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace clearway::scenes {

namespace {

constexpr std::size_t kMostTriangles = 4000000;
constexpr double kFineness = 40;  // greatest fineness, see detailFor

constexpr char kHere[] = " at this clearance and seed";

Detail detailFor(double fineness, double step) {
    Detail detail;
    detail.segmentsPerQuarter = std::max(fineness < 1 ? 1 : 2, static_cast<int>(std::pow(fineness, 0.75)));
    detail.segmentsPerTurn = 4 * static_cast<int>(std::ceil(1.5 * std::pow(fineness, 0.75) + 0.5));
    detail.step = step / fineness;
    detail.richness = std::pow(fineness, 0.7);
    return detail;
}

bool beginsWithAny(const std::string& name, const std::vector<std::string>& stems) {
    return std::any_of(stems.begin(), stems.end(),
                       [&](const std::string& stem) { return name.rfind(stem, 0) == 0; });
}

}  // namespace

Piece placed(Piece piece, const Placement& placement) {
    for (Vector3& vertex : piece.vertices) vertex = placement(vertex);
    return piece;
}

Placement standingAt(const Vector3& origin, const Vector3& axis, double turn) {
    Matrix3 upright;
    upright.col(2) = axis.normalized();
    upright.col(0) = upright.col(2).unitOrthogonal();
    upright.col(1) = upright.col(2).cross(upright.col(0));
    const Matrix3 rotation = upright * Eigen::AngleAxisd(turn, Vector3::UnitZ()).toRotationMatrix();
    return [rotation, origin](const Vector3& p) -> Vector3 { return rotation * p + origin; };
}

Placement facing(const Vector3& origin, const Vector3& along, const Vector3& up) {
    Matrix3 rotation;
    rotation.col(2) = up.normalized();
    rotation.col(1) = up.cross(along).normalized();
    rotation.col(0) = rotation.col(1).cross(rotation.col(2));
    return [rotation, origin](const Vector3& p) -> Vector3 { return rotation * p + origin; };
}

void Assembly::add(const std::string& name, const Piece& piece) {
    const auto firstVertex = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto firstTriangle = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.vertices.insert(mesh_.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const TriangleIndices& triangle : piece.triangles) {
        mesh_.triangles.push_back(
            {triangle[0] + firstVertex, triangle[1] + firstVertex, triangle[2] + firstVertex});
    }
    mesh_.components.push_back({name, firstTriangle, static_cast<std::uint32_t>(piece.triangles.size())});
}

void Assembly::include(const std::string& prefix, const Assembly& other) {
    const auto firstVertex = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto firstTriangle = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.vertices.insert(mesh_.vertices.end(), other.mesh_.vertices.begin(), other.mesh_.vertices.end());
    for (const TriangleIndices& t : other.mesh_.triangles)
        mesh_.triangles.push_back({t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex});
    for (Component component : other.mesh_.components) {
        component.name = prefix + component.name;
        component.firstTriangle += firstTriangle;
        mesh_.components.push_back(component);
    }
}

Box Assembly::boxOf(std::size_t component) const {
    const Component& of = mesh_.components[component];
    Box box;
    for (std::uint32_t i = 0; i < of.triangleCount; ++i)
        for (const std::uint32_t corner : mesh_.triangles[of.firstTriangle + i])
            box.extend(mesh_.vertices[corner]);
    return box;
}

/// A component's vertices are contiguous and stand in the order of the components, as its triangles do.
Assembly Assembly::keeping(const std::vector<bool>& isKept) const {
    Assembly kept;
    kept.counts_ = counts_;
    for (std::size_t c = 0; c < mesh_.components.size(); ++c) {
        if (!isKept[c]) continue;
        const Component& of = mesh_.components[c];
        std::uint32_t first = UINT32_MAX, last = 0;
        Piece piece;
        for (std::uint32_t i = 0; i < of.triangleCount; ++i) {
            piece.triangles.push_back(mesh_.triangles[of.firstTriangle + i]);
            for (const std::uint32_t corner : piece.triangles.back()) {
                first = std::min(first, corner);
                last = std::max(last, corner);
            }
        }
        piece.vertices.assign(mesh_.vertices.begin() + first, mesh_.vertices.begin() + last + 1);
        for (TriangleIndices& t : piece.triangles)
            for (std::uint32_t& corner : t) corner -= first;
        kept.add(of.name, piece);
    }
    return kept;
}

std::string Assembly::nextName(const std::string& stem) {
    auto found = std::find_if(counts_.begin(), counts_.end(), [&](const auto& c) { return c.first == stem; });
    if (found == counts_.end()) found = counts_.insert(counts_.end(), {stem, 0});
    const int number = ++found->second;
    return stem + (number < 10 ? "_0" : "_") + std::to_string(number);
}

Mesh Assembly::mesh(const Vector3& shift) const {
    Mesh rounded = mesh_;
    for (Vector3& vertex : rounded.vertices) {
        // Adding zero turns -0 into 0. Some text formats would keep the two apart, others not.
        vertex = (vertex + shift).cast<float>().cast<double>() + Vector3::Zero();
    }
    return rounded;
}

void requireTriangles(std::size_t triangles, const std::string& option, std::size_t least,
                      const std::string& where) {
    if (triangles >= least && triangles <= kMostTriangles) return;
    throw std::invalid_argument(option + " is " + std::to_string(triangles) + ", expected " +
                                std::to_string(least) + " to " + std::to_string(kMostTriangles) + where);
}

int Detail::count(double atRichnessOne) const {
    return std::max(1, static_cast<int>(std::lround(atRichnessOne * richness)));
}

Detail finestDetail(std::size_t triangles, const std::string& option, const FinenessRange& range,
                    const std::function<std::size_t(const Detail&)>& countAt) {
    double low = range.coarsest, high = kFineness;
    const std::size_t least = countAt(detailFor(low, range.step));
    requireTriangles(triangles, option, least, kHere);
    for (int i = 0; i < 24; ++i) {
        const double middle = (low + high) / 2;
        (countAt(detailFor(middle, range.step)) <= triangles ? low : high) = middle;
    }
    return detailFor(low, range.step);
}

Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const BuildAssembly& build) {
    const Detail detail = finestDetail(triangles, option, range,
                                       [&](const Detail& tried) { return build(tried, 0).triangleCount(); });
    const std::size_t without = build(detail, 0).triangleCount(),
                      studTriangles = build(detail, 1).triangleCount() - without;
    return build(detail, static_cast<int>((triangles - without) / studTriangles)).mesh();
}

Detail coarsestDetail(const FinenessRange& range) {
    return detailFor(range.coarsest, range.step);
}

Assembly leavingOutSmall(const Assembly& whole, std::size_t triangles, const std::string& option,
                         const std::vector<std::string>& kept) {
    const std::vector<Component>& components = whole.components();
    std::vector<std::pair<double, std::size_t>> bySize;
    std::size_t least = 0, remaining = whole.triangleCount();
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (beginsWithAny(components[i].name, kept)) {
            least += components[i].triangleCount;
        } else {
            bySize.emplace_back(whole.boxOf(i).diagonal().norm(), i);
        }
    }
    requireTriangles(triangles, option, least, kHere);
    std::sort(bySize.begin(), bySize.end());
    std::vector<bool> isKept(components.size(), true);
    for (const auto& [size, i] : bySize) {
        if (remaining <= triangles) break;
        isKept[i] = false;
        remaining -= components[i].triangleCount;
    }
    return whole.keeping(isKept);
}

Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const std::vector<std::string>& kept, const BuildAssembly& build) {
    const Detail coarsest = coarsestDetail(range);
    const Assembly least = build(coarsest, 0);
    if (triangles >= least.triangleCount()) return buildTo(triangles, option, range, build);
    const std::size_t remaining = leavingOutSmall(least, triangles, option, kept).triangleCount(),
                      studTriangles = build(coarsest, 1).triangleCount() - least.triangleCount();
    const Assembly filled = build(coarsest, static_cast<int>((triangles - remaining) / studTriangles));
    return leavingOutSmall(filled, triangles, option, kept).mesh();
}

}  // namespace clearway::scenes
