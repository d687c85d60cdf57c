// Assemblies: one mesh file of several components, or a folder of mesh files.
#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <iterator>

#include "clearway/errors.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "core/text.h"

namespace clearway {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMeshEndings[] = {".stl", ".obj", ".ply", ".off", ".gltf", ".glb", ".3mf", ".dae"};

bool isMeshFile(const fs::path& file) {
    const std::string ending = file.extension().string();
    return std::any_of(std::begin(kMeshEndings), std::end(kMeshEndings),
                       [&](const char* known) { return boost::iequals(ending, known); });
}

}  // namespace

std::vector<std::string> assemblyFiles(const std::string& path) {
    std::error_code isGone;
    if (!fs::is_directory(path, isGone)) return {path};
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path, isGone)) {
        if (entry.is_regular_file() && isMeshFile(entry.path())) files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    if (isGone) throw FileError("cannot read the folder '" + path + "': " + isGone.message());
    if (files.empty())
        throw FileError("the folder '" + path + "' holds no mesh file, expected at least one of " +
                        joined(std::vector<std::string>(std::begin(kMeshEndings), std::end(kMeshEndings))));
    return files;
}

Mesh loadAssembly(const std::string& path, const MeshReader& read) {
    std::vector<Mesh> meshes;
    for (const std::string& file : assemblyFiles(path)) meshes.push_back(read(file, {}));
    return joinedEnvironment(meshes);
}

}  // namespace clearway
