#define BOOST_TEST_MODULE json_text
#include "core/json_text.h"

#include <boost/test/unit_test.hpp>

namespace clearway::testing {

BOOST_AUTO_TEST_CASE(no_text_can_end_the_script_it_stands_in) {
    const std::string json = jsonText("</script><!-- \"quoted\" \\ \n");
    BOOST_TEST(json == "\"\\u003c/script>\\u003c!-- \\\"quoted\\\" \\\\ \\u000a\"");
}

BOOST_AUTO_TEST_CASE(utf8_stays_as_it_is) {
    for (const std::string text : {"Träger", "中", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf"})
        BOOST_TEST(jsonText(text) == '"' + text + '"');
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_utf8_are_taken_for_latin1) {
    BOOST_TEST(jsonText("Tr\xe4ger") == "\"Tr\\u00e4ger\"");
    BOOST_TEST(jsonText("\xff\xfe") == "\"\\u00ff\\u00fe\"");
    BOOST_TEST(jsonText("cut \xe4\xb8") == "\"cut \\u00e4\\u00b8\"");
    BOOST_TEST(jsonText("\xc0\xaf") == "\"\\u00c0\\u00af\"");                        // too long a form of /
    BOOST_TEST(jsonText("\xed\xa0\x80") == "\"\\u00ed\\u00a0\\u0080\"");             // half of a pair
    BOOST_TEST(jsonText("\xf4\x90\x80\x80") == "\"\\u00f4\\u0090\\u0080\\u0080\"");  // beyond the last
}

}  // namespace clearway::testing
