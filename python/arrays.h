// NumPy arrays to poses and meshes' numbers, and back. Every array that is not what it should be is refused by name.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "clearway/errors.h"
#include "clearway/query.h"
#include "clearway/types.h"
#include "python/released_gil.h"

namespace clearway::python {

namespace py = pybind11;

inline std::string shapeOf(const py::array& array) {
    return py::str(array.attr("shape"));
}

/// The object as an array of doubles, copied unless it is one; of numbers, with so many dimensions. `name` is for the message.
inline py::array_t<double, py::array::c_style> numbersOf(const py::handle& object, const std::string& name,
                                                         py::ssize_t dimensions) {
    const LockedStretch stretch;  // NumPy may run Python's code
    const py::array given = py::module_::import("numpy").attr("asarray")(object);
    const std::string kind = py::str(given.dtype().attr("kind"));
    if (kind != "f" && kind != "i" && kind != "u") {
        throw ArgumentError(name + " has dtype " + std::string(py::str(given.dtype())) +
                            ", expected numbers");
    }
    if (given.ndim() != dimensions) {
        throw ArgumentError(name + " has shape " + shapeOf(given) + ", expected " +
                            std::to_string(dimensions) + " dimensions");
    }
    // A broadcast array may stand for more numbers than fit into memory; NumPy then raises MemoryError.
    return py::array_t<double, py::array::c_style | py::array::forcecast>(given);
}

/// The pose of 16 doubles in row-major order, whose last row must be 0 0 0 1.
inline Pose poseOfRows(const double* m, const std::string& name) {
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) {
        throw ArgumentError("the last row of " + name + " is not 0 0 0 1");
    }
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) pose.rotation(row, column) = m[4 * row + column];
        pose.translation[row] = m[4 * row + 3];
    }
    try {
        requirePose(pose);
    } catch (const std::invalid_argument& error) {
        throw ArgumentError(name + ": " + error.what());
    }
    return pose;
}

inline Pose poseOf(const py::handle& object, const std::string& name = "pose") {
    const auto matrix = numbersOf(object, name, 2);
    if (matrix.shape(0) != 4 || matrix.shape(1) != 4) {
        throw ArgumentError(name + " has shape " + shapeOf(matrix) + ", expected (4, 4)");
    }
    return poseOfRows(matrix.data(), name);
}

inline std::vector<Pose> posesOf(const py::handle& object) {
    const auto matrices = numbersOf(object, "poses", 3);
    if (matrices.shape(1) != 4 || matrices.shape(2) != 4) {
        throw ArgumentError("poses has shape " + shapeOf(matrices) + ", expected (N, 4, 4)");
    }
    std::vector<Pose> poses;
    for (py::ssize_t i = 0; i < matrices.shape(0); ++i) {
        poses.push_back(poseOfRows(matrices.data(i, 0, 0), "poses[" + std::to_string(i) + "]"));
    }
    return poses;
}

/// The witness of a distance. Beyond the cap triangles are -1 and points NaN, as in arrays.
inline Witness witnessOf(const DistanceResult& result) {
    const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    return result.witness.value_or(Witness{nowhere, nowhere, -1, -1, -1, -1});
}

/// (N, 4, 4).
inline py::array_t<double> arrayOf(const std::vector<Pose>& poses) {
    py::array_t<double> matrices({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
    auto entries = matrices.mutable_unchecked<3>();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 3; ++column)
                entries(i, row, column) = row < 3 ? poses[i].rotation(row, column) : 0;
            entries(i, row, 3) = row < 3 ? poses[i].translation[row] : 1;
        }
    }
    return matrices;
}

inline py::array_t<double> arrayOf(const Vector3& point) {
    return py::array_t<double>(3, point.data());
}

inline py::array_t<double> arrayOf(const Pose& pose) {
    py::array_t<double> matrix({4, 4});
    auto entries = matrix.mutable_unchecked<2>();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column)
            entries(row, column) = row < 3 ? pose.rotation(row, column) : 0;
        entries(row, 3) = row < 3 ? pose.translation[row] : 1;
    }
    return matrix;
}

/// (2, 3): the least and the greatest corner.
inline py::array_t<double> arrayOf(const Box& box) {
    py::array_t<double> corners({2, 3});
    for (int axis = 0; axis < 3; ++axis) {
        corners.mutable_at(0, axis) = box.min()[axis];
        corners.mutable_at(1, axis) = box.max()[axis];
    }
    return corners;
}

}  // namespace clearway::python
