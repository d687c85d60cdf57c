#include "program/study/thesis.h"

#include <algorithm>
#include <numeric>

namespace clearway::study {

const std::vector<ThesisScene>& thesisScenes() {
    using Leaves = std::array<std::array<double, 4>, 4>;
    static const std::vector<ThesisScene> kScenes = {
        {"Cembox",
         "cembox",
         {563, 595, 578, 528},
         {3842, 3842, 3842, 3842},
         {205, 595},
         {3.72, 6.31},
         {41, 35},
         std::nullopt},
        {"TunnelConsole",
         "tunnel-console",
         {335, 358, 339, 283},
         {2240, 2240, 2200, 2126},
         {230, 358},
         {2.42, 4.05},
         {28, 24},
         Leaves{{{5469, 25513, 41062, 30180},
                 {36310, 38221, 35639, 20183},
                 {88144, 40539, 26613, 12835},
                 {300401, 0, 0, 0}}}},
        {"LargeEnvironment",
         "large-environment",
         {35.8, 58.3, 37.9, 38.7},
         {3151, 16223, 16310, 16310},
         {18, 58},
         {14.61, 25.97},
         {150, 128},
         std::nullopt},
    };
    return kScenes;
}

const ThesisScene* thesisSceneOf(const std::string& scene) {
    for (const ThesisScene& each : thesisScenes()) {
        if (scene.rfind(each.family, 0) == 0) return &each;
    }
    return nullptr;
}

std::optional<double> thesisValue(const ThesisScene& scene, const std::string& measure,
                                  const std::string& generalSplit, const std::string& leafSplit) {
    const auto found = std::find(kThesisLeafSplits.begin(), kThesisLeafSplits.end(), leafSplit);
    if (found == kThesisLeafSplits.end()) return std::nullopt;
    const auto leaf = static_cast<std::size_t>(found - kThesisLeafSplits.begin());
    const bool isAxis = generalSplit == "axis", isChain = leafSplit == "chain";
    if (measure == "distances_per_second" && isAxis) return scene.distances[leaf];
    if (measure == "collisions_per_second" && isAxis) return scene.collisions[leaf];
    if (measure == "leaves" && isAxis && scene.leaves) {
        const auto& bySize = (*scene.leaves)[leaf];
        return std::accumulate(bySize.begin(), bySize.end(), 0.0);
    }
    if (!isChain || (!isAxis && generalSplit != "mean")) return std::nullopt;
    if (measure == "distances_per_second") return scene.generalDistances[0];
    if (measure == "build_seconds") return scene.buildSeconds[isAxis];
    if (measure == "megabytes") return scene.megabytes[isAxis];
    return std::nullopt;
}

}  // namespace clearway::study
