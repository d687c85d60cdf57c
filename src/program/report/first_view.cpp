#include "program/report/first_view.h"

#include <algorithm>
#include <cmath>

namespace clearway::report {

namespace {

using Eigen::Vector3f;

/// Bonuses of a view from the side and of one from the usual direction, as shares of the points.
constexpr double kSideWorth = 0.2, kUsualWorth = 0.1;
constexpr float kOffSurface = 1e-4f;  ///< of the ray: its beginning, so that a point does not hide itself

std::vector<Vector3f> triedDirections() {
    std::vector<Vector3f> directions;
    for (const float elevation : {0.5f, 0.25f, 0.9f, 1.3f, -0.35f}) {  // radians
        for (int i = 0; i < 12; ++i) {
            const float azimuth = static_cast<float>(M_PI) * (static_cast<float>(i) / 6 - 0.325f);
            directions.emplace_back(std::cos(elevation) * std::cos(azimuth),
                                    std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        }
    }
    return directions;
}

}  // namespace

double visibleShare(const render::RayScene& obstacles, const ViewRequest& request,
                    const Vector3f& direction) {
    const Vector3f camera = request.centre + request.distance * direction;
    std::size_t seen = 0;
    for (const Vector3f& point : request.points)
        seen += !obstacles.isBlocked({point, camera - point, kOffSurface}, 1);
    return double(seen) / double(std::max<std::size_t>(1, request.points.size()));
}

ChosenView chooseView(const render::RayScene& obstacles, const ViewRequest& request) {
    const Vector3f along = request.along.stableNormalized();
    ChosenView best;
    Vector3f usual = Vector3f::Zero();
    double bestWorth = -1;
    for (Vector3f direction : triedDirections()) {
        if (request.isSquare) direction = (direction - direction.dot(along) * along).stableNormalized();
        if (usual.isZero()) usual = direction;
        const double visible = visibleShare(obstacles, request, direction);
        const double worth = visible + kSideWorth * direction.cross(along).norm() +
                             kUsualWorth * std::max(0.0f, direction.dot(usual));
        if (worth <= bestWorth) continue;
        bestWorth = worth;
        best = {direction, visible};
    }
    return best;
}

}  // namespace clearway::report
