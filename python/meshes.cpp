// Meshes and models for Python.
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/errors.h"
#include "clearway/mesh.h"
#include "clearway/model.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/released_gil.h"

namespace clearway::python {
namespace {

using FileName = std::filesystem::path;

Mesh makeMesh(const py::object& vertices, const py::object& triangles, const std::string& name) {
    const auto points = numbersOf(vertices, "vertices", 2);
    const py::array indices(py::reinterpret_borrow<py::object>(triangles));
    const std::string kind = py::str(indices.dtype().attr("kind"));
    if (points.shape(1) != 3) {
        throw ArgumentError("vertices has shape " + shapeOf(points) + ", expected (N, 3)");
    }
    if (indices.ndim() != 2 || indices.shape(1) != 3 || (kind != "i" && kind != "u")) {
        throw ArgumentError("triangles has shape " + shapeOf(indices) + " and dtype " +
                            std::string(py::str(indices.dtype())) + ", expected (N, 3) whole numbers");
    }
    Mesh mesh;
    for (py::ssize_t i = 0; i < points.shape(0); ++i) {
        mesh.vertices.emplace_back(points.at(i, 0), points.at(i, 1), points.at(i, 2));
    }
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> rows(indices);
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        TriangleIndices triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const std::int64_t index = rows.at(i, corner);
            if (index < 0 || index >= points.shape(0)) {
                throw ArgumentError(fmt::format("triangles[{}] names vertex {}, expected 0 to {}", i, index,
                                                points.shape(0) - 1));
            }
            triangle[corner] = static_cast<std::uint32_t>(index);
        }
        mesh.triangles.push_back(triangle);
    }
    if (!name.empty()) mesh.components = {{name, 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

/// (N, 3), a copy.
template <class Number, class Rows>
py::array_t<Number> rowsOfThree(const Rows& rows) {
    py::array_t<Number> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (int k = 0; k < 3; ++k) array.mutable_at(i, k) = rows[i][k];
    }
    return array;
}

Model buildModel(const Mesh& mesh, const std::string& preset, const std::optional<std::string>& generalSplit,
                 const std::optional<std::string>& leafSplit, const std::optional<int>& leafSize,
                 const std::optional<int>& nodeWidth, const std::optional<std::string>& fit, int threads) {
    requirePreset(preset);
    BuildOptions options;
    options.generalSplit = generalSplit.value_or(options.generalSplit);
    options.leafSplit = leafSplit.value_or(options.leafSplit);
    options.leafSize = leafSize.value_or(options.leafSize);
    options.nodeWidth = nodeWidth.value_or(options.nodeWidth);
    options.fit = fit.value_or(options.fit);
    options.threads = threads;
    const ReleasedGil released;
    return Model::build(mesh, options);
}

}  // namespace

void requirePreset(const std::string& name) {
    if (name == "best") return;
    if (name != "fast") throw ArgumentError(fmt::format("preset is '{}', expected best", name));
    if (PyErr_WarnEx(PyExc_DeprecationWarning,
                     "preset='fast' means 'best', and will be refused from version 0.4 on", 1) != 0)
        throw py::error_already_set();
}

void bindMeshesAndModels(py::module_& module) {
    py::class_<Mesh>(
        module, "Mesh",
        R"(Triangles over shared vertices. The doubles are exact by definition: every query answers for them. Immutable.)")
        .def(
            py::init(&makeMesh), py::arg("vertices"), py::arg("triangles"), py::kw_only(),
            py::arg("name") = "",
            R"(vertices: (V, 3) numbers, kept as doubles. triangles: (T, 3) whole numbers, rows of vertices.)")
        .def_static(
            "load",
            [](const FileName& file, double scale) {
                LoadOptions options;
                options.scale = scale;
                return loadMesh(file.string(), options);
            },
            py::arg("file"), py::kw_only(), py::arg("scale") = 1.0, WithoutGil(),
            R"(Reads a file of any format that assimp reads: stl, obj, ply, glb and more. scale: a factor for its coordinates.)")
        .def(
            "save", [](const Mesh& mesh, const FileName& file) { saveMesh(mesh, file.string()); },
            py::arg("file"), WithoutGil(),
            R"(Writes .glb, .obj, .ply, .stl or .dae; coordinates are rounded to float.)")
        .def_property_readonly(
            "vertices", [](const Mesh& mesh) { return rowsOfThree<double>(mesh.vertices); },
            R"((V, 3) doubles, a copy.)")
        .def_property_readonly(
            "triangles", [](const Mesh& mesh) { return rowsOfThree<std::uint32_t>(mesh.triangles); },
            R"((T, 3) uint32, a copy.)")
        .def_property_readonly(
            "components",
            [](const Mesh& mesh) {
                std::vector<std::string> names;
                for (const Component& component : mesh.components) names.push_back(component.name);
                return names;
            },
            R"(The names of the components, which are runs of triangles.)")
        .def("__repr__", [](const Mesh& mesh) {
            return fmt::format("Mesh({} vertices, {} triangles)", mesh.vertices.size(),
                               mesh.triangles.size());
        });
    py::class_<Model>(
        module, "Model",
        R"(A mesh prepared for queries, with its own copy of it. Immutable; any number of threads may query one model.)")
        .def(
            py::init(&buildModel), py::arg("mesh"), py::kw_only(), py::arg("preset") = "best",
            py::arg("general_split") = py::none(), py::arg("leaf_split") = py::none(),
            py::arg("leaf_size") = py::none(), py::arg("node_width") = py::none(),
            py::arg("fit") = py::none(), py::arg("threads") = 0,
            R"(Builds the model of a mesh. preset: "best"; "fast" means the same and is deprecated. The names of strategies are those of C++'s BuildOptions. threads: 0 for all cores.)")
        .def("__copy__", [](const Model& model) { return model; })
        .def("__deepcopy__", [](const Model& model, const py::dict& /*memo*/) { return model; })
        .def_static(
            "load", [](const FileName& file) { return Model::load(file.string()); }, py::arg("file"),
            WithoutGil(), R"(Reads a file written by save. Raises FileError for any other file.)")
        .def(
            "save", [](const Model& model, const FileName& file) { model.save(file.string()); },
            py::arg("file"), WithoutGil(),
            R"(Writes the model, for load; queries of the one that is read answer to the same bit.)")
        .def_property_readonly("box", &Model::box,
                               R"((2, 3): the least and the greatest corner, mesh coordinates.)")
        .def_property_readonly("radius_about_origin", &Model::radiusAboutOrigin,
                               R"(No rotation about the origin of mesh coordinates reaches further.)")
        .def_property_readonly(
            "triangle_count", [](const Model& model) { return model.report().triangles; },
            R"(The number of triangles that queries see: those of the mesh without duplicates.)")
        .def("__repr__", [](const Model& model) {
            return "Model(" + std::to_string(model.report().triangles) + " triangles)";
        });
}

}  // namespace clearway::python
