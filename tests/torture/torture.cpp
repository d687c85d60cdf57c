// The torture program: checks the queries' answers in exact arithmetic, on families of hard pairs of
// triangles and of hard poses of small meshes. Ends with 1 if a promise of include/clearway/query.h is
// broken.
#include <algorithm>
#include <boost/program_options.hpp>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"
#include "torture/mesh_families.h"
#include "torture/pair_families.h"
#include "torture/resting.h"
#include "torture/runs.h"

namespace clearway::testing {
namespace {

namespace options = boost::program_options;

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> words;
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

options::options_description allOptions() {
    options::options_description all("options");
    auto add = all.add_options();
    add("help", "print this help");
    add("pairs", options::value<std::int64_t>(), "number of triangle pairs, over all families");
    add("poses", options::value<std::int64_t>(), "number of mesh poses, over all families");
    add("minutes", options::value<double>()->default_value(3),
        "run time, if neither --pairs nor --poses is given");
    add("seed", options::value<std::uint64_t>()->default_value(1), "seed of all random draws");
    add("families", options::value<std::string>(),
        "comma-separated families of pairs or meshes, instead of all");
    add("without-fcl", "do not ask FCL");
    add("csv", options::value<std::string>(), "file for the figures");
    add("resting", "measure only the cost of resting contact for `collides`");
    return all;
}

std::uint64_t count(const options::variables_map& values, const char* name) {
    if (values.count(name) == 0) return 0;
    const auto given = values[name].as<std::int64_t>();
    if (given >= 0) return std::uint64_t(given);
    throw std::invalid_argument("--" + std::string(name) + " is " + std::to_string(given) +
                                ", expected a number of at least 0");
}

void requireKnown(const std::vector<std::string>& names) {
    std::string all;
    std::vector<std::string> known;
    for (const PairFamily& family : pairFamilies()) known.push_back(family.name);
    for (const MeshFamily& family : meshFamilies()) known.push_back(family.name);
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        throw std::invalid_argument("there is no family '" + name + "', expected one of " + all);
    }
}

/// Reads the command line. Returns nothing if help was asked for and printed. Throws std::invalid_argument if
/// a value is wrong, with the value and what was expected, and std::runtime_error if the CSV cannot be
/// written.
std::optional<TortureOptions> readOptions(int argc, char** argv) {
    options::variables_map values;
    options::store(options::parse_command_line(argc, argv, allOptions()), values);
    if (values.count("help") > 0) {
        std::cout << allOptions();
        return std::nullopt;
    }
    TortureOptions result;
    result.pairs = count(values, "pairs");
    result.poses = count(values, "poses");
    if (values.count("pairs") + values.count("poses") == 0) {
        result.minutes = values["minutes"].as<double>();
        if (!(result.minutes > 0)) {
            throw std::invalid_argument("--minutes is " + std::to_string(result.minutes) +
                                        ", expected more than 0");
        }
    }
    result.seed = values["seed"].as<std::uint64_t>();
    if (values.count("families") > 0) result.families = split(values["families"].as<std::string>());
    requireKnown(result.families);
    result.withFcl = values.count("without-fcl") == 0;
    result.resting = values.count("resting") > 0;
    if (values.count("csv") > 0) {
        result.csv = values["csv"].as<std::string>();
        requireReplaceable(result.csv);
    }
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
