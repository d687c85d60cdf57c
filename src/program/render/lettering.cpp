#include "program/render/lettering.h"

#include <algorithm>
#include <cmath>

namespace clearway::render {

namespace {

/// A letter's strokes on a grid of 4 across and 6 up: two digits a point, a space lifts the pen.
struct Letter {
    char character;
    const char* strokes;
};
constexpr Letter kLetters[] = {
    {'0', "10304145361605011030"},
    {'1', "1010 05162620 1030"},
    {'2', "05163645440040"},
    {'3', "05163645443323 3342413010"},
    {'4', "3036023242"},
    {'5', "4606033342413010 1001"},
    {'6', "453616050110304142330302"},
    {'7', "06464510"},
    {'8', "13041536454433130201103041423313 334445"},
    {'9', "0110304145361605041343"},
    {'.', "1011"},
    {'-', "0343"},
    {'+', "0343 2125"},
    {'a', "0413344340 42120110304142"},
    {'c', "4334140301103041"},
    {'e', "024243341403011030 3041"},
    {'l', "16112030"},
    {'n', "0004 03143443 4340"},
    {'r', "0004 0214344443"},
};
constexpr double kAdvance = 5.6, kRows = 6;  ///< in units of the grid

const char* strokesOf(char character) {
    for (const Letter& letter : kLetters) {
        if (letter.character == character) return letter.strokes;
    }
    return "";
}

double distanceToSegment(const PicturePoint& p, const PicturePoint& a, const PicturePoint& b) {
    const double abX = b.first - a.first, abY = b.second - a.second;
    const double lengthSquared = abX * abX + abY * abY;
    const double along = (p.first - a.first) * abX + (p.second - a.second) * abY;
    const double t = lengthSquared > 0 ? std::clamp(along / lengthSquared, 0.0, 1.0) : 0;
    return std::hypot(a.first + t * abX - p.first, a.second + t * abY - p.second);
}

double distanceToStroke(const PicturePoint& p, const std::vector<PicturePoint>& points) {
    double least = distanceToSegment(p, points.front(), points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
        least = std::min(least, distanceToSegment(p, points[i - 1], points[i]));
    return least;
}

void blend(Image& image, int x, int y, double cover, const Colour& colour) {
    const auto share = static_cast<float>(std::clamp(cover, 0.0, 1.0));
    image.at(x, y) = (1 - share) * image.at(x, y) + share * colour;
}

/// Calls visit for the picture's pixels in the area.
template <class Visit>
void visitPixels(const Area& area, const Image& image, const Visit& visit) {
    const int left = std::max(0, static_cast<int>(std::floor(area.left)));
    const int top = std::max(0, static_cast<int>(std::floor(area.top)));
    const int right = std::min(image.width, static_cast<int>(std::ceil(area.right)));
    const int bottom = std::min(image.height, static_cast<int>(std::ceil(area.bottom)));
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) visit(x, y);
    }
}

}  // namespace

void drawStroke(const std::vector<PicturePoint>& points, double width, const Colour& colour, Image& image) {
    if (points.empty()) return;
    Area area{points[0].first, points[0].second, points[0].first, points[0].second};
    for (const auto& [x, y] : points) {
        area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x),
                std::max(area.bottom, y)};
    }
    area = {area.left - width, area.top - width, area.right + width, area.bottom + width};
    visitPixels(area, image, [&](int x, int y) {
        blend(image, x, y, 0.5 + width / 2 - distanceToStroke({x + 0.5, y + 0.5}, points), colour);
    });
}

void fillArea(const Area& area, const Colour& colour, Image& image) {
    const auto cover = [](int pixel, double from, double to) {
        return std::min(pixel + 1.0, to) - std::max<double>(pixel, from);
    };
    visitPixels(area, image, [&](int x, int y) {
        blend(image, x, y, cover(x, area.left, area.right) * cover(y, area.top, area.bottom), colour);
    });
}

void drawText(const std::string& text, PicturePoint place, double height, const Colour& colour,
              Image& image) {
    const double unit = height / kRows;
    for (const char character : text) {
        std::vector<PicturePoint> stroke;
        const auto draw = [&] {
            drawStroke(stroke, std::max(1.0, 0.13 * height), colour, image);
            stroke.clear();
        };
        for (const char* c = strokesOf(character); *c != 0; ++c) {
            if (*c == ' ') {
                draw();
                continue;
            }
            stroke.push_back({place.first + unit * (c[0] - '0'), place.second - unit * (c[1] - '0')});
            ++c;
        }
        draw();
        place.first += unit * (character == '.' ? kAdvance - 2.4 : kAdvance);
    }
}

double widthOfText(const std::string& text, double height) {
    const auto points = static_cast<double>(std::count(text.begin(), text.end(), '.'));
    const double units = kAdvance * static_cast<double>(text.size()) - 2.4 * points - (kAdvance - 4);
    return text.empty() ? 0 : height / kRows * units;
}

}  // namespace clearway::render
