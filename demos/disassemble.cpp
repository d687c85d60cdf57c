// demos/disassemble.cpp ASSEMBLY OUT [SECONDS [NAME...]]: takes an assembly apart, part by part; --help says more. Each path is certified
// among the parts still there. Parts that touch at the start may overlap, or do not count at first: the table tells how much.
#include <clearway/animation.h>
#include <clearway/errors.h>
#include <clearway/obstacle_groups.h>
#include <clearway/overlap.h>
#include <clearway/planning/plan.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <regex>

namespace cp = clearway::planning;

constexpr const char* kUsage = R"(demo_disassemble ASSEMBLY OUT [SECONDS [NAME...]]

Takes an assembly apart, part by part. Tries small parts first, and the largest one only while no other comes out.

  ASSEMBLY  a mesh file of several parts in assembled places, or a folder of mesh files
  OUT       a folder: gets a problem and a certified path for each part that comes out, disassembly.csv with the table,
            and disassembly.glb, in which the parts move one after the other
  SECONDS   the most time for one try of a part (20)
  NAME      a part that stays in place, or several: * and ? stand for any text and any character

Clearances are certified; where overlaps are allowed, they are how much farther the part may move until they are used up.
The exit code is 1 when parts stay that should not.
)";
constexpr double kFirstSeconds = 0.5;  // for each part; most come out at once
constexpr double kLonger = 7;          // by which the time grows when no part comes out
constexpr double kOverlap = 1.34;      // of the depth of a contact; frees a flat one
constexpr double kSlack =
    0.005;  // of the part's diagonal, added to the overlap, so that the part can begin to move
constexpr double kContact =
    0.0005;  // of the part's diagonal: how far a part moves until contacts that were ignored count
constexpr double kBeside = 0.1;            // of the part's diagonal: nearer parts stand next to it
constexpr double kRoundedDown = 0.999995;  // six digits of so much of a number are not above it
constexpr double kShownSeconds = 3;        // that a part moves in the animation
constexpr std::size_t kMostNamed = 3;      // parts that hold one, in its note
constexpr std::size_t kLongestName = 100;  // letters of a part's name in the names of files

volatile std::sig_atomic_t isStopped = 0;

std::string shown(double number, int digits = 3) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

struct Part {
    clearway::Mesh mesh;
    clearway::Model model;
    double diagonal;
    bool stays;  // because the user says so
};

/// The assembly without the parts that are out, read from memory.
struct Assembly {
    std::map<std::string, clearway::Mesh> files;
    std::map<std::string, Part> parts;    // by their names, those that are out, too
    std::vector<std::string> there, out;  // names of parts; small ones first, and those that stay at the end
    clearway::Problem whole;              // without a part that moves

    /// staying: names of parts that are not taken out, as those of obstacle rules.
    Assembly(const std::string& path, const std::vector<std::string>& staying) {
        for (const std::string& file : clearway::assemblyFiles(path)) {
            files[file] = clearway::loadMesh(file);
            (files.size() == 1 ? whole.meshes.robot : whole.meshes.furtherWorlds.emplace_back()) = file;
        }
        const clearway::Mesh all = clearway::loadAssembly(path, reader());
        whole.meshes.world = whole.meshes.robot;
        whole.meshes.asOmplApp = false;
        whole.outside.emplace();
        whole.deflection = all.origin.deflection;
        for (const clearway::LengthUnit& unit : clearway::lengthUnits())
            if (unit.metres == all.origin.unitMetres) whole.unit = unit.name;
        clearway::Problem others = whole;  // without the triangles of the parts that stay
        others.meshes.partNames = staying;
        const clearway::Mesh moving = clearway::joinedEnvironment(clearway::loadWorlds(others, reader()));
        if (all.components.size() < 2)
            throw std::invalid_argument("'" + path + "' has one part, expected several");
        for (std::size_t i = 0; i < all.components.size(); ++i) {
            if (all.components[i].triangleCount == 0) continue;
            there.push_back(all.components[i].name);
            const clearway::Mesh mesh = clearway::loadPart(problemOf(there.back()), reader());
            const bool stays = moving.components[i].triangleCount == 0;
            parts.emplace(there.back(), Part{mesh, clearway::Model::build(mesh),
                                             clearway::boundingBox(mesh).diagonal().norm(), stays});
        }
        std::stable_sort(there.begin(), there.end(), [&](const std::string& a, const std::string& b) {
            return std::pair(parts.at(a).stays, parts.at(a).diagonal) <
                   std::pair(parts.at(b).stays, parts.at(b).diagonal);
        });
    }

    /// Whether the parts still there stay, or are one.
    bool isApart() const { return there.size() == 1 || parts.at(there.front()).stays; }

    /// The problem to move one part outside of the others.
    clearway::Problem problemOf(const std::string& part) const {
        clearway::Problem problem = whole;
        problem.meshes.partNames = {part};
        problem.rules.ignored = out;
        return problem;
    }

    clearway::Mesh remaining() const {
        clearway::Problem problem = whole;
        problem.rules.ignored = out;
        return clearway::obstaclesOf(problem, clearway::loadWorlds(problem, reader())).groups.at(0).mesh;
    }

    clearway::MeshReader reader() const {
        return [this](const std::string& file, const clearway::LoadOptions&) { return files.at(file); };
    }
};

/// The parts still there that the part touches.
std::vector<std::string> touchedBy(const Assembly& assembly, const std::string& part) {
    std::vector<std::string> touched;
    for (const std::string& other : assembly.there) {
        if (other != part &&
            clearway::collides(assembly.parts.at(part).model, assembly.parts.at(other).model, {}))
            touched.push_back(other);
    }
    return touched;
}

/// As deep as the touched parts reach into the part where they are assembled, and a little deeper. Throws clearway::ArgumentError if the
/// part is open: then no depth is known.
double overlapToAllow(const Assembly& assembly, const Part& part, const std::vector<std::string>& touched) {
    double depth = 0;
    const clearway::OverlapMeter meter(part.mesh, part.model);
    for (const std::string& other : touched)
        depth = std::max(depth, meter.deepest(assembly.parts.at(other).mesh, {}).upper);
    return kOverlap * depth + kSlack * part.diagonal;
}

/// A part that did not come out: in how much time, what stopped it, most often first, and both in words.
struct Held {
    double seconds;
    std::vector<std::string> by;
    std::string words;
};

/// The parts that stopped motions of the part and stand next to it; if there are none, all that stopped it.
Held whatHolds(const cp::PlanReport& report, const Assembly& assembly, const Part& part, double seconds) {
    Held held{seconds, {}, report.shutIn ? "shut in" : "no way out found in " + shown(seconds) + " s"};
    if (!report.whyNoPath) return held;
    std::vector<std::string> all, beside;
    const auto add = [&](const std::string& name) {
        if (name.empty() || std::find(all.begin(), all.end(), name) != all.end()) return;
        all.push_back(name);
        if (clearway::isWithin(part.model, assembly.parts.at(name).model, {}, kBeside * part.diagonal))
            beside.push_back(name);
    };
    for (const cp::FollowedTrack& track : report.whyNoPath->tracks) add(track.obstacleMesh);
    for (const cp::Blocker& blocker : report.whyNoPath->blockers) add(blocker.name);
    held.by = beside.empty() ? all : beside;
    for (std::size_t i = 0; i < held.by.size() && i < kMostNamed; ++i)
        held.words += (i == 0 ? ", held by '" : ", '") + held.by[i] + "'";
    if (held.by.size() > kMostNamed)
        held.words += " and " + std::to_string(held.by.size() - kMostNamed) + " more";
    return held;
}

using Row = std::array<std::string, 6>;  // the table's cells, as text

/// Parts on their way out, in their order; and the parts that are still held.
struct Disassembly {
    std::string folder;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::vector<clearway::MovingPart> moves;
    std::vector<Row> rows = {{"order", "part", "seconds", "length", "clearance", "note"}};
    std::map<std::string, Held> held;

    std::string seconds() const {
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
        return shown(since.count(), 4);
    }
};

/// A plan of the part's way out, and how its problem allows the contacts at the start, for people.
struct WayOut {
    clearway::Problem problem;
    cp::PlanReport report;
    std::string contacts;
};

/// Where the part touches others, they may overlap, or, where that does not free the start, they are ignored until the part has moved a little.
WayOut planWayOut(const Assembly& assembly, const std::string& name, double seconds) {
    cp::PlanOptions options;
    options.seconds = seconds;
    options.quick = true;
    options.isStopped = [] { return isStopped != 0; };
    WayOut way{assembly.problemOf(name), {}, "no contact"};
    const clearway::SceneMeshes meshes = clearway::loadMeshes(way.problem, assembly.reader());
    const auto plan = [&] {
        way.report = cp::plan(way.problem, clearway::buildScene(way.problem, meshes).scene, options);
    };
    const Part& part = assembly.parts.at(name);
    const std::vector<std::string> touched = touchedBy(assembly, name);
    try {
        if (!touched.empty()) {
            const double overlap = overlapToAllow(assembly, part, touched);
            for (const std::string& other : touched) way.problem.rules.overlap.byName[other] = overlap;
            way.contacts = "overlaps up to " + shown(overlap) + " allowed";
        }
        plan();
    } catch (const clearway::ArgumentError&) {
        if (touched.empty()) throw;
        const double distance = kContact * part.diagonal;
        way.problem.rules.overlap = {};
        way.problem.rules.startContact = clearway::ContactRule{touched, distance};
        way.contacts = "contacts ignored for the first " + shown(distance);
        plan();
    }
    return way;
}

/// Moves the part out, and writes its problem and path; or keeps what holds the part.
bool moveOut(Assembly& assembly, const std::string& part, double seconds, Disassembly& all) try {
    std::fprintf(stderr, "trying %s for %g s\n", part.c_str(), seconds);
    const WayOut way = planWayOut(assembly, part, seconds);
    if (way.report.outcome == cp::PlanReport::Outcome::kStopped) {
        all.held[part] = {0, {}, "interrupted"};
        return false;
    }
    if (way.report.outcome != cp::PlanReport::Outcome::kFound) {
        all.held[part] = whatHolds(way.report, assembly, assembly.parts.at(part), seconds);
        return false;
    }
    const double begin = kShownSeconds * static_cast<double>(all.moves.size());
    all.moves.push_back(
        {assembly.parts.at(part).mesh, way.report.path, begin, begin + kShownSeconds, true, part});
    char number[16];
    std::snprintf(number, sizeof number, "%03zu_", all.moves.size());
    std::string name = number + part.substr(0, kLongestName);
    std::replace(name.begin(), name.end(), '/', '_');
    clearway::writeProblem(way.problem, all.folder + "/" + name + ".cfg");
    clearway::writePath(way.report.path, way.problem.space, all.folder + "/" + name + ".path");
    all.rows.push_back({std::to_string(all.moves.size()), part, all.seconds(), shown(way.report.length, 6),
                        shown(kRoundedDown * way.report.audit.lowerClearance, 6), way.contacts});
    std::fprintf(stderr, "%s is out\n", part.c_str());
    assembly.there.erase(std::find(assembly.there.begin(), assembly.there.end(), part));
    assembly.out.push_back(part);
    all.held.erase(part);
    for (auto& [other, held] : all.held)  // which may come out now
        if (std::count(held.by.begin(), held.by.end(), part) > 0) held.seconds = 0;
    return true;
} catch (const std::exception& error) {
    const std::string words = error.what();
    all.held[part] = {seconds, {}, words.substr(0, words.find("; "))};
    return false;
}

/// Takes out what comes out: those that need the least time first, and small parts first. A part is tried again with more time, or once
/// something is out that held it. Unless the user says which parts stay, the largest one does for as long as another one comes out.
void takeApart(Assembly& assembly, double mostSeconds, Disassembly& all) {
    double seconds = std::min(kFirstSeconds, mostSeconds);
    while (!assembly.isApart()) {
        bool isAnyOut = false;
        const std::vector<std::string> parts = assembly.there;
        for (const std::string& part : parts) {
            if (isStopped) return;
            if (assembly.parts.at(part).stays) break;
            if (part == parts.back() && (isAnyOut || assembly.isApart())) break;
            const auto held = all.held.find(part);
            if (held != all.held.end() && held->second.seconds >= seconds) continue;
            isAnyOut |= moveOut(assembly, part, seconds, all);
        }
        if (!isAnyOut && seconds >= mostSeconds) return;
        seconds = std::min(isAnyOut ? kFirstSeconds : kLonger * seconds, mostSeconds);
    }
}

/// Adds a row for each part that is still there.
void addRest(const Assembly& assembly, Disassembly& all) {
    for (const std::string& part : assembly.there) {
        const auto held = all.held.find(part);
        const bool stays = assembly.isApart() || assembly.parts.at(part).stays;
        all.rows.push_back({"", part, "", "", "",
                            stays                    ? "stays"
                            : held == all.held.end() ? "not tried"
                                                     : held->second.words});
    }
}

/// Prints the rows, and writes them for other programs.
void tell(const std::vector<Row>& rows, const std::string& file) {
    std::array<std::size_t, std::tuple_size_v<Row>> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size() + 2);
    std::ofstream csv(file);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::cout << std::left << std::setw(static_cast<int>(widths[i])) << row[i];
            csv << (i == 0 ? "" : ",") << std::quoted(row[i], '"', '"');
        }
        std::cout << "\n";
        csv << "\n";
    }
    if (!csv.flush()) throw std::runtime_error("cannot write '" + file + "'");
}

/// Removes what an earlier run left, so that the folder holds one order.
void clear(const std::string& folder) {
    std::filesystem::create_directories(folder);
    const std::regex ours(R"(\d{3,}_.*\.(cfg|path)|disassembly\.(glb|csv))");
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (std::regex_match(entry.path().filename().string(), ours)) old.push_back(entry.path());
    for (const std::filesystem::path& file : old) std::filesystem::remove(file);
}

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (std::count(words.begin(), words.end(), "--help") > 0)
        return std::cout << kUsage << std::flush ? 0 : 2;
    if (argc < 3) throw std::invalid_argument("expected ASSEMBLY OUT [SECONDS [NAME...]]; --help says more");
    char* end = nullptr;
    const double most = argc > 3 ? std::strtod(argv[3], &end) : 20;
    if (!(most > 0 && most < 1e6) || (end && *end != 0))
        throw std::invalid_argument("SECONDS is '" + words[2] + "', expected a number above 0");
    std::error_code isGone;
    if (std::filesystem::equivalent(argv[1], argv[2], isGone))
        throw std::invalid_argument("OUT is the folder of the assembly, expected another one");
    Disassembly all{words[1]};
    Assembly assembly(words[0], {words.begin() + std::min(argc - 1, 3), words.end()});
    clear(all.folder);
    std::signal(SIGINT, [](int) { isStopped = 1; });  // ends the search; what is out stays
    takeApart(assembly, most, all);
    addRest(assembly, all);
    tell(all.rows, all.folder + "/disassembly.csv");
    std::cout << all.moves.size() << " of " << assembly.parts.size()
              << " parts came out one after the other, in " << all.seconds() << " s\n";
    const clearway::Problem& whole = assembly.whole;
    if (whole.deflection > 0)
        std::cout << "certified for these triangles; the surfaces may be up to 2 x "
                  << shown(whole.deflection) << " closer\n";
    saveAnimation(assembly.remaining(), all.moves, metresPerUnit(whole).value_or(1),
                  all.folder + "/disassembly.glb");
    return assembly.isApart() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "disassemble: " << error.what() << "\n";
    return 2;
}
