// How near the part comes to each obstacle of a path's surroundings.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "clearway/scene.h"
#include "program/report/frames.h"

namespace clearway::report {

/// The least clearance (distance - margin) to one component of the environment over all frames at which the
/// component counts.
struct ObstacleClearance {
    /// A lower bound of the least clearance; infinite when the component counts at no frame.
    double lower = std::numeric_limits<double>::infinity();
    double margin = 0;
    std::size_t frame = 0;    ///< of the least clearance, where that is measured
    bool isMeasured = false;  ///< false: `lower` is that of the boxes around part and component
    /// The reason why the frame's pose is invalid, if the component alone is the reason.
    WhyInvalid::Kind trouble = WhyInvalid::Kind::kValid;
    bool isLeftOutAtStart = false, isLeftOutAtGoal = false;  ///< it may be touched there
    bool isInScene = false;  ///< false: the component is ignored, or the scene has no obstacle of its name
};

/// One entry for each component of the environment's mesh; the scene's obstacles bear the components' names. Measures
/// the `most` components whose boxes come nearest, at the frames within range of the scene.
std::vector<ObstacleClearance> obstacleClearances(const Scene& scene, const Mesh& environment,
                                                  const std::vector<ReportFrame>& frames, std::size_t most);

}  // namespace clearway::report
