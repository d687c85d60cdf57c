// demos/disassemble.cpp ASSEMBLY OUT [SECONDS]: takes an assembly apart, part by part. ASSEMBLY is a mesh file of several components in
// assembled places, or a folder of mesh files. OUT gets, for each part that comes out, a problem and its path, which is certified to keep
// clear of all parts still there, and disassembly.glb, in which they move one after the other. SECONDS (20) is the most time for a part.
#include <clearway/animation.h>
#include <clearway/errors.h>
#include <clearway/obstacle_groups.h>
#include <clearway/overlap.h>
#include <clearway/planning/plan.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

namespace cp = clearway::planning;

constexpr double kFirstSeconds = 0.5;  // for each part; most come out at once
constexpr double kLonger = 6;          // by which the time grows when no part comes out
constexpr double kOverlap = 1.34;      // of the depth of a contact; frees a flat one
constexpr double kSlack =
    0.005;  // of the part's diagonal, added to the overlap, so that the part can begin to move
constexpr double kShownSeconds = 3;  // that a part moves in the animation

/// The assembly without the parts that are out, read from memory.
class Assembly {
  public:
    explicit Assembly(const std::string& path) : files_(clearway::assemblyFiles(path)) {
        for (const std::string& file : files_) meshes_[file] = clearway::loadMesh(file);
        const clearway::Mesh all = clearway::loadAssembly(path, reader());
        for (const clearway::Component& component : all.components) {
            if (component.triangleCount > 0) parts_.push_back(component.name);
        }
        if (parts_.size() < 2) throw std::invalid_argument("'" + path + "' has one part, expected several");
        std::map<std::string, double> sizes;
        for (const std::string& part : parts_)
            sizes[part] = boundingBox(clearway::loadPart(problemOf(part), reader())).diagonal().norm();
        std::stable_sort(parts_.begin(), parts_.end(), [&](const std::string& a, const std::string& b) {
            return sizes.at(a) < sizes.at(b);
        });
        metres_ = all.origin.unitMetres > 0 ? all.origin.unitMetres : 1;
    }

    const std::vector<std::string>& parts() const { return parts_; }
    double metres() const { return metres_; }

    bool isOut(const std::string& part) const {
        return std::find(out_.begin(), out_.end(), part) != out_.end();
    }

    void takeOut(const std::string& part) {
        parts_.erase(std::find(parts_.begin(), parts_.end(), part));
        out_.push_back(part);
    }

    /// The problem to move one part outside of the others.
    clearway::Problem problemOf(const std::string& part) const {
        clearway::Problem problem;
        problem.meshes.robot = problem.meshes.world = files_[0];
        problem.meshes.furtherWorlds.assign(files_.begin() + 1, files_.end());
        problem.meshes.partNames = {part};
        problem.meshes.asOmplApp = false;
        problem.rules.ignored = out_;
        problem.outside.emplace();
        return problem;
    }

    clearway::Mesh remaining() const {
        clearway::Problem problem = problemOf("");
        problem.meshes.partNames.clear();
        return clearway::obstaclesOf(problem, clearway::loadWorlds(problem, reader())).groups.at(0).mesh;
    }

    clearway::MeshReader reader() const {
        return [this](const std::string& file, const clearway::LoadOptions&) { return meshes_.at(file); };
    }

  private:
    std::vector<std::string> files_, parts_, out_;
    std::map<std::string, clearway::Mesh> meshes_;
    double metres_ = 1;
};

/// Parts touch where they are assembled. Lets others reach as deep into the part as they do at the start, and a little deeper.
void allowContact(clearway::Problem& problem, const clearway::SceneMeshes& meshes) {
    const clearway::Mesh rest = clearway::obstaclesOf(problem, meshes.worlds).groups.at(0).mesh;
    if (!clearway::collides(clearway::Model::build(meshes.part), clearway::Model::build(rest), {})) return;
    double depth = 0;
    try {
        depth = clearway::OverlapMeter(meshes.part).deepest(rest, {}).upper;
    } catch (const clearway::ArgumentError&) {
        // An open part has no inside: the others may reach through its surface by the slack alone.
    }
    const double diagonal = clearway::boundingBox(meshes.part).diagonal().norm();
    problem.rules.overlap.common = kOverlap * depth + kSlack * diagonal;
}

/// A part that did not come out: in how much time, and what stopped it.
struct Held {
    double seconds = 0;
    std::set<std::string> by;
    std::string error;
};

Held whatHolds(const cp::PlanReport& report, double seconds) {
    Held held{seconds, {}, report.shutIn ? "it is shut in" : ""};
    if (!report.whyNoPath) return held;
    for (const cp::FollowedTrack& track : report.whyNoPath->tracks) held.by.insert(track.obstacleMesh);
    for (const cp::Blocker& blocker : report.whyNoPath->blockers) held.by.insert(blocker.name);
    held.by.erase("");  // the bounds
    return held;
}

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Parts on their way out, in their order; and the parts that are still held.
struct Disassembly {
    std::string folder;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::vector<clearway::MovingPart> moves;
    std::map<std::string, Held> held;
};

/// Moves the part out, and writes its problem and path; or keeps what holds the part.
bool moveOut(const Assembly& assembly, const std::string& part, double seconds, Disassembly& all) {
    clearway::Problem problem = assembly.problemOf(part);
    const clearway::SceneMeshes meshes = clearway::loadMeshes(problem, assembly.reader());
    cp::PlanOptions options;
    options.seconds = seconds;
    options.quick = true;
    try {
        allowContact(problem, meshes);
        const cp::PlanReport report = cp::plan(problem, clearway::buildScene(problem, meshes).scene, options);
        if (report.outcome != cp::PlanReport::Outcome::kFound) {
            all.held[part] = whatHolds(report, seconds);
            return false;
        }
        std::string name = std::to_string(all.moves.size() + 1) + "_" + part;
        std::replace(name.begin(), name.end(), '/', '_');
        clearway::writeProblem(problem, all.folder + "/" + name + ".cfg");
        clearway::writePath(report.path, problem.space, all.folder + "/" + name + ".path");
        const double begin = kShownSeconds * static_cast<double>(all.moves.size());
        all.moves.push_back({meshes.part, report.path, begin, begin + kShownSeconds, true, part});
        std::printf("%3zu %-24s out after %5.1f s (%.2f s of planning, %zu motions, overlap %.3g)\n",
                    all.moves.size(), part.c_str(), secondsSince(all.begin), report.planningSeconds,
                    report.path.size() - 1, problem.rules.overlap.common);
        std::fflush(stdout);
        all.held.erase(part);
        return true;
    } catch (const clearway::ArgumentError& error) {
        all.held[part] = {seconds, {}, error.what()};
        return false;
    }
}

/// Takes out what comes out: those that need the least time first, and small parts first. A part is tried again with more time, or once
/// something is out that held it. The largest part stays for as long as another one comes out.
void takeApart(Assembly& assembly, double mostSeconds, Disassembly& all) {
    double seconds = std::min(kFirstSeconds, mostSeconds);
    while (true) {
        bool isAnyOut = false;
        const std::vector<std::string> parts = assembly.parts();
        for (const std::string& part : parts) {
            if (part == parts.back() && (isAnyOut || assembly.parts().size() == 1)) break;
            const auto held = all.held.find(part);
            if (held != all.held.end() && held->second.seconds >= seconds &&
                std::none_of(held->second.by.begin(), held->second.by.end(),
                             [&](const std::string& name) { return assembly.isOut(name); }))
                continue;
            if (!moveOut(assembly, part, seconds, all)) continue;
            assembly.takeOut(part);
            isAnyOut = true;
        }
        if (assembly.parts().size() == 1) return;
        if (!isAnyOut && seconds >= mostSeconds) return;
        seconds = std::min(isAnyOut ? kFirstSeconds : kLonger * seconds, mostSeconds);
    }
}

void printHeld(const std::string& part, const Held& held) {
    std::string names;
    for (const std::string& name : held.by) names += (names.empty() ? "held by '" : ", '") + name + "'";
    std::printf("    %s: %s%s\n", part.c_str(), held.error.c_str(), names.c_str());
}

int main(int argc, char** argv) try {
    if (argc != 3 && argc != 4) throw std::invalid_argument("expected ASSEMBLY OUT [SECONDS]");
    const double most = argc == 4 ? std::strtod(argv[3], nullptr) : 20;
    if (!(most > 0))
        throw std::invalid_argument("SECONDS is '" + std::string(argv[3]) + "', expected a number above 0");
    Disassembly all;
    all.folder = argv[2];
    Assembly assembly(argv[1]);
    std::filesystem::create_directories(all.folder);
    const std::size_t count = assembly.parts().size();
    takeApart(assembly, most, all);
    for (const auto& [part, held] : all.held) printHeld(part, held);
    std::printf("%zu of %zu parts came out one after the other, in %.0f s%s\n", all.moves.size(), count,
                secondsSince(all.begin), assembly.parts().size() == 1 ? "; the last one is alone" : "");
    saveAnimation(assembly.remaining(), all.moves, assembly.metres(), all.folder + "/disassembly.glb");
    return assembly.parts().size() == 1 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "disassemble: " << error.what() << "\n";
    return 2;
}
