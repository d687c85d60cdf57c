#include "mesh/components.h"

#include <boost/test/unit_test.hpp>

namespace clearway {
BOOST_AUTO_TEST_SUITE(components_test)

using Names = std::vector<std::string>;

Names madeDistinct(const Names& names) {
    std::vector<Component> components;
    for (const std::string& name : names) components.push_back({name, 0, 0});
    makeNamesDistinct(components, "part");
    Names distinct;
    for (const Component& component : components) distinct.push_back(component.name);
    return distinct;
}

BOOST_AUTO_TEST_CASE(node_and_mesh_make_one_name) {
    BOOST_TEST(componentName("arm", "link") == "arm/link");
    BOOST_TEST(componentName("arm", "arm") == "arm");
    BOOST_TEST(componentName("arm", "") == "arm");
    BOOST_TEST(componentName("", "link") == "link");
    BOOST_TEST(componentName("", "") == "");
}

BOOST_AUTO_TEST_CASE(names_that_importers_make_up_count_as_none) {
    BOOST_TEST(componentName("<STL_BINARY>", "") == "");
    BOOST_TEST(componentName("$ColladaAutoName$_0", "link") == "link");
    BOOST_TEST(componentName("defaultobject", "defaultobject") == "");
    BOOST_TEST(componentName("a<b>", "$x") == "a<b>");
}

BOOST_AUTO_TEST_CASE(repeated_names_are_numbered_and_a_name_the_file_gives_is_kept) {
    BOOST_TEST(madeDistinct({"rib", "boss", "rib", "rib"}) == (Names{"rib", "boss", "rib#2", "rib#3"}));
    BOOST_TEST(madeDistinct({"rib", "rib", "rib#2", "rib"}) == (Names{"rib", "rib#3", "rib#2", "rib#4"}));
    BOOST_TEST(madeDistinct({"rib#2", "rib#2", "rib", "rib"}) == (Names{"rib#2", "rib#2#2", "rib", "rib#3"}));
    BOOST_TEST(madeDistinct({"", "a", ""}) == (Names{"part", "a", "part#2"}));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
