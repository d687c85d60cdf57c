// A tree of boxes finds each box that meets another one, once, wherever the boxes are and however large.
#include "model/box_tree.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(box_tree_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 71;

/// Boxes on a grid and beside it, some of them flat, thin or points.
Box randomBox(Random& random) {
    Vector3 corner = random.inBox(4), sides(random.below(3), random.below(3), random.below(3));
    if (random.below(2) == 0) corner = corner.array().round();
    return {corner, corner + 0.25 * sides};
}

BOOST_AUTO_TEST_CASE(boxes_that_meet_are_found_once) {
    Random random(kSeed);
    for (int round = 0; round < 200; ++round) {
        const double unit = std::ldexp(1.0, round % 5 == 0 ? random.below(1600) - 800 : 0);
        const Vector3 shift = round % 3 == 0 ? random.inBox(1e6) : Vector3::Zero().eval();
        const auto placed = [&](const Box& box) {
            return Box(unit * (box.min() + shift), unit * (box.max() + shift));
        };
        std::vector<Box> boxes(random.below(round % 10 == 0 ? 1000 : 20));
        for (Box& box : boxes) box = placed(randomBox(random));
        const BoxTree tree(boxes);
        for (int k = 0; k < 20; ++k) {
            Box asked = placed(randomBox(random));
            if (k % 2 == 0) asked.max().z() = std::numeric_limits<double>::infinity();
            std::vector<int> found(boxes.size(), 0);
            tree.eachMeeting(asked, [&](std::uint32_t i) { ++found[i]; });
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                BOOST_TEST_CONTEXT("seed " << kSeed << ", round " << round << ", box " << i) {
                    BOOST_TEST(found[i] <= 1);
                    if (boxes[i].intersects(asked)) BOOST_TEST(found[i] == 1);
                    const Vector3 gap = (boxes[i].min() - asked.max()).cwiseMax(asked.min() - boxes[i].max());
                    if (gap.maxCoeff() > 1e-6 * 8 * unit) BOOST_TEST(found[i] == 0);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_tree_without_boxes_finds_none) {
    BoxTree().eachMeeting(Box(Vector3::Zero(), Vector3::Ones()), [](std::uint32_t) { BOOST_FAIL("found"); });
    BoxTree(std::vector<Box>()).eachMeeting(Box(Vector3::Zero(), Vector3::Ones()), [](std::uint32_t) {
        BOOST_FAIL("found");
    });
}

BOOST_AUTO_TEST_SUITE_END()
