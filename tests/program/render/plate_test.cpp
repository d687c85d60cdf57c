#include "program/render/plate.h"

#include <boost/test/unit_test.hpp>

#include "program/render/arrangement.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(plate_test)

using namespace render;

/// A plate reuses the rays of what stands still. The light and shade of the body that moves must be there all
/// the same.
BOOST_AUTO_TEST_CASE(a_picture_from_a_plate_equals_a_picture_taken_anew) {
    const WindowScene window = windowScene();
    const auto at = [&](double x, bool isGhost) {
        PosedPart pose{window.problem.start, 5, isGhost};
        pose.state.position.x() = x;
        return pose;
    };
    RenderOptions options;
    options.width = 160;
    options.height = 100;
    options.samples = 2;
    options.eye = Vector3(-260, -200, 160);
    const std::vector<PosedPart> still = {at(-60, true), at(60, true)}, way = {at(-60, false), at(60, false)};
    Arrangement arrangement(window.partMesh, window.wallMesh, {still, way, way}, options);
    Stage& solids = arrangement.stages().solids;
    const std::size_t mover = arrangement.addMover();
    Stage alone;
    alone.addShape(arrangement.partSurface());
    alone.addBody(Body());
    solids.showBody(mover, false);
    arrangement.finish();
    const Plate plate(arrangement.stages(), arrangement.camera(), arrangement.exposure());
    solids.showBody(mover, true);
    for (const double x : {-60.0, -25.0, 0.0, 40.0, 400.0, -260.0}) {
        Body body = arrangement.bodyOf(at(x, false));
        solids.changeBody(mover, body);
        arrangement.finish();
        body.shape = 0;
        alone.changeBody(0, body);
        alone.finish();
        const Image cheap = plate.with(alone.rays(), arrangement.areaOf(body.placement));
        const Image anew = expose(arrangement.stages(), arrangement.camera(), arrangement.exposure());
        BOOST_TEST((cheap.pixels == anew.pixels), "at " << x);
    }
}

BOOST_AUTO_TEST_CASE(a_plate_is_refused_when_its_rays_would_fill_the_memory) {
    Exposure exposure;
    BOOST_TEST(Plate::canHold(exposure));
    exposure.samples = 4096;
    BOOST_TEST(!Plate::canHold(exposure));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
