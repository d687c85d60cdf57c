#include "demos/study/study_run_text.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "program/bench/run_text.h"

namespace clearway::study {

std::string textOf(const StudyRun& run) {
    Text json = {
        {"row", cellsOf(runColumns(), run.row)}, {"machine", run.machine}, {"warnings", run.warnings}};
    if (run.calls) json["calls"] = *run.calls;
    return jsonLine(json);
}

StudyRun readStudyRun(const std::string& text, const std::string& of) {
    StudyRun run;
    readWith(text, of, [&](const Text& json) {
        const Columns<RunRow> columns = runColumns();
        const Cells cells = json.at("row").get<Cells>();
        if (cells.size() != columns.size() || readCells(columns, cells, run.row) < columns.size())
            throw std::runtime_error("what the process of " + of + " printed is no row of runs.csv");
        run.machine = json.at("machine").get<std::string>();
        if (json.contains("calls")) run.calls = json["calls"].get<std::string>();
        run.warnings = json.at("warnings").get<std::vector<std::string>>();
    });
    return run;
}

}  // namespace clearway::study
