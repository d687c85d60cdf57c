// Paths and states of parts from and to NumPy arrays: poses (N, 4, 4), or states (N, 7), x y z qx qy qz qw.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "clearway/errors.h"
#include "clearway/problem.h"
#include "python/arrays.h"

namespace clearway::python {

/// Quaternions this close to unit length are kept as they are, so that what was read is written again.
constexpr double kUnitLength = 1e-14;

/// SE(2) holds positions with z = 0 and turns about z. Turns are off by the rounding of their matrix.
inline void requireIn(Space space, const PartState& state, const std::string& name) {
    constexpr double kFlat = 1e-12;  // sine of half the angle off the plane
    if (space == Space::kSe3) return;
    if (state.position.z() != 0 || !(std::hypot(state.rotation.x(), state.rotation.y()) <= kFlat)) {
        throw ArgumentError(name + " is not in the plane, expected z = 0 and a turn about z in SE2");
    }
}

inline PartState stateOf(const Pose& pose, Space space, const std::string& name) {
    const Eigen::Quaterniond rotation = toQuaternion(pose);
    PartState state{pose.translation, {rotation.w(), rotation.x(), rotation.y(), rotation.z()}};
    requireIn(space, state, name);
    return state;
}

/// numbers: x y z qx qy qz qw. The quaternion is normalised.
inline PartState stateOf(const double* numbers, Space space, const std::string& name) {
    PartState state{{numbers[0], numbers[1], numbers[2]}, {numbers[6], numbers[3], numbers[4], numbers[5]}};
    if (!state.position.allFinite() || !state.rotation.coeffs().allFinite()) {
        throw ArgumentError(name + " has a number that is not finite");
    }
    const double length = state.rotation.coeffs().stableNorm();
    if (!(length > 0))
        throw ArgumentError(name + ": the quaternion is 0 0 0 0, expected one of length above 0");
    if (std::abs(length - 1) > kUnitLength) {
        state.rotation.coeffs() /= length;
        state.rotation.normalize();
    }
    requireIn(space, state, name);
    return state;
}

/// The states of a path given as poses or as states.
inline std::vector<PartState> statesOf(const py::handle& path, Space space = Space::kSe3) {
    const py::array given(py::reinterpret_borrow<py::object>(path));
    std::vector<PartState> states;
    if (given.ndim() != 2) {
        const std::vector<Pose> poses = posesOf(given);
        for (std::size_t i = 0; i < poses.size(); ++i)
            states.push_back(stateOf(poses[i], space, fmt::format("poses[{}]", i)));
        return states;
    }
    const auto rows = numbersOf(given, "states", 2);
    if (rows.shape(1) != 7) {
        throw ArgumentError("states has shape " + shapeOf(rows) + ", expected (N, 7), or poses (N, 4, 4)");
    }
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
        states.push_back(stateOf(rows.data(i, 0), space, fmt::format("states[{}]", i)));
    return states;
}

/// (N, 4, 4).
inline py::array_t<double> posesOf(const std::vector<PartState>& states) {
    std::vector<Pose> poses;
    for (const PartState& state : states) poses.push_back(clearway::poseOf(state));
    return arrayOf(poses);
}

/// (N, 7).
inline py::array_t<double> arrayOf(const std::vector<PartState>& states) {
    py::array_t<double> rows({static_cast<py::ssize_t>(states.size()), py::ssize_t{7}});
    auto entries = rows.mutable_unchecked<2>();
    for (std::size_t i = 0; i < states.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) entries(i, axis) = states[i].position[axis];
        for (int k = 0; k < 4; ++k) entries(i, 3 + k) = states[i].rotation.coeffs()[k];
    }
    return rows;
}

}  // namespace clearway::python
