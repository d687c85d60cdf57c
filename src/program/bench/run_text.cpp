#include "program/bench/run_text.h"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace clearway::study {
namespace {

Text toText(const PartState& state) {
    const auto& p = state.position;
    const auto& q = state.rotation.coeffs();
    return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

PartState stateIn(const Text& json) {
    PartState state;
    const auto n = json.get<std::array<double, 7>>();
    state.position = {n[0], n[1], n[2]};
    state.rotation.coeffs() << n[3], n[4], n[5], n[6];
    return state;
}

}  // namespace

std::string jsonLine(const Text& json) {
    return json.dump(-1, ' ', false, Text::error_handler_t::replace) + "\n";
}

void readWith(const std::string& text, const std::string& of, const std::function<void(const Text&)>& read) {
    try {
        read(Text::parse(text));
    } catch (const Text::exception& error) {
        throw std::runtime_error("what the process of " + of + " printed is no run: " + error.what());
    }
}

std::string textOf(const ToldRun& told) {
    const BenchmarkRun& run = told.run;
    Text json = {{"properties", run.properties}, {"progress", run.progress}, {"solved", run.isSolved},
                 {"length", run.length},         {"path", Text::array()},    {"warnings", told.warnings}};
    for (const PartState& state : run.path) json["path"].push_back(toText(state));
    return jsonLine(json);
}

ToldRun readToldRun(const std::string& text, const std::string& of) {
    ToldRun told;
    readWith(text, of, [&](const Text& json) {
        told.run.properties = json.at("properties").get<Properties>();
        told.run.progress = json.at("progress").get<std::vector<Properties>>();
        told.run.isSolved = json.at("solved").get<bool>();
        told.run.length = json.at("length").get<double>();
        for (const Text& state : json.at("path")) told.run.path.push_back(stateIn(state));
        told.warnings = json.at("warnings").get<std::vector<std::string>>();
    });
    return told;
}

}  // namespace clearway::study
