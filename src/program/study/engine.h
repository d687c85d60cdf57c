// How trees are built, and on which instructions they are asked: what the study compares.
#pragma once

#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "program/study/growing_table.h"
#include "program/study/study_options.h"

namespace clearway::study {

struct Engine {
    BuildOptions build;
    std::string target = "best";  ///< as useTarget takes it
};

/// "sah/chain"; with what differs from leaves of up to 4, nodes of 8 and the best instructions: "sah/chain 16
/// avx2".
std::string nameOf(const Engine& engine);

/// Columns general_split, leaf_size, node_width, instructions and leaf_split of an engine's rows.
std::vector<std::string> engineColumns();
TableRow engineRow(const Engine& engine);

/// Engines that differ in the leaf split alone, compared with the first.
using EngineGroup = std::vector<Engine>;

/// Those that planners are run with, a group for each general split.
std::vector<EngineGroup> plannedGroups(const StudyOptions& options);

/// Those, and all others that recorded calls are replayed with: MeanSplit, leaves of up to 8 and 16, the
/// machine's other vector instruction sets and nodes of two children. Groups that share trees follow each
/// other.
std::vector<EngineGroup> replayedGroups(const StudyOptions& options);

/// True when both are built alike.
bool shareTrees(const Engine& a, const Engine& b);

}  // namespace clearway::study
