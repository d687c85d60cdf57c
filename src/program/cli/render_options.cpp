#include "program/cli/render_options.h"

#include <fmt/format.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include "core/number.h"
#include "program/options/print.h"
#include "program/render/camera.h"

namespace clearway::cli {

namespace {

constexpr double kWidestAngle = 170;  ///< degrees

std::string viewList() {
    std::string all = "inside (cut open beside the path, close up)";
    for (const render::NamedView& view : render::namedViews())
        all += std::string(", ") + view.name + " (" + view.about + ")";
    return all;
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
                    if (drawing.angle >= kWidestAngle)
                        throw Expected{"degrees below " + readable(kWidestAngle)};
                });
    line.option("--cut PLANE",
                "removes the environment on the camera's side of a plane: x=D, y=D, z=D, or A,B,C,D for "
                "Ax+By+Cz=D",
                [&](const std::string& text) { drawing.cut = cutOf(text); });
}

}  // namespace

std::vector<double> numbersOf(const std::string& text, const std::string& expected) {
    std::vector<std::string> words;
    boost::split(words, text, boost::is_any_of(","));
    std::vector<double> numbers;
    for (const std::string& word : words) numbers.push_back(number(word, expected));
    return numbers;
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

}  // namespace clearway::cli
