// Options of several subcommands, and what they choose: the problem, how motions and trees are made, the
// files to write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/cli/command_line.h"

namespace clearway::cli {

/// The problem file, and the margin that replaces the file's.
struct ProblemChoice {
    std::string file;
    std::optional<double> margin;

    /// Throws what readProblem throws.
    Problem read() const;
};

/// PROBLEM.cfg and --margin.
void addProblem(CommandLine& commandLine, ProblemChoice& to);

/// --step and --ompl-weights.
void addMotionOptions(CommandLine& commandLine, std::optional<double>& step, bool& omplWeights);

/// --target: an instruction set, in use from the time it is read.
void addTarget(CommandLine& commandLine);

/// How models are built, and the folder that keeps them; empty: none.
struct TreeChoice {
    BuildOptions options;
    std::string cache;

    /// Builds the mesh's model with these options, or takes it from the cache. Replaces a file there that
    /// cannot be used, with a warning on stderr.
    Model build(const Mesh& mesh) const;

    /// loadScene as the program calls it: behind the load guard, from the cache, and as far as planning with
    /// these options reaches. Prints the scene's notes as warnings.
    Scene load(const Problem& problem, const planning::PlanOptions& plan = {}) const;
};

/// --preset, --general-split, --leaf-split, --fit, --leaf-size and --node-width.
void addTreeOptions(CommandLine& commandLine, BuildOptions& to);

/// "sah, fitted by frames, leaves of up to 4 split by none, 8 wide".
std::string treeDescription(const BuildOptions& options);

/// --cache.
void addCache(CommandLine& commandLine, TreeChoice& to);

/// The files a problem is read from.
std::vector<std::string> inputsOf(const Problem& problem);

/// The files a subcommand is to write. No two may be one file, and none a file that is read.
class OutputFiles {
  public:
    explicit OutputFiles(std::vector<std::string> inputs) : inputs_(std::move(inputs)) {}

    /// Throws before long work when the option's file cannot be written or is another one's. Empty: no file.
    void add(const std::string& option, const std::string& file);

  private:
    struct Output {
        std::string option, file;
    };
    std::vector<std::string> inputs_;
    std::vector<Output> outputs_;
};

}  // namespace clearway::cli
