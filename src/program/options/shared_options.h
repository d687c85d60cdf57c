// Options that several subcommands share, and their values: the problem, how to check motions and build
// trees, the files to write.
#pragma once

#include <cstdint>
#include <map>
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

/// Calls loadMeshes behind the load guard.
SceneMeshes guardedLoadMeshes(const Problem& problem);

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

/// How to build models, and the folder that keeps them and shrunk parts (empty: none).
struct TreeChoice {
    BuildOptions options;
    std::string cache;

    /// Builds the mesh's model with these options or others, or takes it from the cache. Replaces a file there that
    /// cannot be used, with a warning on stderr. Goes on without a cache that cannot be written, with one warning.
    Model build(const Mesh& mesh, const BuildOptions& others,
                const std::optional<QueryRange>& range = std::nullopt) const;

    /// Calls clearway::shrink, or takes its result from the cache as build() does.
    ShrunkPart shrink(const Mesh& mesh, const ShrinkOptions& shrinkOptions) const;
};

/// How the program shrinks: a line counts the seconds, and Ctrl-C stops it where heedInterrupts() was called: loadScene then throws
/// ShrinkStopped.
SceneLoading interruptibleLoading(const TreeChoice& trees = {});

/// The meshes of a problem, each file read once, and scenes of them. A scene takes over the models that it shares with the scene
/// made before it.
class ProblemScenes {
  public:
    /// Reads the problem's files, behind the load guard.
    ProblemScenes(const Problem& problem, TreeChoice trees);

    const SceneMeshes& meshes() const { return meshes_; }

    /// Makes the scene of the problem, or of one that differs in its rules, with a range that suffices for planning with these
    /// options.
    LoadedScene sceneWithNotes(const Problem& problem, const planning::PlanOptions& plan = {});

    /// The scene alone. Prints its notes as warnings.
    Scene scene(const Problem& problem, const planning::PlanOptions& plan = {});

    /// The scene of all of the meshes, however far from the part they are.
    Scene wholeScene(const Problem& problem);

    /// Seconds that shrinking took for the last scene.
    double shrinkSeconds() const { return shrinkSeconds_; }

    /// The model of a mesh, taken from the last scene if it is there.
    Model modelOf(const Mesh& mesh, const std::optional<QueryRange>& range) const;

  private:
    LoadedScene load(const Problem& problem, SceneLoading loading);
    Model modelOf(const Mesh& mesh, const BuildOptions& options,
                  const std::optional<QueryRange>& range) const;

    TreeChoice trees_;
    SceneMeshes meshes_;
    double shrinkSeconds_ = 0;
    std::map<std::uint64_t, Model> last_;  ///< the last scene's models by their keys
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
