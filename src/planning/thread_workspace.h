// One workspace for each pair of thread and owner, without locks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "clearway/query.h"

namespace clearway::planning {

/// A new owner. Its number is never used again in the process, so that no owner meets the scratch of a dead
/// one.
std::shared_ptr<const std::uint64_t> newWorkspaceOwner();

/// The calling thread's workspace for the owner. A thread frees the workspaces of dead owners when it meets a
/// new owner, and all of them when it ends.
Workspace& threadWorkspace(const std::shared_ptr<const std::uint64_t>& owner);

/// How many workspaces the calling thread keeps.
std::size_t threadWorkspaceCount();

}  // namespace clearway::planning
