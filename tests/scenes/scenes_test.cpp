#define BOOST_TEST_MODULE scenes
#include "scenes/scenes.h"

#include <boost/test/unit_test.hpp>
#include <cctype>
#include <set>
#include <stdexcept>

using namespace clearway;

BOOST_AUTO_TEST_CASE(every_name_is_different_and_ends_with_a_version) {
    std::set<std::string> names;
    for (const NamedScene& scene : namedScenes()) {
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
    for (const NamedScene& scene : namedScenes()) {
        const std::string name = scene.name, stem = name.substr(0, name.rfind('-'));
        const int version = std::stoi(name.substr(stem.size() + 1));
        const std::string newest = sceneNamed(stem).name;
        BOOST_TEST(newest.substr(0, newest.rfind('-')) == stem);
        BOOST_TEST(std::stoi(newest.substr(stem.size() + 1)) >= version);
    }
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_list_of_names) {
    for (const std::string name : {"", "tunnel", "tunnel-console-0", "tunnel-console-", "Tunnel-console-1"}) {
        BOOST_CHECK_EXCEPTION(sceneNamed(name), std::invalid_argument,
                              [&](const std::invalid_argument& error) {
                                  const std::string text = error.what();
                                  bool all = text.find("'" + name + "'") != std::string::npos;
                                  for (const NamedScene& scene : namedScenes())
                                      all = all && text.find(scene.name) != std::string::npos;
                                  return all;
                              });
    }
}
