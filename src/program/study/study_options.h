// What the leaf-strategy study runs, and how it is told to stop and tells how far it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "program/study/calls.h"

namespace clearway::study {

struct StudyPlanner {
    std::string name;       ///< OMPL's class
    std::string objective;  ///< as objectiveNames() has them; empty: the first path, or the planner's own
};

struct StudyOptions {
    std::vector<StudyPlanner> planners = {
        {"RRTConnect", ""}, {"KPIECE1", ""}, {"PRM", ""}, {"RRTstar", ""}, {"BITstar", "max_min_clearance"}};
    std::vector<std::string> generalSplits = {"axis", "sah"};
    std::vector<std::string> leafSplits = {"none", "chain", "edge",
                                           "all"};  ///< the first is what others are compared with
    int seeds = 10;                                 ///< 1 to this, of each planner with each strategy
    double seconds = 20;                            ///< for each run
    double megabytes = 8192;
    CallSampling sampling;
    int repetitions = 7;  ///< of each replay
    bool isShort =
        false;  ///< replays the leaves of other sizes and the other instruction sets with one general split
    int tablePoses = 1000;
    std::string cache;  ///< folder for built trees; empty: none

    std::function<bool()> isStopped;
    std::function<void(const std::string&)> tell;  ///< one line
};

}  // namespace clearway::study
