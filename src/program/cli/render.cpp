#include "program/cli/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clearway/query.h"
#include "core/number.h"
#include "problem/clearance_word.h"
#include "program/cli/film.h"
#include "program/cli/overlaps.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print_audit.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"
#include "program/render/camera.h"

namespace clearway::cli {

namespace {

constexpr std::size_t kMostPoses = 200;
constexpr int kLeastSide = 16, kLargestSide = 16384;          ///< of a picture, pixels
constexpr double kNarrowestAngle = 1e-3, kWidestAngle = 170;  ///< degrees
constexpr double kFarthestPlace =
    1e15;  ///< of the camera, in coordinates: rays are in float, which squares them

struct RenderArguments {
    ProblemChoice problem;
    std::string path, out;
    TreeChoice trees;
    render::RenderOptions drawing;
    std::size_t poseCount = kUsualPoses;
    std::vector<double> shares;  ///< the values of --at
    FilmChoice film;
};

/// Reads numbers with commas between them.
std::vector<double> numbersOf(const std::string& text, const std::string& expected) {
    std::vector<std::string> words;
    boost::split(words, text, boost::is_any_of(","));
    std::vector<double> numbers;
    for (const std::string& word : words) numbers.push_back(number(word, expected));
    return numbers;
}

std::vector<double> sharesOf(const std::string& text) {
    const Expected expected{"numbers from 0 to 1, at most " + std::to_string(kMostPoses)};
    const std::vector<double> shares = numbersOf(text, expected.what);
    const auto isShare = [](double share) { return share >= 0 && share <= 1; };
    if (shares.size() > kMostPoses || !std::all_of(shares.begin(), shares.end(), isShare)) throw expected;
    return shares;
}

std::string viewList() {
    std::string all = "inside (cut open beside the path, close up)";
    for (const render::NamedView& view : render::namedViews())
        all += std::string(", ") + view.name + " (" + view.about + ")";
    return all;
}

Vector3 pointOf(const std::string& text) {
    const Expected expected{"three numbers X,Y,Z of at most " + readable(kFarthestPlace)};
    const std::vector<double> numbers = numbersOf(text, expected.what);
    if (numbers.size() != 3) throw expected;
    const Vector3 point(numbers[0], numbers[1], numbers[2]);
    if (!(point.cwiseAbs().maxCoeff() <= kFarthestPlace)) throw expected;
    return point;
}

void readSize(const std::string& text, render::RenderOptions& drawing) {
    const std::size_t x = text.find('x');
    const auto width = parseInteger(text.substr(0, x));
    const auto height = parseInteger(x == std::string::npos ? "" : text.substr(x + 1));
    for (const auto& side : {width, height}) {
        if (side && *side >= kLeastSide && *side <= kLargestSide) continue;
        throw Expected{fmt::format("WIDTHxHEIGHT, each {} to {}", kLeastSide, kLargestSide)};
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
                    if (drawing.angle < kNarrowestAngle || drawing.angle >= kWidestAngle)
                        throw Expected{"degrees from " + readable(kNarrowestAngle) + ", below " +
                                       readable(kWidestAngle)};
                });
    line.option("--cut PLANE",
                "removes the environment on the camera's side of a plane: x=D, y=D, z=D, or A,B,C,D for "
                "Ax+By+Cz=D",
                [&](const std::string& text) { drawing.cut = cutOf(text); });
}

void addDrawing(CommandLine& line, render::RenderOptions& drawing) {
    line.option("--size WxH", "pixels (1280x720)", [&](const std::string& text) { readSize(text, drawing); });
    addCamera(line, drawing);
    line.flag("--axes", "draws the directions of x, y and z in a corner", drawing.hasAxes);
    line.option("--scale D",
                "clearance at the top of the colour scale (a round number, a few times the least clearance)",
                positive(drawing.scaleMost));
    line.option("--samples N", "rays for each pixel, 1 to 4096 (16)", integer<int>(drawing.samples, 1, 4096));
}

bool readArguments(const Arguments& arguments, RenderArguments& given) {
    CommandLine line(
        "clearway render PROBLEM.cfg [IN.path] (--out FILE | --frames DIR | --video FILE) [options]",
        "Draws the environment and the part at poses along the path, coloured by clearance; "
        "without a path, at\n"
        "the problem's start and goal (a goal outside has no pose). --frames and --video show the "
        "motion along the path,\n"
        "beside --out or in its place. Coordinates and lengths are the environment's; z is up.");
    addProblem(line, given.problem);
    line.argument("[IN.path]", input(given.path));
    line.option("--out FILE", "the picture, a PNG file", to(given.out));
    addFilm(line, given.film, [&] { return !given.path.empty(); });
    addDrawing(line, given.drawing);
    const auto withPath = [&](const Reader& read) {
        return [&given, read](const std::string& text) {
            if (given.path.empty()) throw Expected{"only with a path file beside the problem"};
            if (given.out.empty()) throw Expected{"only with --out: a film shows the whole path"};
            read(text);
        };
    };
    line.option("--poses N", "number of poses, evenly along the path (4)",
                withPath(integer<std::size_t>(given.poseCount, 1, kMostPoses)));
    line.option("--at T,...", "these poses, in place of --poses: 0 is the start, 1 the end",
                withPath([&](const std::string& text) { given.shares = sharesOf(text); }));
    line.exclude("--at", "--poses");
    addJson(line);
    addCache(line, given.trees);
    if (!line.parse(arguments)) return false;
    if (given.out.empty() && !given.film.isWanted())
        throw std::invalid_argument("--out is missing, expected one of --out, --frames and --video");
    return true;
}

/// The poses that a problem states.
std::vector<PartState> endsOf(const Problem& problem) {
    if (problem.outside) return {problem.start};
    return {problem.start, problem.goal};
}

/// Prints a row about a pose at a share of the path, and keeps its value.
void tellPose(double share, const PartState& state, const std::string& shown, const Json& found) {
    printRow("pose at " + readable(share), shown);
    Json json = {{"share", share}, {"pose", toJson(state)}};
    json.update(found);
    facts()["poses"].push_back(json);
}

void tellPose(double share, const PartState& state, const Scene& scene, const PoseClearance& at,
              const WhyInvalid& why) {
    const MeshNames names = distinctMeshNames(scene, at.nearest);
    const std::string word = clearanceWord(scene);
    const std::string between = !at.nearest.witness
                                    ? " or more"
                                    : fmt::format("{}, between '{}' and '{}'", slackLimit(scene, at.nearest),
                                                  names.part, names.environment);
    tellPose(share, state,
             !why.isValid()         ? "NOT valid: " + why.words()
             : std::isinf(at.lower) ? "nothing to keep clear of"
                                    : word + " " + shownLength(at.lower) + between + leftOutAt(at),
             {{"valid", at.isValid()},
              {word, toJson(at.lower)},
              {"pair", closestPair(at.nearest, names.part, names.environment)}});
}

/// Throws before long work when an output cannot be written.
void requireOutputs(const RenderArguments& given, const Problem& problem, std::size_t states) {
    std::vector<std::string> inputs = inputsOf(problem);
    if (!given.path.empty()) inputs.push_back(given.path);
    OutputFiles files(inputs);
    files.add("--out", given.out, {".png"});
    given.film.require(given.drawing, states, given.out, files);
    requireFactsFile(files);
}

/// Writes the picture of --out and prints a row about each pose and the file. Returns false when interrupted.
bool writePicture(const RenderArguments& given, const Model& part, const FilmScene& scene) {
    const std::size_t usual = given.path.empty() ? scene.line.states().size() : given.poseCount;
    auto poses =
        posesAt(scene.line, given.shares.empty() ? evenShares(usual) : given.shares, scene.clearance, true);
    chooseGhosts(part, poses);
    const render::Image picture =
        render::render(scene.part, scene.environment, poses, scene.way, given.drawing);
    if (picture.pixels.empty()) return printRow("picture", "none, interrupted"), false;
    render::writePng(picture, given.out);
    tell({{"picture", fmt::format("{}, {} x {}", given.out, picture.width, picture.height), "picture",
           given.out}});
    return true;
}

}  // namespace

std::vector<render::PosedPart> posesAt(const PathLine& line, const std::vector<double>& shares,
                                       const SceneClearance& clearance, bool isPrinted) {
    std::vector<render::PosedPart> poses;
    for (const double share : shares) {
        const PartState state = line.at(share);
        const Pose X_environmentPart = poseOf(state);
        if (clearance.isOutOfRange(X_environmentPart)) {
            poses.push_back({state, std::numeric_limits<double>::infinity()});
            if (!isPrinted) continue;
            tellPose(share, state, "out of the problem's bounds", Json::object());
            continue;
        }
        const PoseClearance at = clearance.at(X_environmentPart);
        poses.push_back({state, at.lower});
        poses.back().isInContact = !at.isValid();
        if (isPrinted)
            tellPose(share, state, clearance.scene(), at, clearance.whyInvalid(X_environmentPart, at));
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (shares[i] == 0) poses[i].role = render::PoseRole::kStart;
        if (shares[i] == 1) poses[i].role = render::PoseRole::kGoal;
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
    heedInterrupts();  // before files are tried out, so that an interrupt leaves none of them
    requireOutputs(given, problem, states.size());
    given.drawing.isStopped = isInterrupted;
    given.drawing.unit = problem.unit;
    ElapsedLine elapsed("rendering");
    ProblemScenes scenes(problem, given.trees);
    const Mesh environment = shownEnvironment(problem, scenes.meshes().worlds);
    const Scene scene = scenes.scene(problem);
    given.drawing.scaleTitle = clearanceWord(scene);
    printWarnings(problem.warnings);
    const SceneClearance clearance(scene);
    const PathLine line(states, scene.part.radiusAboutOrigin());
    const auto way = hasPath && !isInterrupted() ? posesAt(line, evenShares(kWayPoses), clearance, false)
                                                 : std::vector<render::PosedPart>{};
    if (!isInterrupted()) {
        const std::vector<FoundOverlap> overlaps = overlapsAlong(problem, scenes.meshes(), scene, states);
        printOverlaps(overlaps);
        facts()["overlaps"] = toJson(overlaps);
        for (const FoundOverlap& found : overlaps) given.drawing.marks.push_back(found.deepest.point);
    }
    const FilmScene shown{scenes.meshes().part, environment, line, clearance, way, elapsed};
    const bool hasPicture = given.out.empty() || writePicture(given, scene.part, shown);
    const bool hasFilm = !given.film.isWanted() || writeFilm(given.film, shown, given.drawing);
    return hasPicture && hasFilm ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
