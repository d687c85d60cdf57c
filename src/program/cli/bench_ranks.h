// `bench` under mpirun: its runs are handed out to all ranks, and each is a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "program/bench/benchmark.h"
#include "program/bench/kept_runs.h"
#include "program/bench/ranks.h"
#include "program/options/command_line.h"

namespace clearway::cli {

/// Calls `run`, whose exit code it returns: with the processes that mpirun or srun started together with this one, or with null
/// when this one was started alone. Of several processes one alone calls `run`; the others do what it hands out.
int runOnRanks(const std::function<int(study::Ranks*)>& run);

/// Declares --one-run, by which the processes know which run is theirs.
void addOneRun(CommandLine& commandLine, std::optional<std::size_t>& run);

/// For a process that does one run: prints the run's text, and writes no facts. Returns the exit code.
int tellRun(const std::string& text);

struct LostRun {
    std::string name;  ///< "RRTConnect, seed 3"
    std::string end;   ///< how its process ended
};

/// Does the runs of one benchmark. Those that end are kept in the folder LOG.runs, and not repeated.
class BenchmarkOnRanks {
  public:
    /// words: those of the command line after `bench`. files: the problem's. Throws as study::KeptRuns does.
    BenchmarkOnRanks(study::Ranks& ranks, Arguments words, const std::string& log,
                     const std::vector<std::string>& files);

    /// See study::BenchmarkOptions::doRuns. Throws std::runtime_error when a run cannot be kept or is not one.
    bool doRuns(study::Benchmark& benchmark);

    /// The runs whose processes crashed or were killed.
    const std::vector<LostRun>& lost() const { return lost_; }

    /// When the log is written: forgets the runs unless some are missing.
    void finish(bool isComplete) const;

  private:
    study::Ranks& ranks_;
    Arguments words_;
    study::KeptRuns kept_;
    std::vector<LostRun> lost_;
};

}  // namespace clearway::cli
