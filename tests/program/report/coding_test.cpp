#include "program/report/coding.h"

#include <boost/test/unit_test.hpp>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(coding_test)

using namespace report;

BOOST_AUTO_TEST_CASE(base64_is_that_of_the_standard) {
    // Source of the vectors: RFC 4648.
    const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) BOOST_TEST(base64(bytes.data(), bytes.size()) == text);
    const unsigned char high[] = {0xff, 0xef, 0xbe};
    BOOST_TEST(base64(high, 3) == "/+++");
}

BOOST_AUTO_TEST_CASE(html_has_no_markup_of_the_texts_own) {
    BOOST_TEST(htmlText("a <b> & \"c\"") == "a &lt;b&gt; &amp; &quot;c&quot;");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
