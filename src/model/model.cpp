// Builds a model: mesh, clean mesh, tree.
#include "clearway/model.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "build/build.h"
#include "core/clock.h"
#include "core/parallel.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "model/model_data.h"
#include "model/query_range.h"
#include "tree/largest_displacement.h"

namespace clearway {

Model::Model(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

std::uint64_t Model::newId() {
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

Model Model::build(const Mesh& mesh, const BuildOptions& options, const std::optional<QueryRange>& range) {
    const Clock::time_point start = Clock::now();
    requireBuildOptions(options);
    if (range) requireRange(*range);
    CleanMesh cleaned = onThreads(options.threads, [&] { return clean(mesh); });

    auto data = std::make_shared<Data>();
    data->id = newId();
    data->key = modelKey(mesh, options, range);
    if (range) data->report.unreachableTriangles = leaveOutUnreachable(cleaned, *range);
    if (data->report.unreachableTriangles > 0) data->range = range;
    data->tree = buildTree(cleaned, options);
    // Queries derive M and the default width of an interval from this box: both stay those of the whole mesh.
    if (data->range) data->tree.box = boundingBox(mesh);
    data->components = componentsOf(mesh);
    data->origin = mesh.origin;
    data->report.options = options;
    data->report.clean = cleaned.report;
    data->report.triangles = cleaned.triangles.size();
    data->report.tree = statistics(data->tree);
    data->report.seconds = secondsSince(start);
    return Model(std::move(data));
}

const BuildReport& Model::report() const {
    return data_->report;
}
const Box& Model::box() const {
    return data_->tree.box;
}
const std::vector<Component>& Model::components() const {
    return data_->components;
}
const MeshOrigin& Model::origin() const {
    return data_->origin;
}
const std::optional<QueryRange>& Model::range() const {
    return data_->range;
}
double Model::radiusAboutOrigin() const {
    return data_->tree.radiusAboutMeshOrigin;
}
double Model::radiusAboutAxis(const Vector3& direction) const {
    const double length = direction.stableNorm();
    const Vector3 unit = direction / length;
    if (!(length > 0) || !std::isfinite(length) || !unit.allFinite()) return radiusAboutOrigin();
    return std::min(clearway::radiusAboutAxis(data_->tree, unit.normalized()), radiusAboutOrigin());
}
double Model::displacement(const Pose& from, const Pose& to, std::optional<double> cap) const {
    return largestDisplacement(data_->tree, from, to, cap.value_or(std::numeric_limits<double>::infinity()));
}
std::uint64_t Model::key() const {
    return data_->key;
}
std::uint64_t Model::id() const {
    return data_->id;
}
}  // namespace clearway
