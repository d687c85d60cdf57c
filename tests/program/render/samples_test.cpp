#include "program/render/samples.h"

#include <boost/test/unit_test.hpp>
#include <set>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(samples_test)

using namespace render;

BOOST_AUTO_TEST_CASE(so_many_samples_have_one_in_each_cell_however_the_square_is_divided) {
    constexpr std::uint32_t kCount = 16;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const SquareSamples samples(seed, kCount - 1);
        for (const int columns : {1, 2, 4, 8, 16}) {
            const int rows = static_cast<int>(kCount) / columns;
            std::set<std::pair<int, int>> cells;
            for (std::uint32_t i = 0; i < kCount; ++i) {
                const auto [x, y] = samples(i);
                BOOST_TEST_REQUIRE((x >= 0 && x < 1 && y >= 0 && y < 1));
                cells.insert({static_cast<int>(x * columns), static_cast<int>(y * rows)});
            }
            BOOST_TEST(cells.size() == kCount, "seed " << seed << ", " << columns << " columns");
        }
    }
}

BOOST_AUTO_TEST_CASE(pixels_have_samples_of_their_own) {
    std::set<std::pair<float, float>> first;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) first.insert(SquareSamples(mixed(seed), 15)(0));
    BOOST_TEST(first.size() > 990u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
