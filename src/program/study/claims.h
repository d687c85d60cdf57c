// The thesis's claims about its strategies, judged by what is measured here.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"

namespace clearway::study {

/// By which claims are judged, for people to read.
std::string claimRule();

/// scene, node_width, claim, thesis_ratio (empty where the thesis has no such scene), ratio, low, high,
/// verdict.
std::vector<std::string> claimColumns();

/// trees: rows as measureTrees writes them. Of a claim that one is faster or more the verdict is "holds", "no
/// difference", "the opposite" or "undecided", of one that both are alike "holds", "the first is faster",
/// "the first is slower" or "undecided".
std::vector<TableRow> judgeClaims(const std::vector<TableRow>& trees);

}  // namespace clearway::study
