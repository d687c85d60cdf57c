#include "bench/public/published_paths.h"

#include <filesystem>

#include "clearway/planning/check_path.h"
#include "clearway/planning/se3_space.h"
#include "core/number.h"
#include "core/text.h"
#include "planning/space/ompl_states.h"
#include "support/oracle.h"
#include "support/path_check.h"

namespace clearway::testing::public_problems {
namespace {

constexpr double kPrinted = 1e-5;
constexpr int kPosesPerSegment = 20;

Box grown(const Problem& problem, const Box& bounds) {
    Vector3 slack = Vector3::Constant(kPrinted * bounds.diagonal().norm());
    if (problem.space == Space::kSe2) slack.z() = 0;
    return Box(bounds.min() - slack, bounds.max() + slack);
}

PartState stateAt(const Problem& problem, const PartState& from, const PartState& to, double t) {
    const ob::StateSpacePtr space =
        planning::makeSpace(problem.space, Box(Vector3::Constant(-1), Vector3::Constant(1)), 1);
    const auto a = planning::toOmpl(space, problem.space, from),
               b = planning::toOmpl(space, problem.space, to);
    ob::ScopedState<> at(b);
    if (t < 1) space->interpolate(a.get(), b.get(), t, at.get());
    return planning::fromOmpl(problem.space, at.get());
}

std::string inQuotes(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

PathVerdict judgePath(const PublicProblem& published, const std::string& path) {
    Problem problem = readProblem(published.file);
    const LoadedScene loaded = loadScene(problem);
    const Scene& scene = loaded.scene;
    problem.volume = grown(problem, boundsOf(problem, scene.environmentBox(), scene.part.box()));
    const std::vector<PartState> states = readPath(path, problem.space);
    const planning::PathAudit audit = planning::checkPath(problem, scene, states, {}).audit;
    const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));

    const std::string name = std::filesystem::path(path).filename().string();
    PathVerdict verdict;
    int confirmed = 0, undecided = 0, outOfBounds = 0, asked = 0;
    for (std::size_t i = 0; i < audit.segments.size(); ++i) {
        const planning::SegmentAudit& segment = audit.segments[i];
        const std::vector<PartState> motion = {states[i], states[std::min(i + 1, states.size() - 1)]};
        if (segment.isValid()) {
            asked += kPosesPerSegment;
            verdict.refuted += collisionsAlong(oracle, motion, problem, kPosesPerSegment) > 0;
            continue;
        }
        const planning::MotionReport& report = segment.motion;
        const bool isOut = report.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds;
        const double t = isOut ? report.blockedTime : report.closestTime;
        const PartState at = stateAt(problem, motion[0], motion[1], t);
        const bool isUndecided = report.verdict == planning::MotionVerdict::kUndecided;
        outOfBounds += isOut;
        undecided += isUndecided;
        ++asked;
        confirmed += isOut || oracle.collides(segment.X_environmentPart);
        std::vector<std::string> words = {published.name, name, std::to_string(i + 1), shortNumber(t)};
        for (const double value : {at.position.x(), at.position.y(), at.position.z(), at.rotation.x(),
                                   at.rotation.y(), at.rotation.z(), at.rotation.w()}) {
            words.push_back(shortNumber(value));
        }
        words.push_back(isOut ? "out of bounds" : isUndecided ? "undecided" : "in collision");
        words.push_back(inQuotes(segment.partMesh));
        words.push_back(report.closest.witness ? std::to_string(report.closest.witness->partTriangle) : "-1");
        words.push_back(inQuotes(segment.environmentMesh));
        words.push_back(report.closest.witness ? std::to_string(report.closest.witness->environmentTriangle)
                                               : "-1");
        verdict.invalidRows.push_back(clearway::joined(words, ","));
    }
    verdict.row = published.name + "," + name;
    for (const std::size_t count : {states.size(), audit.segments.size(), audit.notValid.size(),
                                    std::size_t(confirmed), std::size_t(undecided), std::size_t(outOfBounds),
                                    std::size_t(verdict.refuted), std::size_t(asked)}) {
        verdict.row += "," + std::to_string(count);
    }
    verdict.row += "," + shortNumber(audit.lowerClearance);
    return verdict;
}

}  // namespace clearway::testing::public_problems
