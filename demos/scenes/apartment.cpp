// The scene apartment: a piano mover's problem. Millimetres; z is up from the floor.
#include <algorithm>
#include <cmath>

#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

struct Apartment {
    double doorHalf = 340;  ///< half the width of both doors' openings, between their frames
    double firstDoor = 1500, secondDoor = 4700;  ///< y of the doors' middles

    // The living room is on the left, then the corridor; the music room and the kitchen are on the right.
    double width = 9000, depth = 6500, height = 2500, wall = 120;
    double corridorLow = 4320, corridorHigh = 6080;  ///< x
    double kitchenTop = 3180;                        ///< y
    double leaf = 40;                                ///< thickness of doors

    double pianoLength = 1500, pianoDepth = 600, pianoHeight = 1200;
};

constexpr double kApartmentLeastClearance = 5, kApartmentMostClearance = 70;  // mm
constexpr double kApartmentEase = 0.08;  // extra gap beyond the clearance, as a share of it
constexpr double kLift = 160;            // mm; height of the carried piano above the floor
constexpr double kAbove = 600;           // mm by which planners may lift the piano higher
constexpr FinenessRange kApartmentFineness{400, 0.2};

PartState standing(double x, double y, double turned) {
    PartState state;
    state.position = {x, y, kLift};
    state.rotation = Eigen::AngleAxisd(turned, Vector3::UnitZ());
    return state;
}

constexpr double kApartmentSlit = 1;  // mm between components, so that no two touch

/// Adds pieces given by their corners: plain or rounded boxes.
struct ApartmentBuilder {
    const Apartment& apartment;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    void box(const std::string& name, const Vector3& low, const Vector3& high) {
        assembly.add(name, gridBox(Box(low, high), 12));
    }
    void numberedBox(const std::string& stem, const Vector3& low, const Vector3& high) {
        assembly.addNumbered(stem, gridBox(Box(low, high), 12));
    }
    void cushion(const std::string& stem, const Vector3& low, const Vector3& high, double corner) {
        assembly.addNumbered(stem, roundedBox(low, high, corner, corner / 2, detail.segmentsPerQuarter));
    }
    void turnedAt(const std::string& stem, const Polyline& outline, const Vector3& at) {
        const Piece piece = turned(outline, detail.segmentsPerTurn);
        assembly.addNumbered(stem, placed(piece, [at](const Vector3& p) -> Vector3 { return p + at; }));
    }
    void leg(const std::string& stem, const Vector3& at, double radius, double height) {
        turnedAt(stem, {{0, 0}, {0.6 * radius, 0}, {radius, height}, {0, height}}, at);
    }

    void addWalls();
    void addDoor(const std::string& room, double low, double middle, double sideOfLeaf);
    void addLivingRoom();
    void addShelves();
    void addCorridor();
    void addMusicRoom();
    void addKitchen();
    void addBooks(int studs);
};

/// A door: lintel, frame, and the leaf, which stands open at a right angle.
void ApartmentBuilder::addDoor(const std::string& room, double low, double middle, double sideOfLeaf) {
    const double high = low + apartment.wall, frame = 45, rise = 2100;
    const double half = apartment.doorHalf + frame, top = rise + frame;
    box(room + "_lintel", {low, middle - half + kApartmentSlit, top + kApartmentSlit},
        {high, middle + half - kApartmentSlit, apartment.height});
    for (const double side : {-1.0, 1.0}) {
        const double in = middle + side * apartment.doorHalf, out = middle + side * (half - kApartmentSlit);
        box(room + (side < 0 ? "_jamb_right" : "_jamb_left"), {low - 12, std::min(in, out), kApartmentSlit},
            {high + 12, std::max(in, out), rise});
    }
    box(room + "_head", {low - 12, middle - half + kApartmentSlit, rise + kApartmentSlit},
        {high + 12, middle + half - kApartmentSlit, top});
    // The leaf, opened into the room beside the opening.
    const double hinge = sideOfLeaf > 0 ? high + 14 : low - 14;
    const double width = 2 * apartment.doorHalf - 10, y = middle + half + 60;
    box(room + "_leaf", {std::min(hinge, hinge + sideOfLeaf * width), y, 8},
        {std::max(hinge, hinge + sideOfLeaf * width), y + apartment.leaf, rise - 4});
    const double handle = hinge + sideOfLeaf * (width - 70);
    cushion(room + "_handle", {std::min(handle, handle - sideOfLeaf * 110), y - 52, 1030},
            {std::max(handle, handle - sideOfLeaf * 110), y - 30, 1052}, 8);
}

void ApartmentBuilder::addWalls() {
    const double w = apartment.width, d = apartment.depth, t = apartment.wall, h = apartment.height;
    box("floor", {-t, -t, -200}, {w + t, d + t, 0});
    const auto wall = [&](const std::string& name, const Vector2& low, const Vector2& high) {
        box("wall_" + name, {low.x(), low.y(), kApartmentSlit}, {high.x(), high.y(), h});
    };
    wall("south", {-t, -t}, {w + t, -kApartmentSlit});
    wall("north", {-t, d + kApartmentSlit}, {w + t, d + t});
    wall("west", {-t, 0}, {-kApartmentSlit, d});
    wall("east", {w + kApartmentSlit, 0}, {w + t, d});
    const double half = apartment.doorHalf + 45;
    const double left = apartment.corridorLow - t, right = apartment.corridorHigh;
    wall("living_room_south", {left, kApartmentSlit}, {left + t, apartment.firstDoor - half});
    wall("living_room_north", {left, apartment.firstDoor + half}, {left + t, d - kApartmentSlit});
    wall("music_room_south", {right, kApartmentSlit}, {right + t, apartment.secondDoor - half});
    wall("music_room_north", {right, apartment.secondDoor + half}, {right + t, d - kApartmentSlit});
    wall("kitchen_north", {right + t + kApartmentSlit, apartment.kitchenTop},
         {w - kApartmentSlit, apartment.kitchenTop + t});
    addDoor("living_room_door", left, apartment.firstDoor, -1);
    addDoor("music_room_door", right, apartment.secondDoor, 1);
}

void ApartmentBuilder::addLivingRoom() {
    cushion("living_room_rug", {700, 2250, kApartmentSlit}, {3100, 3350, 9}, 6);
    // A sofa along the west wall.
    cushion("living_room_sofa_base", {60, 2000, 90}, {860, 3800, 330}, 60);
    cushion("living_room_sofa_back", {60, 2010, 335}, {270, 3790, 820}, 80);
    for (int i = 0; i < 3; ++i)
        cushion("living_room_sofa_cushion", {280, 2020 + 590.0 * i, 335}, {850, 2600 + 590.0 * i, 480}, 50);
    for (const double x : {130.0, 790.0})
        for (const double y : {2080.0, 3720.0}) leg("living_room_sofa_leg", {x, y, kApartmentSlit}, 28, 88);
    // A table and four chairs in the south.
    turnedAt("living_room_table", {{0, 700}, {480, 700}, {500, 715}, {500, 730}, {485, 742}, {0, 742}},
             {800, 720, 0});
    turnedAt("living_room_table_foot",
             {{0, 0}, {260, 0}, {270, 20}, {60, 50}, {45, 120}, {45, 600}, {120, 698}, {0, 698}},
             {800, 720, kApartmentSlit});
    for (int i = 0; i < 4; ++i) {
        const double angle = M_PI / 4 + M_PI_2 * i;
        const Vector3 at(800 + 560 * std::cos(angle), 720 + 560 * std::sin(angle), 0);
        cushion("living_room_chair_seat", at + Vector3(-180, -180, 440), at + Vector3(180, 180, 480), 30);
        for (const double x : {-150.0, 150.0})
            for (const double y : {-150.0, 150.0})
                leg("living_room_chair_leg", at + Vector3(x, y, kApartmentSlit), 16, 438);
    }
    turnedAt("living_room_lamp",
             {{0, 0}, {150, 0}, {150, 20}, {14, 40}, {14, 1400}, {180, 1400}, {120, 1700}, {0, 1700}},
             {300, 6150, kApartmentSlit});
}

/// Shelves along the north wall.
void ApartmentBuilder::addShelves() {
    for (int i = 0; i < 3; ++i) {
        const double x = 1200 + 920.0 * i;
        for (const double side : {x, x + 880})
            numberedBox("living_room_shelf_side", {side, 6150, kApartmentSlit}, {side + 22, 6480, 2000});
        for (int board = 0; board < 5; ++board)
            numberedBox("living_room_shelf_board", {x + 23, 6152, 90 + 440.0 * board},
                        {x + 879, 6478, 112 + 440.0 * board});
    }
}

void ApartmentBuilder::addBooks(int studs) {
    for (int i = 0; i < studs; ++i) {
        const int shelf = i / 22 % 12;
        const double x = 1230 + 920.0 * (shelf % 3) + 38 * (i % 22), z = 113 + 440.0 * (shelf / 3);
        const double back = i / 264;  // after 264 books a further row begins
        const double height = 200 + 14 * ((i * 7) % 11), deep = 140 + 4 * ((i * 5) % 9);
        const double front = 6160 + 0.01 * back + 6 * ((i * 3) % 4);
        numberedBox("living_room_book", {x, front, z}, {x + 33, front + deep, z + height});
    }
}

void ApartmentBuilder::addCorridor() {
    const double x = apartment.corridorLow;
    for (int i = 0; i < 3; ++i) {
        const double y = 3300 + 260.0 * i;
        cushion("corridor_coat", {x + 12, y, 1500}, {x + 110, y + 200, 2000}, 40);
    }
    for (int i = 0; i < 4; ++i)
        cushion("corridor_shoe", {x + 20 + 70.0 * (i % 2), 3320 + 330.0 * (i / 2), kApartmentSlit},
                {x + 80 + 70.0 * (i % 2), 3560 + 330.0 * (i / 2), 90}, 24);
}

void ApartmentBuilder::addMusicRoom() {
    const double left = apartment.corridorHigh + apartment.wall;
    cushion("music_room_stool", {left + 350, 3420, 470}, {left + 850, 3740, 540}, 30);
    for (const double x : {left + 390, left + 810})
        for (const double y : {3455.0, 3705.0}) leg("music_room_stool_leg", {x, y, kApartmentSlit}, 22, 468);
    turnedAt("music_room_stand", {{0, 0}, {180, 0}, {180, 14}, {12, 26}, {12, 1080}, {40, 1090}, {0, 1100}},
             {8700, 3600, kApartmentSlit});
    box("music_room_stand_desk", {8480, 3560, 1110}, {8880, 3580, 1400});
    turnedAt("music_room_pot", {{0, 0}, {150, 0}, {200, 330}, {0, 330}}, {8750, 6250, kApartmentSlit});
    turnedAt("music_room_plant",
             {{0, 332}, {30, 340}, {24, 700}, {190, 860}, {230, 1100}, {120, 1350}, {0, 1420}},
             {8750, 6250, kApartmentSlit});
}

void ApartmentBuilder::addKitchen() {
    const double left = apartment.corridorHigh + apartment.wall;
    for (int i = 0; i < 4; ++i) {
        const double x = left + 40 + 640.0 * i;
        box("kitchen_cupboard_" + std::to_string(i + 1), {x, 20, 100}, {x + 630, 600, 860});
        cushion("kitchen_handle", {x + 240, 605, 780}, {x + 390, 625, 800}, 6);
    }
    box("kitchen_worktop", {left + 30, 20, 861}, {left + 2640, 640, 900});
    cushion("kitchen_fridge", {8320, 30, 20}, {8960, 690, 1850}, 30);
    cushion("kitchen_table", {6900, 1700, 720}, {8100, 2500, 750}, 20);
    for (const double x : {6970.0, 8030.0})
        for (const double y : {1770.0, 2430.0}) leg("kitchen_table_leg", {x, y, kApartmentSlit}, 30, 717);
}

struct PianoBuilder {
    const Apartment& apartment;
    const Detail& detail;
    Assembly assembly{};

    double side() const { return apartment.pianoLength / 2; }
    double front() const { return -apartment.pianoDepth / 2; }
    double back() const { return apartment.pianoDepth / 2; }

    void rounded(const std::string& name, const Vector3& low, const Vector3& high, double corner) {
        assembly.add(name, roundedBox(low, high, corner, corner / 2, detail.segmentsPerQuarter));
    }
    void box(const std::string& name, const Vector3& low, const Vector3& high) {
        assembly.add(name, gridBox(Box(low, high), 12));
    }
    void addCase();
    void addKeys();
    void addFeet();
};

/// Sound board, sides, panels and lid; the keyboard's shelf protrudes at the front.
void PianoBuilder::addCase() {
    const double h = apartment.pianoHeight, face = front() + 250;
    box("sound_board", {-side() + 41, back() - 60, 80}, {side() - 41, back(), h - 31});
    for (const double s : {-1.0, 1.0}) {
        const double out = s * side(), in = s * (side() - 40);
        rounded(s < 0 ? "side_left" : "side_right", {std::min(in, out), face, 80},
                {std::max(in, out), back(), h - 31}, 8);
        rounded(s < 0 ? "arm_left" : "arm_right", {std::min(in, out), front(), 620},
                {std::max(in, out), face - 1, 780}, 12);
    }
    rounded("lid", {-side(), face - 15, h - 30}, {side(), back(), h}, 10);
    rounded("upper_panel", {-side() + 41, face, 800}, {side() - 41, face + 22, h - 31}, 4);
    rounded("lower_panel", {-side() + 41, face + 40, 120}, {side() - 41, face + 62, 600}, 4);
    rounded("key_bed", {-side() + 41, front() + 10, 620}, {side() - 41, face + 60, 690}, 6);
    rounded("key_slip", {-side() + 41, front() + 5, 691}, {side() - 41, front() + 25, 712}, 4);
    rounded("music_desk", {-430, face - 22, 830}, {430, face - 4, 1090}, 6);
}

void PianoBuilder::addKeys() {
    constexpr int kWhite = 52;
    const double pitch = (2 * side() - 100) / kWhite, low = front() + 30;
    for (int i = 0; i < kWhite; ++i) {
        const double x = -side() + 50 + pitch * i;
        assembly.addNumbered(
            "white_key",
            gridBox(Box(Vector3(x + 0.5, low, 691), Vector3(x + pitch - 0.5, low + 150, 714)), 12));
        const int note = (i + 5) % 7;  // the lowest is an A
        if (note == 2 || note == 6 || i + 1 == kWhite) continue;
        assembly.addNumbered(
            "black_key",
            gridBox(Box(Vector3(x + pitch - 6, low + 52, 715), Vector3(x + pitch + 6, low + 150, 726)), 12));
    }
}

void PianoBuilder::addFeet() {
    const int n = detail.segmentsPerTurn;
    for (const double x : {-side() + 60, side() - 60}) {
        for (const double y : {front() + 60, back() - 60}) {
            const double top = y < 0 ? 618 : 78;
            const Polyline outline{{0, 0},   {22, 0},  {26, 8},       {26, 40},
                                   {14, 55}, {30, 70}, {36, top - 4}, {0, top}};
            assembly.addNumbered("foot", placed(turned(outline, n), standingAt({x, y, 0}, Vector3::UnitZ())));
        }
    }
    for (const double x : {-70.0, 0.0, 70.0})
        assembly.addNumbered("pedal", roundedBox({x - 14, front() + 190, 60}, {x + 14, front() + 288, 72}, 8,
                                                 3, detail.segmentsPerQuarter));
}

Assembly buildApartment(const Apartment& apartment, const Detail& detail, Random random, int studs) {
    ApartmentBuilder builder{apartment, detail, random};
    builder.addWalls();
    builder.addLivingRoom();
    builder.addShelves();
    builder.addCorridor();
    builder.addMusicRoom();
    builder.addKitchen();
    builder.addBooks(studs);
    return builder.assembly;
}

Assembly buildPiano(const Apartment& apartment, const Detail& detail, int studs) {
    PianoBuilder builder{apartment, detail};
    builder.addCase();
    builder.addKeys();
    builder.addFeet();
    for (int i = 0; i < studs; ++i) {
        // Rows in front of the sound board.
        const double x = -640 + 14.0 * (i % 92), z = 900 + 16.0 * (i / 92 % 14);
        const double y = apartment.pianoDepth / 2 - 75 - 14.0 * (i / 1288);
        builder.assembly.addNumbered("tuning_pin",
                                     gridBox(Box(Vector3(x, y, z), Vector3(x + 5, y + 12, z + 5)), 12));
    }
    return builder.assembly;
}

}  // namespace

GeneratedScene makeApartment(const SceneOptions& options) {
    requireClearance(options.clearance, kApartmentLeastClearance, kApartmentMostClearance);
    Apartment apartment;
    Random random(options.seed);
    apartment.firstDoor += std::floor(random.between(-100, 101));
    apartment.secondDoor += std::floor(random.between(-150, 151));
    apartment.doorHalf = apartment.pianoDepth / 2 + options.clearance * (1 + kApartmentEase) + 0.01;

    GeneratedScene scene;
    scene.name = "apartment";
    scene.part =
        buildTo(options.partTriangles, "part-triangles", kApartmentFineness,
                [&](const Detail& detail, int studs) { return buildPiano(apartment, detail, studs); });
    scene.environment = buildTo(
        options.environmentTriangles, "environment-triangles", kApartmentFineness,
        [&](const Detail& detail, int studs) { return buildApartment(apartment, detail, random, studs); });

    const double corridor = (apartment.corridorLow + apartment.corridorHigh) / 2;
    const double first = apartment.firstDoor, second = apartment.secondDoor;
    scene.path = {standing(2100, 4700, 0.8),          standing(2350, first, 0),
                  standing(corridor, first, 0),       standing(corridor, first, M_PI_2),
                  standing(corridor, second, M_PI_2), standing(corridor, second, 0),
                  standing(8050, second, 0),          standing(8050, second + 100, -0.4)};
    statePathAsProblem(scene, 0);
    // The piano's middle may be anywhere within the walls, but not above them.
    const double low = scene.path[0].position.z();
    scene.problem.volume =
        Box(Vector3(0, 0, low - kLift), Vector3(apartment.width, apartment.depth, low + kAbove));
    scene.problem.name = "apartment v1";
    scene.problem.fineness = apartment.leaf / 2;
    return scene;
}

}  // namespace clearway::scenes
