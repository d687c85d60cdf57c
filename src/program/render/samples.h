// Points that fill the unit square evenly, different for every pixel and equal in every run.
// Source: Kollig, Keller, Efficient Multidimensional Sampling, 2002: a scrambled (0, 2)-sequence.
#pragma once

#include <cstdint>
#include <utility>

namespace clearway::render {

/// A hash of 32 bits.
inline std::uint32_t mixed(std::uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

inline float unitFloat(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;  // below 1
}

/// The sequence of points for one purpose in one pixel.
class SquareSamples {
  public:
    /// mask: a power of two less 1. The first mask + 1 samples are spread evenly.
    SquareSamples(std::uint32_t seed, std::uint32_t mask)
        : order_(mixed(seed) & mask), first_(mixed(seed + 0x9e3779b9u)), second_(mixed(seed + 0x3c6ef372u)) {}

    std::pair<float, float> operator()(std::uint32_t index) const {
        index ^= order_;
        std::uint32_t x = 0, y = 0, direction = 1u << 31;
        for (std::uint32_t bit = 31; index != 0; index >>= 1, --bit) {
            if (index & 1) {
                x |= 1u << bit;
                y ^= direction;
            }
            direction ^= direction >> 1;
        }
        return {unitFloat(x ^ first_), unitFloat(y ^ second_)};
    }

  private:
    std::uint32_t order_, first_, second_;
};

}  // namespace clearway::render
