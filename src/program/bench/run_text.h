// A benchmark's run as a line of JSON, by which a rank tells it to rank 0.
#pragma once

#include <string>

#include "core/json.h"
#include "program/bench/benchmark.h"

namespace clearway::study {

/// Leaves out the run's measures, which its properties hold.
std::string textOf(const EndedRun& ended);

/// Throws a std::exception when textOf() wrote no such text.
EndedRun readEndedRun(const std::string& text);

/// Bytes that are not UTF-8, from names of files, are replaced.
std::string lineOf(const Json& json);

}  // namespace clearway::study
