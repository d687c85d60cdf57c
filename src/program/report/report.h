// The report page: one HTML file with a 3D view, a slider along the path, its clearance profile, figures and
// tables, that needs nothing but a browser.
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
    std::vector<double> shares;  ///< of the way, of each row: where a click on it goes; or empty
};

struct ReportInput {
    std::string title;
    std::string verdict;  ///< a few words beside the title
    const Mesh& part;     ///< as the scene's models were made from
    const Mesh& environment;
    const Scene& scene;
    const std::vector<PartState>& path;
    const planning::PathAudit& audit;  ///< of the path; what its profile certifies is drawn if it has one
    std::vector<ReportTable> tables;
};

struct WrittenReport {
    std::size_t bytes = 0;
    std::size_t partTriangles = 0, environmentTriangles = 0;  ///< in the page
};

/// Meshes of more triangles than a page can show at ease are thinned out; the page says so, and by how much.
/// Clearances are those of the whole meshes. Written to a temporary name, then renamed. Throws
/// std::runtime_error when it cannot be written.
WrittenReport writeReport(const ReportInput& input, const std::string& file);

/// The table of an audit's segments.
ReportTable segmentTable(const planning::PathAudit& audit, const std::vector<PartState>& path,
                         double turnRadius);

}  // namespace clearway::report
