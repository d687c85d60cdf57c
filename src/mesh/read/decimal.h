// The number at the beginning of a text, as the nearest double.
#pragma once

#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>

namespace clearway {

/// As std::from_chars, but a number that is too small for a double is 0, and one that is too large is infinite.
inline std::from_chars_result fromDecimal(const char* first, const char* last, double& value) {
    std::from_chars_result result = std::from_chars(first, last, value);
    if (result.ec != std::errc::result_out_of_range) return result;
    long double wide = 0;
    if (std::from_chars(first, last, wide).ec == std::errc::result_out_of_range) {
        const std::string_view text(first, static_cast<std::size_t>(result.ptr - first));
        const bool isSmall = text.find("e-") != text.npos || text.find("E-") != text.npos;
        wide = isSmall ? 0 : std::numeric_limits<long double>::infinity();
    }
    value = static_cast<double>(wide);
    result.ec = {};
    return result;
}

}  // namespace clearway
