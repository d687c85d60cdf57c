// Conversions between linear light, sRGB and Oklab.
// Source: B. Ottosson, A perceptual color space for image processing, 2020 (Oklab).
#include "program/render/colour.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway::render {

namespace {

float toLinear(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

float fromLinear(float value) {
    return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
}

/// lab: lightness, then green to red, then blue to yellow.
Colour fromOklab(const Eigen::Vector3f& lab) {
    const float l = lab[0] + 0.3963377774f * lab[1] + 0.2158037573f * lab[2];
    const float m = lab[0] - 0.1055613458f * lab[1] - 0.0638541728f * lab[2];
    const float s = lab[0] - 0.0894841775f * lab[1] - 1.2914855480f * lab[2];
    const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
            -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
            -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
}

/// The scale in Oklab, evenly spaced and evenly darker: yellow, orange, purple red, violet, blue.
const Eigen::Vector3f kScale[] = {{0.900f, -0.020f, 0.180f},
                                  {0.780f, 0.080f, 0.140f},
                                  {0.650f, 0.200f, 0.030f},
                                  {0.520f, 0.140f, -0.140f},
                                  {0.400f, -0.010f, -0.190f}};

}  // namespace

Colour sRgb(int red, int green, int blue) {
    const auto linear = [](int value) { return toLinear(static_cast<float>(value) / 255); };
    return {linear(red), linear(green), linear(blue)};
}

std::array<std::uint8_t, 3> toSRgb(const Colour& colour) {
    std::array<std::uint8_t, 3> bytes;
    for (int i = 0; i < 3; ++i) {
        const float value = fromLinear(std::clamp(colour[i], 0.0f, 1.0f));
        bytes[i] = static_cast<std::uint8_t>(std::lround(255 * value));
    }
    return bytes;
}

Colour clearanceColour(double share) {
    constexpr int kLast = static_cast<int>(std::size(kScale)) - 1;
    const double place = kLast * std::clamp(share, 0.0, 1.0);
    const int below = std::min(static_cast<int>(place), kLast - 1);
    const auto t = static_cast<float>(place - below);
    return fromOklab((1 - t) * kScale[below] + t * kScale[below + 1]).cwiseMax(0).cwiseMin(1);
}

Colour contactColour() {
    return sRgb(0, 190, 150);
}

double niceCeiling(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 1;
    using Limits = std::numeric_limits<double>;
    const double power = std::max(std::pow(10.0, std::floor(std::log10(value))), Limits::denorm_min());
    for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (digit * power >= value) return std::min(digit * power, Limits::max());
    }
    return std::min(10 * power, Limits::max());
}

double scaleFor(double least, double most, bool hasContact) {
    constexpr double kTightShare = 5;  // the scale's top is at most this many times the least clearance
    constexpr double kContactShare = 4;
    if (!(least > 0)) return niceCeiling(most);
    const double tight = kTightShare * least;
    return niceCeiling(std::min(most, hasContact ? std::max(tight, most / kContactShare) : tight));
}

}  // namespace clearway::render
