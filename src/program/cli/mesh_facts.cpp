#include "program/cli/mesh_facts.h"

#include <fmt/format.h>

#include "mesh/clean.h"
#include "mesh/topology.h"
#include "program/options/facts.h"

namespace clearway::cli {

namespace {

Box inFileUnits(const Box& box, const MeshOrigin& origin) {
    return Box((box.min() - origin.shift) / origin.scale, (box.max() - origin.shift) / origin.scale);
}

/// The mesh as it was read: its file, the conversions on reading, its box.
Facts readingFacts(const Mesh& mesh, const std::string& reading) {
    const MeshOrigin& origin = mesh.origin;
    const Box box = boundingBox(mesh);
    Facts facts = {{"mesh", origin.file, "file", origin.file}, {"read", reading}};
    for (const auto& [label, text] : readingRows(origin)) facts.push_back({label, text});
    const Facts conversions = {
        {"applied", fmt::format("scale {}, then shift {}", readable(origin.scale), readable(origin.shift)),
         "scale", toJson(origin.scale)},
        kept("shift", toJson(origin.shift)),
        kept("format", origin.format),
        kept("reading", readingWord(origin)),
        kept("unit_stated", origin.unitMetres > 0 ? Json(unitName(origin.unitMetres)) : Json()),
        shownIf(origin.deflection > 0, {"deflection stated", readable(origin.deflection), "deflection_stated",
                                        origin.deflection > 0 ? Json(origin.deflection) : Json()}),
        kept("up_axis_stated", origin.upAxis != 0 ? Json(std::string(1, origin.upAxis)) : Json()),
        kept("notes", origin.notes),
        shownIf(origin.ignoredFaces > 0,
                {"left out",
                 counted(origin.ignoredFaces, "face") +
                     " (points, lines, and triangles of faces whose outlines cross themselves)",
                 "faces_left_out", origin.ignoredFaces}),
        kept("faces_that_cross_themselves", origin.crossingFaces),
        kept("faces_not_flat", origin.bentFaces),
        {"box in file units", readable(inFileUnits(box, origin))},
        {"box as applied", inUnit(readable(box)), "box", toJson(box)},
        {"size as applied", shownPlace(box.sizes())}};
    facts.insert(facts.end(), conversions.begin(), conversions.end());
    return facts;
}

std::string describe(const EdgeReport& edges) {
    if (edges.closedEdges == 0 && edges.isClosed()) return "none: every triangle is a point or a line";
    if (!edges.isClosed())
        return fmt::format(
            "open: {} of one triangle, {} of more than two, {} where the two neighbours face different sides",
            counted(edges.openEdges, "edge"), edges.touchingEdges + edges.overfullEdges, edges.twistedEdges);
    return edges.touchingEdges > 0
               ? "closed, and touches itself along " + counted(edges.touchingEdges, "edge")
               : "closed";
}

/// The triangles, whether their surface is closed, and the findings of cleaning.
Facts triangleFacts(const Mesh& mesh, const CleanMesh& cleaned) {
    const EdgeReport edges = checkEdges(cleaned.triangles);
    const CleanReport& report = cleaned.report;
    Facts facts = {
        {"triangles", std::to_string(mesh.triangles.size()), "triangles", mesh.triangles.size()},
        {"vertices",
         fmt::format("{} read, {} different ones in use", mesh.vertices.size(), cleaned.vertices.size()),
         "vertices",
         {{"read", mesh.vertices.size()}, {"different", cleaned.vertices.size()}}},
        {"components", std::to_string(mesh.components.size()), "components", toJson(mesh.components)}};
    for (const Component& component : mesh.components)
        facts.push_back({"  " + component.name, counted(component.triangleCount, "triangle")});
    facts.push_back({"surface", describe(edges), "closed", edges.closedEdges > 0 && edges.isClosed()});
    facts.push_back(kept("edges", {{"of_one_triangle", edges.openEdges},
                                   {"of_more_than_two", edges.touchingEdges + edges.overfullEdges},
                                   {"with_neighbours_facing_apart", edges.twistedEdges}}));
    facts.push_back({"cleaning",
                     fmt::format("{} welded, {} unused, {} without area kept, {} dropped",
                                 counted(report.weldedVertices, "vertex copy", "vertex copies"),
                                 report.unusedVertices, counted(report.degenerateTriangles, "triangle"),
                                 counted(report.duplicateTriangles, "duplicate")),
                     "cleaning",
                     {{"welded", report.weldedVertices},
                      {"unused", report.unusedVertices},
                      {"without_area", report.degenerateTriangles},
                      {"duplicates_dropped", report.duplicateTriangles}}});
    return facts;
}

Facts treeFacts(const BuildReport& report) {
    const TreeStatistics& tree = report.tree;
    std::string leaves = std::to_string(tree.leaves);
    for (std::size_t size = 1; size < tree.leavesBySize.size(); ++size)
        leaves += fmt::format("{}{} of {}", size == 1 ? ": " : ", ", tree.leavesBySize[size], size);
    const double bytesEach = static_cast<double>(tree.bytes) / static_cast<double>(report.triangles);
    return {
        {"tree", treeDescription(report.options), "general_split", report.options.generalSplit},
        kept("leaf_split", report.options.leafSplit),
        kept("leaf_size", report.options.leafSize),
        {"  nodes", fmt::format("{}, {} children on average", tree.nodes, readable(tree.meanChildren)),
         "nodes", tree.nodes},
        kept("mean_children", toJson(tree.meanChildren)),
        {"  leaves", leaves, "leaves", tree.leaves},
        kept("leaves_by_size", tree.leavesBySize),
        {"  depth", std::to_string(tree.depth), "depth", tree.depth},
        {"  bytes", fmt::format("{}, {} per triangle", tree.bytes, readable(bytesEach)), "bytes", tree.bytes},
        {"  build seconds", readable(report.seconds), "build_seconds", toJson(report.seconds)},
        kept("triangles", report.triangles),
        kept("out_of_range", report.unreachableTriangles)};
}

}  // namespace

void describeMesh(const char* name, const Mesh& mesh, const std::string& reading, const Model& model,
                  const std::optional<QueryRange>& range) {
    Json& all = facts()[name];
    const auto tellOf = [&all](const Facts& table) {
        printRows(rowsOf(table));
        all.update(toJson(table));
    };
    tellOf(readingFacts(mesh, reading));
    tellOf(triangleFacts(mesh, clean(mesh)));
    const BuildReport& report = model.report();
    if (range)
        printRow("out of range",
                 fmt::format("{}, never within {} of the part; planning leaves them out",
                             counted(report.unreachableTriangles, "triangle"), shownLength(range->cap)));
    printRows(rowsOf(treeFacts(report)));
    all["tree"] = toJson(treeFacts(report));
}

}  // namespace clearway::cli
