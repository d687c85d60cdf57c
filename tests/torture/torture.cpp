// The torture program: checks the queries' answers in exact arithmetic, on families of hard pairs of
// triangles and of hard poses of small meshes. Ends with 1 if a promise of include/clearway/query.h is
// broken.
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>

#include "core/replace_file.h"
#include "program/options/command_line.h"
#include "torture/mesh_families.h"
#include "torture/pair_families.h"
#include "torture/resting.h"
#include "torture/runs.h"

namespace clearway::testing {
namespace {

using cli::integer;

constexpr double kDefaultMinutes = 3;

/// The families in a list with commas.
std::vector<std::string> familiesOf(const std::string& list) {
    std::vector<std::string> known, names;
    for (const PairFamily& family : pairFamilies()) known.push_back(family.name);
    for (const MeshFamily& family : meshFamilies()) known.push_back(family.name);
    std::istringstream in(list);
    for (std::string name; std::getline(in, name, ',');) names.push_back(cli::oneOf(name, known));
    return names;
}

/// Reads the command line. Prints the help and returns nothing when it is asked for. Throws
/// std::invalid_argument that names a wrong option, its value and what was expected, and std::runtime_error
/// if the CSV cannot be written.
std::optional<TortureOptions> readOptions(int argc, char** argv) {
    TortureOptions result;
    std::optional<std::uint64_t> pairs, poses;
    double minutes = kDefaultMinutes;
    cli::CommandLine line("torture [options]", "Judges pairs and poses that are hard to answer truthfully.");
    line.option("--pairs N", "number of triangle pairs, over all families",
                integer<std::uint64_t>(pairs, 0, INT64_MAX));
    line.option("--poses N", "number of mesh poses, over all families",
                integer<std::uint64_t>(poses, 0, INT64_MAX));
    line.option("--minutes M", "run time, if neither --pairs nor --poses is given (3)",
                cli::positive(minutes));
    line.option("--seed N", "seed of all random draws (1)",
                integer<std::uint64_t>(result.seed, 0, INT64_MAX));
    line.option("--families NAMES", "comma-separated families of pairs or meshes, instead of all",
                [&](const std::string& list) { result.families = familiesOf(list); });
    line.option("--without-fcl", "does not ask FCL", [&](const std::string&) { result.withFcl = false; });
    line.option("--csv FILE", "file for the figures", [&](const std::string& file) {
        requireReplaceable(file);
        result.csv = file;
    });
    line.flag("--resting", "measures only the cost of resting contact for `collides`", result.resting);
    if (!line.parse({argv + 1, argv + argc})) return std::nullopt;
    result.pairs = pairs.value_or(0);
    result.poses = poses.value_or(0);
    if (!pairs && !poses) result.minutes = minutes;
    return result;
}

int run(const TortureOptions& given) {
    if (given.resting) {
        measureResting(std::cout, 200);
        return 0;
    }
    const std::vector<PairFigures> pairs = runPairs(given);
    const std::vector<MeshFigures> meshes = runMeshes(given);
    print(std::cout, pairs);
    print(std::cout, meshes);
    if (!given.csv.empty()) writeCsv(given.csv, pairs, meshes);
    std::uint64_t violations = 0;
    for (const PairFigures& figures : pairs) violations += figures.violations;
    for (const MeshFigures& figures : meshes) violations += figures.violations;
    std::cout << '\n' << violations << " violations, seed " << given.seed << '\n';
    return violations == 0 ? 0 : 1;
}

}  // namespace
}  // namespace clearway::testing

int main(int argc, char** argv) {
    try {
        const auto given = clearway::testing::readOptions(argc, argv);
        return given ? clearway::testing::run(*given) : 0;
    } catch (const std::exception& error) {
        std::cerr << "torture: " << error.what() << '\n';
        return 2;
    }
}
