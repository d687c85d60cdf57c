#include "program/render/legend_signs.h"

#include <algorithm>
#include <cmath>

#include "program/render/ink_mask.h"
#include "program/render/marks.h"
#include "program/render/outlines.h"

namespace clearway::render {

namespace {

struct NamedSign {
    Sign sign;
    const char* words;
};

constexpr NamedSign kSigns[] = {
    {Sign::kStart, "start"},     {Sign::kGoal, "goal"}, {Sign::kBetween, "in between"},
    {Sign::kMoving, "moving"},   {Sign::kWay, "way"},   {Sign::kContact, "in contact"},
    {Sign::kOverlap, "overlap"},
};

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

}  // namespace

std::string wordsOf(Sign sign) {
    const auto row = std::find_if(std::begin(kSigns), std::end(kSigns),
                                  [&](const NamedSign& named) { return named.sign == sign; });
    return row->words;
}

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
            return drawIn(markColour(), area, image, [&](InkMask& ink) {
                const double radius = 0.42 * (area.bottom - area.top);
                ink.drawCircle(0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom), radius, thick);
            });
    }
}

}  // namespace clearway::render
