// Times the wait before a planner begins: reading the files and building the trees.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/study/experiment.h"
#include "demos/study/table.h"

namespace clearway::study {

/// A row of files.csv: a scene with trees of one kind, on one processor. Medians of a few times.
struct FilesRow : Engine {
    std::string scene;
    double loadSeconds = 0;   ///< reading and cleaning the part's and the environment's files
    double buildSeconds = 0;  ///< building both trees
    std::uint64_t triangles = 0, leaves = 0;
    double megabytes = 0;  ///< of both trees

    double seconds() const { return loadSeconds + buildSeconds; }
};

Columns<FilesRow> filesColumns();

/// Measures all planned engines, which take turns. load: reads the problem and its files. Returns nothing when the study was stopped.
std::optional<std::vector<FilesRow>> measureFiles(const std::function<StudyProblem()>& load,
                                                  const StudyOptions& options);

}  // namespace clearway::study
