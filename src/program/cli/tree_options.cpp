#include "program/cli/tree_options.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace clearway::cli {

namespace {

constexpr int kLargestLeaf = 16;  // triangles; requireBuildOptions refuses more

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

std::vector<std::string> widthNames() {
    std::vector<std::string> names;
    for (const int width : nodeWidths()) names.push_back(std::to_string(width));
    return names;
}

std::string oneOf(const Options& options, const std::string& name, const std::vector<std::string>& known) {
    const std::string value = options.text(name);
    if (std::find(known.begin(), known.end(), value) == known.end()) {
        throw std::invalid_argument("--" + name + " is '" + value + "', expected one of " + joined(known));
    }
    return value;
}

}  // namespace

void addTreeOptions(CommandLine& commandLine) {
    const BuildOptions defaults;
    commandLine.options.add_options()  //
        ("preset", optionValue("NAME"),
         ("the options to start from: " + joined(buildPresetNames()) + " (best)").c_str())  //
        ("general-split", optionValue("NAME"),
         ("how nodes are split: " + joined(generalSplitNames()) + " (" + defaults.generalSplit + ")")
             .c_str())  //
        ("leaf-split", optionValue("NAME"),
         ("how leaves are split: " + joined(leafSplitNames()) + " (" + defaults.leafSplit + ")").c_str())  //
        ("fit", optionValue("NAME"),
         ("how volumes are fitted: " + joined(fitNames()) + " (" + defaults.fit + ")").c_str())  //
        ("leaf-size", optionValue("N"),
         ("most triangles in a leaf, 1 to 16 (" + std::to_string(defaults.leafSize) + ")").c_str())  //
        ("node-width", optionValue("N"),
         ("children of a node: " + joined(widthNames()) + " (" + std::to_string(defaults.nodeWidth) + ")")
             .c_str());
}

BuildOptions treeOptions(const Options& options) {
    BuildOptions chosen;
    if (options.has("preset")) chosen = buildPreset(oneOf(options, "preset", buildPresetNames()));
    if (options.has("general-split"))
        chosen.generalSplit = oneOf(options, "general-split", generalSplitNames());
    if (options.has("leaf-split")) chosen.leafSplit = oneOf(options, "leaf-split", leafSplitNames());
    if (options.has("fit")) chosen.fit = oneOf(options, "fit", fitNames());
    if (options.has("leaf-size"))
        chosen.leafSize = static_cast<int>(options.integer("leaf-size", 1, kLargestLeaf));
    if (options.has("node-width")) chosen.nodeWidth = std::stoi(oneOf(options, "node-width", widthNames()));
    return chosen;
}

void addCacheOption(CommandLine& commandLine) {
    commandLine.options.add_options()  //
        ("cache", optionValue("DIR"),
         "keeps built trees in this folder and takes them from there the next time");
}

std::string cacheFolder(const Options& options) {
    if (!options.has("cache")) return "";
    const std::string folder = options.text("cache");
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (!std::filesystem::is_directory(folder)) {
        throw std::runtime_error("--cache is '" + folder + "', expected a folder that exists or can be made");
    }
    return folder;
}

Model buildModel(const Mesh& mesh, const BuildOptions& options, const std::string& cacheFolder,
                 const std::optional<Reach>& reach) {
    if (cacheFolder.empty()) return Model::build(mesh, options, reach);
    const CachedModel cached = buildCached(mesh, options, cacheFolder, reach);
    if (!cached.warning.empty()) std::cerr << "clearway: warning: " << cached.warning << "\n";
    return cached.model;
}

std::string description(const BuildOptions& options) {
    return options.generalSplit + ", fitted by " + options.fit + ", leaves of up to " +
           std::to_string(options.leafSize) + " split by " + options.leafSplit + ", " +
           std::to_string(options.nodeWidth) + " wide";
}

}  // namespace clearway::cli
