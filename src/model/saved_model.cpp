// Models as files of the cache. Raise the version with every change of the payload and of the tree that a build makes from a given mesh and
// options.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

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

/// Out: an ArchiveWriter or a Hash.
template <class Out>
void addVector(Out& out, const Vector3& v) {
    for (int k = 0; k < 3; ++k) out.add(v[k]);
}

Vector3 readVector(ArchiveReader& in) {
    Vector3 v;
    for (int k = 0; k < 3; ++k) v[k] = in.read<double>();
    return v;
}

template <class Out>
void addOptions(Out& out, const BuildOptions& options) {
    out.add(options.generalSplit);
    out.add(options.leafSplit);
    out.add(options.fit);
    out.add(std::int32_t(options.leafSize));
    out.add(std::int32_t(options.nodeWidth));
}

BuildOptions readOptions(ArchiveReader& in) {
    BuildOptions options;
    options.generalSplit = in.readText();
    options.leafSplit = in.readText();
    options.fit = in.readText();
    options.leafSize = in.read<std::int32_t>();
    options.nodeWidth = in.read<std::int32_t>();
    return options;
}

template <class Out>
void addRange(Out& out, const std::optional<QueryRange>& range) {
    out.add(std::uint64_t(range.has_value()));
    if (!range) return;
    addVector(out, range->positions.min());
    addVector(out, range->positions.max());
    out.add(range->partRadius);
    out.add(range->cap);
}

std::optional<QueryRange> readRange(ArchiveReader& in) {
    if (in.read<std::uint64_t>() == 0) return std::nullopt;
    QueryRange range;
    const Vector3 low = readVector(in), high = readVector(in);
    range.positions = Box(low, high);
    range.partRadius = in.read<double>();
    range.cap = in.read<double>();
    return range;
}

void addTree(ArchiveWriter& out, const FlatTree& tree) {
    out.add(std::int32_t(tree.nodeWidth));
    addVector(out, tree.origin);
    out.add(std::int32_t(tree.unitExponent));
    out.add(tree.radius);
    std::apply([&](const auto&... nodes) { (out.addArray(nodes), ...); }, tree.nodesByWidth);
    out.addArray(tree.leafBlocks);
    out.addArray(tree.vertices);
    addVector(out, tree.box.min());
    addVector(out, tree.box.max());
    out.add(tree.radiusAboutMeshOrigin);
}

FlatTree readTree(ArchiveReader& in) {
    FlatTree tree;
    tree.nodeWidth = in.read<std::int32_t>();
    tree.origin = readVector(in);
    tree.unitExponent = in.read<std::int32_t>();
    tree.unit = std::ldexp(1.0, tree.unitExponent);
    tree.radius = in.read<float>();
    std::apply([&](auto&... nodes) { (in.readArray(nodes), ...); }, tree.nodesByWidth);
    in.readArray(tree.leafBlocks);
    in.readArray(tree.vertices);
    const Vector3 low = readVector(in), high = readVector(in);
    tree.box = Box(low, high);
    tree.radiusAboutMeshOrigin = in.read<double>();
    return tree;
}

void addRest(ArchiveWriter& out, const BuildReport& report, const std::vector<Component>& components,
             const MeshOrigin& origin) {
    for (const std::size_t count : {report.clean.weldedVertices, report.clean.unusedVertices,
                                    report.clean.degenerateTriangles, report.clean.duplicateTriangles}) {
        out.add(std::uint64_t(count));
    }
    out.add(std::uint64_t(report.unreachableTriangles));
    out.add(report.seconds);
    out.add(std::uint64_t(components.size()));
    for (const Component& component : components) {
        out.add(component.name);
        out.add(component.firstTriangle);
        out.add(component.triangleCount);
    }
    out.add(origin.file);
    out.add(origin.scale);
    addVector(out, origin.shift);
    out.add(origin.format);
    out.add(std::uint64_t(origin.isChecked));
    out.add(origin.unitMetres);
    out.add(std::uint64_t(origin.upAxis));
    out.add(std::uint64_t(origin.ignoredFaces));
    out.add(std::uint64_t(origin.crossingFaces));
    out.add(std::uint64_t(origin.bentFaces));
    out.add(origin.bentBy);
    for (const std::vector<std::string>* const lines : {&origin.warnings, &origin.notes}) {
        out.add(std::uint64_t(lines->size()));
        for (const std::string& line : *lines) out.add(line);
    }
}

void readRest(ArchiveReader& in, BuildReport& report, std::vector<Component>& components,
              MeshOrigin& origin) {
    for (std::size_t* count : {&report.clean.weldedVertices, &report.clean.unusedVertices,
                               &report.clean.degenerateTriangles, &report.clean.duplicateTriangles}) {
        *count = in.read<std::uint64_t>();
    }
    report.unreachableTriangles = in.read<std::uint64_t>();
    report.seconds = in.read<double>();
    components.resize(in.readCount(16));
    for (Component& component : components) {
        component.name = in.readText();
        component.firstTriangle = in.read<std::uint32_t>();
        component.triangleCount = in.read<std::uint32_t>();
    }
    origin.file = in.readText();
    origin.scale = in.read<double>();
    origin.shift = readVector(in);
    origin.format = in.readText();
    origin.isChecked = in.read<std::uint64_t>() != 0;
    origin.unitMetres = in.read<double>();
    origin.upAxis = static_cast<char>(in.read<std::uint64_t>());
    origin.ignoredFaces = in.read<std::uint64_t>();
    origin.crossingFaces = in.read<std::uint64_t>();
    origin.bentFaces = in.read<std::uint64_t>();
    origin.bentBy = in.read<double>();
    for (std::vector<std::string>* const lines : {&origin.warnings, &origin.notes}) {
        lines->resize(in.readCount(8));
        for (std::string& line : *lines) line = in.readText();
    }
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
    addOptions(out, options);
    addRange(out, range);
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
    addOptions(payload, data_->report.options);
    addRange(payload, data_->range);
    addTree(payload, data_->tree);
    addRest(payload, data_->report, data_->components, data_->origin);
    writeSavedFile(file, kModel, data_->key, payload);
}

Model Model::load(const std::string& file) {
    const SavedFile saved = readSavedFile(file, kModel);
    auto data = std::make_shared<Data>();
    data->key = saved.key;
    try {
        ArchiveReader in(saved.payload());
        data->report.options = readOptions(in);
        data->range = readRange(in);
        data->tree = readTree(in);
        readRest(in, data->report, data->components, data->origin);
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
