// demos/disassemble.cpp ASSEMBLY OUT [SECONDS]: takes an assembly apart, part by part. ASSEMBLY is a mesh file of several components in
// assembled places, or a folder of mesh files. OUT gets, for each part that comes out, a problem and its path, certified among the parts
// still there, and disassembly.glb, in which they move one after the other. SECONDS (20) is the most time for a part. Parts that touch at
// the start may overlap, or do not count at first: each row tells how much.
#include <clearway/animation.h>
#include <clearway/errors.h>
#include <clearway/obstacle_groups.h>
#include <clearway/overlap.h>
#include <clearway/planning/plan.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

namespace cp = clearway::planning;

constexpr double kFirstSeconds = 0.5;  // for each part; most come out at once
constexpr double kLonger = 7;          // by which the time grows when no part comes out
constexpr double kOverlap = 1.34;      // of the depth of a contact; frees a flat one
constexpr double kSlack =
    0.005;  // of the part's diagonal, added to the overlap, so that the part can begin to move
constexpr double kContact =
    0.0005;  // of the part's diagonal: how far a part moves until contacts that were ignored count
constexpr std::size_t kLongestName = 100;  // of a part, in the names of files
constexpr double kBeside = 0.1;            // of the part's diagonal: nearer parts stand next to it
constexpr double kShownSeconds = 3;        // that a part moves in the animation

volatile std::sig_atomic_t isStopped = 0;

std::string shown(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", length);
    return text;
}

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
        for (const std::string& part : parts_) {
            partMeshes_[part] = clearway::loadPart(problemOf(part), reader());
            models_.emplace(part, clearway::Model::build(partMeshes_[part]));
        }
        const auto size = [&](const std::string& part) { return model(part).box().diagonal().norm(); };
        std::stable_sort(parts_.begin(), parts_.end(),
                         [&](const std::string& a, const std::string& b) { return size(a) < size(b); });
        metres_ = all.origin.unitMetres > 0 ? all.origin.unitMetres : 1;
        hasUnit_ = all.origin.unitMetres > 0;
        deflection_ = all.origin.deflection;
    }

    const std::vector<std::string>& parts() const { return parts_; }
    const clearway::Mesh& mesh(const std::string& part) const { return partMeshes_.at(part); }
    const clearway::Model& model(const std::string& part) const { return models_.at(part); }
    double metres() const { return metres_; }
    double deflection() const { return deflection_; }

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
        problem.deflection = deflection_;
        for (const clearway::LengthUnit& unit : clearway::lengthUnits())
            if (unit.metres == metres_ && hasUnit_) problem.unit = unit.name;
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
    std::map<std::string, clearway::Mesh> meshes_, partMeshes_;  // of the files, of the parts
    std::map<std::string, clearway::Model> models_;
    double metres_ = 1, deflection_ = 0;
    bool hasUnit_ = false;
};

/// The parts still there that the part touches.
std::vector<std::string> touchedBy(const Assembly& assembly, const std::string& part) {
    std::vector<std::string> touched;
    for (const std::string& other : assembly.parts()) {
        if (other != part && clearway::collides(assembly.model(part), assembly.model(other), {}))
            touched.push_back(other);
    }
    return touched;
}

/// Parts touch where they are assembled. Lets the touched ones reach as deep into the part as they do at the start, and a little deeper.
/// Throws clearway::ArgumentError if the part is open: then no depth is known.
void allowOverlap(clearway::Problem& problem, const Assembly& assembly, const std::string& part,
                  const std::vector<std::string>& touched) {
    double depth = 0;
    const clearway::OverlapMeter meter(assembly.mesh(part), assembly.model(part));
    for (const std::string& other : touched)
        depth = std::max(depth, meter.deepest(assembly.mesh(other), {}).upper);
    const double overlap = kOverlap * depth + kSlack * assembly.model(part).box().diagonal().norm();
    for (const std::string& other : touched) problem.rules.overlap.byName[other] = overlap;
}

/// A part that did not come out: in how much time, and what stopped it, most often first.
struct Held {
    double seconds = 0;
    std::vector<std::string> by;
    std::string error;
};

/// The parts that stopped motions of the part and stand next to it; if there are none, all that stopped it.
Held whatHolds(const cp::PlanReport& report, const Assembly& assembly, const std::string& part,
               double seconds) {
    Held held{seconds, {}, report.shutIn ? "shut in" : ""};
    if (!report.whyNoPath) return held;
    std::vector<std::string> all, beside;
    const auto add = [&](const std::string& name) {
        if (name.empty() || std::find(all.begin(), all.end(), name) != all.end()) return;
        all.push_back(name);
        const double near = kBeside * assembly.model(part).box().diagonal().norm();
        if (clearway::isWithin(assembly.model(part), assembly.model(name), {}, near)) beside.push_back(name);
    };
    for (const cp::FollowedTrack& track : report.whyNoPath->tracks) add(track.obstacleMesh);
    for (const cp::Blocker& blocker : report.whyNoPath->blockers) add(blocker.name);
    held.by = beside.empty() ? all : beside;
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

/// A plan of the part's way out, and how its problem allows the contacts at the start, for people.
struct WayOut {
    clearway::Problem problem;
    cp::PlanReport report;
    std::string contacts;
};

/// Where the part touches others, they may overlap, or, where that does not free the start, they are ignored until the part has moved a little.
WayOut planWayOut(const Assembly& assembly, const std::string& part, double seconds) {
    cp::PlanOptions options;
    options.seconds = seconds;
    options.quick = true;
    options.isStopped = [] { return isStopped != 0; };
    WayOut way{assembly.problemOf(part), {}, "no contact"};
    const clearway::SceneMeshes meshes = clearway::loadMeshes(way.problem, assembly.reader());
    const auto plan = [&] {
        way.report = cp::plan(way.problem, clearway::buildScene(way.problem, meshes).scene, options);
    };
    const std::vector<std::string> touched = touchedBy(assembly, part);
    try {
        if (!touched.empty()) allowOverlap(way.problem, assembly, part, touched);
        if (!touched.empty())
            way.contacts =
                "overlaps up to " + shown(way.problem.rules.overlap.byName.begin()->second) + " allowed";
        plan();
    } catch (const clearway::ArgumentError&) {
        if (touched.empty()) throw;
        const double distance = kContact * boundingBox(meshes.part).diagonal().norm();
        way.problem.rules.overlap = {};
        way.problem.rules.startContact = clearway::ContactRule{touched, distance};
        way.contacts = "contacts ignored for the first " + shown(distance);
        plan();
    }
    return way;
}

/// Moves the part out, and writes its problem and path; or keeps what holds the part.
bool moveOut(const Assembly& assembly, const std::string& part, double seconds, Disassembly& all) try {
    std::fprintf(stderr, "trying %s for %g s\n", part.c_str(), seconds);
    const WayOut way = planWayOut(assembly, part, seconds);
    if (way.report.outcome != cp::PlanReport::Outcome::kFound) {
        all.held[part] = whatHolds(way.report, assembly, part, seconds);
        return false;
    }
    char number[16];
    std::snprintf(number, sizeof number, "%03zu_", all.moves.size() + 1);
    std::string name = number + part.substr(0, kLongestName);
    std::replace(name.begin(), name.end(), '/', '_');
    clearway::writeProblem(way.problem, all.folder + "/" + name + ".cfg");
    clearway::writePath(way.report.path, way.problem.space, all.folder + "/" + name + ".path");
    const double begin = kShownSeconds * static_cast<double>(all.moves.size());
    all.moves.push_back({assembly.mesh(part), way.report.path, begin, begin + kShownSeconds, true, part});
    std::printf("%3zu %-24s out after %5.1f s (%.2f s of planning, %zu motions, %s)\n", all.moves.size(),
                part.c_str(), secondsSince(all.begin), way.report.planningSeconds, way.report.path.size() - 1,
                way.contacts.c_str());
    std::fflush(stdout);
    all.held.erase(part);
    return true;
} catch (const std::exception& error) {
    const std::string words = error.what();
    all.held[part] = {seconds, {}, words.substr(0, words.find("; "))};
    return false;
}

/// Takes out what comes out: those that need the least time first, and small parts first. A part is tried again with more time, or once
/// something is out that held it. The largest part stays for as long as another one comes out.
void takeApart(Assembly& assembly, double mostSeconds, Disassembly& all) {
    double seconds = std::min(kFirstSeconds, mostSeconds);
    while (true) {
        bool isAnyOut = false;
        const std::vector<std::string> parts = assembly.parts();
        for (const std::string& part : parts) {
            if (isStopped) return;
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
    constexpr std::size_t kMost = 3;
    std::string words = held.error;
    if (words.empty()) words = "no way out found in " + shown(held.seconds) + " s";
    for (std::size_t i = 0; i < held.by.size() && i < kMost; ++i)
        words += (i == 0 ? ", held by '" : ", '") + held.by[i] + "'";
    if (held.by.size() > kMost) words += " and " + std::to_string(held.by.size() - kMost) + " more";
    std::printf("    %s: %s\n", part.c_str(), words.c_str());
}

/// Removes what an earlier run left, so that the folder holds one order.
void clear(const std::string& folder) {
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string(), ending = entry.path().extension().string();
        const bool isNumbered =
            name.size() > 4 && name[3] == '_' && name.find_first_not_of("0123456789") == 3;
        if (isNumbered && (ending == ".cfg" || ending == ".path")) old.push_back(entry.path());
    }
    for (const std::filesystem::path& file : old) std::filesystem::remove(file);
    std::filesystem::remove(folder + "/disassembly.glb");
}

int main(int argc, char** argv) try {
    if (argc != 3 && argc != 4) throw std::invalid_argument("expected ASSEMBLY OUT [SECONDS]");
    char* end = nullptr;
    const double most = argc == 4 ? std::strtod(argv[3], &end) : 20;
    if (!(most > 0 && most < 1e6) || (end && *end != 0))
        throw std::invalid_argument("SECONDS is '" + std::string(argv[3]) + "', expected a number above 0");
    std::error_code isGone;
    if (std::filesystem::equivalent(argv[1], argv[2], isGone))
        throw std::invalid_argument("OUT is the folder of the assembly, expected another one");
    Disassembly all;
    all.folder = argv[2];
    Assembly assembly(argv[1]);
    clear(all.folder);
    std::signal(SIGINT, [](int) { isStopped = 1; });  // ends the search; what is out stays
    const std::size_t count = assembly.parts().size();
    takeApart(assembly, most, all);
    if (assembly.parts().size() == 1) all.held.clear();  // nothing is left that holds the last one
    for (const auto& [part, held] : all.held) printHeld(part, held);
    std::printf("%zu of %zu parts came out one after the other, in %.0f s%s\n", all.moves.size(), count,
                secondsSince(all.begin), assembly.parts().size() == 1 ? "; the last one is alone" : "");
    if (assembly.deflection() > 0)
        std::printf("certified for these triangles; the surfaces may be up to 2 x %s closer\n",
                    shown(assembly.deflection()).c_str());
    saveAnimation(assembly.remaining(), all.moves, assembly.metres(), all.folder + "/disassembly.glb");
    return assembly.parts().size() == 1 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "disassemble: " << error.what() << "\n";
    return 2;
}
