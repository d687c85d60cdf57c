// The study's answer in two sentences.
#pragma once

#include <string>
#include <vector>

#include "demos/study/statistics.h"

namespace clearway::study {

/// Which tree takes least time from files to one path, and which for thousands of queries, with the number of queries after which it
/// repays a longer building. Two sentences, each with its line end. Says so when nothing was measured.
std::string answerOf(const std::vector<RatioRow>& ratios, const Measured& measured,
                     const StudyOptions& options);

}  // namespace clearway::study
