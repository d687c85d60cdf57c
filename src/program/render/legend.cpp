#include "program/render/legend.h"

#include <algorithm>
#include <cmath>

#include "core/number.h"
#include "program/render/ink_mask.h"
#include "program/render/marks.h"
#include "program/render/outlines.h"

namespace clearway::render {

namespace {

constexpr double kLeastLetters = 4;  ///< height of the least readable digit, pixels
const Colour kTextColour = sRgb(40, 42, 48);

/// All lengths of a legend follow from the size of the picture.
struct Layout {
    double letters;  ///< height of a digit
    double left, width, top, bottom;
    double signsTop, signsBottom;

    Layout(int pictureWidth, int pictureHeight)
        : letters(std::max(6.0, 0.024 * std::min<double>(pictureHeight, 0.7 * pictureWidth))),
          left(pictureWidth - 8.6 * letters),
          width(1.4 * letters),
          top(0.17 * pictureHeight),
          bottom(0.60 * pictureHeight),
          signsTop(0.66 * pictureHeight),
          signsBottom(0.97 * pictureHeight) {}

    double right() const { return left + width; }
    double yOf(double share) const { return bottom + std::clamp(share, 0.0, 1.0) * (top - bottom); }
};

/// The largest of three numbers of steps whose ticks are short numbers.
int stepsTo(double most) {
    for (const int steps : {5, 4, 3}) {
        if (shortNumber(most / steps).size() <= std::max<std::size_t>(3, shortNumber(most).size() + 1))
            return steps;
    }
    return 2;
}

/// The value without rounding noise: "7.5" for 7.500000000000001.
std::string tickText(double value) {
    const double power = std::pow(10.0, 3 - std::floor(std::log10(std::max(value, 1e-300))));
    return value > 0 ? shortNumber(std::round(value * power) / power) : "0";
}

/// The height of letters, at most `letters`, at which the widest of the texts has room.
double lettersFor(const std::vector<std::string>& texts, double letters, double room, const InkMask& ink) {
    double widest = 0;
    for (const std::string& text : texts) widest = std::max(widest, ink.widthOf(text, letters));
    return letters * std::min(1.0, room / std::max(widest, 1e-9));
}

void drawTicks(const Layout& layout, const Legend& legend, double thin, int pictureWidth, InkMask& ink) {
    const double most = legend.most;
    const int steps = stepsTo(most);
    std::vector<std::string> ticks;
    for (int i = 0; i <= steps; ++i) ticks.push_back(tickText(most * i / steps));
    if (legend.isCutOff) ticks.back() = "\u2265 " + ticks.back();
    const double left = layout.right() + 0.9 * layout.letters;
    const double figures = lettersFor(ticks, layout.letters, pictureWidth - left - 0.3 * layout.letters, ink);
    for (int i = 0; i <= steps; ++i) {
        const double y = layout.yOf(double(i) / steps);
        ink.drawLine(layout.right(), y, layout.right() + 0.5 * layout.letters, y, thin);
        ink.drawText(ticks[i], left, y + 0.5 * figures, figures);
    }
}

/// Draws the title and, below it, the unit.
void drawTitle(const Layout& layout, const Legend& legend, int pictureWidth, InkMask& ink) {
    std::vector<std::string> lines = {legend.title};
    if (!legend.unit.empty()) lines.push_back("in " + legend.unit);
    const double room = pictureWidth - layout.left - 0.3 * layout.letters;
    const double letters = lettersFor(lines, layout.letters, room, ink);
    double y = layout.top - 1.4 * letters;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line, y -= 1.7 * letters)
        ink.drawText(*line, layout.left, y, letters);
}

/// Colours the scale's rows; only the first and the last may cover part of a pixel.
void fillScale(const Layout& layout, Image& image) {
    const auto cover = [](int pixel, double from, double to) {
        return static_cast<float>(std::min(pixel + 1.0, to) - std::max<double>(pixel, from));
    };
    const int left = std::max(0, static_cast<int>(layout.left));
    const int right = std::min(image.width, static_cast<int>(std::ceil(layout.right())));
    for (int y = static_cast<int>(layout.top); y < layout.bottom; ++y) {
        const Colour colour = clearanceColour((layout.bottom - y - 0.5) / (layout.bottom - layout.top));
        for (int x = left; x < right; ++x) {
            const float share = cover(x, layout.left, layout.right()) * cover(y, layout.top, layout.bottom);
            image.at(x, y) += share * (colour - image.at(x, y));
        }
    }
}

constexpr const char* kWords[] = {"start", "goal",       "in between", "moving",
                                  "way",   "in contact", "overlap",    "contact or overlap"};  // as Sign

/// Draws on the right part of the picture, from `left` on, in one colour.
template <class Draw>
void drawIn(const Colour& colour, const Area& area, Image& image, const Draw& draw) {
    InkMask ink(std::max(0, static_cast<int>(area.left) - 4), image.width, image.height);
    draw(ink);
    ink.layOver(image, colour);
}

void fillBox(const Colour& colour, const Area& area, Image& image) {
    drawIn(colour, area, image, [&](InkMask& ink) { ink.fillBox(area); });
}

void drawBoxFrame(const Colour& colour, const Area& area, double width, Image& image) {
    const double in = 0.5 * width;
    drawIn(colour, area, image, [&](InkMask& ink) {
        ink.drawFrame({area.left + in, area.top + in, area.right - in, area.bottom - in}, width);
    });
}

/// A part of no particular clearance: a pale box.
void drawPart(Pen pen, double width, const Area& area, Image& image) {
    fillBox(Colour::Constant(0.85f), area, image);
    drawBoxFrame(penColour(pen), area, width, image);
}

void drawContact(double width, const Area& area, Image& image) {
    fillBox(contactColour(), area, image);
    drawIn(Colour::Zero(), area, image, [&](InkMask& ink) {
        ink.keepWithin(area);
        const double height = area.bottom - area.top, step = 0.45 * height;
        for (double x = area.left; x < area.right + height; x += step)
            ink.drawLine(x, area.top, x - height, area.bottom, 0.2 * step);
    });
    drawBoxFrame(penColour(Pen::kPlain), area, width, image);
}

/// The line along the path, in the colours of the scale.
void drawWay(const Area& area, Image& image) {
    const double y = 0.5 * (area.top + area.bottom), half = 0.16 * (area.bottom - area.top);
    for (int x = static_cast<int>(area.left); x < area.right; ++x) {
        const double share = (x - area.left) / (area.right - area.left);
        fillBox(clearanceColour(0.15 + 0.7 * share), {double(x), y - half, x + 1.0, y + half}, image);
    }
}

/// Draws the sign into an area of the legend.
void drawSign(Sign sign, const Area& area, Image& image) {
    const double thin = std::max(1.0, 0.08 * (area.bottom - area.top)), thick = 2 * thin;
    switch (sign) {
        case Sign::kStart:
            return drawPart(Pen::kStart, thick, area, image);
        case Sign::kGoal:
            return drawPart(Pen::kGoal, thick, area, image);
        case Sign::kBetween:
        case Sign::kMoving:
            return drawPart(Pen::kPlain, thin, area, image);
        case Sign::kWay:
            return drawWay(area, image);
        case Sign::kContact:
            return drawContact(thin, area, image);
        case Sign::kOverlap:
        case Sign::kMeeting:
            return drawIn(markColour(), area, image, [&](InkMask& ink) {
                const double radius = 0.42 * (area.bottom - area.top);
                ink.drawCircle(0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom), radius, thick);
            });
    }
}

/// One row for each sign, as far as rows that can be read have room.
void drawSigns(const Layout& layout, const std::vector<Sign>& signs, Image& image) {
    if (signs.empty()) return;
    InkMask text(std::max(0, static_cast<int>(layout.left)), image.width, image.height);
    std::vector<std::string> words;
    for (const Sign sign : signs) words.push_back(wordsOf(sign));
    const double pitch = std::min(2.1 * layout.letters,
                                  (layout.signsBottom - layout.signsTop) / static_cast<double>(signs.size()));
    const double wordsLeft = layout.right() + 0.7 * layout.letters;
    const double room = image.width - wordsLeft - 0.3 * layout.letters;
    const double letters = lettersFor(words, std::min(0.85 * layout.letters, pitch / 1.6), room, text);
    if (letters < kLeastLetters) return;
    double y = layout.signsTop + 0.5 * pitch;
    for (const Sign sign : signs) {
        const double half = std::min(0.6 * layout.width, 0.38 * pitch);
        drawSign(sign, {layout.left, y - half, layout.right(), y + half}, image);
        text.drawText(wordsOf(sign), wordsLeft, y + 0.5 * letters, letters);
        y += pitch;
    }
    text.layOver(image, kTextColour);
}

}  // namespace

std::string wordsOf(Sign sign) {
    return kWords[static_cast<std::size_t>(sign)];
}

std::vector<Sign> signsOf(const std::vector<PosedPart>& poses, bool hasMover) {
    const auto holds = [&](PoseRole role) {
        return std::any_of(poses.begin(), poses.end(),
                           [&](const PosedPart& pose) { return pose.role == role; });
    };
    std::vector<Sign> signs;
    if (holds(PoseRole::kStart)) signs.push_back(Sign::kStart);
    if (holds(PoseRole::kBetween)) signs.push_back(Sign::kBetween);
    if (hasMover) signs.push_back(Sign::kMoving);
    if (holds(PoseRole::kGoal)) signs.push_back(Sign::kGoal);
    return signs;
}

Area areaBesideLegend(int width, int height) {
    const Layout layout(width, height);
    const double border = 1.2 * layout.letters;
    return {border, border, layout.left - 2.2 * layout.letters, height - border};
}

void drawLegend(const Legend& legend, Image& image) {
    const Layout layout(image.width, image.height);
    const double letters = layout.letters, thin = std::max(1.0, 0.07 * letters);
    fillScale(layout, image);
    InkMask ink(std::max(0, static_cast<int>(layout.left - 2 * letters)), image.width, image.height);
    ink.drawFrame({layout.left, layout.top, layout.right(), layout.bottom}, thin);
    drawTicks(layout, legend, thin, image.width, ink);
    for (const double clearance : legend.clearances) {
        const double y = layout.yOf(clearance / legend.most), x = layout.left - 0.35 * letters;
        ink.drawLine(x, y, x - 0.45 * letters, y, 0.28 * letters);
    }
    drawTitle(layout, legend, image.width, ink);
    ink.layOver(image, kTextColour);
    drawSigns(layout, legend.signs, image);
}

}  // namespace clearway::render
