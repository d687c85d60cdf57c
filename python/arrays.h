// NumPy arrays to poses and meshes' numbers, and back. Every array that is not what it should be is refused by name.
#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "clearway/errors.h"
#include "clearway/query.h"
#include "clearway/types.h"

namespace clearway::python {

namespace py = pybind11;

inline std::string shapeOf(const py::array& array) {
    return py::str(array.attr("shape"));
}

/// The object as an array of doubles, copied unless it is one; of numbers, with so many dimensions. `name` is for the message.
inline py::array_t<double, py::array::c_style> numbersOf(const py::handle& object, const std::string& name,
                                                         py::ssize_t dimensions) {
    const py::array given(py::reinterpret_borrow<py::object>(object));
    const std::string kind = py::str(given.dtype().attr("kind"));
    if (kind != "f" && kind != "i" && kind != "u") {
        throw ArgumentError(
            fmt::format("{} has dtype {}, expected numbers", name, std::string(py::str(given.dtype()))));
    }
    if (given.ndim() != dimensions) {
        throw ArgumentError(
            fmt::format("{} has shape {}, expected {} dimensions", name, shapeOf(given), dimensions));
    }
    // A broadcast array may stand for more numbers than fit into memory; NumPy then raises MemoryError.
    return py::array_t<double, py::array::c_style | py::array::forcecast>(given);
}

/// The upper three rows of 16 doubles in row-major order.
inline Pose upperRowsOf(const double* m) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) pose.rotation(row, column) = m[4 * row + column];
        pose.translation[row] = m[4 * row + 3];
    }
    return pose;
}

/// The pose of 16 doubles in row-major order, whose last row must be 0 0 0 1.
inline Pose poseOfRows(const double* m, const std::string& name) {
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) {
        throw ArgumentError("the last row of " + name + " is not 0 0 0 1");
    }
    const Pose pose = upperRowsOf(m);
    try {
        requirePose(pose);
    } catch (const std::invalid_argument& error) {
        throw ArgumentError(name + ": " + error.what());
    }
    return pose;
}

/// The object as a matrix (4, 4).
inline py::array_t<double, py::array::c_style> matrixOf(const py::handle& object, const std::string& name) {
    const auto matrix = numbersOf(object, name, 2);
    if (matrix.shape(0) != 4 || matrix.shape(1) != 4) {
        throw ArgumentError(name + " has shape " + shapeOf(matrix) + ", expected (4, 4)");
    }
    return matrix;
}

inline Pose poseOf(const py::handle& object, const std::string& name = "pose") {
    return poseOfRows(matrixOf(object, name).data(), name);
}

inline std::vector<Pose> posesOf(const py::handle& object) {
    const auto matrices = numbersOf(object, "poses", 3);
    if (matrices.shape(1) != 4 || matrices.shape(2) != 4) {
        throw ArgumentError("poses has shape " + shapeOf(matrices) + ", expected (N, 4, 4)");
    }
    std::vector<Pose> poses;
    for (py::ssize_t i = 0; i < matrices.shape(0); ++i) {
        poses.push_back(poseOfRows(matrices.data(i, 0, 0), fmt::format("poses[{}]", i)));
    }
    return poses;
}

inline Vector3 vectorOf(const py::handle& object) {
    const auto vector = numbersOf(object, "vector", 1);
    if (vector.shape(0) != 3) {
        throw ArgumentError("vector has shape " + shapeOf(vector) + ", expected (3,)");
    }
    return {vector.at(0), vector.at(1), vector.at(2)};
}

/// The witness of a distance. Beyond the cap triangles are -1 and points NaN, as in arrays.
inline Witness witnessOf(const DistanceResult& result) {
    const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    return result.witness.value_or(Witness{nowhere, nowhere, -1, -1, -1, -1});
}

/// Writes the 16 numbers of a pose, in row-major order.
inline void writeRows(const Pose& pose, double* m) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column)
            m[4 * row + column] = row < 3 ? pose.rotation(row, column) : 0;
        m[4 * row + 3] = row < 3 ? pose.translation[row] : 1;
    }
}

inline py::array_t<double> arrayOf(const Pose& pose) {
    py::array_t<double> matrix({4, 4});
    writeRows(pose, matrix.mutable_data());
    return matrix;
}

/// (N, 4, 4).
inline py::array_t<double> arrayOf(const std::vector<Pose>& poses) {
    py::array_t<double> matrices({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
    for (std::size_t i = 0; i < poses.size(); ++i) writeRows(poses[i], matrices.mutable_data(i, 0, 0));
    return matrices;
}

inline py::array_t<double> arrayOf(const Vector3& point) {
    return py::array_t<double>(3, point.data());
}

template <class Value>
py::array_t<Value> arrayOf(const std::vector<Value>& values) {
    return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// One member of all rows.
template <class Value, class Row, class Member>
py::array_t<Value> columnOf(const std::vector<Row>& rows, Member Row::*member) {
    std::vector<Value> column;
    for (const Row& row : rows) column.push_back(static_cast<Value>(row.*member));
    return arrayOf(column);
}

inline py::object flagsOf(const std::vector<std::uint8_t>& flags) {
    return arrayOf(flags).attr("astype")("bool");
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

namespace pybind11::detail {

/// Values that functions of the module take and return as NumPy arrays.
template <class Value>
struct ArrayCaster {
    PYBIND11_TYPE_CASTER(Value, const_name("array"));
    bool load(handle given, bool) {
        if constexpr (std::is_same_v<Value, clearway::Pose>) {
            value = clearway::python::poseOf(given);
        } else if constexpr (std::is_same_v<Value, clearway::Vector3>) {
            value = clearway::python::vectorOf(given);
        } else {
            value = clearway::python::posesOf(given);
        }
        return true;
    }
    static handle cast(const Value& value, return_value_policy, handle) {
        return clearway::python::arrayOf(value).release();
    }
};
template <>
struct type_caster<clearway::Pose> : ArrayCaster<clearway::Pose> {};
template <>
struct type_caster<std::vector<clearway::Pose>> : ArrayCaster<std::vector<clearway::Pose>> {};
template <>
struct type_caster<clearway::Vector3> : ArrayCaster<clearway::Vector3> {};
template <>
struct type_caster<clearway::Box> : ArrayCaster<clearway::Box> {};

}  // namespace pybind11::detail
