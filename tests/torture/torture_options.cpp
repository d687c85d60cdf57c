#include "torture/torture_options.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"
#include "torture/mesh_families.h"
#include "torture/pair_families.h"

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
    add("help", "print this");
    add("pairs", options::value<std::int64_t>(), "of triangles, over all families");
    add("poses", options::value<std::int64_t>(), "of meshes, over all families");
    add("minutes", options::value<double>()->default_value(3), "when neither is given");
    add("seed", options::value<std::uint64_t>()->default_value(1), "of everything drawn");
    add("families", options::value<std::string>(), "of pairs or meshes, instead of all");
    add("without-fcl", "does not ask FCL");
    add("csv", options::value<std::string>(), "file for the figures");
    add("resting", "measures what resting contact costs `collides`, instead");
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

}  // namespace

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

}  // namespace clearway::testing
