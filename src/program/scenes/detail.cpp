#include "program/scenes/detail.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace clearway::scenes {

namespace {

constexpr std::size_t kMostTriangles = 4000000;
constexpr double kFineness = 40;  // the greatest, see detailFor

Detail detailFor(double fineness, double step) {
    Detail detail;
    detail.segmentsPerQuarter = std::max(fineness < 1 ? 1 : 2, static_cast<int>(std::pow(fineness, 0.75)));
    detail.segmentsPerTurn = 4 * static_cast<int>(std::ceil(1.5 * std::pow(fineness, 0.75) + 0.5));
    detail.step = step / fineness;
    detail.richness = std::pow(fineness, 0.7);
    return detail;
}

void requireTriangles(std::size_t triangles, const std::string& option, std::size_t least) {
    if (triangles >= least && triangles <= kMostTriangles) return;
    throw std::invalid_argument(option + " is " + std::to_string(triangles) + ", expected " +
                                std::to_string(least) + " to " + std::to_string(kMostTriangles) +
                                " at this clearance and seed");
}

bool beginsWithAny(const std::string& name, const std::vector<std::string>& stems) {
    return std::any_of(stems.begin(), stems.end(),
                       [&](const std::string& stem) { return name.rfind(stem, 0) == 0; });
}

}  // namespace

int Detail::count(double atRichnessOne) const {
    return std::max(1, static_cast<int>(std::lround(atRichnessOne * richness)));
}

Detail finestDetail(std::size_t triangles, const std::string& option, const FinenessRange& range,
                    const std::function<std::size_t(const Detail&)>& countAt) {
    double low = range.coarsest, high = kFineness;
    const std::size_t least = countAt(detailFor(low, range.step));
    requireTriangles(triangles, option, least);
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
    requireTriangles(triangles, option, least);
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
