#include "program/study/engine.h"

#include <algorithm>

#include "clearway/targets.h"

namespace clearway::study {
namespace {

const BuildOptions kBest;

EngineGroup groupOf(const StudyOptions& options, const std::string& generalSplit) {
    EngineGroup group;
    for (const std::string& leafSplit : options.leafSplits) {
        Engine engine;
        engine.build.generalSplit = generalSplit;
        engine.build.leafSplit = leafSplit;
        group.push_back(engine);
    }
    return group;
}

template <class Change>
EngineGroup changed(EngineGroup group, const Change& change) {
    for (Engine& engine : group) change(engine);
    return group;
}

}  // namespace

std::string nameOf(const Engine& engine) {
    const BuildOptions& build = engine.build;
    std::string name = build.generalSplit + "/" + build.leafSplit;
    if (build.leafSize != kBest.leafSize) name += " leaves of " + std::to_string(build.leafSize);
    if (build.nodeWidth != kBest.nodeWidth) name += " width " + std::to_string(build.nodeWidth);
    if (engine.target != "best") name += " " + engine.target;
    return name;
}

std::vector<std::string> engineColumns() {
    return {"general_split", "leaf_size", "node_width", "instructions", "leaf_split"};
}

TableRow engineRow(const Engine& engine) {
    return {{"general_split", engine.build.generalSplit},
            {"leaf_size", std::to_string(engine.build.leafSize)},
            {"node_width", std::to_string(engine.build.nodeWidth)},
            {"instructions", engine.target},
            {"leaf_split", engine.build.leafSplit}};
}

std::vector<EngineGroup> plannedGroups(const StudyOptions& options) {
    std::vector<EngineGroup> groups;
    for (const std::string& general : options.generalSplits) groups.push_back(groupOf(options, general));
    return groups;
}

std::vector<EngineGroup> replayedGroups(const StudyOptions& options) {
    std::vector<std::string> others = availableTargets();
    others.erase(others.begin());  // the best one
    others.erase(std::remove(others.begin(), others.end(), "scalar"), others.end());
    std::vector<std::string> varied = options.generalSplits;
    if (options.isShort) varied = {varied.back()};

    std::vector<EngineGroup> groups;
    for (const EngineGroup& planned : plannedGroups(options)) {
        groups.push_back(planned);
        if (planned[0].build.generalSplit != varied.back() && options.isShort) continue;
        for (const std::string& target : others) {
            groups.push_back(changed(planned, [&](Engine& engine) { engine.target = target; }));
        }
    }
    groups.push_back(groupOf(options, "mean"));
    for (const std::string& general : varied) {
        for (const int size : {8, 16}) {
            groups.push_back(
                changed(groupOf(options, general), [&](Engine& engine) { engine.build.leafSize = size; }));
        }
        groups.push_back(
            changed(groupOf(options, general), [&](Engine& engine) { engine.build.nodeWidth = 2; }));
    }
    return groups;
}

bool shareTrees(const Engine& a, const Engine& b) {
    return a.build.generalSplit == b.build.generalSplit && a.build.leafSplit == b.build.leafSplit &&
           a.build.leafSize == b.build.leafSize && a.build.nodeWidth == b.build.nodeWidth &&
           a.build.fit == b.build.fit;
}

}  // namespace clearway::study
