// Judges and solves rigid-body problems that others published, found in a user's checkouts of their repositories
// (data/problems says which); this repository holds nothing of theirs.
//   benchmarks public CHECKOUTS OUT
// Every run is a process of its own. A run that stands in OUT's tables already is not repeated, so a benchmark that was
// stopped goes on where it was.
#include <sys/wait.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "bench/public/assembly_part.h"
#include "bench/public/checkouts.h"
#include "bench/public/contenders.h"
#include "bench/public/published_paths.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "program/bench/ranks.h"
#include "program/cli/run_on_ranks.h"
#include "program/options/command_line.h"

namespace clearway::testing::public_problems {
namespace {

namespace fs = std::filesystem;

constexpr int kSkipped = 77;  ///< the exit code that CTest takes for a skipped test

struct Choices {
    std::string checkouts, out, only, job;
    double seconds = 60, partSeconds = 20;
    std::uint32_t seeds = 10, contenderSeeds = 3, together = 2;
    study::Ranks* ranks = nullptr;  ///< null unless mpirun started this process
};

bool readChoices(int count, char** words, Choices& to) {
    cli::CommandLine line(
        "benchmarks public CHECKOUTS OUT [options]",
        "Audits, solves and compares problems that others published, read from your checkouts of their\n"
        "repositories. Writes paths.csv, invalid_segments.csv, runs.csv and parts.csv to OUT; a run that "
        "stands\n"
        "there already is not repeated. Under `mpirun -n N` each of N ranks does its share of the runs.");
    line.argument("CHECKOUTS", cli::to(to.checkouts));
    line.argument("OUT", cli::folder(to.out));
    line.option("--only TEXT", "takes only problems and assemblies with this in their names",
                cli::to(to.only));
    line.option("--seeds N", "clearway plans each problem with seeds 1 to N (10)",
                cli::integer<std::uint32_t>(to.seeds, 0, UINT32_MAX));
    line.option("--contender-seeds N", "the other planners do so with seeds 1 to N (3)",
                cli::integer<std::uint32_t>(to.contenderSeeds, 0, UINT32_MAX));
    line.option("--together N", "so many of these run at a time (2)",
                cli::integer<std::uint32_t>(to.together, 1, 1024));
    line.option("--time S", "seconds of each run (60)", cli::positive(to.seconds));
    line.option("--part-time S", "seconds for each part of an assembly; 0 leaves assemblies out (20)",
                cli::nonNegative(to.partSeconds));
    line.option("--job TEXT", "for the benchmark's own processes: does one run and prints its row",
                cli::to(to.job));
    return line.parse({words + 1, words + count});
}

/// A table that grows row by row. Rows are known by the words before the run's own columns.
class Table {
  public:
    Table(std::string file, const std::string& keyColumns, const std::string& columns)
        : file_(std::move(file)) {
        const std::string header = keyColumns + "," + columns;
        keyWords_ = 1 + static_cast<std::size_t>(std::count(keyColumns.begin(), keyColumns.end(), ','));
        if (!fs::exists(file_)) {
            replaceFile(file_, [&](std::ostream& out) { out << header << "\n"; });
            return;
        }
        const std::vector<std::string> lines = readLines(file_, "a table of this benchmark");
        if (lines.empty() || lines[0] != header)
            throw std::invalid_argument(file_ + ": its first line is " +
                                        quote(lines.empty() ? "" : lines[0]) + ", expected " + header);
        for (std::size_t i = 1; i < lines.size(); ++i) keys_.insert(keyOf(lines[i]));
    }

    bool has(const std::string& key) const { return keys_.count(key) > 0; }

    void append(const std::string& row) {
        std::ofstream out(file_, std::ios::app);
        if (!(out << row << "\n" << std::flush)) throw std::runtime_error(file_ + ": cannot be written");
        keys_.insert(keyOf(row));
    }

  private:
    std::string keyOf(const std::string& row) const {
        std::size_t end = 0;
        for (std::size_t i = 0; i < keyWords_ && end != std::string::npos; ++i)
            end = row.find(',', end + (i > 0));
        return row.substr(0, end);
    }

    std::string file_;
    std::size_t keyWords_ = 1;
    std::set<std::string> keys_;
};

/// The words for --job: "run," or "part," before the first words of the job's row.
using Job = std::string;

std::string keyOf(const Job& job) {
    return job.substr(job.find(',') + 1);
}

/// The last line of what a job's process printed.
std::string lastLine(std::string printed) {
    while (!printed.empty() && printed.back() == '\n') printed.pop_back();
    return printed.substr(printed.rfind('\n') + 1);
}

/// A row of empty columns that says how the job's process ended.
std::string lostRow(const Job& job, std::string end) {
    const std::string columns = job.rfind("run,", 0) == 0 ? kRunColumns : kPartColumns;
    std::replace(end.begin(), end.end(), ',', ';');
    return std::string(static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ',')), ',') +
           "the process ended: " + end;
}

/// Does the job in a process of its own and returns its row. The row of a process that crashes says so in place of its columns.
std::string rowOf(const Job& job, const Choices& choices) {
    std::string command = "exec", printed;
    for (const std::string& word : {fs::read_symlink("/proc/self/exe").string(), std::string("public"),
                                    choices.checkouts, choices.out, "--time=" + shortNumber(choices.seconds),
                                    "--part-time=" + shortNumber(choices.partSeconds), "--job=" + job})
        command += " '" + boost::replace_all_copy(word, "'", "'\\''") + "'";
    FILE* process = ::popen((command + " 2>&1 </dev/null").c_str(), "r");
    if (!process) throw std::runtime_error("no process can be started for " + job);
    char block[4096];
    while (const std::size_t size = std::fread(block, 1, sizeof block, process)) printed.append(block, size);
    const int status = ::pclose(process);
    const std::string last = lastLine(printed);
    if (status == 0) return keyOf(job) + "," + last;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGINT) throw std::runtime_error("interrupted");
    const std::string end = signal != 0 ? std::string("signal ") + ::strsignal(signal)
                                        : "exit code " + std::to_string(WEXITSTATUS(status));
    return keyOf(job) + "," + lostRow(job, end + ": " + last);
}

/// Does the jobs that the table lacks, several at a time, or one at a time on each rank.
void doJobs(const Choices& choices, std::vector<Job> jobs, int atATime, Table& table) {
    jobs.erase(
        std::remove_if(jobs.begin(), jobs.end(), [&](const Job& job) { return table.has(keyOf(job)); }),
        jobs.end());
    const auto take = [&](const std::string& row) {
        table.append(row);
        std::cout << row << std::endl;
    };
    if (choices.ranks)
        return choices.ranks->share(
            jobs, [&](const Job& job) { return rowOf(job, choices); }, take, [] {});
    std::mutex mutex;
    std::size_t next = 0;
    std::exception_ptr trouble;
    const auto work = [&] {
        for (std::unique_lock lock(mutex); next < jobs.size() && !trouble;) {
            const Job& job = jobs[next++];
            lock.unlock();
            try {
                const std::string row = rowOf(job, choices);
                lock.lock();
                take(row);
            } catch (...) {
                if (!lock) lock.lock();
                trouble = std::current_exception();
            }
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < atATime; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (trouble) std::rethrow_exception(trouble);
}

std::string fileFor(const std::string& folder, std::string name, const std::string& ending) {
    std::replace(name.begin(), name.end(), '/', '_');
    makeFolder(folder);
    return folder + "/" + name + ending;
}

bool isWanted(const Choices& choices, const std::string& name) {
    return name.find(choices.only) != std::string::npos;
}

/// Returns how many verdicts the oracle refuted.
int judgePaths(const Choices& choices, const PublicProblems& found) {
    const std::string columns = kPathColumns, segments = kSegmentColumns;
    const auto keyed = [](const std::string& all) { return all.substr(std::string("problem,path,").size()); };
    Table paths(choices.out + "/paths.csv", "problem,path", keyed(columns));
    Table invalid(choices.out + "/invalid_segments.csv", "problem,path,segment",
                  segments.substr(std::string("problem,path,segment,").size()));
    int refuted = 0;
    for (const PublicProblem& puzzle : found.puzzles) {
        if (!isWanted(choices, puzzle.name)) continue;
        for (const std::string& path : puzzle.paths) {
            const std::string key = puzzle.name + "," + fs::path(path).filename().string();
            if (paths.has(key)) continue;
            const PathVerdict verdict = judgePath(puzzle, path);
            for (const std::string& row : verdict.invalidRows) invalid.append(row);
            paths.append(verdict.row);
            std::cout << verdict.row << std::endl;
            refuted += verdict.refuted;
        }
    }
    return refuted;
}

void runPlanners(const Choices& choices, const PublicProblems& found) {
    Table table(choices.out + "/runs.csv", "problem,contender,seed", kRunColumns);
    std::vector<Job> ours, others;
    const auto add = [](std::vector<Job>& to, const PublicProblem& puzzle, const std::string& contender,
                        std::uint32_t seed) {
        to.push_back("run," + puzzle.name + "," + contender + "," + std::to_string(seed));
    };
    for (const PublicProblem& puzzle : found.puzzles) {
        if (!isWanted(choices, puzzle.name)) continue;
        for (std::uint32_t seed = 1; seed <= choices.seeds; ++seed) add(ours, puzzle, kOurs, seed);
        for (std::uint32_t seed = 1; seed <= choices.contenderSeeds; ++seed) {
            for (const std::string& contender : contenders()) {
                if (contender != kFcl || puzzle.isOmplApps) add(others, puzzle, contender, seed);
            }
        }
    }
    // Ours plans on all cores, the others on one each.
    doJobs(choices, ours, 1, table);
    doJobs(choices, others, static_cast<int>(choices.together), table);
}

void takeApart(const Choices& choices, const PublicProblems& found) {
    if (choices.partSeconds == 0) return;
    Table table(choices.out + "/parts.csv", "assembly,part", kPartColumns);
    std::vector<Job> jobs;
    for (const Assembly& assembly : found.assemblies) {
        if (!isWanted(choices, assembly.name)) continue;
        for (std::size_t i = 0; i < assembly.files.size(); ++i) {
            jobs.push_back("part," + assembly.name + "," + fs::path(assembly.files[i]).stem().string());
        }
    }
    doJobs(choices, jobs, 1, table);
}

std::string doJob(const Choices& choices, const PublicProblems& found) {
    std::vector<std::string> words(1);
    for (const char c : choices.job) {
        if (c == ',')
            words.emplace_back();
        else
            words.back() += c;
    }
    const std::string paths = choices.out + "/paths";
    if (words[0] == "run" && words.size() == 4) {
        for (const PublicProblem& puzzle : found.puzzles) {
            if (puzzle.name != words[1]) continue;
            return runContender(puzzle.file, words[2],
                                static_cast<std::uint32_t>(parseInteger(words[3]).value()), choices.seconds,
                                fileFor(paths, puzzle.name + "_" + words[2] + "_" + words[3], ".path"));
        }
    }
    if (words[0] == "part" && words.size() == 3) {
        for (const Assembly& assembly : found.assemblies) {
            for (std::size_t i = 0; i < assembly.files.size(); ++i) {
                if (assembly.name != words[1] || fs::path(assembly.files[i]).stem() != words[2]) continue;
                const std::string folder = choices.out + "/problems/" + assembly.name;
                return runPart(assembly, i, choices.partSeconds, fileFor(folder, words[2], ".cfg"),
                               fileFor(paths, assembly.name + "_" + words[2], ".path"));
            }
        }
    }
    throw std::invalid_argument("--job is " + quote(choices.job) +
                                ", expected run,PROBLEM,CONTENDER,SEED or part,ASSEMBLY,PART");
}

int run(int count, char** words, study::Ranks* ranks) {
    Choices choices;
    if (!readChoices(count, words, choices)) return 0;
    choices.ranks = ranks;
    if (ranks && ranks->rank() > 0)
        return ranks->serve([&](const Job& job) { return rowOf(job, choices); }), 0;
    makeFolder(choices.out);
    const PublicProblems found =
        findPublicProblems(readManifests(), choices.checkouts, choices.out + "/problems");
    if (!choices.job.empty()) {
        // Notes name files, by where they are in the checkouts.
        std::cout << boost::replace_all_copy(doJob(choices, found),
                                             (fs::path(choices.checkouts) / "").string(), "")
                  << "\n";
        return 0;
    }
    for (const std::string& line : found.skipped) std::cout << "skipped: " << line << "\n";
    if (found.puzzles.empty() && found.assemblies.empty()) {
        std::cout << "skipped: there is no problem in " << choices.checkouts << "\n";
        return kSkipped;
    }
    const int refuted = judgePaths(choices, found);
    takeApart(choices, found);
    runPlanners(choices, found);
    std::cout << refuted << " verdicts on published paths are refuted by the oracle\n";
    return refuted == 0 ? 0 : 1;
}

}  // namespace

int run(int count, char** words) {
    const auto isJob = [](const char* word) { return std::string(word).rfind("--job=", 0) == 0; };
    if (std::any_of(words, words + count, isJob)) return run(count, words, nullptr);  // a rank started it
    return cli::runOnRanks([&](study::Ranks* ranks) { return run(count, words, ranks); });
}

}  // namespace clearway::testing::public_problems
