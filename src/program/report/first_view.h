// Chooses from where to look at the part's way, so that the surroundings hide little of it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "program/render/rays.h"

namespace clearway::report {

struct ViewRequest {
    std::vector<Eigen::Vector3f> points;  ///< to be seen; each counts alike
    Eigen::Vector3f centre;               ///< the camera looks here
    float distance = 0;                   ///< of the camera from the centre, > 0
    Eigen::Vector3f along;  ///< a line that is seen best from its side, of any length; 0 for none
    bool isSquare = false;  ///< chooseView looks at it exactly from its side
};

struct ChosenView {
    Eigen::Vector3f direction;  ///< unit vector from the centre to the camera; z is up
    double visible = 0;         ///< share of the points that nothing hides
};

/// The share of the points that a camera in this direction sees.
double visibleShare(const render::RayScene& obstacles, const ViewRequest& request,
                    const Eigen::Vector3f& direction);

/// Tries directions all around, and prefers the usual one, from the front, above and the right, where others show
/// hardly more.
ChosenView chooseView(const render::RayScene& obstacles, const ViewRequest& request);

}  // namespace clearway::report
