#include "clearway/scene.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(scene_test)

BOOST_AUTO_TEST_CASE(wrong_lengths_are_refused_where_they_are_stated) {
    const Model model = Model::build(testing::box({1, 1, 1}));
    for (const double wrong : {-1.0, std::nan(""), HUGE_VAL}) {
        testing::requireRefusedBy([&] { Obstacle(model, wrong); }, {"margin is "});
        testing::requireRefusedBy([&] { Scene(model, model, wrong); }, {"margin is "});
        testing::requireRefusedBy([&] { ContactZone(Pose(), wrong); }, {"the contact zone's distance is "});
    }
    BOOST_CHECK_THROW(ContactZone(Pose(), 0), std::invalid_argument);
    BOOST_TEST(Obstacle(model).margin == 0);
    BOOST_TEST(Scene(model, model, 2).largestMargin() == 2);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
