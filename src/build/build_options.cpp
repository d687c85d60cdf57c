// The tables' names, and the check of options against them.
#include "clearway/build_options.h"

#include <algorithm>
#include <stdexcept>

#include "build/fits.h"
#include "build/general_splits.h"
#include "build/leaf_splits.h"

namespace clearway {

namespace {

constexpr int kLargestLeaf = 16;

constexpr int kMostThreads = 1024;

struct NamedPreset {
    const char* name;
    BuildOptions (*options)();
};

BuildOptions fastBuild() {
    BuildOptions options;
    options.generalSplit = "embree";
    return options;
}

constexpr NamedPreset kPresets[] = {
    {"best", [] { return BuildOptions(); }},
    {"fast", fastBuild},
};

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

template <class Row, std::size_t kRows>
std::vector<std::string> namesOf(const Row (&table)[kRows]) {
    std::vector<std::string> names;
    for (const Row& row : table) names.emplace_back(row.name);
    return names;
}

template <class Row, std::size_t kRows>
const Row& rowNamed(const Row (&table)[kRows], const std::string& option, const std::string& name) {
    for (const Row& row : table) {
        if (name == row.name) return row;
    }
    throw std::invalid_argument(option + " is \"" + name + "\", expected one of: " + joined(namesOf(table)));
}

}  // namespace

std::vector<std::string> buildPresetNames() {
    return namesOf(kPresets);
}

std::vector<std::string> generalSplitNames() {
    return namesOf(kGeneralSplits);
}

std::vector<std::string> leafSplitNames() {
    return namesOf(kLeafSplits);
}

std::vector<std::string> fitNames() {
    return namesOf(kFits);
}

std::vector<int> nodeWidths() {
    return {8, 2};
}

const NamedGeneralSplit& generalSplitNamed(const std::string& name) {
    return rowNamed(kGeneralSplits, "generalSplit", name);
}

const NamedLeafSplit& leafSplitNamed(const std::string& name) {
    return rowNamed(kLeafSplits, "leafSplit", name);
}

const NamedFit& fitNamed(const std::string& name) {
    return rowNamed(kFits, "fit", name);
}

BuildOptions buildPreset(const std::string& name) {
    return rowNamed(kPresets, "preset", name).options();
}

void requireBuildOptions(const BuildOptions& options) {
    generalSplitNamed(options.generalSplit);
    leafSplitNamed(options.leafSplit);
    fitNamed(options.fit);
    if (options.leafSize < 1 || options.leafSize > kLargestLeaf) {
        throw std::invalid_argument("leafSize is " + std::to_string(options.leafSize) + ", expected 1 to " +
                                    std::to_string(kLargestLeaf));
    }
    if (options.threads < 0 || options.threads > kMostThreads) {
        throw std::invalid_argument("threads is " + std::to_string(options.threads) + ", expected 0 to " +
                                    std::to_string(kMostThreads));
    }
    const std::vector<int> widths = nodeWidths();
    if (std::find(widths.begin(), widths.end(), options.nodeWidth) == widths.end()) {
        std::vector<std::string> known;
        for (const int width : widths) known.push_back(std::to_string(width));
        throw std::invalid_argument("nodeWidth is " + std::to_string(options.nodeWidth) +
                                    ", expected one of: " + joined(known));
    }
}

}  // namespace clearway
