// Material of the query tests: pairs of meshes with poses that are far, near, touching and colliding, the
// oracle's answers to them, and the check that a result keeps every promise of clearway/query.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace clearway::testing {

constexpr double kUnitRoundoff = 0x1p-53;

struct QueryCase {
    std::string name;  ///< with the seed
    Mesh part;
    Mesh environment;
    std::shared_ptr<const MeshOracle> oracle;
    std::vector<Pose> poses;
    std::vector<OracleAnswer> answers;  ///< one per pose
};

/// The cases, made once per process.
const std::vector<QueryCase>& queryCases();

/// The meshes with their oracle and its answers at the poses.
QueryCase makeCase(const std::string& name, const Mesh& part, const Mesh& environment,
                   const std::vector<Pose>& poses);

struct ModelPair {
    Model part;
    Model environment;
};

inline BuildOptions ofWidth(int width) {
    BuildOptions options;
    options.nodeWidth = width;
    return options;
}

ModelPair buildPair(const QueryCase& queryCase, const BuildOptions& options = {});

/// The largest absolute coordinate among environment, part, moved part and the pose's translation: M in the
/// contracts.
double largestCoordinate(const QueryCase& queryCase, const Pose& pose);

/// The largest width an interval may have without tolerances.
double widestDefault(const QueryCase& queryCase, const Pose& pose);

/// Checks with BOOST_TEST the interval, accuracy, ids and witnesses of a result without cap. `width`: largest
/// width allowed, by default widestDefault.
void checkDistance(const DistanceResult& result, const QueryCase& queryCase, const Pose& pose,
                   const OracleAnswer& truth, double width = -1);

}  // namespace clearway::testing
