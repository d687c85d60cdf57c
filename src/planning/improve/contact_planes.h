// The contacts of a part nearby, as planes that its moves keep off.
#pragma once

#include <optional>
#include <vector>

#include "clearway/scene_clearance.h"
#include "planning/improve/part_moves.h"

namespace clearway::planning {

/// A point of the part in front of a plane of the environment.
struct ContactPlane {
    Vector3 pointOnPart;  ///< part coordinates
    Vector3 pointOnEnvironment;
    Vector3 normal;  ///< unit, from the environment to the part
    double margin = 0;
};

/// A contact plane at a pose: `row` times a twist is how much the gap grows, to first order.
struct ContactRow {
    Twist row;
    double gap;  ///< distance of the point from the plane, less the margin
};

/// The plane of the closest pair; none when the pair is unknown or touches.
std::optional<ContactPlane> contactPlaneOf(const SceneDistance& nearest, const Scene& scene,
                                           const Pose& X_environmentPart);

ContactRow rowAt(const ContactPlane& plane, const PartMoves& moves, const Pose& X_environmentPart);

/// The contacts at a pose whose gaps are at most the band, the smallest gap first, of the obstacles that count there. Of several whose
/// rows hardly differ the first is kept, and at most 150 in all. Pairs that touch are left out.
std::vector<ContactRow> rowsNear(const SceneClearance& clearance, const PartMoves& moves,
                                 const Pose& X_environmentPart, double band);

/// The twist nearest to the desired one for which each gap is at least `gap` afterwards, to first order: by Gauss-Seidel
/// steps on the multipliers of the rows. Rows that contradict each other are kept as far as the steps bring them.
Twist nearestKeeping(double gap, const std::vector<ContactRow>& rows, const Twist& desired);

}  // namespace clearway::planning
