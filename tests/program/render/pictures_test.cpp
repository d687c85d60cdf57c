#include "program/render/render.h"

#include <boost/test/unit_test.hpp>
#include <functional>

#include "program/render/legend.h"
#include "program/render/outlines.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(pictures_test)

using namespace render;

constexpr int kWidth = 240, kHeight = 160;

/// The wall with its window; the plate before it, in its middle and behind it, in distinct clearances.
struct Shot {
    WindowScene window = windowScene();
    RenderOptions options;
    std::vector<PosedPart> poses;

    Shot() {
        options.width = kWidth;
        options.height = kHeight;
        options.samples = 4;
        options.scaleMost = 10;
    }
    PartState upright(double x) const {
        PartState state = window.problem.start;
        state.position.x() = x;
        return state;
    }
    Image taken(const std::vector<PosedPart>& way = {}) const {
        return render::render(window.partMesh, window.wallMesh, poses, way, options);
    }
};

bool isColourful(const Colour& pixel) {
    return pixel.maxCoeff() > 1.6f * pixel.minCoeff();
}
bool isYellow(const Colour& pixel) {
    return isColourful(pixel) && pixel[0] > 1.5f * pixel[2] && pixel[1] > 1.5f * pixel[2];
}
bool isBlue(const Colour& pixel) {
    return isColourful(pixel) && pixel[2] > 1.5f * pixel[0];
}
bool isWhite(const Colour& pixel) {
    return pixel.minCoeff() > 0.999f;
}

std::function<bool(const Colour&)> isLike(Pen pen) {
    return [colour = penColour(pen)](const Colour& pixel) {
        return (pixel - colour).cwiseAbs().maxCoeff() < 0.08f;
    };
}

/// The number of pixels beside the legend with this property.
int count(const Image& image, const std::function<bool(const Colour&)>& isSo) {
    int counted = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < areaBesideLegend(image.width, image.height).right; ++x)
            counted += isSo(image.at(x, y));
    }
    return counted;
}

BOOST_AUTO_TEST_CASE(the_part_is_seen_in_the_colour_of_its_clearance) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 0}};
    const Image tight = shot.taken();
    BOOST_TEST(count(tight, isYellow) > 100);
    BOOST_TEST(count(tight, isBlue) == 0);
    shot.poses[0].clearance = 10;
    const Image free = shot.taken();
    BOOST_TEST(count(free, isBlue) > 100);
    BOOST_TEST(count(free, isYellow) == 0);
}

BOOST_AUTO_TEST_CASE(the_legends_figures_are_in_the_picture_however_long) {
    for (const double most : {5.0, 0.00025, 123456.0, 2.5e-8, 1.23456e-30}) {
        for (const auto& [width, height] : {std::pair(1280, 720), std::pair(480, 270), std::pair(100, 400)}) {
            Image image(width, height, Colour::Ones());
            Legend legend;
            legend.most = most;
            legend.clearances = {0};
            drawLegend(legend, image);
            for (int y = 0; y < height; ++y)
                BOOST_TEST_REQUIRE(isWhite(image.at(width - 1, y)),
                                   most << " in " << width << " x " << height);
        }
    }
}

BOOST_AUTO_TEST_CASE(all_of_the_scene_is_in_the_picture_beside_the_legend) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 0}, {shot.upright(60), 10}};
    for (const NamedView& view : namedViews()) {
        shot.options.view = view.name;
        const Image image = shot.taken();
        const Area area = areaBesideLegend(kWidth, kHeight);
        int edge = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < area.right + 2; ++x) {
                const bool isOutside =
                    x < area.left - 2 || x > area.right || y < area.top - 2 || y > area.bottom + 1;
                edge += isOutside && !isWhite(image.at(x, y));
            }
        }
        BOOST_TEST(edge == 0, view.name);
        BOOST_TEST(count(image, [](const Colour& pixel) { return !isWhite(pixel); }) > 1000, view.name);
    }
}

BOOST_AUTO_TEST_CASE(the_environment_hides_the_part_until_it_is_cut) {
    Shot shot;
    shot.options.view = "left";  // looks along x, at the wall
    shot.poses = {{shot.upright(60), 0}};
    const int throughTheWindow = count(shot.taken(), isYellow);
    shot.options.cut = CutPlane{Vector3::UnitX(), 10};  // all of the wall is on the camera's side
    const int uncovered = count(shot.taken(), isYellow);
    BOOST_TEST(uncovered > throughTheWindow + 100);
    shot.options.cut = CutPlane{-Vector3::UnitX(), -10};
    BOOST_TEST(count(shot.taken(), isYellow) == uncovered);
    shot.options.cut = CutPlane{Vector3::UnitX(), -10};  // no part of the wall is on the camera's side
    BOOST_TEST(count(shot.taken(), isYellow) == throughTheWindow);
}

BOOST_AUTO_TEST_CASE(the_inside_is_shown_cut_open_with_the_part_in_it) {
    Shot shot;
    Mesh& room = shot.window.wallMesh = shot.window.partMesh;  // a closed box around all
    for (Vector3& vertex : room.vertices) vertex = vertex.cwiseProduct(Vector3(4, 4, 16));
    shot.poses = {{shot.upright(-60), 5}, {shot.upright(0), 0}, {shot.upright(60), 5}};
    for (const NamedView& view : namedViews()) {
        shot.options.view = view.name;
        BOOST_TEST(count(shot.taken(), isColourful) == 0, view.name);
    }
    shot.options.view = "inside";
    BOOST_TEST(count(shot.taken(), isYellow) > 300);
}

BOOST_AUTO_TEST_CASE(silhouettes_are_dark_lines) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 5}};
    shot.options.view = "front";
    const Image image = shot.taken();
    const auto isDark = [](const Colour& pixel) { return pixel.maxCoeff() < 0.12f; };
    BOOST_TEST(count(image, isDark) > 50);
    // From the left, the first thing that is not background is a line.
    for (int y = 0; y < kHeight; ++y) {
        int x = 0;
        while (x < kWidth - 3 && isWhite(image.at(x, y))) ++x;
        if (x >= areaBesideLegend(kWidth, kHeight).right) continue;
        BOOST_TEST(std::min({image.at(x, y).maxCoeff(), image.at(x + 1, y).maxCoeff(),
                             image.at(x + 2, y).maxCoeff()}) < 0.35f,
                   "row " << y);
    }
}

BOOST_AUTO_TEST_CASE(a_ghost_lets_the_wall_behind_it_through) {
    Shot shot;
    shot.options.view = "left";
    shot.poses = {{shot.upright(-60), 0}};
    const int solid = count(shot.taken(), isYellow);
    shot.poses[0].isGhost = true;
    const Image image = shot.taken();
    shot.poses[0].isGhost = false;
    const auto isPale = [](const Colour& pixel) { return pixel.minCoeff() > 0.08f && isColourful(pixel); };
    BOOST_TEST(count(image, isPale) > solid / 2);
    BOOST_TEST(count(shot.taken(), isPale) < solid / 4);
}

/// A ghost must not tint: blue in front of orange would be a red that the scale has for another clearance.
BOOST_AUTO_TEST_CASE(a_ghost_pales_what_has_a_clearance_and_never_tints_it) {
    Shot shot;
    shot.options.view = "left";
    shot.options.isClose = true;
    shot.poses = {{shot.upright(-30), 2.5}};
    const auto isWarm = [](const Colour& pixel) { return pixel[0] - pixel[2] > 0.05f; };
    // Orange when paled, too: white is subtracted from red and green.
    const auto isOrange = [&](const Colour& pixel) {
        return isWarm(pixel) && pixel[1] - pixel[2] > 0.2f * (pixel[0] - pixel[2]);
    };
    BOOST_TEST(count(shot.taken(), isOrange) > 0.95 * count(shot.taken(), isWarm));
    const int solid = count(shot.taken(), isOrange);
    shot.poses.push_back({shot.upright(-60), 10, true});
    const Image image = shot.taken();
    BOOST_TEST(count(image, isOrange) > 0.95 * count(image, isWarm));
    BOOST_TEST(count(image, isOrange) > solid / 2);
    BOOST_TEST(count(image, [&](const Colour& pixel) { return isOrange(pixel) && pixel[2] > 0.1f; }) >
               solid / 2);
}

BOOST_AUTO_TEST_CASE(the_way_is_a_line_in_the_colours_of_its_clearances) {
    Shot shot;
    shot.options.view = "top";
    shot.poses = {{shot.upright(60), 5}};
    BOOST_TEST(count(shot.taken(), isBlue) == 0);
    const std::vector<PosedPart> way = {
        {shot.upright(-60), 10}, {shot.upright(-10), 10}, {shot.upright(60), 5}};
    BOOST_TEST(count(shot.taken(way), isBlue) > 20);
}

BOOST_AUTO_TEST_CASE(a_mark_is_a_ring_around_its_place_over_what_hides_it) {
    const auto isRing = [](const Colour& pixel) {
        return pixel[0] > 1.5f * pixel[2] && pixel[2] > 1.2f * pixel[1];
    };
    Shot shot;
    shot.poses = {{shot.upright(60), 10}};
    shot.options.eye = Vector3(300, 0, 0);
    shot.options.lookAt = Vector3(0, 0, 0);
    BOOST_TEST(count(shot.taken(), isRing) == 0);
    shot.options.marks = {Vector3(0, 0, 0), Vector3(400, 0, 0)};  // behind the plate; behind the camera
    const Image image = shot.taken();
    const int found = count(image, isRing);
    BOOST_TEST(found > 10);
    BOOST_TEST(found < 120);
    const Area area = areaBesideLegend(kWidth, kHeight);
    const int x = static_cast<int>((area.left + area.right) / 2),
              y = static_cast<int>((area.top + area.bottom) / 2);
    BOOST_TEST(!isRing(image.at(x, y)));
    bool isAbove = false;
    for (int up = 1; up < 8; ++up) {
        isAbove = isAbove || isRing(image.at(x - 1, y - up)) || isRing(image.at(x, y - up));
    }
    BOOST_TEST(isAbove);
}

BOOST_AUTO_TEST_CASE(a_pose_in_contact_is_hatched_in_its_own_colour_and_a_free_one_is_not) {
    const auto isContact = [](const Colour& pixel) {
        return pixel[1] > 2.5f * pixel[0] && pixel[1] > 1.2f * pixel[2] && pixel[1] > 0.1f;
    };
    const auto isBlack = [](const Colour& pixel) { return pixel.maxCoeff() < 0.03f; };
    Shot shot;
    shot.options.isClose = true;
    shot.poses = {{shot.upright(-60), 0}};
    const int blackWhenFree = count(shot.taken(), isBlack);
    BOOST_TEST(count(shot.taken(), isContact) == 0);
    shot.poses[0].isInContact = true;
    const Image image = shot.taken();
    BOOST_TEST(count(image, isYellow) == 0);
    BOOST_TEST(count(image, isContact) > 1000);
    BOOST_TEST(count(image, isBlack) > blackWhenFree + 500);
}

BOOST_AUTO_TEST_CASE(the_way_in_contact_has_the_colour_of_contact) {
    const auto isGreen = [](const Colour& pixel) {
        return pixel[1] > 2 * pixel[0] && pixel[1] > 1.2f * pixel[2];
    };
    Shot shot;
    shot.options.view = "top";
    shot.poses = {{shot.upright(60), 5}};
    std::vector<PosedPart> way = {{shot.upright(-60), 5}, {shot.upright(-10), 5}, {shot.upright(60), 5}};
    BOOST_TEST(count(shot.taken(way), isGreen) == 0);
    way[0].isInContact = true;
    BOOST_TEST(count(shot.taken(way), isGreen) > 20);
}

BOOST_AUTO_TEST_CASE(start_and_goal_have_outlines_of_their_own_colours) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 3}, {shot.upright(60), 3}};
    for (const bool isGhost : {false, true}) {
        for (PosedPart& pose : shot.poses) pose.isGhost = isGhost;
        shot.poses[0].role = shot.poses[1].role = PoseRole::kBetween;
        const Image plain = shot.taken();
        BOOST_TEST(count(plain, isLike(Pen::kStart)) + count(plain, isLike(Pen::kGoal)) < 10);
        shot.poses[0].role = PoseRole::kStart;
        shot.poses[1].role = PoseRole::kGoal;
        const Image told = shot.taken();
        BOOST_TEST(count(told, isLike(Pen::kStart)) > 50);
        BOOST_TEST(count(told, isLike(Pen::kGoal)) > 20);
    }
}

BOOST_AUTO_TEST_CASE(the_outline_of_a_start_is_left_out_along_a_part_close_to_it) {
    for (const double farther : {0.0, 0.01, 0.1, 5.0}) {
        Shot shot;
        shot.poses = {{shot.upright(-60), 0, false, true},
                      {shot.upright(-60 - farther), 3, true, false, PoseRole::kStart}};
        const int outline = count(shot.taken(), isLike(Pen::kStart));
        BOOST_TEST((farther < 1 ? outline == 0 : outline > 30), farther << ": " << outline);
    }
}

BOOST_AUTO_TEST_CASE(a_part_hides_a_face_that_it_has_in_common_with_the_wall) {
    Shot shot;
    shot.options.view = "left";
    PartState flush = shot.window.problem.start;
    flush.rotation.setIdentity();
    const double front = boundingBox(shot.window.wallMesh).min().x();
    std::vector<int> outlines;
    for (const double inFront : {0.0, 0.5}) {
        flush.position = Vector3(front - inFront + 30, 60, 5);  // the plate is 60 long
        shot.poses = {{flush, 0, false, true, PoseRole::kStart}};
        outlines.push_back(count(shot.taken(), isLike(Pen::kStart)));
    }
    BOOST_TEST(outlines[1] > 20);
    BOOST_TEST(std::abs(outlines[0] - outlines[1]) <= outlines[1] / 10, outlines[0] << " " << outlines[1]);
}

BOOST_AUTO_TEST_CASE(axes_are_drawn_in_the_lower_left_corner) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 5}};
    shot.options.eye = Vector3(-400, -300, 200);
    shot.options.lookAt = Vector3(0, 0, -2000);  // nothing but background
    const auto isDark = [](const Colour& pixel) { return pixel.maxCoeff() < 0.3f; };
    const int without = count(shot.taken(), isDark);
    shot.options.hasAxes = true;
    BOOST_TEST(count(shot.taken(), isDark) > without + 30);
}

BOOST_AUTO_TEST_CASE(a_slot_in_a_grey_plate_is_seen) {
    Shot shot;  // the wall's window, seen flat on
    shot.options.view = "left";
    shot.poses = {{shot.upright(-60), 5}};
    shot.poses[0].state.position.y() = 300;
    const auto isLine = [](const Colour& pixel) { return pixel.maxCoeff() < 0.2f; };
    BOOST_TEST(count(shot.taken(), isLine) > 150);
}

BOOST_AUTO_TEST_CASE(a_stopped_picture_has_no_pixels) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 5}};
    shot.options.isStopped = [] { return true; };
    BOOST_TEST(shot.taken().pixels.empty());
}

BOOST_AUTO_TEST_CASE(a_camera_of_ones_own_sees_what_it_looks_at) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 0}};
    shot.options.eye = Vector3(-400, 0, 0);
    const int ahead = count(shot.taken(), isYellow);
    BOOST_TEST(ahead > 100);
    shot.options.lookAt = Vector3(-800, 0, 0);
    BOOST_TEST(count(shot.taken(), [](const Colour& pixel) { return !isWhite(pixel); }) == 0);
    shot.options.lookAt = Vector3(0, 0, 0);
    shot.options.angle = 10;
    BOOST_TEST(count(shot.taken(), isYellow) > 2 * ahead);
}

BOOST_AUTO_TEST_CASE(the_same_picture_is_taken_twice) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 0}, {shot.upright(0), 3, true}};
    BOOST_TEST((shot.taken().pixels == shot.taken().pixels));
}

BOOST_AUTO_TEST_CASE(the_picture_does_not_depend_on_where_the_scene_lies) {
    Shot shot;
    shot.poses = {{shot.upright(-60), 0}};
    const Image here = shot.taken();
    const Vector3 far(4e6, -7e6, 1e6);
    for (Vector3& vertex : shot.window.wallMesh.vertices) vertex += far;
    shot.poses[0].state.position += far;
    const Image there = shot.taken();
    int different = 0;
    for (std::size_t i = 0; i < here.pixels.size(); ++i)
        different += (here.pixels[i] - there.pixels[i]).cwiseAbs().maxCoeff() > 0.05f;
    BOOST_TEST(different < 40);
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused_by_name) {
    Shot shot;
    const auto refuses = [&](const std::string& word) { requireRefusedBy([&] { shot.taken(); }, {word}); };
    refuses("no pose");
    shot.poses = {{shot.upright(-60), 0}};
    shot.options.view = "askew";
    refuses("view is 'askew', expected one of inside, iso, front");
    shot = Shot();
    shot.poses = {{shot.upright(-60), 0}};
    shot.options.eye = shot.options.lookAt = Vector3(1, 2, 3);
    refuses("stands at the point it looks at");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
