// The data that the report page shows, as JSON.
#pragma once

#include <cstddef>
#include <string>

#include "program/report/report.h"

namespace clearway::report {

struct PageData {
    std::string json;
    std::size_t partTriangles = 0, environmentTriangles = 0;
};

/// Measures and simplifies what the page shows. Coordinates are relative to the middle of the environment's box,
/// because the page computes in floats; only the texts for copying have the environment's own coordinates.
PageData pageDataOf(const ReportInput& input);

}  // namespace clearway::report
