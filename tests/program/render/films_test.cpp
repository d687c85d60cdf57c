#include "program/render/film.h"

#include <boost/test/unit_test.hpp>

#include "program/render/legend.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(films_test)

using namespace render;

/// The wall with its window, seen from beside, and the plate on its way through it.
struct Motion {
    WindowScene window = windowScene();
    RenderOptions options;
    FilmCast cast;

    Motion() {
        options.width = 160;
        options.height = 100;
        options.samples = 2;
        options.scaleMost = 10;
        options.eye = Vector3(-260, -200, 160);
        cast.still = {at(-60, PoseRole::kStart), at(60, PoseRole::kGoal)};
        for (PosedPart& end : cast.still) end.isGhost = true;
        cast.framed = {at(-60), at(0), at(60)};
        cast.way = cast.framed;
    }
    PosedPart at(double x, PoseRole role = PoseRole::kBetween) const {
        PosedPart pose{window.problem.start, 5};
        pose.state.position.x() = x;
        pose.role = role;
        return pose;
    }
    Film film() const { return Film(window.partMesh, window.wallMesh, cast, options); }
};

int differences(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < areaBesideLegend(a.width, a.height).right; ++x)
            count += (a.at(x, y) - b.at(x, y)).cwiseAbs().maxCoeff() > 1e-4f;
    }
    return count;
}

BOOST_AUTO_TEST_CASE(pictures_of_a_film_show_the_part_at_different_places) {
    const Motion motion;
    Film film = motion.film();
    const Image first = film.picture(motion.at(-50));
    BOOST_TEST(differences(first, film.picture(motion.at(40))) > 200);
    BOOST_TEST(differences(first, film.picture(motion.at(-50))) == 0);
}

BOOST_AUTO_TEST_CASE(a_stopped_film_has_no_pictures) {
    Motion motion;
    bool isStopped = false;
    motion.options.isStopped = [&] { return isStopped; };
    Film film = motion.film();
    BOOST_TEST(!film.picture(motion.at(0)).pixels.empty());
    isStopped = true;
    BOOST_TEST(film.picture(motion.at(0)).pixels.empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
