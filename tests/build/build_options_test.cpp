#include "clearway/build_options.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(build_options_test)

std::string refusal(const BuildOptions& options) {
    return testing::refusalBy([&] { requireBuildOptions(options); });
}

BOOST_AUTO_TEST_CASE(every_known_name_size_and_width_is_accepted) {
    for (const std::string& general : generalSplitNames()) {
        for (const std::string& leaf : leafSplitNames()) {
            for (const int width : nodeWidths()) {
                for (int leafSize = 1; leafSize <= 16; ++leafSize) {
                    BOOST_TEST(refusal({general, leaf, leafSize, width}) == "accepted");
                }
            }
        }
    }
    for (const std::string& fit : fitNames()) {
        for (const int threads : {0, 1, 2, 1024}) {
            BOOST_TEST(refusal({"sah", "none", 4, 8, fit, threads}) == "accepted");
        }
    }
    BOOST_TEST(refusal(BuildOptions{}) == "accepted");
}

BOOST_AUTO_TEST_CASE(what_is_unknown_is_refused_by_name_with_what_is_known) {
    BOOST_TEST(refusal({"sideways", "none", 4, 8}) ==
               "generalSplit is 'sideways', expected one of sah, embree, axis, mean");
    BOOST_TEST(refusal({"", "none", 4, 8}) == "generalSplit is '', expected one of sah, embree, axis, mean");
    BOOST_TEST(refusal({"axis", "None", 4, 8}) ==
               "leafSplit is 'None' (did you mean 'none'?), expected one of none, chain, edge, all, cost");
    BOOST_TEST(refusal({"axis", "none", 0, 8}) == "leafSize is 0, expected 1 to 16");
    BOOST_TEST(refusal({"axis", "none", 17, 8}) == "leafSize is 17, expected 1 to 16");
    BOOST_TEST(refusal({"axis", "none", -3, 8}) == "leafSize is -3, expected 1 to 16");
    BOOST_TEST(refusal({"axis", "none", 4, 3}) == "nodeWidth is 3, expected one of 8, 2");
    BOOST_TEST(refusal({"axis", "none", 4, 8, "tight"}) ==
               "fit is 'tight', expected one of frames, covariance");
    BOOST_TEST(refusal({"axis", "none", 4, 8, "frames", -1}) == "threads is -1, expected 0 to 1024");
    BOOST_TEST(refusal({"axis", "none", 4, 8, "frames", 1025}) == "threads is 1025, expected 0 to 1024");
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
BOOST_AUTO_TEST_CASE(the_deprecated_presets_are_the_default_options) {
    const BuildOptions unchanged;
    BOOST_TEST((buildPresetNames() == std::vector<std::string>{"best", "fast"}));
    for (const std::string& name : buildPresetNames()) {
        const BuildOptions options = buildPreset(name);
        BOOST_TEST(options.generalSplit == unchanged.generalSplit);
        BOOST_TEST(options.leafSplit == unchanged.leafSplit);
        BOOST_TEST(options.leafSize == unchanged.leafSize);
        BOOST_TEST(options.fit == unchanged.fit);
    }
    BOOST_CHECK_EXCEPTION(buildPreset("slow"), std::invalid_argument, [](const std::invalid_argument& error) {
        return std::string(error.what()) == "preset is 'slow', expected one of best, fast";
    });
}
#pragma GCC diagnostic pop

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
