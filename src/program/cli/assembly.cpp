#include "program/cli/assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "clearway/query.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "mesh/components.h"
#include "model/solids.h"
#include "problem/config.h"
#include "program/cli/csv_cells.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/render/render.h"

namespace clearway::cli {
namespace {

constexpr double kShallow = 5e-4;          ///< of the smaller part's diagonal: a contact at most so deep
constexpr double kBelow = 1e-3;            ///< of the smaller part's diagonal, below a surface
constexpr std::size_t kMostSamples = 200;  ///< of a part's triangles
constexpr std::size_t kMostPairRows = 40;  ///< of each kind, on screen

using TriangleCorners = std::array<Vector3, 3>;

/// A component with what queries need. Solids are made when first asked for.
class AssembledPart {
  public:
    explicit AssembledPart(Mesh componentMesh)
        : mesh(std::move(componentMesh)), model(Model::build(mesh)), box(boundingBox(mesh)) {}

    const std::string& name() const { return mesh.components[0].name; }
    double diagonal() const { return box.diagonal().norm(); }
    TriangleCorners corners(std::int64_t triangle) const {
        const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(triangle)];
        return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    }

    const Solids& solids() {
        if (!solids_) solids_ = makeSolids(mesh).solids;
        return *solids_;
    }
    bool isClosed() { return solids().refusals().empty(); }
    /// Whether a piece of the other part lies wholly inside of this one.
    bool holds(AssembledPart& other) {
        return isClosed() && solids().holding({}, other.solids(), {}).has_value();
    }
    /// The part must be closed.
    const OverlapMeter& meter() {
        if (!meter_) meter_.emplace(mesh, model, solids_);
        return *meter_;
    }

    Mesh mesh;
    Model model;
    Box box;

  private:
    std::shared_ptr<const Solids> solids_;
    std::optional<OverlapMeter> meter_;
};

/// How deep the parts reach into each other: the deeper of both ways that a closed part can measure.
std::optional<DeepestPoint> depthOf(AssembledPart& a, AssembledPart& b, double shallow) {
    std::optional<DeepestPoint> deepest;
    for (const auto& [outer, inner] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        if (!outer->isClosed()) continue;
        const DeepestPoint found = outer->meter().deepest(inner->mesh, {}, shallow);
        if (!deepest || found.lower > deepest->lower) deepest = found;
    }
    return deepest;
}

/// A point just below a surface of b that is inside of both closed parts; none is known where the samples have none. Parts that coincide
/// have their surfaces in each other's, so that no point of these lies deep.
std::optional<Vector3> sharedPoint(AssembledPart& a, AssembledPart& b) {
    if (!a.isClosed() || !b.isClosed()) return std::nullopt;
    const double below = kBelow * std::min(a.diagonal(), b.diagonal());
    const std::size_t step = std::max<std::size_t>(1, b.mesh.triangles.size() / kMostSamples);
    for (std::size_t i = 0; i < b.mesh.triangles.size(); i += step) {
        const auto& [p, q, r] = b.mesh.triangles[i];
        const Vector3 &u = b.mesh.vertices[p], &v = b.mesh.vertices[q], &w = b.mesh.vertices[r];
        const Vector3 normal = (v - u).cross(w - u).normalized(), middle = (u + v + w) / 3;
        for (const double side : {-below, below}) {
            const Vector3 point = middle + side * normal;
            if (point.allFinite() && a.solids().hold(point) && b.solids().hold(point)) return point;
        }
    }
    return std::nullopt;
}

void findEscape(const AssembledPart& a, const AssembledPart& b, PartPair& pair) {
    const SceneClearance clearance(Scene(b.model, a.model));
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const EscapeDistance way = clearance.escapeDistance({}, sign * Vector3::Unit(axis));
            if (pair.escape && pair.escape->upper <= way.upper) continue;
            pair.escape = way;
            pair.escapeDirection = std::string(sign > 0 ? "+" : "-") + kAxisNames[axis];
        }
    }
}

/// The length of the shortest move that parts two triangles which meet. It is across one of the triangles, or across an edge of each. 0 for
/// triangles that are points or lie on one line.
double crossingOf(const TriangleCorners& a, const TriangleCorners& b) {
    double least = std::numeric_limits<double>::infinity();
    const auto lookAlong = [&](const Vector3& axis) {
        const double length = axis.norm();
        if (!(length > 0)) return;
        const auto [leastA, mostA] = std::minmax({axis.dot(a[0]), axis.dot(a[1]), axis.dot(a[2])});
        const auto [leastB, mostB] = std::minmax({axis.dot(b[0]), axis.dot(b[1]), axis.dot(b[2])});
        least = std::min(least, std::min(mostA - leastB, mostB - leastA) / length);
    };
    const auto edge = [](const TriangleCorners& corners, int k) -> Vector3 {
        return corners[(k + 1) % 3] - corners[k];
    };
    for (const TriangleCorners& corners : {a, b}) lookAlong(edge(corners, 0).cross(edge(corners, 1)));
    for (int i = 0; i < 9; ++i) lookAlong(edge(a, i / 3).cross(edge(b, i % 3)));
    return std::isfinite(least) ? least : 0;
}

/// Makes the pair a contact, or an overlap where triangles cross by more than `shallow`: thin sheets may cut through each other without
/// a point that lies deep in one.
void describeTouching(const AssembledPart& a, const AssembledPart& b, double shallow, Workspace& workspace,
                      PartPair& pair) {
    pair.kind = PartPair::Kind::kContact;
    Box where;
    double mostCrossing = shallow;
    Vector3 crossingAt;
    for (const DistanceResult& each : nearPairs(b.model, a.model, {}, 0, workspace)) {
        if (!each.collides()) continue;
        ++pair.touchingTriangles;
        where.extend(each.witness->pointOnEnvironment);
        const double crossing =
            crossingOf(b.corners(each.witness->partTriangle), a.corners(each.witness->environmentTriangle));
        if (crossing <= mostCrossing) continue;
        mostCrossing = crossing;
        crossingAt = each.witness->pointOnEnvironment;
    }
    if (!where.isEmpty()) pair.at = where.center();
    if (mostCrossing == shallow) return;
    pair.kind = PartPair::Kind::kOverlap;
    pair.at = crossingAt;
}

/// Nothing where the parts are farther apart than `near`.
std::optional<PartPair> pairOf(AssembledPart& a, AssembledPart& b, double near, Workspace& workspace) {
    DistanceOptions options;
    options.cap = near;
    const DistanceResult gap = distance(b.model, a.model, {}, options, workspace);
    const bool isInside = !gap.collides() && a.box.intersects(b.box) && (a.holds(b) || b.holds(a));
    if (!gap.witness && !gap.collides() && !isInside) return std::nullopt;
    PartPair pair;
    pair.a = a.name();
    pair.b = b.name();
    if (!gap.collides() && !isInside) {
        pair.lower = gap.lower;
        pair.upper = gap.upper;
        pair.at = (gap.witness->pointOnPart + gap.witness->pointOnEnvironment) / 2;
        return pair;
    }
    const double shallow = kShallow * std::min(a.diagonal(), b.diagonal());
    pair.depth = depthOf(a, b, shallow);
    pair.kind = PartPair::Kind::kOverlap;
    if (isInside || (pair.depth && pair.depth->lower > shallow)) {
        pair.at = pair.depth->point;
    } else if (const std::optional<Vector3> shared = sharedPoint(a, b)) {
        pair.doCoincide = true;
        pair.at = *shared;
    } else {
        describeTouching(a, b, shallow, workspace, pair);
    }
    if (pair.kind == PartPair::Kind::kOverlap) findEscape(a, b, pair);
    return pair;
}

std::string mostDepth(const PartPair& pair) {
    return pair.depth ? ", at most " + shownLength(pair.depth->upper) + " deep"
                      : "; neither is a solid, so no depth is known";
}

std::string pairRow(const PartPair& pair) {
    const std::string names = fmt::format("'{}' and '{}'", pair.a, pair.b), at = " at " + shownPlace(pair.at);
    switch (pair.kind) {
        case PartPair::Kind::kOverlap:
            return fmt::format("{}, {}{}; pushed through '{}', '{}' is out of it {} along {}", names,
                               pair.doCoincide              ? "surfaces coincide around a shared volume"
                               : pair.touchingTriangles > 0 ? "surfaces cross" + mostDepth(pair)
                                                            : shownLength(pair.depth->upper) + " deep",
                               at, pair.a, pair.b, shownLength(pair.escape->upper), pair.escapeDirection);
        case PartPair::Kind::kContact:
            return fmt::format(
                "{}, {} around {}{}", names,
                counted(pair.touchingTriangles, "touching pair of triangles", "touching pairs of triangles"),
                shownPlace(pair.at), mostDepth(pair));
        case PartPair::Kind::kGap:
            break;
    }
    return fmt::format("{}, {}{}", names, shownLength(pair.lower), at);
}

constexpr const char* kPairKinds[] = {"overlap", "contact", "gap"};  // as PartPair::Kind

Json jsonOf(const PartPair& pair) {
    Json json = {{"kind", kPairKinds[static_cast<int>(pair.kind)]},
                 {"a", pair.a},
                 {"b", pair.b},
                 {"gap", {pair.lower, pair.upper}},
                 {"at", toJson(pair.at)},
                 {"touching_triangles", pair.touchingTriangles},
                 {"coincide", pair.doCoincide},
                 {"depth", nullptr},
                 {"escape", nullptr}};
    if (pair.depth) json["depth"] = {pair.depth->lower, pair.depth->upper};
    if (pair.escape)
        json["escape"] = {{"direction", pair.escapeDirection},
                          {"lower", toJson(pair.escape->lower)},
                          {"upper", toJson(pair.escape->upper)}};
    return json;
}

std::string pairTable(const std::vector<PartPair>& pairs) {
    std::string text =
        "kind,a,b,gap_lower,gap_upper,x,y,z,touching_triangles,coincide,depth_lower,depth_upper,escape,"
        "escape_upper\n";
    for (const PartPair& pair : pairs) {
        text +=
            fmt::format("{},{},{},{},{},{},{},{:d},{},{},{},{}\n", kPairKinds[static_cast<int>(pair.kind)],
                        textCell(pair.a), textCell(pair.b), formatNumber(pair.lower),
                        formatNumber(pair.upper), numberCells(pair.at), pair.touchingTriangles,
                        pair.doCoincide, pair.depth ? formatNumber(pair.depth->lower) : "",
                        pair.depth ? formatNumber(pair.depth->upper) : "", pair.escapeDirection,
                        pair.escape ? formatNumber(pair.escape->upper) : "");
    }
    return text;
}

}  // namespace

std::vector<PartPair> pairsOf(const Mesh& assembly, double near) {
    std::vector<std::unique_ptr<AssembledPart>> parts;
    const std::size_t count = componentsOf(assembly).size();
    for (std::size_t i = 0; i < count; ++i) {
        Mesh mesh = meshOfComponents(assembly, {i});
        if (!mesh.triangles.empty()) parts.push_back(std::make_unique<AssembledPart>(std::move(mesh)));
    }
    std::vector<PartPair> pairs;
    Workspace workspace;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = i + 1; k < parts.size(); ++k) {
            if (parts[i]->box.exteriorDistance(parts[k]->box) > near) continue;
            workspace.forgetWarmStart();
            if (auto pair = pairOf(*parts[i], *parts[k], near, workspace)) pairs.push_back(std::move(*pair));
        }
    }
    const auto order = [](const PartPair& pair) {
        return std::tuple(pair.kind, pair.depth ? -pair.depth->lower : 0.0, pair.lower);
    };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const PartPair& a, const PartPair& b) { return order(a) < order(b); });
    return pairs;
}

void drawPairs(const Mesh& assembly, const std::vector<PartPair>& pairs, const std::string& file) {
    render::RenderOptions drawing;
    drawing.marksContacts = true;
    const std::vector<Component> components = componentsOf(assembly);
    std::map<std::string, double> sizes;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
        sizes[components[i].name] = boundingBox(meshOfComponents(assembly, {i})).diagonal().norm();
        if (sizes[components[i].name] > sizes[components[largest].name]) largest = i;
    }
    std::set<std::string> meeting;
    for (const PartPair& pair : pairs) {
        if (pair.kind == PartPair::Kind::kGap) break;
        drawing.marks.push_back(pair.at);
        meeting.insert(sizes[pair.a] < sizes[pair.b] ? pair.a : pair.b);
    }
    std::vector<std::size_t> chosen, rest;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const bool isChosen = i != largest && (meeting.empty() || meeting.count(components[i].name) > 0);
        (isChosen ? chosen : rest).push_back(i);
    }
    if (chosen.empty()) throw std::invalid_argument("--picture is of several parts, and there is one alone");
    const render::PosedPart pose{{}, 0, false, !meeting.empty()};
    const render::Image picture = render::render(meshOfComponents(assembly, chosen),
                                                 meshOfComponents(assembly, rest), {pose}, {}, drawing);
    render::writePng(picture, file);
    tell({{"picture", fmt::format("{}, {} x {}", file, picture.width, picture.height), "picture", file}});
}

void tellPairs(const std::vector<PartPair>& pairs, double near, const std::string& csvFile) {
    Json json = Json::array();
    for (const PartPair& pair : pairs) json.push_back(jsonOf(pair));
    for (std::size_t kind = 0; kind < 3; ++kind) {
        std::size_t count = 0;
        for (const PartPair& pair : pairs) {
            if (static_cast<std::size_t>(pair.kind) == kind && ++count <= kMostPairRows)
                printRow(kPairKinds[kind], pairRow(pair));
        }
        if (count > kMostPairRows)
            printRow(kPairKinds[kind],
                     fmt::format("{} more; --csv or --json writes all", count - kMostPairRows));
    }
    if (pairs.empty()) printRow("parts", "none are nearer to each other than " + shownLength(near));
    facts()["near"] = near;
    facts()["pairs"] = json;
    if (!csvFile.empty()) replaceFile(csvFile, [&](std::ostream& out) { out << pairTable(pairs); });
}

}  // namespace clearway::cli
