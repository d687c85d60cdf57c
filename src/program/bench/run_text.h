// A run as a text (JSON), by which the process that did it tells it to the process that writes it down.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "program/bench/planner_run.h"

namespace clearway::study {

/// A run of a benchmark, with the warnings that came up.
struct ToldRun {
    BenchmarkRun run;  ///< without its measures, which its properties hold
    std::vector<std::string> warnings;
};

std::string textOf(const ToldRun& told);

/// Reads what textOf wrote. Throws std::runtime_error, naming what the text is of, when it is no such text.
ToldRun readToldRun(const std::string& text, const std::string& of);

using Text = nlohmann::json;  // numbers are doubles, unlike those of core/json.h

/// On one line. Bytes that are not UTF-8, from names of files, are replaced.
std::string jsonLine(const Text& json);

/// Calls `read` with the JSON. Throws std::runtime_error when the text is no JSON, or `read` misses something in it.
void readWith(const std::string& text, const std::string& of, const std::function<void(const Text&)>& read);

}  // namespace clearway::study
