#include "program/cli/render.h"

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/planning/scene_clearance.h"
#include "clearway/query.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "program/cli/load_guard.h"
#include "program/cli/overlaps.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print.h"
#include "program/cli/shared_options.h"
#include "program/render/camera.h"

namespace clearway::cli {

namespace {

constexpr int kLeastSide = 16, kLargestSide = 16384;  ///< pixels
constexpr std::size_t kMostPoses = 200;
constexpr double kWidestAngle = 170;  ///< degrees

struct RenderArguments {
    ProblemChoice problem;
    std::string path, out;
    TreeChoice trees{buildPreset("fast"), ""};  // slow builds do not pay for a few hundred queries
    render::RenderOptions drawing;
    std::size_t poseCount = kUsualPoses;
    std::vector<double> shares;  ///< the values of --at
};

std::string viewList() {
    std::string all = "inside (cut open beside the path, close up)";
    for (const render::NamedView& view : render::namedViews())
        all += std::string(", ") + view.name + " (" + view.about + ")";
    return all;
}

/// Reads numbers with commas between them.
std::vector<double> numbersOf(const std::string& text, const std::string& expected) {
    std::vector<std::string> words;
    boost::split(words, text, boost::is_any_of(","));
    std::vector<double> numbers;
    for (const std::string& word : words) numbers.push_back(number(word, expected));
    return numbers;
}

Vector3 pointOf(const std::string& text) {
    const Expected expected{"three numbers X,Y,Z"};
    const std::vector<double> numbers = numbersOf(text, expected.what);
    if (numbers.size() != 3) throw expected;
    return {numbers[0], numbers[1], numbers[2]};
}

void readSize(const std::string& text, render::RenderOptions& drawing) {
    const std::size_t x = text.find('x');
    const auto width = parseInteger(text.substr(0, x));
    const auto height = parseInteger(x == std::string::npos ? "" : text.substr(x + 1));
    for (const auto& side : {width, height}) {
        if (side && *side >= kLeastSide && *side <= kLargestSide) continue;
        throw Expected{"WIDTHxHEIGHT, each " + std::to_string(kLeastSide) + " to " +
                       std::to_string(kLargestSide)};
    }
    drawing.width = static_cast<int>(*width);
    drawing.height = static_cast<int>(*height);
}

render::CutPlane cutOf(const std::string& text) {
    const Expected expected{"x=D, y=D, z=D or four numbers A,B,C,D with A, B, C not all 0"};
    if (text.size() > 2 && text[1] == '=' && text[0] >= 'x' && text[0] <= 'z') {
        return {Vector3::Unit(text[0] - 'x'), number(text.substr(2), expected.what)};
    }
    const std::vector<double> numbers = numbersOf(text, expected.what);
    if (numbers.size() != 4) throw expected;
    const Vector3 normal(numbers[0], numbers[1], numbers[2]);
    const double length = normal.stableNorm();
    if (!(length > 0)) throw expected;
    return {normal / length, numbers[3] / length};
}

std::vector<double> sharesOf(const std::string& text) {
    const Expected expected{"numbers from 0 to 1, at most " + std::to_string(kMostPoses)};
    const std::vector<double> shares = numbersOf(text, expected.what);
    const auto isShare = [](double share) { return share >= 0 && share <= 1; };
    if (shares.size() > kMostPoses || !std::all_of(shares.begin(), shares.end(), isShare)) throw expected;
    return shares;
}

void addCamera(CommandLine& line, render::RenderOptions& drawing) {
    line.option("--view NAME", viewList() + " (iso)", [&](const std::string& name) {
        if (name != "inside") render::viewNamed(name);
        drawing.view = name;
    });
    line.flag("--close", "fills the picture with the part's poses, not the whole environment",
              drawing.isClose);
    line.option("--eye X,Y,Z", "where the camera stands, in place of a view",
                [&](const std::string& text) { drawing.eye = pointOf(text); });
    line.exclude("--view", "--eye");
    line.option("--look-at X,Y,Z", "point that the camera at --eye looks at (the middle of the environment)",
                [&](const std::string& text) {
                    if (!drawing.eye) throw Expected{"only with --eye: a named view looks at all it shows"};
                    drawing.lookAt = pointOf(text);
                });
    line.option("--angle DEG", "angle of view along the picture's longer side (30)",
                [&](const std::string& text) {
                    drawing.angle = positiveNumber(text);
                    if (drawing.angle >= kWidestAngle)
                        throw Expected{"degrees below " + readable(kWidestAngle)};
                });
    line.option("--cut PLANE",
                "removes the environment on the camera's side of a plane: x=D, y=D, z=D, or A,B,C,D for "
                "Ax+By+Cz=D",
                [&](const std::string& text) { drawing.cut = cutOf(text); });
}

bool readArguments(const Arguments& arguments, RenderArguments& given) {
    CommandLine line("clearway render PROBLEM.cfg [IN.path] --out OUT.png [options]",
                     "Draws the environment and the part at poses along the path, coloured by clearance; "
                     "without a path, at\n"
                     "the problem's start and goal (a goal outside has no pose). Coordinates and lengths are "
                     "the environment's; z is up.");
    addProblem(line, given.problem);
    line.argument("[IN.path]", input(given.path));
    line.option("--out FILE", "the picture, a PNG file", to(given.out), CommandLine::Count::kRequired);
    line.option("--size WxH", "pixels (1280x720)",
                [&](const std::string& text) { readSize(text, given.drawing); });
    addCamera(line, given.drawing);
    const auto withPath = [&](const Reader& read) {
        return [&given, read](const std::string& text) {
            if (given.path.empty()) throw Expected{"only with a path file beside the problem"};
            read(text);
        };
    };
    line.option("--poses N", "number of poses, evenly along the path (4)",
                withPath(integer<std::size_t>(given.poseCount, 1, kMostPoses)));
    line.option("--at T,...", "these poses, in place of --poses: 0 is the start, 1 the end",
                withPath([&](const std::string& text) { given.shares = sharesOf(text); }));
    line.exclude("--at", "--poses");
    line.option("--scale D", "clearance at the top of the colour scale (a round number that holds all)",
                positive(given.drawing.scaleMost));
    line.option("--samples N", "rays for each pixel, 1 to 4096 (16)",
                integer<int>(given.drawing.samples, 1, 4096));
    addCache(line, given.trees);
    return line.parse(arguments);
}

/// The poses that a problem states.
std::vector<PartState> endsOf(const Problem& problem) {
    if (problem.outside) return {problem.start};
    return {problem.start, problem.goal};
}

void printPose(double share, const Scene& scene, const planning::PoseClearance& at) {
    const SceneDistance& nearest = at.nearest;
    const planning::MeshNames names = planning::meshNames(scene, nearest);
    const std::string between = nearest.partTriangle < 0
                                    ? " or more"
                                    : ", between '" + names.part + "' and '" + names.environment + "'";
    printRow("pose at " + readable(share),
             std::isinf(at.lower) ? "nothing to keep clear of"
             : nearest.collides() ? "IN COLLISION" + between
             : !at.isValid()      ? "NOT valid, too close, clearance " + readable(at.lower) + between
                                  : "clearance " + readable(at.lower) + between);
}

}  // namespace

std::vector<render::PosedPart> posesAt(const report::PathLine& line, const std::vector<double>& shares,
                                       const planning::SceneClearance& clearance, bool isPrinted) {
    std::vector<render::PosedPart> poses;
    for (const double share : shares) {
        const PartState state = line.at(share);
        const Pose X_environmentPart = poseOf(state);
        if (clearance.isOutOfReach(X_environmentPart)) {
            poses.push_back({state, std::numeric_limits<double>::infinity()});
            if (isPrinted) printRow("pose at " + readable(share), "out of the problem's bounds");
            continue;
        }
        const planning::PoseClearance at = clearance.at(X_environmentPart);
        poses.push_back({state, at.lower});
        if (isPrinted) printPose(share, clearance.scene(), at);
    }
    return poses;
}

void chooseGhosts(const Model& part, std::vector<render::PosedPart>& poses) {
    const auto tightest = std::min_element(
        poses.begin(), poses.end(),
        [](const render::PosedPart& a, const render::PosedPart& b) { return a.clearance < b.clearance; });
    Workspace workspace;
    std::vector<Pose> solid{poseOf(tightest->state)};
    for (render::PosedPart& pose : poses) {
        if (&pose == &*tightest) continue;
        const Pose X_part = poseOf(pose.state);
        pose.isGhost = std::any_of(solid.begin(), solid.end(), [&](const Pose& X_other) {
            return collides(part, part, nearestPose(inverse(X_other) * X_part), workspace);
        });
        if (!pose.isGhost) solid.push_back(X_part);
    }
}

int render(const Arguments& arguments) {
    RenderArguments given;
    if (!readArguments(arguments, given)) return kDone;
    const bool hasPath = !given.path.empty();
    const Problem problem = given.problem.read();
    const std::vector<PartState> states = hasPath ? readPath(given.path, problem.space) : endsOf(problem);
    std::vector<std::string> inputs = inputsOf(problem);
    if (hasPath) inputs.push_back(given.path);
    OutputFiles(inputs).add("--out", given.out, {".png"});
    const ElapsedLine elapsed("rendering");
    const Mesh part = loadPart(problem, guardedLoadMesh);
    const Mesh environment = shownEnvironment(problem);
    const Scene scene = given.trees.load(problem);
    const planning::SceneClearance clearance(scene);
    const report::PathLine line(states, scene.part.radiusAboutOrigin());
    const std::vector<double> shares =
        !given.shares.empty() ? given.shares : report::evenShares(hasPath ? given.poseCount : states.size());
    auto poses = posesAt(line, shares, clearance, true);
    chooseGhosts(scene.part, poses);
    const auto way = hasPath ? posesAt(line, report::evenShares(kWayPoses), clearance, false)
                             : std::vector<render::PosedPart>{};
    render::RenderOptions& drawing = given.drawing;
    const std::vector<FoundOverlap> overlaps = overlapsAlong(problem, scene, states);
    printOverlaps(overlaps);
    for (const FoundOverlap& found : overlaps) drawing.marks.push_back(found.deepest.point);
    render::writePng(render::render(part, environment, poses, way, drawing), given.out);
    printRow("picture",
             given.out + ", " + std::to_string(drawing.width) + " x " + std::to_string(drawing.height));
    return kDone;
}

}  // namespace clearway::cli
