#include "program/cli/describe_mesh.h"

#include "mesh/clean.h"
#include "mesh/topology.h"
#include "program/cli/print.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

namespace {

Box inFileUnits(const Box& box, const MeshOrigin& origin) {
    return Box((box.min() - origin.shift) / origin.scale, (box.max() - origin.shift) / origin.scale);
}

void describeReading(const Mesh& mesh, const std::string& reading) {
    const MeshOrigin& origin = mesh.origin;
    const Box box = boundingBox(mesh);
    printRow("mesh", origin.file);
    printRow("read", reading);
    printRow("applied", "scale " + readable(origin.scale) + ", then shift " + readable(origin.shift));
    for (const std::string& note : origin.notes) printRow("note", note);
    if (origin.ignoredFaces > 0) {
        printRow("left out",
                 counted(origin.ignoredFaces, "face") + " (points, lines, not to be triangulated)");
    }
    printRow("box in file units", readable(inFileUnits(box, origin)));
    printRow("box as applied", readable(box));
    printRow("size as applied", readable(Vector3(box.sizes())));
}

void describeTriangles(const Mesh& mesh, const CleanMesh& cleaned) {
    printRow("triangles", std::to_string(mesh.triangles.size()));
    printRow("vertices", std::to_string(mesh.vertices.size()) + " read, " +
                             std::to_string(cleaned.vertices.size()) + " different ones in use");
    printRow("components", std::to_string(mesh.components.size()));
    for (const Component& component : mesh.components) {
        printRow("  " + component.name, counted(component.triangleCount, "triangle"));
    }
    const EdgeReport edges = checkEdges(cleaned.triangles);
    std::string surface = "closed";
    if (edges.closedEdges == 0 && edges.isClosed()) {
        surface = "none: every triangle is a point or a line";
    } else if (!edges.isClosed()) {
        surface = "open: " + counted(edges.openEdges, "edge") + " of one triangle, " +
                  std::to_string(edges.overfullEdges) + " of more than two, " +
                  std::to_string(edges.twistedEdges) + " where the two neighbours face different sides";
    }
    printRow("surface", surface);
    const CleanReport& report = cleaned.report;
    printRow("cleaning", counted(report.weldedVertices, "vertex copy", "vertex copies") + " welded, " +
                             std::to_string(report.unusedVertices) + " unused, " +
                             counted(report.degenerateTriangles, "triangle") + " without area kept, " +
                             counted(report.duplicateTriangles, "duplicate") + " dropped");
}

void describeReach(const Reach& reach, const BuildReport& report) {
    printRow("out of reach", counted(report.unreachableTriangles, "triangle") + ", never within " +
                                 readable(reach.cap) + " of the part; planning leaves them out");
}

void describeTree(const BuildReport& report) {
    const TreeStatistics& tree = report.tree;
    std::string leaves = std::to_string(tree.leaves);
    for (std::size_t size = 1; size < tree.leavesBySize.size(); ++size) {
        leaves += (size == 1 ? ": " : ", ") + std::to_string(tree.leavesBySize[size]) + " of " +
                  std::to_string(size);
    }
    printRow("tree", description(report.options));
    printRow("  nodes",
             std::to_string(tree.nodes) + ", " + readable(tree.meanChildren) + " children on average");
    printRow("  leaves", leaves);
    printRow("  depth", std::to_string(tree.depth));
    printRow("  bytes",
             std::to_string(tree.bytes) + ", " +
                 readable(static_cast<double>(tree.bytes) / static_cast<double>(report.triangles)) +
                 " per triangle");
    printRow("  build seconds", readable(report.seconds));
}

}  // namespace

Model describeMesh(const Mesh& mesh, const std::string& reading, const BuildOptions& options,
                   const std::optional<Reach>& reach) {
    describeReading(mesh, reading);
    describeTriangles(mesh, clean(mesh));
    const Model model = Model::build(mesh, options, reach);
    if (reach) describeReach(*reach, model.report());
    describeTree(model.report());
    return model;
}

}  // namespace clearway::cli
