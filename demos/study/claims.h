// Judges the claims of R. Ytterlid's thesis about leaf and general splits by clearway's measurements.
#pragma once

#include <string>
#include <vector>

#include "demos/study/statistics.h"
#include "demos/study/table.h"
#include "demos/study/tree_tables.h"

namespace clearway::study {

/// A row of claims.csv: the ratio of a measure between the claim's two kinds of trees, and the verdict. A
/// claim that one kind is faster or more gets "holds", "no difference", "the opposite" or "undecided". A
/// claim that both are alike gets "holds", "the first is faster", "the first is slower" or "undecided".
struct ClaimRow : PairedRatio {
    std::string scene;
    int nodeWidth = 0;
    std::string claim;
    Measure thesisRatio;  ///< empty where the thesis has no such scene
    std::string verdict;
};

Columns<ClaimRow> claimColumns();
std::vector<ClaimRow> judgeClaims(const std::vector<TreeRow>& trees);

}  // namespace clearway::study
