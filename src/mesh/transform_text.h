// An affine map in words, for what `clearway info` prints.
#pragma once

#include <Eigen/Core>
#include <string>

namespace clearway {

/// "x' = 0.0254 x, y' = 0.0254 z, z' = -0.0254 y": the rows of a map of three coordinates and 1, zero terms
/// left out.
std::string transformText(const Eigen::Matrix<double, 3, 4>& transform);

}  // namespace clearway
