#include "program/render/legend.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "program/render/ink_mask.h"

namespace clearway::render {

namespace {

const Colour kTextColour = sRgb(40, 42, 48);
/// All lengths of a legend follow from the size of the picture.
struct Layout {
    double letters;  ///< height of a digit
    double left, width, top, bottom;

    Layout(int pictureWidth, int pictureHeight)
        : letters(std::max(6.0, 0.024 * std::min<double>(pictureHeight, 0.7 * pictureWidth))),
          left(pictureWidth - 8 * letters),
          width(1.4 * letters),
          top(0.30 * pictureHeight),
          bottom(0.78 * pictureHeight) {}

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

void drawTicks(const Layout& layout, double most, double thin, int pictureWidth, InkMask& ink) {
    const int steps = stepsTo(most);
    std::vector<std::string> ticks;
    double widest = 0;
    for (int i = 0; i <= steps; ++i) {
        ticks.push_back(tickText(most * i / steps));
        widest = std::max(widest, ink.widthOf(ticks.back(), layout.letters));
    }
    const double left = layout.right() + 0.9 * layout.letters;
    const double room = pictureWidth - left - 0.3 * layout.letters;
    const double figures = layout.letters * std::min(1.0, room / widest);  // the longest tick has room
    for (int i = 0; i <= steps; ++i) {
        const double y = layout.yOf(double(i) / steps);
        ink.drawLine(layout.right(), y, layout.right() + 0.5 * layout.letters, y, thin);
        ink.drawText(ticks[i], left, y + 0.5 * figures, figures);
    }
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

}  // namespace

Area areaBesideLegend(int width, int height) {
    const Layout layout(width, height);
    const double border = 1.2 * layout.letters;
    return {border, border, layout.left - 2.2 * layout.letters, height - border};
}

void drawLegend(double most, const std::vector<double>& clearances, Image& image) {
    const Layout layout(image.width, image.height);
    const double letters = layout.letters, thin = std::max(1.0, 0.07 * letters);
    fillScale(layout, image);
    InkMask ink(std::max(0, static_cast<int>(layout.left - 2 * letters)), image.width, image.height);
    ink.drawFrame({layout.left, layout.top, layout.right(), layout.bottom}, thin);
    drawTicks(layout, most, thin, image.width, ink);
    for (const double clearance : clearances) {
        const double y = layout.yOf(clearance / most), x = layout.left - 0.35 * letters;
        ink.drawLine(x, y, x - 0.45 * letters, y, 0.28 * letters);
    }
    const double width = ink.widthOf("clearance", letters);
    ink.drawText("clearance", std::min(layout.left, image.width - width - 0.8 * letters),
                 layout.top - 1.6 * letters, letters);
    ink.layOver(image, kTextColour);
}

}  // namespace clearway::render
