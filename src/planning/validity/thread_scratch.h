// The scratch of one thread for one scene, without locks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "clearway/query.h"

namespace clearway::planning {

/// The number of queries about scenes and the work that they did.
struct QueryTally {
    std::uint64_t distances = 0;
    std::uint64_t withins = 0;  ///< whether in contact, or within a margin
    QueryCounters work;

    void addDistance(const QueryCounters& counters) {
        ++distances;
        work += counters;
    }
    void addWithin(const QueryCounters& counters) {
        ++withins;
        work += counters;
    }
};

/// Returns the tally of the calling thread's queries, of all scenes, and begins a new one at 0.
QueryTally takeQueryTally();

struct ThreadScratch {
    std::vector<Workspace> workspaces;  ///< one for each obstacle
    std::size_t nearest = 0;            ///< the obstacle that was nearest, or in the way, last time
    QueryTally* tally = nullptr;        ///< the thread's, of all scenes
};

/// A new owner. Its number is never used again in the process, so that no owner meets the scratch of a dead
/// one.
std::shared_ptr<const std::uint64_t> newScratchOwner();

/// The calling thread's scratch for the owner, made with so many workspaces. A thread frees the scratch of
/// dead owners when it meets a new owner, and all of it when it ends.
ThreadScratch& threadScratch(const std::shared_ptr<const std::uint64_t>& owner, std::size_t workspaces);

/// For how many owners the calling thread keeps scratch.
std::size_t threadScratchCount();

}  // namespace clearway::planning
