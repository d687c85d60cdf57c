#include "program/report/coding.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace clearway::report {

std::string base64(const void* bytes, std::size_t count) {
    using namespace boost::archive::iterators;
    using Digits = base64_from_binary<transform_width<const char*, 6, 8>>;
    const auto* const begin = static_cast<const char*>(bytes);
    std::string text(Digits(begin), Digits(begin + count));
    return text.append((3 - count % 3) % 3, '=');
}

std::string htmlText(std::string text) {
    boost::replace_all(text, "&", "&amp;");  // first, because the other replacements contain &
    boost::replace_all(text, "<", "&lt;");
    boost::replace_all(text, ">", "&gt;");
    boost::replace_all(text, "\"", "&quot;");
    return text;
}

}  // namespace clearway::report
