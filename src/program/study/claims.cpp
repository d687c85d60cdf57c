#include "program/study/claims.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/number.h"
#include "program/study/paired_ratio.h"
#include "program/study/thesis.h"

namespace clearway::study {
namespace {

constexpr double kLeastDifference = 1.02;       ///< of speeds, memory and leaves; less is none
constexpr double kLeastBuildDifference = 1.10;  ///< of build seconds, which are measured once
constexpr double kAlike = 1.05;  ///< an interval no further off than this tells of no difference

struct Trees {
    const char* general;
    const char* leaf;
};

/// That trees a have more of the measure than trees b; or as much.
struct Claim {
    const char* text;
    std::string_view measure;
    Trees a, b;
    bool isEqual = false;
    /// Where the thesis's own figures say so: in scenes of this family alone, or in all but these.
    const char* onlyIn = "";
    const char* notIn = "";
};

constexpr std::string_view kDistances = "distances_per_second";
constexpr std::string_view kCollisions = "collisions_per_second";
constexpr std::string_view kBuildSeconds = "build_seconds";

constexpr const char* kLargeEnvironment = "large-environment";

constexpr Claim kClaims[] = {
    {"AxisSplit answers distances faster than MeanSplit", kDistances, {"axis", "chain"}, {"mean", "chain"}},
    {"AxisSplit takes longer to build than MeanSplit", kBuildSeconds, {"axis", "chain"}, {"mean", "chain"}},
    {"MeanSplit takes more memory than AxisSplit", "megabytes", {"mean", "chain"}, {"axis", "chain"}},
    {"ChainSplit answers distances faster than NoSplit", kDistances, {"axis", "chain"}, {"axis", "none"}},
    {"ChainSplit answers distances faster than EdgeSplit", kDistances, {"axis", "chain"}, {"axis", "edge"}},
    {"ChainSplit answers distances faster than AllSplit", kDistances, {"axis", "chain"}, {"axis", "all"}},
    {"ChainSplit answers collisions as fast as NoSplit",
     kCollisions,
     {"axis", "chain"},
     {"axis", "none"},
     true,
     "",
     kLargeEnvironment},
    {"ChainSplit answers collisions faster than NoSplit",
     kCollisions,
     {"axis", "chain"},
     {"axis", "none"},
     false,
     kLargeEnvironment},
    {"EdgeSplit answers collisions as fast as ChainSplit",
     kCollisions,
     {"axis", "edge"},
     {"axis", "chain"},
     true},
    {"AllSplit answers collisions as fast as ChainSplit",
     kCollisions,
     {"axis", "all"},
     {"axis", "chain"},
     true},
    {"ChainSplit makes more leaves than NoSplit", "leaves", {"axis", "chain"}, {"axis", "none"}},
    {"EdgeSplit makes more leaves than ChainSplit", "leaves", {"axis", "edge"}, {"axis", "chain"}},
    {"AllSplit makes more leaves than EdgeSplit", "leaves", {"axis", "all"}, {"axis", "edge"}},
};

bool isAbout(const Claim& claim, const std::string& scene) {
    const auto isOf = [&](const std::string& family) {
        return !family.empty() && scene.rfind(family, 0) == 0;
    };
    return (*claim.onlyIn == 0 || isOf(claim.onlyIn)) && !isOf(claim.notIn);
}

std::vector<double> numbersIn(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> numbers;
    for (std::string word; in >> word;) numbers.push_back(parseNumber(word).value_or(0));
    return numbers;
}

bool isRate(const Claim& claim) {
    return claim.measure == kDistances || claim.measure == kCollisions;
}

/// a's measure over b's, where b's blocks of poses take longer by that ratio.
PairedRatio ratioOf(const Claim& claim, const TableRow& a, const TableRow& b) {
    std::vector<std::vector<double>> ratios;
    if (isRate(claim)) {
        const std::string column =
            claim.measure == kDistances ? "distances_block_seconds" : "collisions_block_seconds";
        const std::vector<double> ofA = numbersIn(a.at(column)), ofB = numbersIn(b.at(column));
        for (std::size_t i = 0; i < ofA.size() && i < ofB.size(); ++i) {
            if (ofA[i] > 0 && ofB[i] > 0) ratios.push_back({ofB[i] / ofA[i]});
        }
    } else {
        const double ofA = parseNumber(a.at(std::string(claim.measure))).value_or(0),
                     ofB = parseNumber(b.at(std::string(claim.measure))).value_or(0);
        if (ofB > 0) ratios.push_back({ofA / ofB});
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

std::optional<double> thesisRatio(const Claim& claim, const std::string& scene) {
    const ThesisScene* thesis = thesisSceneOf(scene);
    if (thesis == nullptr) return std::nullopt;
    const auto a = thesisValue(*thesis, std::string(claim.measure), claim.a.general, claim.a.leaf);
    const auto b = thesisValue(*thesis, std::string(claim.measure), claim.b.general, claim.b.leaf);
    return a && b ? std::optional<double>(*a / *b) : std::nullopt;
}

std::string percentOff(double ratio) {
    return std::to_string(std::lround(100 * (ratio - 1))) + " %";
}

}  // namespace

std::string claimRule() {
    return "Claims: a ratio is the median over 20 blocks of poses (of build seconds, memory and leaves the "
           "one "
           "value). The first has\nmore, or less, when the whole 95 % interval says so and the ratio is at "
           "least " +
           percentOff(kLeastDifference) + " off (build seconds " + percentOff(kLeastBuildDifference) +
           "). There is no\ndifference when the interval reaches no further than " + percentOff(kAlike) +
           " (build seconds " + percentOff(kLeastBuildDifference) + "). Else it is undecided.";
}

std::vector<std::string> claimColumns() {
    return {"scene", "node_width", "claim", "thesis_ratio", "ratio", "low", "high", "verdict"};
}

std::vector<TableRow> judgeClaims(const std::vector<TableRow>& trees) {
    // by scene and width, then by both splits
    std::map<std::pair<std::string, std::string>, std::map<std::string, const TableRow*>> byEngine;
    for (const TableRow& row : trees) {
        byEngine[{row.at("scene"), row.at("node_width")}]
                [row.at("general_split") + "/" + row.at("leaf_split")] = &row;
    }
    std::vector<TableRow> verdicts;
    for (const auto& [engine, rows] : byEngine) {
        for (const Claim& claim : kClaims) {
            if (!isAbout(claim, engine.first)) continue;
            const auto a = rows.find(std::string(claim.a.general) + "/" + claim.a.leaf);
            const auto b = rows.find(std::string(claim.b.general) + "/" + claim.b.leaf);
            if (a == rows.end() || b == rows.end()) continue;
            const PairedRatio ratio = ratioOf(claim, *a->second, *b->second);
            const auto thesis = thesisRatio(claim, engine.first);
            verdicts.push_back({{"scene", engine.first},
                                {"node_width", engine.second},
                                {"claim", claim.text},
                                {"thesis_ratio", thesis ? shortNumber(*thesis) : ""},
                                {"ratio", shortNumber(ratio.median)},
                                {"low", shortNumber(ratio.low)},
                                {"high", shortNumber(ratio.high)},
                                {"verdict", verdictOn(claim, ratio)}});
        }
    }
    return verdicts;
}

}  // namespace clearway::study
