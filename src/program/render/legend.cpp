#include "program/render/legend.h"

#include <algorithm>
#include <cmath>

#include "core/number.h"
#include "program/render/lettering.h"

namespace clearway::render {

namespace {

const Colour kInk = sRgb(40, 42, 48);

/// All lengths of a legend follow from the size of the picture.
struct Layout {
    double letters;  ///< height of a figure
    double left, width, top, bottom;

    Layout(int pictureWidth, int pictureHeight)
        : letters(std::max(6.0, 0.024 * std::min<double>(pictureHeight, 0.7 * pictureWidth))),
          left(pictureWidth - 8 * letters),
          width(1.4 * letters),
          top(0.30 * pictureHeight),
          bottom(0.78 * pictureHeight) {}

    double yOf(double share) const { return bottom + std::clamp(share, 0.0, 1.0) * (top - bottom); }
};

/// The largest of a few numbers of steps that ends each step at a short number.
int stepsTo(double most) {
    for (const int steps : {5, 4, 3}) {
        if (shortNumber(most / steps).size() <= std::max<std::size_t>(3, shortNumber(most).size() + 1))
            return steps;
    }
    return 2;
}

/// Height of the figures beside the ticks: as the legend's, but that the longest of them has room.
double tickHeight(const std::vector<std::string>& ticks, double room, double letters) {
    double widest = 0;
    for (const std::string& tick : ticks) widest = std::max(widest, widthOfText(tick, letters));
    return widest > room ? letters * room / widest : letters;
}

/// "7.5" of 7.500000000000001.
std::string tickText(double value) {
    const double power = std::pow(10.0, 3 - std::floor(std::log10(std::max(value, 1e-300))));
    return value > 0 ? shortNumber(std::round(value * power) / power) : "0";
}

}  // namespace

Area areaBesideLegend(int width, int height) {
    const Layout layout(width, height);
    const double border = 1.2 * layout.letters;
    return {border, border, layout.left - 2.2 * layout.letters, height - border};
}

void drawLegend(double most, const std::vector<double>& clearances, Image& image) {
    const Layout layout(image.width, image.height);
    const double right = layout.left + layout.width, height = layout.bottom - layout.top;
    for (int y = static_cast<int>(layout.top); y < layout.bottom; ++y) {
        const double share = (layout.bottom - y - 0.5) / height;
        fillArea({layout.left, std::max<double>(y, layout.top), right, std::min(y + 1.0, layout.bottom)},
                 clearanceColour(share), image);
    }
    const double thin = std::max(1.0, 0.07 * layout.letters);
    drawStroke({{layout.left, layout.top},
                {right, layout.top},
                {right, layout.bottom},
                {layout.left, layout.bottom},
                {layout.left, layout.top}},
               thin, kInk, image);
    const int steps = stepsTo(most);
    std::vector<std::string> ticks;
    for (int i = 0; i <= steps; ++i) ticks.push_back(tickText(most * i / steps));
    const double tickLeft = right + 0.9 * layout.letters;
    const double figures = tickHeight(ticks, image.width - tickLeft - 0.3 * layout.letters, layout.letters);
    for (int i = 0; i <= steps; ++i) {
        const double y = layout.yOf(double(i) / steps);
        drawStroke({{right, y}, {right + 0.5 * layout.letters, y}}, thin, kInk, image);
        drawText(ticks[i], {tickLeft, y + 0.5 * figures}, figures, kInk, image);
    }
    for (const double clearance : clearances) {
        const double y = layout.yOf(clearance / most), x = layout.left - 0.35 * layout.letters;
        drawStroke({{x, y}, {x - 0.45 * layout.letters, y}}, 0.28 * layout.letters, kInk, image);
    }
    const double titleWidth = widthOfText("clearance", layout.letters);
    drawText("clearance",
             {std::min(layout.left, image.width - titleWidth - 0.8 * layout.letters),
              layout.top - 1.6 * layout.letters},
             layout.letters, kInk, image);
}

}  // namespace clearway::render
