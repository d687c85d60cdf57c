#include "program/cli/bench_ranks.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "core/clock.h"
#include "core/hash.h"
#include "core/text.h"
#include "program/bench/child_process.h"
#include "program/bench/hand_out.h"
#include "program/bench/run_text.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

using study::Benchmark;
using study::BenchmarkRun;
using study::JobEnd;
using study::RunPlace;

study::Settings settingsFor(const Arguments& words, const std::vector<std::string>& files) {
    Hash hash;
    for (const std::string& file : files) {
        std::ifstream in(file, std::ios::binary);
        hash.add(std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>()));
    }
    return {{"command", joined(words, " ")}, {"files", std::to_string(hash.value())}};
}

study::Job jobFor(std::size_t run, const std::string& name, const Arguments& words) {
    study::Job job{name, {"bench", "--one-run", std::to_string(run)}};
    job.words.insert(job.words.end(), words.begin(), words.end());
    return job;
}

std::size_t countOf(const Benchmark& benchmark) {
    return benchmark.planners.size() * static_cast<std::size_t>(benchmark.options.runs);
}

std::string nameOf(std::size_t run, const Benchmark& benchmark) {
    const RunPlace place = placeOf(run, benchmark.options);
    return benchmark.planners[place.planner].name + ", seed " +
           std::to_string(seedOf(place.run, benchmark.options));
}

void addWarnings(const std::vector<std::string>& more, Benchmark& benchmark) {
    std::vector<std::string>& all = benchmark.warnings;
    for (const std::string& warning : more) {
        if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
    }
}

/// A run that was kept. Empty when there is none, or when the machine went down before its file was on the disk.
std::optional<study::ToldRun> readKept(const study::KeptRuns& kept, std::size_t run) {
    const auto text = kept.read(run);
    if (!text) return std::nullopt;
    try {
        return study::readToldRun(*text, "a run");
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

/// Tells of the runs that begin, and about how long the rest will take.
class Progress {
  public:
    Progress(const Benchmark& benchmark, std::size_t left, int ranks)
        : benchmark_(benchmark), left_(left), ranks_(ranks), begin_(Clock::now()) {}

    void tellBegin(std::size_t run) const {
        if (!benchmark_.options.tell) return;
        const double elapsed = secondsSince(begin_);
        const double each =
            ended_ > 0 ? elapsed / static_cast<double>(ended_) : benchmark_.options.secondsLimit() / ranks_;
        benchmark_.options.tell({benchmark_.planners[placeOf(run, benchmark_.options).planner].name,
                                 static_cast<int>(run), static_cast<int>(countOf(benchmark_)),
                                 each * static_cast<double>(left_ - ended_)});
    }
    void end() { ++ended_; }

  private:
    const Benchmark& benchmark_;
    std::size_t left_, ended_ = 0;
    int ranks_;
    Clock::time_point begin_;
};

}  // namespace

int runOnRanks(const std::function<int(study::Ranks*)>& run) {
    if (!study::isRank()) return run(nullptr);
    study::Ranks ranks;
    if (ranks.rank() > 0) {
        heedInterrupts();
        study::serve(ranks, isInterrupted);
        return kDone;
    }
    const int code = run(&ranks);
    study::dismiss(ranks);
    return code;
}

void addOneRun(CommandLine& commandLine, std::optional<std::size_t>& run) {
    commandLine.option("--one-run K",
                       "for the processes that this one starts under mpirun: does the run K, counted from 0, "
                       "and prints it for the process that started this one",
                       integer<std::size_t>(run, 0, INT64_MAX));
}

int tellRun(const std::string& text) {
    dropFacts();
    std::cout << text;
    requirePrinted();
    return kDone;
}

BenchmarkOnRanks::BenchmarkOnRanks(study::Ranks& ranks, Arguments words, const std::string& log,
                                   const std::vector<std::string>& files)
    : ranks_(ranks), words_(std::move(words)), kept_(log + ".runs", settingsFor(words_, files)) {}

bool BenchmarkOnRanks::doRuns(Benchmark& benchmark) {
    std::vector<std::optional<BenchmarkRun>> all(countOf(benchmark));
    const auto take = [&](std::size_t run, study::ToldRun told) {
        all[run] = std::move(told.run);
        addWarnings(told.warnings, benchmark);
    };
    std::vector<std::size_t> left;
    std::vector<study::Job> jobs;
    for (std::size_t run = 0; run < all.size(); ++run) {
        if (auto told = readKept(kept_, run)) {
            take(run, std::move(*told));
        } else {
            left.push_back(run);
            jobs.push_back(jobFor(run, nameOf(run, benchmark), words_));
        }
    }

    Progress progress(benchmark, left.size(), ranks_.count());
    study::Meanwhile meanwhile;
    meanwhile.isStopped = isInterrupted;
    meanwhile.begin = [&](std::size_t job, int) { progress.tellBegin(left[job]); };
    meanwhile.end = [&](const JobEnd& end) {
        const std::size_t run = left[end.job];
        progress.end();
        if (end.isDone) {
            take(run, study::readToldRun(end.text, jobs[end.job].name));
            kept_.keep(run, end.text);
        } else {
            all[run] = study::lostRun(seedOf(placeOf(run, benchmark.options).run, benchmark.options));
            lost_.push_back({jobs[end.job].name, end.text});
        }
    };
    const bool isComplete = handOut(ranks_, jobs, meanwhile);
    for (std::size_t run = 0; run < all.size(); ++run) {
        if (all[run])
            benchmark.planners[placeOf(run, benchmark.options).planner].runs.push_back(std::move(*all[run]));
    }
    return isComplete && lost_.empty();
}

void BenchmarkOnRanks::finish(bool isComplete) const {
    if (isComplete) kept_.remove();
}

}  // namespace clearway::cli
