// clearway render: a picture of a problem, and of the part on its way.
#include "program/render/render.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <stdexcept>

#include "clearway/planning/scene_clearance.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "program/cli/command_line.h"
#include "program/cli/elapsed_line.h"
#include "program/cli/load_guard.h"
#include "program/cli/path_poses.h"
#include "program/cli/planning_scene.h"
#include "program/cli/print.h"
#include "program/cli/tree_options.h"
#include "program/render/camera.h"
#include "program/report/path_line.h"

namespace clearway::cli {

namespace {

constexpr int kLargestSide = 16384;  ///< pixels
constexpr std::size_t kMostPoses = 200;

std::string viewList() {
    std::string all = "inside (cut open beside the path, close up)";
    for (const render::NamedView& view : render::namedViews())
        all += std::string(", ") + view.name + " (" + view.about + ")";
    return all;
}

CommandLine renderCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway render PROBLEM.cfg [IN.path] --out OUT.png [options]";
    commandLine.purpose =
        "Draws the environment and the part at poses along the path, coloured by clearance; without a path, "
        "at "
        "the\nproblem's start and goal. Coordinates and lengths are the environment's, z is up.";
    commandLine.positional = {"PROBLEM.cfg", "[IN.path]"};
    commandLine.options.add_options()                                                                //
        ("out", optionValue("FILE"), "the picture, a PNG file")                                      //
        ("size", optionValue("WxH"), "pixels (1280x720)")                                            //
        ("view", optionValue("NAME"), (viewList() + " (iso)").c_str())                               //
        ("close", "the part's poses fill the picture, not the whole environment")                    //
        ("eye", optionValue("X,Y,Z"), "where the camera stands, in place of a view")                 //
        ("look-at", optionValue("X,Y,Z"), "what it looks at (the middle of the environment)")        //
        ("angle", optionValue("DEG"), "what the picture's longer side takes in (30)")                //
        ("poses", optionValue("N"), "so many poses, evenly along the path (4)")                      //
        ("at", optionValue("T,..."), "these poses, in place of --poses: 0 is the start, 1 the end")  //
        ("cut", optionValue("PLANE"),
         "takes away the environment on the camera's side of a plane: x=D, y=D, z=D or A,B,C,D for "
         "Ax+By+Cz=D")  //
        ("scale", optionValue("D"),
         "clearance at the top of the colour scale (a round number that holds all)")                     //
        ("margin", optionValue("M"), "distance that counts as no clearance, in place of the problem's")  //
        ("samples", optionValue("N"), "rays for each pixel, 1 to 4096 (16)");
    addCacheOption(commandLine);
    return commandLine;
}

[[noreturn]] void refuse(const Options& options, const std::string& name, const std::string& expected) {
    throw std::invalid_argument("--" + name + " is '" + options.text(name) + "', expected " + expected);
}

std::vector<double> numbersOf(const Options& options, const std::string& name, const std::string& expected) {
    std::vector<std::string> words;
    const std::string text = options.text(name);
    boost::split(words, text, boost::is_any_of(","));
    std::vector<double> numbers;
    for (const std::string& word : words) {
        const std::optional<double> number = parseNumber(word);
        if (!number) refuse(options, name, expected);
        numbers.push_back(*number);
    }
    return numbers;
}

Vector3 pointOf(const Options& options, const std::string& name) {
    const char* const expected = "three numbers X,Y,Z";
    const std::vector<double> numbers = numbersOf(options, name, expected);
    if (numbers.size() != 3) refuse(options, name, expected);
    return {numbers[0], numbers[1], numbers[2]};
}

void readSize(const Options& options, render::RenderOptions& result) {
    std::vector<std::string> words;
    const std::string text = options.text("size");
    boost::split(words, text, boost::is_any_of("x"));
    std::vector<int> sides;
    for (const std::string& word : words) {
        const auto side = parseInteger(word);
        if (side && *side >= 16 && *side <= kLargestSide) sides.push_back(static_cast<int>(*side));
    }
    if (sides.size() != 2 || words.size() != 2) {
        refuse(options, "size", "WIDTHxHEIGHT, each 16 to " + std::to_string(kLargestSide));
    }
    result.width = sides[0];
    result.height = sides[1];
}

render::CutPlane cutOf(const Options& options) {
    const char* const expected = "x=D, y=D, z=D or four numbers A,B,C,D with A, B, C not all 0";
    const std::string text = options.text("cut");
    if (text.size() > 2 && text[1] == '=' && text[0] >= 'x' && text[0] <= 'z') {
        const std::optional<double> offset = parseNumber(text.substr(2));
        if (!offset) refuse(options, "cut", expected);
        return {Vector3::Unit(text[0] - 'x'), *offset};
    }
    const std::vector<double> numbers = numbersOf(options, "cut", expected);
    if (numbers.size() != 4) refuse(options, "cut", expected);
    const Vector3 normal(numbers[0], numbers[1], numbers[2]);
    const double length = normal.stableNorm();
    if (!(length > 0)) refuse(options, "cut", expected);
    return {normal / length, numbers[3] / length};
}

render::RenderOptions renderOptions(const Options& options) {
    render::RenderOptions result;
    if (options.has("size")) readSize(options, result);
    if (options.has("view")) {
        result.view = options.text("view");
        if (result.view != "inside") render::viewNamed(result.view);
    }
    if (options.has("eye")) result.eye = pointOf(options, "eye");
    if (options.has("look-at")) result.lookAt = pointOf(options, "look-at");
    if (options.has("look-at") && !options.has("eye"))
        refuse(options, "look-at", "--eye with it: a named view looks at all it shows");
    if (options.has("view") && options.has("eye")) refuse(options, "view", "either --view or --eye");
    if (options.has("angle")) {
        result.angle = options.positive("angle");
        if (result.angle >= 170) refuse(options, "angle", "degrees below 170");
    }
    if (options.has("cut")) result.cut = cutOf(options);
    if (options.has("scale")) result.scaleMost = options.positive("scale");
    if (options.has("samples")) result.samples = static_cast<int>(options.integer("samples", 1, 4096));
    result.isClose = options.has("close");
    return result;
}

/// Where along the path the part is shown.
std::vector<double> sharesOf(const Options& options, bool hasPath) {
    if (options.has("poses") && options.has("at")) refuse(options, "at", "either --at or --poses");
    for (const char* name : {"poses", "at"}) {
        if (options.has(name) && !hasPath) refuse(options, name, "a path file beside the problem");
    }
    if (options.has("at")) {
        const char* const expected = "numbers from 0 to 1, at most 200";
        const std::vector<double> shares = numbersOf(options, "at", expected);
        for (const double share : shares) {
            if (!(share >= 0 && share <= 1)) refuse(options, "at", expected);
        }
        if (shares.size() > kMostPoses) refuse(options, "at", expected);
        return shares;
    }
    if (!hasPath) return {0, 1};
    return report::evenShares(options.has("poses")
                                  ? static_cast<std::size_t>(options.integer("poses", 1, kMostPoses))
                                  : kUsualPoses);
}

}  // namespace

int render(const Arguments& arguments) {
    const std::optional<Options> given = parse(renderCommandLine(), arguments);
    if (!given) return kDone;
    const Options& options = *given;
    const std::string file = options.text("out");
    const bool hasPath = options.has("[IN.path]");
    const render::RenderOptions drawing = renderOptions(options);
    const std::vector<double> shares = sharesOf(options, hasPath);
    if (options.has("margin")) options.nonNegative("margin");  // all wrong usage first
    requireReplaceable(file);
    const std::string cache = cacheFolder(options);

    Problem problem = readProblem(options.text("PROBLEM.cfg"));
    if (options.has("margin")) problem.margin = options.nonNegative("margin");
    const std::vector<PartState> states = hasPath ? readPath(options.text("[IN.path]"), problem.space)
                                                  : std::vector<PartState>{problem.start, problem.goal};
    options.requireOtherFile("out", inputsOf(problem));
    if (hasPath) options.requireOtherFile("out", {options.text("[IN.path]")});
    const ElapsedLine elapsed("rendering");
    const Mesh part = guardedLoadPart(problem);
    const Mesh environment = shownEnvironment(problem);
    // A few hundred queries: trees that are built sooner than they are asked.
    const Scene scene = buildScene(problem, {}, buildPreset("fast"), cache);
    const planning::SceneClearance clearance(scene);
    const report::PathLine line(states, scene.part.radiusAboutOrigin());
    auto poses = posesAt(line, shares, clearance, true);
    chooseGhosts(scene.part, poses);
    const auto way = hasPath ? posesAt(line, report::evenShares(kWayPoses), clearance, false)
                             : std::vector<render::PosedPart>{};
    render::writePng(render(part, environment, poses, way, drawing), file);
    printRow("picture", file + ", " + std::to_string(drawing.width) + " x " + std::to_string(drawing.height));
    return kDone;
}

}  // namespace clearway::cli
