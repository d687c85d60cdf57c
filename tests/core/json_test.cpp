#include "core/json.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(json_test)

BOOST_AUTO_TEST_CASE(no_text_can_end_the_script_it_stands_in) {
    const std::string text = "</script><!-- \"quoted\" \\ \n";
    const std::string json = jsonText({{"a", {text}}});
    BOOST_TEST(json == R"({"a":["\u003c/script>\u003c!-- \"quoted\" \\ \n"]})");
    BOOST_TEST(FloatJson::parse(json)["a"][0].get<std::string>() == text);
}

BOOST_AUTO_TEST_CASE(utf8_stays_as_it_is) {
    for (const std::string text : {"Träger", "中", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf"})
        BOOST_TEST(jsonText(text) == '"' + text + '"');
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_utf8_are_taken_for_latin1) {
    BOOST_TEST(jsonText("Tr\xe4ger") == "\"Träger\"");
    BOOST_TEST(jsonText("Träger, Tr\xe4ger") == "\"Träger, Träger\"");
    BOOST_TEST(jsonText("\xff\xfe") == "\"ÿþ\"");
    BOOST_TEST(jsonText("cut \xe4\xb8") == "\"cut ä¸\"");
    BOOST_TEST(jsonText("\xc0\xaf") == "\"À¯\"");                                // too long a form of /
    BOOST_TEST(jsonText("\xed\xa0\x80") == "\"\u00ed\u00a0\u0080\"");            // half of a pair
    BOOST_TEST(jsonText("\xf4\x90\x80\x80") == "\"\u00f4\u0090\u0080\u0080\"");  // beyond the last
    BOOST_TEST(jsonText({{"a", {{"b", {1, "\xe4"}}}}}) == "{\"a\":{\"b\":[1,\"ä\"]}}");
}

BOOST_AUTO_TEST_CASE(numbers_read_back_to_the_same_float_and_what_is_none_is_null) {
    for (const float value : {0.1f, -1e-30f, 16777217.0f, 3.4e38f})
        BOOST_TEST(std::stof(jsonText(value)) == value);
    BOOST_TEST(jsonText(0.1) == "0.1");
    BOOST_TEST(jsonText({1, -2.5, NAN, INFINITY}) == "[1,-2.5,null,null]");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
