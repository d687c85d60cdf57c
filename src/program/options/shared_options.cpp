#include "program/options/shared_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <stdexcept>

#include "clearway/targets.h"
#include "core/clock.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "program/options/facts.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

/// A folder that keeps nothing is reported once, not for each obstacle.
void warnOfCache(const std::string& warning, bool isKept) {
    static std::atomic<bool> isReported{false};
    if (!warning.empty() && (isKept || !isReported.exchange(true))) printWarnings({warning});
}

}  // namespace

Problem readJudged(const std::string& file) {
    Problem problem = readProblem(file);
    for (const std::string& warning : planning::unknownNames(problem)) problem.warnings.push_back(warning);
    return problem;
}

SceneMeshes guardedLoadMeshes(const Problem& problem) {
    return loadMeshes(problem, guardedLoadMesh);
}

SceneLoading interruptibleLoading(const TreeChoice& trees) {
    SceneLoading loading;
    loading.shrink = [trees](const Mesh& mesh, ShrinkOptions options) {
        const ElapsedLine elapsed("shrinking by " + shownLength(options.overlap));
        options.isStopped = isInterrupted;
        return trees.shrink(mesh, options);
    };
    return loading;
}

Problem ProblemChoice::read() const {
    Problem problem = readJudged(file);
    problem.margin = margin.value_or(problem.margin);
    tellProblem(problem);
    return problem;
}

void addProblem(CommandLine& commandLine, ProblemChoice& choice) {
    commandLine.argument("PROBLEM.cfg", to(choice.file));
    commandLine.option(
        "--margin M",
        "distance to keep from the environment, in place of the problem's margin; its margin.NAME "
        "values stay",
        nonNegative(choice.margin));
}

void addOmplWeights(CommandLine& commandLine, bool& omplWeights) {
    commandLine.flag("--ompl-weights", "weights rotation as OMPL does, not by the part's radius",
                     omplWeights);
}

void addTarget(CommandLine& commandLine) {
    commandLine.option("--target NAME", "instruction set, one that this machine has (the best)", useTarget);
}

Model TreeChoice::build(const Mesh& mesh, const BuildOptions& others,
                        const std::optional<QueryRange>& range) const {
    if (cache.empty()) return Model::build(mesh, others, range);
    CachedModel cached = buildCached(mesh, others, cache, range);
    warnOfCache(cached.warning, cached.isKept);
    return std::move(cached.model);
}

ShrunkPart TreeChoice::shrink(const Mesh& mesh, const ShrinkOptions& shrinkOptions) const {
    if (cache.empty()) return clearway::shrink(mesh, shrinkOptions);
    CachedShrunkPart cached = shrinkCached(mesh, shrinkOptions, cache);
    warnOfCache(cached.warning, cached.isKept);
    return std::move(cached.part);
}

ProblemScenes::ProblemScenes(const Problem& problem, TreeChoice trees)
    : trees_(std::move(trees)), meshes_(guardedLoadMeshes(problem)) {}

LoadedScene ProblemScenes::sceneWithNotes(const Problem& problem, const planning::PlanOptions& plan) {
    SceneLoading loading = interruptibleLoading(trees_);
    loading.range = [&](const Model& part, const Box& environmentBox) {
        return planning::planningRange(problem, plan, part, environmentBox);
    };
    return load(problem, std::move(loading));
}

Scene ProblemScenes::scene(const Problem& problem, const planning::PlanOptions& plan) {
    LoadedScene loaded = sceneWithNotes(problem, plan);
    printWarnings(loaded.notes);
    return std::move(loaded.scene);
}

Scene ProblemScenes::wholeScene(const Problem& problem) {
    return load(problem, interruptibleLoading(trees_)).scene;
}

Model ProblemScenes::modelOf(const Mesh& mesh, const std::optional<QueryRange>& range) const {
    return modelOf(mesh, trees_.options, range);
}

Model ProblemScenes::modelOf(const Mesh& mesh, const BuildOptions& options,
                             const std::optional<QueryRange>& range) const {
    if (last_.empty()) return trees_.build(mesh, options, range);
    const auto known = last_.find(modelKey(mesh, options, range));
    return known != last_.end() ? known->second : trees_.build(mesh, options, range);
}

LoadedScene ProblemScenes::load(const Problem& problem, SceneLoading loading) {
    std::map<std::uint64_t, Model> models;
    loading.build = [&](const Mesh& mesh, const BuildOptions& options,
                        const std::optional<QueryRange>& range) {
        const Model model = modelOf(mesh, options, range);
        models.emplace(model.key(), model);
        return model;
    };
    shrinkSeconds_ = 0;
    loading.shrink = [&, shrink = loading.shrink](const Mesh& mesh, const ShrinkOptions& options) {
        const Clock::time_point begin = Clock::now();
        ShrunkPart shrunk = shrink(mesh, options);
        shrinkSeconds_ += secondsSince(begin);
        return shrunk;
    };
    LoadedScene loaded = buildScene(problem, meshes_, trees_.options, loading);
    last_ = std::move(models);
    return loaded;
}

void addTreeOptions(CommandLine& commandLine, BuildOptions& options) {
    const BuildOptions defaults;
    const auto choice = [&](const char* declaration, const char* about, const std::vector<std::string>& names,
                            const std::string& usual, const std::function<void(const std::string&)>& store) {
        commandLine.option(declaration, std::string(about) + ": " + joined(names) + " (" + usual + ")",
                           [names, store](const std::string& value) { store(oneOf(value, names)); });
    };
    commandLine.option(
        "--preset NAME", "best, or fast, which is deprecated and means the same",
        [](const std::string& value) {
            if (oneOf(value, {"best", "fast"}) == "fast")
                printWarnings({"--preset fast: means best, and will be refused from version 0.4 on"});
        });
    choice("--general-split NAME", "how nodes are split", generalSplitNames(), defaults.generalSplit,
           to(options.generalSplit));
    choice("--leaf-split NAME", "how leaves are split", leafSplitNames(), defaults.leafSplit,
           to(options.leafSplit));
    choice("--fit NAME", "how volumes are fitted", fitNames(), defaults.fit, to(options.fit));
    commandLine.option("--leaf-size N",
                       "most triangles in a leaf, 1 to 16 (" + std::to_string(defaults.leafSize) + ")",
                       integer<int>(options.leafSize, 1, kLargestLeafSize));
    std::vector<std::string> widths;
    for (const int width : nodeWidths()) widths.push_back(std::to_string(width));
    choice("--node-width N", "children of a node", widths, std::to_string(defaults.nodeWidth),
           [&](const std::string& width) { options.nodeWidth = std::stoi(width); });
}

std::string treeDescription(const BuildOptions& options) {
    return fmt::format("{}, fitted by {}, leaves of up to {} split by {}, {} wide", options.generalSplit,
                       options.fit, options.leafSize, options.leafSplit, options.nodeWidth);
}

void addCache(CommandLine& commandLine, TreeChoice& choice) {
    commandLine.option(
        "--cache DIR",
        "keeps built trees and shrunk parts in this folder and takes them from there the next time",
        [&choice](const std::string& value) {
            std::error_code failed;
            std::filesystem::create_directories(value, failed);
            if (failed) throw Expected{"a folder that exists or can be made"};
            choice.cache = value;
        });
}

std::vector<std::string> inputsOf(const Problem& problem) {
    std::vector<std::string> files = worldFiles(problem);
    files.push_back(problem.file);
    files.push_back(problem.meshes.robot);
    return files;
}

void OutputFiles::addOrStandardOutput(const std::string& option, const std::string& file) {
    if (file == "-") return claimStandardOutput(option);
    add(option, file);
}

void OutputFiles::add(const std::string& option, const std::string& file,
                      const std::vector<std::string>& endings) {
    if (file.empty()) return;
    if (file == "-") throw std::invalid_argument(option + " is '-', expected the name of a file");
    const auto refuse = [&](const std::string& taken) {
        throw std::invalid_argument(option + " is '" + file + "', " + taken + ", expected another file");
    };
    for (const std::string& input : inputs_) {
        if (isSameFile(file, input)) refuse("the input file '" + input + "'");
    }
    for (const Output& output : outputs_) {
        if (isSameFile(file, output.file)) refuse("which is also the file of " + output.option);
    }
    const std::string ending = boost::to_lower_copy(std::filesystem::path(file).extension().string());
    if (!endings.empty() && std::find(endings.begin(), endings.end(), ending) == endings.end())
        throw std::invalid_argument(option + " is '" + file + "', expected a name that ends in " +
                                    joined(endings, " or "));
    requireReplaceable(file);
    outputs_.push_back({option, file});
}

}  // namespace clearway::cli
