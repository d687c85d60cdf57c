#include <boost/test/unit_test.hpp>

#include "support/full_run.h"
#include "torture/runs.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(pairs_test)

constexpr std::uint64_t kSeed = 20261121;

BOOST_AUTO_TEST_CASE(hard_pairs_are_answered_as_exact_arithmetic_does) {
    TortureOptions options;
    options.pairs = isFullRun() ? 2'000'000 : 40'000;
    options.seed = kSeed;
    options.withFcl = false;
    std::uint64_t pairs = 0;
    for (const PairFigures& figures : runPairs(options)) {
        BOOST_TEST_CONTEXT("family " << figures.family << ", seed " << kSeed) {
            BOOST_TEST(figures.violations == 0u);
            BOOST_TEST(figures.refused * 100 < figures.pairs);
            // Otherwise the family is easier than intended.
            BOOST_TEST(figures.touching * 100 > figures.pairs);
            BOOST_TEST((figures.pairs - figures.touching) * 100 > figures.pairs);
        }
        pairs += figures.pairs;
    }
    BOOST_TEST(pairs == options.pairs);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
