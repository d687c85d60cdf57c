// Assemblies: one mesh file of several components, or a folder of mesh files.
#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <iterator>

#include "clearway/errors.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "core/text.h"
#include "problem/assembly_files.h"

namespace clearway {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMeshEndings[] = {".stl", ".obj", ".ply", ".off", ".gltf", ".glb", ".3mf", ".dae"};

/// Formats of CAD and other programs, parts in which would be missing.
constexpr const char* kOtherEndings[] = {".step", ".stp",   ".iges",   ".igs", ".brep", ".sat",
                                         ".x_t",  ".jt",    ".fbx",    ".3ds", ".wrl",  ".x3d",
                                         ".amf",  ".blend", ".sldprt", ".ipt"};

template <class Endings>
bool hasEnding(const fs::path& file, const Endings& endings) {
    const std::string ending = file.extension().string();
    return std::any_of(std::begin(endings), std::end(endings),
                       [&](const char* known) { return boost::iequals(ending, known); });
}

/// Refuses a folder with a part that cannot be read, unless a mesh of it lies beside it: that part would be missing.
void requireNoOther(const fs::path& folder, const std::vector<std::string>& meshes) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const fs::path& file = entry.path();
        const auto isOf = [&](const std::string& mesh) { return fs::path(mesh).stem() == file.stem(); };
        if (!hasEnding(file, kOtherEndings) || std::any_of(meshes.begin(), meshes.end(), isOf)) continue;
        throw FileError("the folder '" + folder.string() + "' holds '" + file.filename().string() +
                        "', which is not read with it, expected a mesh of it, '" + file.stem().string() +
                        ".3mf' (of STEP and IGES files clearway-cad makes one)");
    }
}

}  // namespace

std::string shapeFileWord(const std::string& file) {
    return hasEnding(file, kMeshEndings)    ? "a mesh file"
           : hasEnding(file, kOtherEndings) ? "a CAD or scene file"
                                            : "";
}

std::vector<std::string> assemblyFiles(const std::string& path) {
    std::error_code isGone;
    if (!fs::is_directory(path, isGone)) return {path};
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path, isGone)) {
        if (entry.is_regular_file() && hasEnding(entry.path(), kMeshEndings))
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    if (!isGone) requireNoOther(path, files);
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
