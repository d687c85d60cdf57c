// Lists the names of the strategy tables and checks options against them.
#include "clearway/build_options.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>

#include "build/fit_volumes.h"
#include "build/general_splits.h"
#include "build/leaf_splits.h"
#include "clearway/errors.h"
#include "core/text.h"
#include "tree/flat_tree.h"

namespace clearway {

namespace {

constexpr int kMostThreads = 1024;

template <int... kWidths>
std::vector<int> widestFirst(std::integer_sequence<int, kWidths...>) {
    std::vector<int> widths{kWidths...};
    std::sort(widths.begin(), widths.end(), std::greater<>());
    return widths;
}

}  // namespace

std::vector<std::string> buildPresetNames() {
    return {"best", "fast"};
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
    return widestFirst(NodeWidths());
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
    if (name != "best" && name != "fast")
        throw ArgumentError(fmt::format("preset is '{}', expected one of best, fast", name));
    return {};
}

void requireBuildOptions(const BuildOptions& options) {
    generalSplitNamed(options.generalSplit);
    leafSplitNamed(options.leafSplit);
    fitNamed(options.fit);
    if (options.leafSize < 1 || options.leafSize > kLargestLeafSize) {
        throw ArgumentError(
            fmt::format("leafSize is {}, expected 1 to {}", options.leafSize, kLargestLeafSize));
    }
    if (options.threads < 0 || options.threads > kMostThreads) {
        throw ArgumentError(fmt::format("threads is {}, expected 0 to {}", options.threads, kMostThreads));
    }
    withNodeWidth(options.nodeWidth, [](auto) {});
}

}  // namespace clearway
