#include "scenes/detail.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace clearway {

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

}  // namespace

int Detail::count(double atRichnessOne) const {
    return std::max(1, static_cast<int>(std::lround(atRichnessOne * richness)));
}

Detail finestDetail(std::size_t triangles, const std::string& option, const FinenessRange& range,
                    const std::function<std::size_t(const Detail&)>& countAt) {
    double low = range.coarsest, high = kFineness;
    const std::size_t least = countAt(detailFor(low, range.step));
    if (triangles < least || triangles > kMostTriangles) {
        throw std::invalid_argument(option + " is " + std::to_string(triangles) + ", expected " +
                                    std::to_string(least) + " to " + std::to_string(kMostTriangles) +
                                    " at this clearance and seed");
    }
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

}  // namespace clearway
