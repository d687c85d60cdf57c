// Random numbers that are identical on every machine: the standard guarantees this for engines, not for
// distributions.
#pragma once

#include <cstdint>

#include "core/hash.h"

namespace clearway::scenes {

/// SplitMix64. Source: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() { return mixed(state_ += kGoldenStep); }

    /// A number in [low, high).
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }

  private:
    std::uint64_t state_;
};

}  // namespace clearway::scenes
