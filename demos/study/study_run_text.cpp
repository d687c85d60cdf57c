#include "demos/study/study_run_text.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "program/bench/run_text.h"

namespace clearway::study {

std::string textOf(const StudyRun& run) {
    Json json = {
        {"row", cellsOf(runColumns(), run.row)}, {"machine", run.machine}, {"warnings", run.warnings}};
    if (run.calls) json["calls"] = *run.calls;
    return lineOf(json);
}

StudyRun readStudyRun(const std::string& text) {
    const Json json = Json::parse(text);
    const Cells cells = json.at("row").get<Cells>();
    StudyRun run;
    if (cells.size() != runColumns().size() || readCells(runColumns(), cells, run.row) < cells.size())
        throw std::runtime_error("a rank's run has other columns than runs.csv");
    if (json.contains("calls")) run.calls = json["calls"].get<std::string>();
    json.at("machine").get_to(run.machine);
    json.at("warnings").get_to(run.warnings);
    return run;
}

}  // namespace clearway::study
