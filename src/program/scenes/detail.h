// How fine a scene's pieces are cut and how many of them there are, and the search for what gives the number
// of triangles asked for.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "program/scenes/piece.h"

namespace clearway::scenes {

struct Detail {
    int segmentsPerQuarter = 2;
    int segmentsPerTurn = 16;  ///< a multiple of 4
    double step = 60;          ///< mm between a sweep's stations
    double richness = 1;       ///< numbers of details are multiplied by it

    int count(double atRichnessOne) const;  ///< at least 1
};

/// One number, the fineness, says how fine everything is.
struct FinenessRange {
    double step = 60;     ///< mm between a sweep's stations at fineness 1
    double coarsest = 1;  ///< below 1 roundings are cut into single chords, and details grow few
};

/// The finest detail at which countAt gives no more triangles than asked for. option: what the number is
/// called when it is refused. Throws std::invalid_argument when the coarsest has more triangles, or above 4
/// million are asked for.
Detail finestDetail(std::size_t triangles, const std::string& option, const FinenessRange& range,
                    const std::function<std::size_t(const Detail&)>& countAt);

/// The coarsest of the range.
Detail coarsestDetail(const FinenessRange& range);

/// Small components left out, the one with the smallest box first, until at most so many triangles remain.
/// kept: how names of those begin that stay. Throws likewise when they have more.
Assembly leavingOutSmall(const Assembly& whole, std::size_t triangles, const std::string& option,
                         const std::vector<std::string>& kept);

/// A mesh's pieces at that detail and so many studs beside them, all studs of the same number of triangles.
using BuildAssembly = std::function<Assembly(const Detail& detail, int studs)>;

/// The build at the finest detail, filled up with studs. Throws likewise.
Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const BuildAssembly& build);

/// Where the coarsest build has more triangles, small components are left out, except those whose names begin
/// as `kept` says; studs do.
Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const std::vector<std::string>& kept, const BuildAssembly& build);

}  // namespace clearway::scenes
