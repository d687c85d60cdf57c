#include "planning/validity/thread_scratch.h"

#include <atomic>
#include <unordered_map>
#include <utility>

namespace clearway::planning {
namespace {

struct OwnedScratch {
    std::weak_ptr<const std::uint64_t> owner;
    ThreadScratch scratch;
};

struct ScratchOfThread {
    std::unordered_map<std::uint64_t, OwnedScratch> byOwner;
    std::uint64_t lastOwner = 0;    // numbers begin at 1
    ThreadScratch* last = nullptr;  // elements of an unordered_map stay where they are
    QueryTally tally;
};

ScratchOfThread& scratchOfThisThread() {
    thread_local ScratchOfThread mine;
    return mine;
}

ThreadScratch& findOrMake(ScratchOfThread& mine, const std::shared_ptr<const std::uint64_t>& owner,
                          std::size_t workspaces) {
    const auto found = mine.byOwner.find(*owner);
    if (found != mine.byOwner.end()) return found->second.scratch;
    for (auto it = mine.byOwner.begin(); it != mine.byOwner.end();) {
        it = it->second.owner.expired() ? mine.byOwner.erase(it) : std::next(it);
    }
    OwnedScratch& made = mine.byOwner[*owner];
    made.owner = owner;
    made.scratch.workspaces.resize(workspaces);
    made.scratch.tally = &mine.tally;
    return made.scratch;
}

}  // namespace

std::shared_ptr<const std::uint64_t> newScratchOwner() {
    static std::atomic<std::uint64_t> next{1};
    return std::make_shared<const std::uint64_t>(next.fetch_add(1, std::memory_order_relaxed));
}

ThreadScratch& threadScratch(const std::shared_ptr<const std::uint64_t>& owner, std::size_t workspaces) {
    ScratchOfThread& mine = scratchOfThisThread();
    if (mine.lastOwner != *owner) {
        mine.last = &findOrMake(mine, owner, workspaces);
        mine.lastOwner = *owner;
    }
    return *mine.last;
}

QueryTally takeQueryTally() {
    return std::exchange(scratchOfThisThread().tally, {});
}

std::size_t threadScratchCount() {
    return scratchOfThisThread().byOwner.size();
}

}  // namespace clearway::planning
