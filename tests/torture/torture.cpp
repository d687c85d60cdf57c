// Pairs of triangles and poses of small meshes that are hard to answer truthfully, family by family, against
// exact arithmetic. Ends with 1 when a promise of include/clearway/query.h is broken.
#include <exception>
#include <iostream>

#include "torture/resting.h"
#include "torture/torture_options.h"

namespace clearway::testing {
namespace {

int run(const TortureOptions& given) {
    if (given.resting) {
        measureResting(std::cout, 200);
        return 0;
    }
    const std::vector<PairFigures> pairs = runPairs(given);
    const std::vector<MeshFigures> meshes = runMeshes(given);
    print(std::cout, pairs);
    print(std::cout, meshes);
    if (!given.csv.empty()) writeCsv(given.csv, pairs, meshes);
    std::uint64_t violations = 0;
    for (const PairFigures& figures : pairs) violations += figures.violations;
    for (const MeshFigures& figures : meshes) violations += figures.violations;
    std::cout << '\n' << violations << " violations, seed " << given.seed << '\n';
    return violations == 0 ? 0 : 1;
}

}  // namespace
}  // namespace clearway::testing

int main(int argc, char** argv) {
    try {
        const auto given = clearway::testing::readOptions(argc, argv);
        return given ? clearway::testing::run(*given) : 0;
    } catch (const std::exception& error) {
        std::cerr << "torture: " << error.what() << '\n';
        return 2;
    }
}
