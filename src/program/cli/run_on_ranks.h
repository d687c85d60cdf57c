// Programs under mpirun or srun: rank 0 alone reads, prints and writes; the other ranks do the runs that it shares out.
#pragma once

#include <functional>

#include "program/bench/ranks.h"

namespace clearway::cli {

/// Calls `run`, whose exit code it returns: in every process that mpirun or srun started together with this one, or with null
/// when this process was started alone. On other ranks than 0 nothing is printed and no facts are written, interrupts are heeded,
/// and exceptions go to rank 0.
int runOnRanks(const std::function<int(study::Ranks*)>& run);

}  // namespace clearway::cli
