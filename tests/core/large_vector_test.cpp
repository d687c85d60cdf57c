// Large vectors hold what they are given, wherever their memory comes from.
#include "core/large_vector.h"

#include <boost/test/unit_test.hpp>
#include <cstdint>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(large_vector_test)

struct alignas(64) Line {
    std::uint64_t number;
};

BOOST_AUTO_TEST_CASE(memory_of_any_size_is_aligned_and_keeps_its_values_as_it_grows) {
    LargeVector<Line> lines;
    std::size_t moves = 0;
    const Line* before = nullptr;
    for (std::uint64_t i = 0; i < 200'000; ++i) {  // 12.8 MB, through sizes of small and of large pages
        lines.push_back({i});
        if (lines.data() == before) continue;
        before = lines.data();
        ++moves;
        BOOST_TEST(reinterpret_cast<std::uintptr_t>(before) % alignof(Line) == 0u);
    }
    BOOST_TEST(moves > 10u);
    std::size_t wrong = 0;
    for (std::uint64_t i = 0; i < lines.size(); ++i) wrong += lines[i].number != i;
    BOOST_TEST(wrong == 0u);
    const LargeVector<Line> copy = lines;
    BOOST_TEST(copy.size() == lines.size());
    BOOST_CHECK_THROW(LargePages<Line>().allocate(std::size_t(-1)), std::bad_alloc);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
