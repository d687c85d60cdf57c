// Numbers as text: read strictly, whatever the locale, and written so that they read back to the same double.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace clearway {

/// The finite decimal number that the whole text is. Nothing for anything else: "", "1 2", "0x10", "inf",
/// "nan", or what a double cannot hold ("1e999").
std::optional<double> parseNumber(std::string_view text);

/// Likewise for whole numbers: "12", "-3", "+7", but not "1.0".
std::optional<std::int64_t> parseInteger(std::string_view text);

/// 17 significant digits, so that parseNumber gives back the same double; "inf", "-inf" or "nan" for what is
/// not finite.
std::string formatNumber(double value);

/// The fewest digits that parseNumber reads back to the same double: for messages and for what people read.
std::string shortNumber(double value);

}  // namespace clearway
