// Measures of a rectangle swept sphere. Source: Ytterlid's thesis, 2013, with the longest extent as the
// geometry has it: the thesis prints the product of the squared sides where their sum belongs.
#include "tree/rss.h"

#include <cmath>

namespace clearway {

namespace {
constexpr double kPi = 3.14159265358979323846;
}

double Rss::area() const {
    const double l = 2 * halfLength0;
    const double w = 2 * halfLength1;
    return 4 * kPi * radius * radius + 2 * l * w + 2 * kPi * radius * (l + w);
}

double Rss::volume() const {
    const double l = 2 * halfLength0;
    const double w = 2 * halfLength1;
    return 4.0 / 3.0 * kPi * radius * radius * radius + 2 * radius * l * w + kPi * radius * radius * (l + w);
}

double Rss::longestExtent() const {
    return 2 * std::hypot(halfLength0, halfLength1) + 2 * radius;
}

}  // namespace clearway
