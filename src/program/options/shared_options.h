// Options that several subcommands share, and their values: the problem, how to check motions and build
// trees, the files to write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/options/command_line.h"

namespace clearway::cli {

/// Reads a problem file, and looks up the names in it that planning knows. Throws as readProblem and
/// planning::unknownNames do.
Problem readJudged(const std::string& file);

/// How the program loads scenes: behind the load guard, with a line that counts the seconds of shrinking, which Ctrl-C stops
/// where heedInterrupts() was called: loadScene then throws ShrinkStopped.
SceneLoading guardedLoading();

/// The problem file, and the margin that replaces the file's.
struct ProblemChoice {
    std::string file;
    std::optional<double> margin;

    /// Throws what readJudged throws.
    Problem read() const;
};

/// Declares PROBLEM.cfg and --margin.
void addProblem(CommandLine& commandLine, ProblemChoice& to);

/// Declares --ompl-weights.
void addOmplWeights(CommandLine& commandLine, bool& omplWeights);

/// Declares --target: an instruction set, in use as soon as it is read.
void addTarget(CommandLine& commandLine);

/// How to build models, and the folder that keeps them (empty: none).
struct TreeChoice {
    BuildOptions options;
    std::string cache;

    /// Builds the mesh's model with these options, or takes it from the cache. Replaces a file there that
    /// cannot be used, with a warning on stderr. Goes on without a cache that cannot be written, with one warning.
    Model build(const Mesh& mesh) const;

    /// The model with other options, and for a range.
    Model build(const Mesh& mesh, const BuildOptions& others, const std::optional<QueryRange>& range) const;

    /// Calls loadScene with the load guard, the cache, and a range that suffices for planning with these
    /// options.
    LoadedScene loadWithNotes(const Problem& problem, const planning::PlanOptions& plan) const;

    /// The scene alone. Prints its notes as warnings.
    Scene load(const Problem& problem, const planning::PlanOptions& plan = {}) const;
};

/// Declares --preset, --general-split, --leaf-split, --fit, --leaf-size and --node-width.
void addTreeOptions(CommandLine& commandLine, BuildOptions& to);

/// The options in words: "sah, fitted by frames, leaves of up to 4 split by none, 8 wide".
std::string treeDescription(const BuildOptions& options);

/// Declares --cache.
void addCache(CommandLine& commandLine, TreeChoice& to);

/// The files a problem is read from.
std::vector<std::string> inputsOf(const Problem& problem);

/// The files that a subcommand will write. Each must differ from the others and from all files that are read.
class OutputFiles {
  public:
    explicit OutputFiles(std::vector<std::string> inputs) : inputs_(std::move(inputs)) {}

    /// Adds an option's file. Throws before long work if the file cannot be written, is read, or is another
    /// option's file. An empty name adds no file. endings: those that the file may have; empty: any.
    void add(const std::string& option, const std::string& file,
             const std::vector<std::string>& endings = {});

    /// For files that writeOut() writes: the name `-` claims standard output.
    void addOrStandardOutput(const std::string& option, const std::string& file);

  private:
    struct Output {
        std::string option, file;
    };
    std::vector<std::string> inputs_;
    std::vector<Output> outputs_;
};

}  // namespace clearway::cli
