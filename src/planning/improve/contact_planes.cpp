#include "planning/improve/contact_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace clearway::planning {
namespace {

/// Keeps the first of the rows whose numbers lie in one cell of a grid.
void thin(std::vector<ContactRow>& rows, double cell) {
    std::set<std::array<int, 6>> taken;
    const auto isLikeOther = [&](const ContactRow& row) {
        std::array<int, 6> place;
        for (int k = 0; k < 6; ++k)
            place[static_cast<std::size_t>(k)] = static_cast<int>(std::floor(row.row[k] / cell + 0.5));
        return !taken.insert(place).second;
    };
    rows.erase(std::remove_if(rows.begin(), rows.end(), isLikeOther), rows.end());
}

}  // namespace

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

std::vector<ContactRow> rowsNear(const SceneClearance& clearance, const PartMoves& moves,
                                 const Pose& X_environmentPart, double band) {
    constexpr double kLikeRow = 0.1;
    constexpr std::size_t kMostRows = 150;
    const ContactsAt ignoring = clearance.contactsAt(X_environmentPart);
    std::vector<ContactRow> rows;
    for (const SceneDistance& pair : clearance.nearPairs(X_environmentPart, band, NearPairs::kLocalMinima)) {
        const Obstacle& obstacle = clearance.scene().obstacles[*pair.obstacle];
        if ((ignoring.isInStart && obstacle.isIgnoredAtStart) ||
            (ignoring.isInGoal && obstacle.isIgnoredAtGoal))
            continue;
        const auto plane = contactPlaneOf(pair, clearance.scene(), X_environmentPart);
        if (!plane) continue;
        rows.push_back({moves.along(plane->normal, pair.witness->pointOnPart, X_environmentPart),
                        pair.distance - obstacle.margin});
    }
    double cell = kLikeRow;
    do {
        thin(rows, cell);
        cell *= 1.5;
    } while (rows.size() > kMostRows);
    return rows;
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
