// What the thesis measured, to set beside what is measured here. Source: R. Ytterlid, SIMD Optimized Bounding
// Volume Hierarchies for Fast Proximity Queries, 2013, tables 5 to 11: one Core 2 Duo of 2.66 GHz, 32 bit,
// leaves of up to 4 triangles, on scenes of its own that are not public.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace clearway::study {

/// Per second, with AxisSplit, by the leaf splits in the order of kThesisLeafSplits.
struct ThesisScene {
    const char* name;
    const char* family;  ///< scenes here whose names begin so are of its size and kind
    std::array<double, 4> distances;
    std::array<double, 4> collisions;
    /// With ChainSplit, MeanSplit first, then AxisSplit; build and memory are the static model's.
    std::array<double, 2> generalDistances;
    std::array<double, 2> buildSeconds;
    std::array<double, 2> megabytes;
    /// Of the static model with AxisSplit the leaves of 1, 2, 3 and 4 triangles, by leaf split; not told of
    /// all scenes.
    std::optional<std::array<std::array<double, 4>, 4>> leaves;
};

constexpr std::array<const char*, 4> kThesisLeafSplits = {"none", "chain", "edge", "all"};

const std::vector<ThesisScene>& thesisScenes();

/// Null for a scene of no family.
const ThesisScene* thesisSceneOf(const std::string& scene);

/// A value of the thesis for trees of a general and a leaf split; nothing where it has none. measure:
/// distances_per_second, collisions_per_second, build_seconds, megabytes or leaves (their number).
std::optional<double> thesisValue(const ThesisScene& scene, const std::string& measure,
                                  const std::string& generalSplit, const std::string& leafSplit);

}  // namespace clearway::study
