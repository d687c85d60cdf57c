// demos/console.cpp PROBLEM.cfg OUT.path [SEED]: plans a part's way out of an assembly, then looks for one with as much clearance as
// possible, and writes the better one. Every motion of both is certified along its whole length.
#include <clearway/planning/plan.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace cp = clearway::planning;

constexpr double kSeconds = 3.5;  // for clearance: this console has no more to gain after about two

bool isFound(const cp::PlanReport& report) {
    return report.outcome == cp::PlanReport::Outcome::kFound;
}

void printPath(const char* title, const cp::PlanReport& report) {
    const cp::PathAudit& audit = report.audit;
    const cp::SegmentAudit& tight = audit.segments[audit.closest];
    std::printf("%s\n  after %.2f s, by %s: %zu motions, length %.0f, turned %.0f degrees\n", title,
                report.planningSeconds, report.foundBy.c_str(), audit.segments.size(), report.length,
                report.rotation * 180 / M_PI);
    std::printf("  clearance %.2f, certified", audit.lowerClearance);
    if (!tight.environmentMesh.empty())
        std::printf("; the tightest place is between '%s' and '%s', in motion %zu", tight.partMesh.c_str(),
                    tight.environmentMesh.c_str(), audit.closest + 1);
    std::printf("\n");
}

std::uint32_t seedFrom(const char* text) {
    char* end = nullptr;
    const long long seed = std::strtoll(text, &end, 10);
    if (end == text || *end != 0 || seed < 1 || seed > UINT32_MAX)
        throw std::invalid_argument("SEED is '" + std::string(text) + "', expected a whole number above 0");
    return static_cast<std::uint32_t>(seed);
}

int main(int argc, char** argv) try {
    if (argc != 3 && argc != 4) throw std::invalid_argument("expected PROBLEM.cfg OUT.path [SEED]");
    cp::PlanOptions options;
    if (argc == 4) options.seed = seedFrom(argv[3]);
    const clearway::Problem problem = clearway::readProblem(argv[1]);
    const clearway::Scene scene = clearway::loadScene(problem).scene;
    std::printf("part: %zu triangles\n", scene.part.report().triangles);
    for (const clearway::Obstacle& obstacle : scene.obstacles)  // one for each margin of the problem
        std::printf("environment: %zu triangles, margin %g\n", obstacle.model.report().triangles,
                    obstacle.margin);

    options.quick = true;  // leaves the path as short as it can be
    const cp::PlanReport first = cp::plan(problem, scene, options);
    if (!isFound(first)) {
        std::printf("no path found after %.0f s\n", first.planningSeconds);
        return 1;
    }
    printPath("the first path, shortened:", first);

    options.quick = false;
    options.objective = "max_min_clearance";
    options.seconds = kSeconds;
    const cp::PlanReport wide = cp::plan(problem, scene, options);
    const bool isWider = isFound(wide) && wide.audit.lowerClearance > first.audit.lowerClearance;
    if (isWider) printPath("the path with the most clearance:", wide);
    clearway::writePath((isWider ? wide : first).path, problem.space, argv[2]);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "console: " << error.what() << "\n";
    return 2;
}
