// Planners that contend on one problem: clearway's default, OMPL's planners with clearway's checker, and OMPL's
// RRTConnect with FCL.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clearway::testing::public_problems {

constexpr const char* kOurs = "clearway";       ///< `clearway plan` with its defaults
constexpr const char* kFcl = "RRTConnect+FCL";  ///< RRTConnect, FCL's collide, OMPL's discrete motion check

/// Those beside ours: OMPL's planners with clearway's checker and certified motions, then kFcl.
const std::vector<std::string>& contenders();

constexpr const char* kRunColumns =
    "found,seconds,found_by,valid,clearance,length,rotation_degrees,states_checked,colliding_by_oracle,note";

/// Plans once. Returns a row of kRunColumns. found: the planner's answer; seconds: until then, without reading
/// and building, and for ours without making room and shortening; valid: whether the path is valid all along,
/// by an audit; colliding_by_oracle: of 100 poses of the path, not counted if obstacles may reach into the part.
/// Writes the path to `path` if it is valid. What is thrown becomes the note.
std::string runContender(const std::string& problem, const std::string& contender, std::uint32_t seed,
                         double seconds, const std::string& path);

}  // namespace clearway::testing::public_problems
