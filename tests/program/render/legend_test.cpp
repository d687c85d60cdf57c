#include "program/render/legend.h"

#include <boost/test/unit_test.hpp>
#include <set>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(legend_test)

using namespace render;

constexpr Sign kAllSigns[] = {Sign::kStart, Sign::kGoal,    Sign::kBetween, Sign::kMoving,
                              Sign::kWay,   Sign::kContact, Sign::kOverlap, Sign::kMeeting};

Image drawn(const Legend& legend) {
    Image image(640, 360, Colour::Ones());
    drawLegend(legend, image);
    return image;
}

PosedPart posedAs(PoseRole role) {
    PosedPart pose;
    pose.role = role;
    return pose;
}

BOOST_AUTO_TEST_CASE(every_sign_has_words_and_a_drawing_of_its_own) {
    std::set<std::string> words;
    const Image without = drawn({});
    for (const Sign sign : kAllSigns) {
        words.insert(wordsOf(sign));
        Legend legend;
        legend.signs = {sign};
        BOOST_TEST((drawn(legend).pixels != without.pixels), wordsOf(sign));
    }
    BOOST_TEST(words.size() == std::size(kAllSigns));
    BOOST_TEST(words.count("start") == 1);
    BOOST_TEST(words.count("goal") == 1);
    BOOST_TEST(words.count("in contact") == 1);
}

BOOST_AUTO_TEST_CASE(a_legend_explains_the_poses_that_are_there) {
    const std::vector<PosedPart> ends = {posedAs(PoseRole::kStart), posedAs(PoseRole::kGoal)};
    BOOST_TEST((signsOf(ends, false) == std::vector<Sign>{Sign::kStart, Sign::kGoal}));
    BOOST_TEST((signsOf(ends, true) == std::vector<Sign>{Sign::kStart, Sign::kMoving, Sign::kGoal}));
    BOOST_TEST((signsOf({posedAs(PoseRole::kBetween)}, false) == std::vector<Sign>{Sign::kBetween}));
}

BOOST_AUTO_TEST_CASE(the_unit_stands_in_the_legend) {
    Legend legend;
    const Image unknown = drawn(legend);
    legend.unit = "mm";
    const Image inMillimetres = drawn(legend);
    legend.unit = "in";
    BOOST_TEST((unknown.pixels != inMillimetres.pixels));
    BOOST_TEST((drawn(legend).pixels != inMillimetres.pixels));
}

BOOST_AUTO_TEST_CASE(the_legend_stays_right_of_the_scene_and_in_the_picture) {
    Legend legend;
    legend.unit = "thousandths of an inch";
    legend.most = 123456;
    legend.clearances = {1, 123456};
    legend.signs.assign(std::begin(kAllSigns), std::end(kAllSigns));
    for (const auto& [width, height] : {std::pair(1280, 720), std::pair(320, 180), std::pair(90, 300)}) {
        Image image(width, height, Colour::Ones());
        drawLegend(legend, image);
        const double left = areaBesideLegend(width, height).right;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (x < left || x == width - 1 || y == 0 || y == height - 1)
                    BOOST_TEST_REQUIRE(image.at(x, y).minCoeff() > 0.999f, x << ", " << y << " of " << width);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
