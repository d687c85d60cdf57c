#include "demos/scenes/scenes.h"

#include <boost/test/unit_test.hpp>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <set>
#include <string>
#include <vector>

#include "support/words.h"

BOOST_AUTO_TEST_SUITE(scenes_test)

using namespace clearway;
using namespace clearway::scenes;

/// Numbers that distinguish scenes without storing the meshes.
struct Fingerprint {
    std::size_t triangles, components;
    double moment;  ///< mean of x + 2 y + 3 z over the vertices
    double spread;  ///< root of the mean of the squared vertices
};

Fingerprint fingerprint(const Mesh& mesh) {
    double moment = 0, squares = 0;
    for (const Vector3& v : mesh.vertices) {
        moment += v.dot(Vector3(1, 2, 3));
        squares += v.squaredNorm();
    }
    const auto n = static_cast<double>(mesh.vertices.size());
    return {mesh.triangles.size(), mesh.components.size(), moment / n, std::sqrt(squares / n)};
}

void requireSame(const Fingerprint& made, const Fingerprint& kept) {
    BOOST_TEST(made.triangles == kept.triangles);
    BOOST_TEST(made.components == kept.components);
    BOOST_TEST(std::abs(made.moment - kept.moment) < 1e-3);  // mm; another machine's sine may round otherwise
    BOOST_TEST(std::abs(made.spread - kept.spread) < 1e-3);
}

struct Kept {
    const char* name;
    SceneOptions options;
    Fingerprint part, environment;
};

const Kept kKept[] = {
    {"tunnel-console-3",
     {2, 20000, 60000, 10},
     {19996, 96, -0.3965561396, 224.8182336},
     {59968, 129, 917.7775385, 552.915944}},
    {"boxes-1", {2, 300, 1000, 1}, {300, 1, -0.4699247385, 30.06449794}, {1000, 2, 83.23049873, 119.973494}},
    {"cembox-2",
     {2, 4000, 20000, 3},
     {4000, 142, 0.4205213363, 115.9086617},
     {19980, 127, 2072.819233, 787.0027398}},
    {"large-environment-2",
     {2, 11000, 90000, 3},
     {11000, 146, 0.3373127018, 397.7636358},
     {89996, 409, 4484.161609, 2410.340688}},
    {"puzzle-1",
     {2, 1800, 2200, 2},
     {1790, 1, -0.8204334391, 74.59484754},
     {2186, 1, -75.86817752, 64.36535082}},
    {"puzzle-2",
     {2, 1800, 2200, 2},
     {1790, 1, -0.7628586295, 75.37528424},
     {2186, 1, -78.83091036, 65.73137864}},
    {"peg-in-hole-1",
     {2, 700, 900, 0.5},
     {700, 2, -0.8898309611, 23.33306975},
     {900, 2, -55.48495582, 81.24508925}},
    {"apartment-1",
     {2, 3500, 6000, 30},
     {3500, 177, -1.72696573, 619.6847768},
     {5992, 248, 12688.17522, 6193.536358}},
};

BOOST_AUTO_TEST_CASE(every_name_is_different_and_ends_with_a_version) {
    std::set<std::string> names;
    for (const NamedScene& scene : kScenes) {
        const std::string name = scene.name;
        BOOST_TEST(names.insert(name).second, name);
        const std::size_t dash = name.rfind('-');
        BOOST_REQUIRE(dash != std::string::npos);
        BOOST_TEST(dash + 1 < name.size());
        for (std::size_t i = dash + 1; i < name.size(); ++i) BOOST_TEST(std::isdigit(name[i]), name);
        BOOST_TEST(&sceneNamed(name) == &scene);
    }
}

BOOST_AUTO_TEST_CASE(a_name_without_version_means_the_newest) {
    for (const NamedScene& scene : kScenes) {
        const std::string name = scene.name, stem = name.substr(0, name.rfind('-'));
        const int version = std::stoi(name.substr(stem.size() + 1));
        const std::string newest = sceneNamed(stem).name;
        BOOST_TEST(newest.substr(0, newest.rfind('-')) == stem);
        BOOST_TEST(std::stoi(newest.substr(stem.size() + 1)) >= version);
    }
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_list_of_names) {
    for (const std::string name :
         {"", "tunnel", "tunnel-console-0", "tunnel-console-", "Tunnel-console-3", "tunnel-console-1"}) {
        std::vector<std::string> words = {"'" + name + "'"};
        for (const NamedScene& scene : kScenes) words.push_back(scene.name);
        testing::requireRefusedBy([&] { sceneNamed(name); }, words);
    }
}

BOOST_AUTO_TEST_CASE(what_a_version_makes_stays_what_it_was) {
    for (const Kept& kept : kKept) {
        const GeneratedScene made = sceneNamed(kept.name).make(kept.options);
        for (const auto& [mesh, was] :
             {std::pair(&made.part, &kept.part), {&made.environment, &kept.environment}}) {
            const Fingerprint is = fingerprint(*mesh);
            BOOST_TEST_CONTEXT(kept.name << (mesh == &made.part ? " part" : " environment") << ": {"
                                         << is.triangles << ", " << is.components << ", "
                                         << std::setprecision(10) << is.moment << ", " << is.spread << "}") {
                requireSame(is, *was);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
