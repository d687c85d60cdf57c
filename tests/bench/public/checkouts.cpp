#include "bench/public/checkouts.h"

#include <filesystem>

#include "clearway/obstacle_groups.h"
#include "core/replace_file.h"
#include "support/ppl_mesh.h"

namespace clearway::testing::public_problems {
namespace {

namespace fs = std::filesystem;

/// Poses the problems of manifests whose repositories are among a user's checkouts.
class Finder {
  public:
    Finder(const std::string& checkouts, const std::string& converted)
        : checkouts_(checkouts), converted_(fs::absolute(converted)) {}

    PublicProblems find(const std::vector<Manifest>& manifests) {
        for (const Manifest& manifest : manifests) {
            checkout_ = checkouts_ / manifest.folder;
            if (!fs::is_directory(checkout_)) {
                found_.skipped.push_back(manifest.folder + ": there is no folder " + checkout_.string() +
                                         " with " + manifest.repository + " at " + manifest.commit);
                continue;
            }
            for (const ListedProblem& listed : manifest.problems) findProblem(listed);
            for (const std::string& assembly : manifest.assemblies) findAssembly(assembly);
        }
        return std::move(found_);
    }

  private:
    std::string inCheckout(const std::string& file) const { return (checkout_ / file).string(); }

    /// False, with a line among the skipped, when one of the files is missing or empty.
    bool areThere(const std::string& name, const std::vector<std::string>& files) {
        for (const std::string& file : files) {
            if (fs::exists(file) && fs::file_size(file) > 0) continue;
            found_.skipped.push_back(name + ": there is no " + file + ", or it is empty");
            return false;
        }
        return true;
    }

    void findProblem(const ListedProblem& listed) {
        PublicProblem found{listed.name, inCheckout(listed.config)};
        for (const std::string& path : listed.paths) {
            if (fs::exists(checkout_ / path)) found.paths.push_back(inCheckout(path));
        }
        if (!listed.config.empty() && !areThere(listed.name, {found.file})) return;
        Problem problem = listed.config.empty() ? listed.problem : readProblem(found.file);
        std::vector<std::string> worlds;
        for (const PlacedMesh& mesh : listed.world) worlds.push_back(inCheckout(mesh.file));
        if (!worlds.empty()) {
            problem.meshes.robot = inCheckout(listed.robot);
            problem.meshes.world = worlds.front();
        } else {
            worlds = {problem.meshes.world};
        }
        if (!areThere(listed.name, {problem.meshes.robot}) || !areThere(listed.name, worlds)) return;
        if (!listed.robot.empty()) {
            const fs::path folder = converted_ / listed.name;
            makeFolder(folder.string());
            if (listed.isPpl) convertMeshes(listed, folder, problem);
            found.file = (folder / "problem.cfg").string();
            writeProblem(problem, found.file);
        }
        found.isOmplApps = !problem.outside && problem.rules.overlap.common == 0;
        found_.puzzles.push_back(found);
    }

    void convertMeshes(const ListedProblem& listed, const fs::path& folder, Problem& problem) const {
        std::vector<Mesh> obstacles;
        for (const PlacedMesh& placed : listed.world) {
            obstacles.push_back(loadPplMesh(inCheckout(placed.file)));
            for (Vector3& vertex : obstacles.back().vertices) vertex += placed.position;
        }
        if (listed.hasWalls) obstacles.push_back(boxMesh(*problem.volume));
        const Mesh part = loadPplMesh(problem.meshes.robot);
        problem.meshes.robot = (folder / "part.ply").string();
        problem.meshes.world = (folder / "environment.ply").string();
        saveMesh(part, problem.meshes.robot);
        saveMesh(joinedEnvironment(obstacles), problem.meshes.world);
    }

    void findAssembly(const std::string& folder) {
        const Assembly assembly{fs::path(folder).filename().string(), assemblyFiles(inCheckout(folder))};
        if (assembly.files.size() >= 2)
            found_.assemblies.push_back(assembly);
        else
            found_.skipped.push_back(assembly.name + ": there are fewer than two mesh files in " +
                                     inCheckout(folder));
    }

    fs::path checkouts_, converted_, checkout_;
    PublicProblems found_;
};

}  // namespace

PublicProblems findPublicProblems(const std::vector<Manifest>& manifests, const std::string& checkouts,
                                  const std::string& converted) {
    return Finder(checkouts, converted).find(manifests);
}

}  // namespace clearway::testing::public_problems
