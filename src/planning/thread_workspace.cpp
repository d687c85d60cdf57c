#include "planning/thread_workspace.h"

#include <atomic>
#include <unordered_map>

namespace clearway::planning {
namespace {

struct OwnedWorkspace {
    std::weak_ptr<const std::uint64_t> owner;
    Workspace workspace;
};

struct ThreadWorkspaces {
    std::unordered_map<std::uint64_t, OwnedWorkspace> byOwner;
    std::uint64_t lastOwner = 0;  // numbers begin at 1
    Workspace* last = nullptr;    // elements of an unordered_map stay where they are
};

ThreadWorkspaces& workspacesOfThisThread() {
    thread_local ThreadWorkspaces mine;
    return mine;
}

Workspace& findOrMake(ThreadWorkspaces& mine, const std::shared_ptr<const std::uint64_t>& owner) {
    const auto found = mine.byOwner.find(*owner);
    if (found != mine.byOwner.end()) return found->second.workspace;
    for (auto it = mine.byOwner.begin(); it != mine.byOwner.end();) {
        it = it->second.owner.expired() ? mine.byOwner.erase(it) : std::next(it);
    }
    return mine.byOwner.emplace(*owner, OwnedWorkspace{owner, Workspace()}).first->second.workspace;
}

}  // namespace

std::shared_ptr<const std::uint64_t> newWorkspaceOwner() {
    static std::atomic<std::uint64_t> next{1};
    return std::make_shared<const std::uint64_t>(next.fetch_add(1, std::memory_order_relaxed));
}

Workspace& threadWorkspace(const std::shared_ptr<const std::uint64_t>& owner) {
    ThreadWorkspaces& mine = workspacesOfThisThread();
    if (mine.lastOwner != *owner) {
        mine.last = &findOrMake(mine, owner);
        mine.lastOwner = *owner;
    }
    return *mine.last;
}

std::size_t threadWorkspaceCount() {
    return workspacesOfThisThread().byOwner.size();
}

}  // namespace clearway::planning
