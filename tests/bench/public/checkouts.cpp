#include "bench/public/checkouts.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>

#include "clearway/problem.h"
#include "core/replace_file.h"
#include "support/ppl_scene.h"

namespace clearway::testing::public_problems {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    std::error_code isMissing;
    for (const auto& entry : fs::directory_iterator(folder, isMissing)) {
        if (boost::iequals(entry.path().extension().string(), ending)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> thoseThere(const std::vector<fs::path>& files) {
    std::vector<std::string> there;
    for (const fs::path& file : files) {
        if (fs::exists(file)) there.push_back(file.string());
    }
    return there;
}

class Finder {
  public:
    Finder(const std::string& checkouts, const std::string& converted)
        : checkouts_(checkouts), converted_(fs::absolute(converted)) {}

    PublicProblems find() {
        for (const char* space : {"3D", "2D"}) findOmplApp(space);
        findElk();
        findAlphaOfTunnelDiscovery();
        findPpl("open-ppl-env/alpha-1.6", "open-ppl-env/alpha1.6/alpha", "robot", PplEnds::kQuery);
        findPpl("open-ppl-env/flange-1.0", "open-ppl-env/flange_1.0/flange", "robot", PplEnds::kQuery);
        findPpl("PuzzleTunnelDiscovery/alpha-1.5", "PuzzleTunnelDiscovery/res/alpha/alpha", "env",
                PplEnds::kQuery);
        findPpl("IPPP/alpha-1.0", "IPPP/assets/parasol_benchmarks/alpha1.5/alpha", "env",
                PplEnds::kAssembledToStart);
        for (const char* assembly : {"TXT-Binary", "Pumps/PumpWithThreadedBolts", "Pumps/Pump Assembly"}) {
            findAssembly(assembly);
        }
        return std::move(found_);
    }

  private:
    /// False, with a line among the skipped, when one of the files is missing or empty.
    bool areThere(const std::string& name, const std::vector<fs::path>& files) {
        for (const fs::path& file : files) {
            if (fs::exists(file) && fs::file_size(file) > 0) continue;
            found_.skipped.push_back(name + ": there is no " + file.string() + ", or it is empty");
            return false;
        }
        return true;
    }

    void findOmplApp(const std::string& space) {
        const fs::path folder = checkouts_ / "omplapp/resources" / space;
        const std::vector<fs::path> files = filesIn(folder, ".cfg");
        if (files.empty())
            found_.skipped.push_back("omplapp/" + space + ": there is no .cfg in " + folder.string());
        for (const fs::path& file : files) {
            const std::string name = "omplapp/" + space + "/" + file.stem().string();
            const Problem problem = readProblem(file.string());
            if (!areThere(name, {problem.meshes.robot, problem.meshes.world})) continue;
            add({name, file.string(), thoseThere({fs::path(file).replace_extension(".path")})});
        }
    }

    /// The problem file of the Elk names meshes in its author's folders. The repository's paths for version 1.5 fit
    /// no mesh there: they begin and end elsewhere than its problem file says, and collide nearly everywhere.
    void findElk() {
        const std::string name = "PuzzleTunnelDiscovery/elk-1.75";
        const fs::path folder = checkouts_ / "PuzzleTunnelDiscovery-6bee290/res/elk";
        const fs::path config = folder / "Puzzle-v1.75.cfg", part = folder / "Puzzle-Part-v1.75.ply",
                       counterpart = folder / "Puzzle-CounterPart-v1.75.ply";
        if (!areThere(name, {config, part, counterpart})) return;
        Problem problem = readProblem(config.string());
        problem.meshes.robot = part.string();
        problem.meshes.world = counterpart.string();
        addPuzzle(name, problem, thoseThere({folder / "Puzzle-Path-v1.75-RRTConnect.txt"}));
    }

    /// OMPL.app's alpha-1.2 as .obj files in other coordinates. It has no problem file, so start, goal and bounds
    /// are those of its published path.
    void findAlphaOfTunnelDiscovery() {
        const std::string name = "PuzzleTunnelDiscovery/alpha-1.2";
        const fs::path folder = checkouts_ / "PuzzleTunnelDiscovery/res/alpha";
        const fs::path part = folder / "alpha-1.2.org.obj", environment = folder / "alpha_env-1.2.org.obj",
                       path = folder / "alpha-1.2.org.path";
        if (!areThere(name, {part, environment, path})) return;
        Problem problem;
        problem.meshes.robot = part.string();
        problem.meshes.world = environment.string();
        const std::vector<PartState> states = readPath(path.string(), problem.space);
        problem.start = states.front();
        problem.goal = states.back();
        Box bounds = boundingBox(loadMesh(problem.meshes.world));
        for (const PartState& state : states) bounds.extend(state.position);
        problem.volume = bounds;
        addPuzzle(name, problem, {path.string()});
    }

    enum class PplEnds {
        kQuery,             ///< from the query's first pose to its second one
        kAssembledToStart,  ///< from where the files' coordinates put the robot to the query's first pose
    };

    void findPpl(const std::string& name, const std::string& stem, const std::string& robotEnding,
                 PplEnds ends) {
        const std::string base = (checkouts_ / stem).string();
        if (!areThere(name, {base + ".env", base + "." + robotEnding, base + ".query"})) return;
        const PplScene scene = readPplScene(base + ".env", base + "." + robotEnding, base + ".query");
        if (!areThere(name, {scene.robotFile, scene.obstacleFile})) return;
        const fs::path folder = folderOf(name);
        Problem problem;
        problem.meshes.robot = (folder / "part.ply").string();
        problem.meshes.world = (folder / "environment.ply").string();
        problem.meshes.asOmplApp = false;
        problem.volume = scene.bounds;
        const Mesh robot = loadPplMesh(scene.robotFile);
        Mesh obstacle = loadPplMesh(scene.obstacleFile);
        problem.start = scene.start;
        problem.goal = scene.goal;
        if (ends == PplEnds::kAssembledToStart) {
            problem.goal = scene.start;
            problem.start = {obstacle.origin.shift - robot.origin.shift + scene.obstaclePosition};
        }
        saveMesh(robot, problem.meshes.robot);
        for (Vector3& vertex : obstacle.vertices) vertex += scene.obstaclePosition;
        saveMesh(obstacle, problem.meshes.world);
        addPuzzle(name, problem, {});
    }

    void findAssembly(const std::string& name) {
        const fs::path folder = checkouts_ / "AutomatedAssemblyPlanner/examples" / name;
        Assembly assembly{fs::path(name).filename().string(), {}};
        for (const fs::path& file : filesIn(folder, ".stl")) assembly.files.push_back(file.string());
        if (assembly.files.size() < 2) {
            found_.skipped.push_back("AutomatedAssemblyPlanner/" + name +
                                     ": there are fewer than two .stl in " + folder.string());
            return;
        }
        found_.assemblies.push_back(assembly);
    }

    fs::path folderOf(const std::string& name) {
        const fs::path folder = converted_ / name;
        makeFolder(folder.string());
        return folder;
    }

    void addPuzzle(const std::string& name, const Problem& problem, const std::vector<std::string>& paths) {
        const std::string file = (folderOf(name) / "problem.cfg").string();
        writeProblem(problem, file);
        add({name, file, paths});
    }

    /// Skips a problem that differs from an earlier one only in what planners are told.
    void add(const PublicProblem& puzzle) {
        const Problem problem = readProblem(puzzle.file);
        for (const PublicProblem& earlier : found_.puzzles) {
            const Problem other = readProblem(earlier.file);
            if (problem.meshes.robot != other.meshes.robot || problem.meshes.world != other.meshes.world ||
                !areAlike(problem.start, other.start) || !areAlike(problem.goal, other.goal))
                continue;
            found_.skipped.push_back(puzzle.name + ": it has the meshes, start and goal of " + earlier.name);
            return;
        }
        found_.puzzles.push_back(puzzle);
    }

    static bool areAlike(const PartState& a, const PartState& b) {
        return a.position == b.position && a.rotation.coeffs() == b.rotation.coeffs();
    }

    fs::path checkouts_, converted_;
    PublicProblems found_;
};

}  // namespace

PublicProblems findPublicProblems(const std::string& checkouts, const std::string& converted) {
    return Finder(checkouts, converted).find();
}

}  // namespace clearway::testing::public_problems
