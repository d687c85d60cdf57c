#include "demos/study/claims.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace clearway::study {
namespace {

/// Least ratios that count as a difference: in speed, memory and leaves, and in build times, which are
/// measured only once.
constexpr double kLeastDifference = 1.02, kLeastBuildDifference = 1.10;

/// Two kinds of trees are alike when the interval of their ratio lies within this ratio.
constexpr double kAlike = 1.05;

struct Trees {
    const char* general;
    const char* leaf;
};

/// Claims that trees a have more of the measure than trees b, or as much if isEqual.
struct Claim {
    const char* text;
    TreeMeasure measure;
    Trees a, b;
    bool isEqual = false;
    /// The thesis's figures support some claims in one family of scenes only, others in all families but one.
    const char* onlyIn = "";
    const char* notIn = "";
};

constexpr TreeMeasure kDistances = TreeMeasure::kDistancesPerSecond;
constexpr TreeMeasure kCollisions = TreeMeasure::kCollisionsPerSecond;
constexpr TreeMeasure kBuildSeconds = TreeMeasure::kBuildSeconds;
constexpr TreeMeasure kMegabytes = TreeMeasure::kMegabytes;
constexpr TreeMeasure kLeaves = TreeMeasure::kLeaves;

constexpr const char* kLargeEnvironment = "large-environment";

constexpr Trees kMeanChain = {"mean", "chain"}, kChain = {"axis", "chain"}, kNone = {"axis", "none"},
                kEdge = {"axis", "edge"}, kAll = {"axis", "all"};

constexpr Claim kClaims[] = {
    {"AxisSplit answers distances faster than MeanSplit", kDistances, kChain, kMeanChain},
    {"AxisSplit takes longer to build than MeanSplit", kBuildSeconds, kChain, kMeanChain},
    {"MeanSplit takes more memory than AxisSplit", kMegabytes, kMeanChain, kChain},
    {"ChainSplit answers distances faster than NoSplit", kDistances, kChain, kNone},
    {"ChainSplit answers distances faster than EdgeSplit", kDistances, kChain, kEdge},
    {"ChainSplit answers distances faster than AllSplit", kDistances, kChain, kAll},
    {"ChainSplit answers collisions as fast as NoSplit", kCollisions, kChain, kNone, true, "",
     kLargeEnvironment},
    {"ChainSplit answers collisions faster than NoSplit", kCollisions, kChain, kNone, false,
     kLargeEnvironment},
    {"EdgeSplit answers collisions as fast as ChainSplit", kCollisions, kEdge, kChain, true},
    {"AllSplit answers collisions as fast as ChainSplit", kCollisions, kAll, kChain, true},
    {"ChainSplit makes more leaves than NoSplit", kLeaves, kChain, kNone},
    {"EdgeSplit makes more leaves than ChainSplit", kLeaves, kEdge, kChain},
    {"AllSplit makes more leaves than EdgeSplit", kLeaves, kAll, kEdge},
};

bool isAbout(const Claim& claim, const std::string& scene) {
    const auto isOf = [&](const std::string& family) {
        return !family.empty() && scene.rfind(family, 0) == 0;
    };
    return (*claim.onlyIn == 0 || isOf(claim.onlyIn)) && !isOf(claim.notIn);
}

/// The measure of a row; for rates, the seconds that each block of poses takes.
std::vector<double> valuesOf(const TreeRow& row, TreeMeasure measure) {
    switch (measure) {
        case kDistances:
            return row.distancesBlockSeconds;
        case kCollisions:
            return row.collisionsBlockSeconds;
        case kBuildSeconds:
            return {row.buildSeconds};
        case kMegabytes:
            return {row.megabytes};
        case kLeaves:
            break;
    }
    return {static_cast<double>(row.leaves)};
}

/// The ratio of a's measure to b's. For rates it is the ratio of b's seconds to a's.
PairedRatio ratioOf(const Claim& claim, const TreeRow& a, const TreeRow& b) {
    std::vector<double> over = valuesOf(a, claim.measure), under = valuesOf(b, claim.measure);
    if (claim.measure == kDistances || claim.measure == kCollisions) std::swap(over, under);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < over.size() && i < under.size(); ++i) {
        if (over[i] > 0 && under[i] > 0) ratios.push_back(over[i] / under[i]);
    }
    return pairedRatio(ratios);
}

std::string verdictOn(const Claim& claim, const PairedRatio& ratio) {
    const double least = claim.measure == kBuildSeconds ? kLeastBuildDifference : kLeastDifference,
                 alike = std::max(least, kAlike);
    if (ratio.low > 1 && ratio.median >= least) return claim.isEqual ? "the first is faster" : "holds";
    if (ratio.high < 1 && ratio.median <= 1 / least)
        return claim.isEqual ? "the first is slower" : "the opposite";
    if (ratio.low < 1 / alike || ratio.high > alike) return "undecided";
    return claim.isEqual ? "holds" : "no difference";
}

Measure thesisRatio(const Claim& claim, const std::string& scene) {
    const ThesisScene* thesis = thesisSceneOf(scene);
    if (thesis == nullptr) return std::nullopt;
    const Measure a = thesisValue(*thesis, claim.measure, claim.a.general, claim.a.leaf);
    const Measure b = thesisValue(*thesis, claim.measure, claim.b.general, claim.b.leaf);
    return a && b ? Measure(*a / *b) : std::nullopt;
}

}  // namespace

Columns<ClaimRow> claimColumns() {
    using Row = ClaimRow;
    return {{"scene", &Row::scene},  {"node_width", &Row::nodeWidth},
            {"claim", &Row::claim},  {"thesis_ratio", &Row::thesisRatio},
            {"ratio", &Row::median}, {"low", &Row::low},
            {"high", &Row::high},    {"verdict", &Row::verdict}};
}

std::vector<ClaimRow> judgeClaims(const std::vector<TreeRow>& trees) {
    // Keyed by scene and width, then by both splits.
    std::map<std::pair<std::string, int>, std::map<std::string, const TreeRow*>> byEngine;
    for (const TreeRow& row : trees) {
        byEngine[{row.scene, row.nodeWidth}][row.generalSplit + "/" + row.leafSplit] = &row;
    }
    std::vector<ClaimRow> verdicts;
    for (const auto& [engine, rows] : byEngine) {
        for (const Claim& claim : kClaims) {
            if (!isAbout(claim, engine.first)) continue;
            const auto a = rows.find(std::string(claim.a.general) + "/" + claim.a.leaf);
            const auto b = rows.find(std::string(claim.b.general) + "/" + claim.b.leaf);
            if (a == rows.end() || b == rows.end()) continue;
            ClaimRow row;
            static_cast<PairedRatio&>(row) = ratioOf(claim, *a->second, *b->second);
            row.scene = engine.first;
            row.nodeWidth = engine.second;
            row.claim = claim.text;
            row.thesisRatio = thesisRatio(claim, engine.first);
            row.verdict = verdictOn(claim, row);
            verdicts.push_back(row);
        }
    }
    return verdicts;
}

}  // namespace clearway::study
