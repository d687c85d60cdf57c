// The figures that a torture run counts for each family, and their output as tables and CSV.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "torture/mesh_check.h"
#include "torture/pair_check.h"

namespace clearway::testing {

/// FCL's figures on these cases: contact called free by each of its two queries, distances too large by more
/// than 1e-6 of the scene (which a margin would accept as valid), and answers that are not a number.
struct FclFigures {
    double worstOfScene = 0;
    std::uint64_t freeByCollide = 0, freeByDistance = 0, tooFar = 0, noAnswer = 0;

    /// distance: 0 or less on contact; NaN if FCL has none.
    void add(double distance, bool collides, double truth, double sceneSize);
};

struct WorstFinish {
    std::uint64_t pairs = 0;
    double error = 0;  ///< in units of u64 (M + L)
    double width = 0;
};

struct PairFigures {
    std::string family;
    std::uint64_t pairs = 0, touching = 0, refused = 0, violations = 0;
    double worstError = 0;         ///< of `distance`, in units of u64 (M + L)
    double worstErrorOfScene = 0;  ///< in units of the scene's size
    double widest = 0;             ///< in units of the allowed width
    double widestOfScene = 0;
    WorstFinish regularFinish, flatFinish;
    std::array<std::uint64_t, kStages> distanceStages{}, collidesStages{}, withinStages{};
    FclFigures fcl;

    void add(const CheckedCase& checked);
};

struct MeshFigures {
    std::string family;
    std::uint64_t poses = 0, touching = 0;
    std::uint64_t verge = 0;  ///< poses that are free, but nearer than 1e-12 of the scene
    std::uint64_t falseValid = 0, violations = 0;
    FclFigures fcl;

    void add(const CheckedPose& checked, double sceneSize);
};

void print(std::ostream& out, const std::vector<PairFigures>& all);
void print(std::ostream& out, const std::vector<MeshFigures>& all);

/// Writes one row per family and figure: group,family,figure,value. Throws std::runtime_error if the file
/// cannot be written.
void writeCsv(const std::string& file, const std::vector<PairFigures>& pairs,
              const std::vector<MeshFigures>& meshes);

}  // namespace clearway::testing
