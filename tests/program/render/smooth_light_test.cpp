#include "program/render/smooth_light.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(smooth_light_test)

using namespace render;

constexpr int kSide = 32;
constexpr unsigned kSeed = 7;

/// A wall seen flat on, lit evenly but for grain; the right half is a body of its own, in half the light.
struct Wall {
    std::vector<PixelLight> lights;
    Image image{kSide, kSide, Colour(0, 0, 0)};

    Wall() {
        std::mt19937 random(kSeed);
        std::normal_distribution<float> grain(0, 0.05f);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                PixelLight light;
                const bool isRight = x >= kSide / 2;
                light.light = (isRight ? 0.4f : 0.8f) + grain(random);
                light.point = {static_cast<float>(x), static_cast<float>(y), 0};
                light.normal = Eigen::Vector3f::UnitZ();
                light.size = 1;
                light.body = isRight;
                light.isPlain = true;
                lights.push_back(light);
                image.at(x, y) = light.light * Colour(1, 0.5f, 0.25f);
            }
        }
    }
    /// The mean difference between the red of a half and the light without grain, border included.
    double grainOf(bool isRight) const {
        double sum = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide / 2; ++x)
                sum += std::abs(image.at(x + isRight * kSide / 2, y)[0] - (isRight ? 0.4 : 0.8));
        }
        return sum / (kSide * kSide / 2);
    }
};

BOOST_AUTO_TEST_CASE(grain_goes_and_bodies_keep_their_own_light) {
    BOOST_TEST_MESSAGE("seed " << kSeed);
    Wall wall;
    const double before[] = {wall.grainOf(false), wall.grainOf(true)};
    smoothLight(wall.lights, wall.image);
    for (const bool isRight : {false, true}) BOOST_TEST(wall.grainOf(isRight) < before[isRight] / 2.5);
    BOOST_TEST(wall.image.at(5, 5)[1] == wall.image.at(5, 5)[0] / 2, boost::test_tools::tolerance(1e-5f));
}

BOOST_AUTO_TEST_CASE(a_pixel_that_shows_several_things_stays_as_it_is) {
    Wall wall;
    wall.lights[5 * kSide + 5].isPlain = false;
    wall.image.at(5, 5) = Colour(9, 9, 9);
    wall.lights[5 * kSide + 5].light = 9;
    smoothLight(wall.lights, wall.image);
    BOOST_TEST((wall.image.at(5, 5) == Colour(9, 9, 9)));
    BOOST_TEST(wall.grainOf(false) - 8.2 * 2 / (kSide * kSide) < 0.05);  // no light went into its neighbours
}

BOOST_AUTO_TEST_CASE(light_does_not_cross_an_edge_or_a_shadow) {
    Wall wall;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            PixelLight& light = wall.lights[static_cast<std::size_t>(y * kSide + x)];
            light.body = 0;
            if (x >= kSide / 2) light.normal = Eigen::Vector3f::UnitX();
        }
    }
    const Colour before = wall.image.at(kSide / 2, 9);
    smoothLight(wall.lights, wall.image);
    BOOST_TEST(std::abs(wall.image.at(kSide / 2, 9)[0] - 0.4f) < 0.1f);
    BOOST_TEST(std::abs(wall.image.at(kSide / 2 - 1, 9)[0] - 0.8f) < 0.1f);
    BOOST_TEST((wall.image.at(kSide / 2, 9) != before));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
