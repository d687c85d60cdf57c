// Models as files of the cache. Raise the version with every change of the payload and of the tree that a build makes from a given mesh and
// options.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "clearway/errors.h"
#include "clearway/model.h"
#include "core/archive.h"
#include "core/hash.h"
#include "core/replace_file.h"
#include "core/saved_file.h"
#include "mesh/components.h"
#include "model/model_data.h"
#include "model/query_range.h"

namespace clearway {
namespace {

constexpr SavedKind kModel = {"model", 8};

// Archive: an ArchiveWriter, an ArchiveReader, or for options and ranges a Hash.

template <class Archive, class Options>
void visitOptions(Archive& archive, Options& options) {
    archive.visit(options.generalSplit, options.leafSplit, options.fit, options.leafSize, options.nodeWidth);
}

/// Range: an optional QueryRange.
template <class Archive, class Range>
void visitRange(Archive& archive, Range& range) {
    std::uint64_t count = range.has_value();
    archive.visit(count);
    if (count == 0) return;
    if constexpr (!std::is_const_v<Range>) range.emplace();
    archive.visit(range->positions.min(), range->positions.max(), range->partRadius, range->cap);
}

template <class Archive, class Tree>
void visitTree(Archive& archive, Tree& tree) {
    archive.visit(tree.nodeWidth, tree.origin, tree.unitExponent, tree.radius);
    std::apply([&](auto&... nodes) { (archive.visitArray(nodes), ...); }, tree.nodesByWidth);
    archive.visitArray(tree.leafBlocks);
    archive.visitArray(tree.vertices);
    archive.visit(tree.box.min(), tree.box.max(), tree.radiusAboutMeshOrigin);
}

template <class Archive, class Data>
void visitModel(Archive& archive, Data& data) {
    visitOptions(archive, data.report.options);
    visitRange(archive, data.range);
    visitTree(archive, data.tree);
    auto& clean = data.report.clean;
    archive.visit(clean.weldedVertices, clean.unusedVertices, clean.degenerateTriangles,
                  clean.duplicateTriangles, data.report.unreachableTriangles, data.report.seconds);
    archive.visitEach(data.components, 16, [&](auto& component) {
        archive.visit(component.name, component.firstTriangle, component.triangleCount);
    });
    auto& origin = data.origin;
    archive.visit(origin.file, origin.scale, origin.shift, origin.format, origin.isChecked, origin.unitMetres,
                  origin.upAxis, origin.ignoredFaces, origin.crossingFaces, origin.bentFaces, origin.bentBy);
    for (auto* const lines : {&origin.warnings, &origin.notes})
        archive.visitEach(*lines, 8, [&](auto& line) { archive.visit(line); });
}

std::size_t trianglesOf(const TreeStatistics& tree) {
    std::size_t triangles = 0;
    for (std::size_t size = 0; size < tree.leavesBySize.size(); ++size)
        triangles += size * tree.leavesBySize[size];
    return triangles;
}

/// The number of triangles of consecutive components; -1 if the components are not consecutive.
std::int64_t trianglesOf(const std::vector<Component>& components) {
    std::int64_t next = 0;
    for (const Component& component : components) {
        if (component.firstTriangle != next) return -1;
        next += component.triangleCount;
    }
    return components.empty() ? -1 : next;
}

bool isSame(const Component& a, const Component& b) {
    return a.name == b.name && a.firstTriangle == b.firstTriangle && a.triangleCount == b.triangleCount;
}

}  // namespace

std::uint64_t modelKey(const Mesh& mesh, const BuildOptions& options,
                       const std::optional<QueryRange>& range) {
    Hash out;
    out.add(kModel.version);
    visitOptions(out, options);
    visitRange(out, range);
    out.addArray(mesh.vertices);
    out.addArray(mesh.triangles);
    for (const Component& component : mesh.components) {
        out.add(component.name);
        out.add(component.triangleCount);
    }
    out.add(mesh.origin.file);
    return out.value();
}

void Model::save(const std::string& file) const {
    ArchiveWriter payload;
    visitModel(payload, *data_);
    writeSavedFile(file, kModel, data_->key, payload);
}

Model Model::load(const std::string& file) {
    const SavedFile saved = readSavedFile(file, kModel);
    auto data = std::make_shared<Data>();
    data->key = saved.key;
    try {
        ArchiveReader in(saved.payload());
        visitModel(in, *data);
        data->tree.unit = std::ldexp(1.0, data->tree.unitExponent);
        const std::int64_t triangles = trianglesOf(data->components);
        if (!in.isAtEnd() || triangles < 0) throw FileError("has parts that do not fit together");
        const std::string fault = faultOf(data->tree, std::size_t(triangles));
        if (!fault.empty()) throw FileError(fault);
        data->report.tree = statistics(data->tree);
        data->report.triangles = trianglesOf(data->report.tree);
        const std::size_t leftOut = data->report.clean.duplicateTriangles + data->report.unreachableTriangles;
        if (data->report.triangles + leftOut != std::size_t(triangles)) {
            throw FileError(fmt::format("its leaves hold {} triangles and leave out {} of {}",
                                        data->report.triangles, leftOut, triangles));
        }
    } catch (const std::runtime_error& error) {
        refuseSavedFile(file, kModel, error.what());
    }
    data->id = newId();
    return Model(std::move(data));
}

CachedModel buildCached(const Mesh& mesh, const BuildOptions& options, const std::string& folder,
                        const std::optional<QueryRange>& range) {
    requireBuildOptions(options);
    if (range) requireRange(*range);
    const std::uint64_t key = modelKey(mesh, options, range);
    const std::filesystem::path file = std::filesystem::path(folder) / fmt::format("{:x}.clearway", key);
    std::string warning;
    std::error_code unreadable;  // such a file is not loaded; saving then says what is wrong
    if (std::filesystem::exists(file, unreadable)) {
        try {
            Model model = Model::load(file.string());
            const std::vector<Component> expected = componentsOf(mesh);
            if (model.key() == key && std::equal(model.components().begin(), model.components().end(),
                                                 expected.begin(), expected.end(), isSame)) {
                return {model, true, ""};
            }
            warning = file.string() +
                      ": was built from another mesh, other options or another range; it is built again";
        } catch (const std::runtime_error& error) {
            warning = std::string(error.what()) + "; it is built again";
        }
    }
    const Model model = Model::build(mesh, options, range);
    try {
        makeFolder(folder);
        model.save(file.string());
    } catch (const std::runtime_error& error) {
        const std::string before = warning.empty() ? "" : warning + "; ";
        return {model, false, before + error.what() + "; built models are not kept", false};
    }
    return {model, false, warning};
}

}  // namespace clearway
