// What can be asked of a scene generator.
#pragma once

#include <cstddef>
#include <cstdint>

namespace clearway::scenes {

/// The same options make the same scene on every machine, but for the last digits of sine and cosine. Each
/// scene has values of its own to begin with: its row's defaults in scenes.h.
struct SceneOptions {
    std::uint64_t seed = 1;                ///< varies the details
    std::size_t partTriangles = 0;         ///< reached within 5 %
    std::size_t environmentTriangles = 0;  ///< reached within 5 %
    double clearance = 0;                  ///< least distance along the constructed path, environment units
};

/// Throws std::invalid_argument, naming the value and the range, when the clearance is out of it.
void requireClearance(double clearance, double least, double most);

}  // namespace clearway::scenes
