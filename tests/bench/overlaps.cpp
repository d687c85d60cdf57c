// Times how long shrinking takes, and makes the problems of touching parts for the part `touching` of `run`.
//   benchmarks overlaps shrink PART SHARE REPETITIONS OUT.csv NAME      PART: a mesh file, NAME: of the row
//   benchmarks overlaps problems FOLDER                                 writes the problems and prints their names
// SHARE is the overlap over the part's diagonal. Ends with exit code 1 if a point of the shrunk surface is deeper than the overlap.
#include <algorithm>
#include <iostream>

#include "bench/series.h"
#include "clearway/shrink.h"
#include "core/clock.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "mesh/components.h"
#include "shrink/nearest_triangle.h"
#include "support/assembled_problems.h"
#include "support/random_meshes.h"

namespace clearway::testing::overlaps {

constexpr int kSamples = 20000;  ///< points of the shrunk surface, by area
constexpr double kShallow =
    0.5;  ///< of the overlap: where no obstacle may be so deep, the surface counts as shallow
constexpr double kRounding = 1 + 1e-9;

constexpr const char* kHeader =
    "part,triangles,overlap_over_diagonal,repetitions,seconds,triangles_shrunk,thin_places,share_shallow,"
    "deepest_over_overlap\n";

struct Depths {
    double deepest = 0;  ///< over the overlap
    double shallow = 0;  ///< share of the area
};

Depths depthsOf(const Mesh& part, const ShrunkPart& shrunk) {
    NearestTriangle nearest(Model::build(part));
    std::vector<double> areaUpTo;
    double area = 0;
    const auto corner = [&](std::size_t t, int k) {
        return shrunk.mesh.vertices[shrunk.mesh.triangles[t][k]];
    };
    for (std::size_t t = 0; t < shrunk.mesh.triangles.size(); ++t) {
        area += (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
        areaUpTo.push_back(area);
    }
    Random random(1);
    Depths depths;
    for (int n = 0; n < kSamples; ++n) {
        const auto t =
            std::size_t(std::lower_bound(areaUpTo.begin(), areaUpTo.end() - 1, random.uniform(0, area)) -
                        areaUpTo.begin());
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vector3 point = (1 - u - v) * corner(t, 0) + u * corner(t, 1) + v * corner(t, 2);
        const double depth = nearest.of(point).distance / shrunk.options.overlap;
        depths.deepest = std::max(depths.deepest, depth);
        depths.shallow += (depth < kShallow) / double(kSamples);
    }
    return depths;
}

int shrinkAndTell(const std::string& file, double share, int repetitions, const std::string& out,
                  const std::string& name) {
    const Mesh part = loadMesh(file);
    const ShrinkOptions options{share * boundingBox(part).diagonal().norm()};
    std::vector<double> seconds;
    ShrunkPart shrunk;
    for (int n = 0; n < repetitions; ++n) {
        const auto begin = Clock::now();
        shrunk = shrink(part, options);
        seconds.push_back(secondsSince(begin));
    }
    const Depths depths = depthsOf(part, shrunk);
    std::string row = kHeader + name + "," + std::to_string(part.triangles.size());
    for (const double value :
         {share, double(repetitions), median(seconds), double(shrunk.mesh.triangles.size()),
          double(shrunk.thin.count), depths.shallow, depths.deepest})
        row += "," + shortNumber(value);
    row += "\n";
    std::cout << row;
    replaceFile(out, [&](std::ostream& to) { to << row; });
    return depths.deepest <= kRounding ? 0 : 1;
}

int writeProblems(const std::vector<AssembledProblem>& problems, const std::string& folder) {
    for (const AssembledProblem& problem : problems) {
        writeAssembledProblem(problem, folder);
        std::cout << problem.name << '\n';
    }
    return 0;
}

int run(int count, char** words) {
    const std::string what = count > 1 ? words[1] : "";
    if (what == "problems" && count == 3) return writeProblems(touchingProblems(), words[2]);
    if (what == "tight" && count == 3) {
        std::vector<AssembledProblem> problems = tightProblems();
        problems.push_back(screwAndNut({180, 14, 7, 3}, 0));
        problems.back().name = "m12_on_axis";
        problems.push_back(screwAndNut({180, 14, 7, 3}, 30));
        problems.back().name = "m12";
        problems.push_back(screwAndNut({24, 5.25, 7, 1, true}, 0));
        problems.push_back(screwAndNut({24, 14, 7}, 0));
        return writeProblems(problems, words[2]);
    }
    if (what == "shrink" && count == 7)
        return shrinkAndTell(words[2], std::stod(words[3]), std::stoi(words[4]), words[5], words[6]);
    std::cerr << "usage: benchmarks overlaps shrink PART SHARE REPETITIONS OUT.csv NAME\n"
                 "       benchmarks overlaps problems FOLDER\n";
    return 2;
}

}  // namespace clearway::testing::overlaps
