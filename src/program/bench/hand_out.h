// Hands jobs out to ranks: each rank does one at a time, in a process of its own, and gets the next one when it has ended. So a
// job that crashes or is killed loses only itself, and slow jobs keep no other rank waiting.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "program/bench/ranks.h"

namespace clearway::study {

struct Job {
    std::string name;                ///< for messages
    std::vector<std::string> words;  ///< this program with these words does the job and prints its result
};

/// How a job ended.
struct JobEnd {
    std::size_t job = 0;  ///< its position
    bool isDone =
        false;         ///< false when its process crashed, was killed, or ended with another exit code than 0
    std::string text;  ///< what the process printed; how it ended unless isDone
};

/// Calls that rank 0 makes meanwhile.
struct Meanwhile {
    std::function<bool()> isStopped;                       ///< asked often
    std::function<void(std::size_t job, int rank)> begin;  ///< may be empty
    std::function<void(const JobEnd&)> end;  ///< once for each job that ends, in the order of their ends
};

/// For rank 0, which does jobs too: hands the jobs out in their order and returns when all have ended. Returns false when
/// isStopped returned true, or another rank was sent SIGINT or SIGTERM: the jobs that have not ended are dropped.
bool handOut(Ranks& ranks, const std::vector<Job>& jobs, const Meanwhile& meanwhile);

/// For rank 0: lets the other ranks end, and takes leave of them. Jobs that still run are dropped. Does nothing
/// when it has done so before.
void dismiss(Ranks& ranks);

/// For the other ranks: does what rank 0 hands out until it dismisses them. isStopped: asked often; true makes rank 0's handOut
/// return.
void serve(Ranks& ranks, const std::function<bool()>& isStopped);

}  // namespace clearway::study
