#include "planning/improve/contact_planes.h"

#include <algorithm>

namespace clearway::planning {

std::optional<ContactPlane> contactPlaneOf(const SceneDistance& nearest, const Scene& scene,
                                           const Pose& X_environmentPart) {
    if (!nearest.witness || !nearest.obstacle) return std::nullopt;
    const Vector3 apart = nearest.witness->pointOnPart - nearest.witness->pointOnEnvironment;
    const double distance = apart.norm();
    if (!(distance > 0)) return std::nullopt;
    return ContactPlane{inverse(X_environmentPart) * nearest.witness->pointOnPart,
                        nearest.witness->pointOnEnvironment, apart / distance,
                        scene.obstacles[*nearest.obstacle].margin};
}

ContactRow rowAt(const ContactPlane& plane, const PartMoves& moves, const Pose& X_environmentPart) {
    const Vector3 point = X_environmentPart * plane.pointOnPart;
    return {moves.along(plane.normal, point, X_environmentPart),
            plane.normal.dot(point - plane.pointOnEnvironment) - plane.margin};
}

Twist nearestKeeping(double gap, const std::vector<ContactRow>& rows, const Twist& desired) {
    constexpr int kRounds = 60;
    constexpr double kLeastSquare =
        1e-6;  // planes that no twist moves along: in the plane, those below and above
    Twist twist = desired;
    std::vector<double> multipliers(rows.size(), 0);
    for (int round = 0; round < kRounds; ++round) {
        double changed = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double lacking = gap - rows[i].gap - rows[i].row.dot(twist);
            const double square = rows[i].row.squaredNorm();
            if (square < kLeastSquare) continue;
            const double next = std::max(0.0, multipliers[i] + lacking / square);
            const double step = next - multipliers[i];
            multipliers[i] = next;
            twist += step * rows[i].row;
            changed = std::max(changed, std::abs(step) * std::sqrt(square));
        }
        if (changed <= 1e-6 * gap) break;
    }
    return twist;
}

}  // namespace clearway::planning
