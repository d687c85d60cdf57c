#include "program/bench/run_text.h"

#include <array>
#include <nlohmann/json.hpp>

namespace clearway::study {

std::string lineOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string textOf(const EndedRun& ended) {
    const BenchmarkRun& run = ended.run;
    Json path = Json::array();
    for (const PartState& state : run.path) {
        const auto& p = state.position;
        const auto& q = state.rotation.coeffs();
        path.push_back({p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
    }
    return lineOf({{"number", ended.number},
                   {"properties", run.properties},
                   {"progress", run.progress},
                   {"solved", run.isSolved},
                   {"length", run.length},
                   {"path", path},
                   {"warnings", ended.warnings}});
}

EndedRun readEndedRun(const std::string& text) {
    const Json json = Json::parse(text);
    EndedRun ended;
    BenchmarkRun& run = ended.run;
    json.at("number").get_to(ended.number);
    json.at("properties").get_to(run.properties);
    json.at("progress").get_to(run.progress);
    json.at("solved").get_to(run.isSolved);
    json.at("length").get_to(run.length);
    json.at("warnings").get_to(ended.warnings);
    for (const auto& n : json.at("path").get<std::vector<std::array<double, 7>>>()) {
        PartState& state = run.path.emplace_back();
        state.position = {n[0], n[1], n[2]};
        state.rotation.coeffs() << n[3], n[4], n[5], n[6];
    }
    return ended;
}

}  // namespace clearway::study
