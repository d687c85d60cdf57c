// The report page: one HTML file with a 3D view, a slider along the path, its clearance profile, figures and
// tables. The page needs only a browser.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::report {

struct ReportTable {
    std::string title;
    std::vector<std::string> header;  ///< may be empty
    std::vector<std::vector<std::string>> rows;
    std::vector<double> shares;  ///< share of the path that a click on each row shows; may be empty
};

struct ReportInput {
    std::string title;
    std::string verdict;  ///< a few words beside the title
    const Mesh& part;     ///< the meshes that the scene's models were built from
    const Mesh& environment;
    const Scene& scene;
    const std::vector<PartState>& path;
    const planning::PathAudit& audit;  ///< the audit of the path; its profile, if any, is drawn
    std::vector<ReportTable> tables;
    std::string unit = {};  ///< of lengths, such as "mm"; empty when it is not known
};

struct WrittenReport {
    std::size_t bytes = 0;
    std::size_t partTriangles = 0, environmentTriangles = 0;  ///< in the page
};

/// Writes the page under a temporary name and renames it. Simplifies meshes that are too large for a page;
/// the page states the largest displacement. Clearances are those of the original meshes, or slacks. Throws
/// std::runtime_error when the file cannot be written.
WrittenReport writeReport(const ReportInput& input, const std::string& file);

/// The table of the audit's segments, with the scene's unit.
ReportTable segmentTable(const planning::PathAudit& audit, const std::vector<PartState>& path,
                         const Scene& scene);

}  // namespace clearway::report
