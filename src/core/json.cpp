#include "core/json.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/locale/utf.hpp>
#include <iterator>
#include <nlohmann/json.hpp>

namespace clearway {

std::string utf8Of(const std::string& text) {
    namespace utf = boost::locale::utf;
    std::string result;
    for (auto at = text.begin(); at != text.end();) {
        const auto start = at;
        utf::code_point character = utf::utf_traits<char>::decode(at, text.end());
        if (character == utf::illegal || character == utf::incomplete) {
            character = static_cast<unsigned char>(*start);  // Latin-1 is the start of Unicode
            at = start + 1;
        }
        utf::utf_traits<char>::encode(character, std::back_inserter(result));
    }
    return result;
}

namespace {

void makeUtf8(FloatJson& value) {
    if (value.is_string()) value = utf8Of(value.get_ref<const std::string&>());
    if (!value.is_structured()) return;
    for (FloatJson& item : value) makeUtf8(item);
}

}  // namespace

std::string jsonText(FloatJson value) {
    makeUtf8(value);
    std::string text = value.dump();
    boost::replace_all(text, "<", "\\u003c");  // only strings can contain it
    return text;
}

}  // namespace clearway
