// mesh -> clean -> build -> flat tree.
#include "clearway/model.h"

#include <atomic>
#include <chrono>

#include "build/build.h"
#include "mesh/clean.h"
#include "model/model_data.h"
#include "tree/statistics.h"

namespace clearway {

Model::Model(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

std::uint64_t Model::newId() {
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

Model Model::build(const Mesh& mesh, const BuildOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    requireBuildOptions(options);
    const CleanMesh cleaned = clean(mesh);

    auto data = std::make_shared<Data>();
    data->id = newId();
    data->key = modelKey(mesh, options);
    data->tree = flatten(buildBinaryTree(cleaned, options), cleaned, options.nodeWidth);
    data->components = mesh.components;
    if (data->components.empty()) data->components.push_back({"", 0, std::uint32_t(mesh.triangles.size())});
    data->origin = mesh.origin;
    data->report.options = options;
    data->report.clean = cleaned.report;
    data->report.triangles = cleaned.triangles.size();
    data->report.tree = statistics(data->tree);
    data->report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
double Model::radiusAboutOrigin() const {
    return data_->tree.radiusAboutMeshOrigin;
}
std::uint64_t Model::key() const {
    return data_->key;
}
std::uint64_t Model::id() const {
    return data_->id;
}
const FlatTree& Model::tree() const {
    return data_->tree;
}

}  // namespace clearway
