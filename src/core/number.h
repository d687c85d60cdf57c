// Numbers as text: read strictly in any locale, and written so that they read back to the same double.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "clearway/types.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// The finite decimal number that the whole text states. Empty for every other text: "", "1 2", "0x10",
/// "inf", "nan", and numbers beyond a double ("1e999").
std::optional<double> parseNumber(std::string_view text);

/// The whole number that the whole text states: "12", "-3", "+7", but not "1.0". Empty for every other text.
std::optional<std::int64_t> parseInteger(std::string_view text);

/// The number with 17 significant digits, which parseNumber reads back to the same double; "inf", "-inf" or
/// "nan" if it is not finite.
std::string formatNumber(double value);

/// The number with the fewest digits that parseNumber reads back to the same double: for messages and for
/// people.
std::string shortNumber(double value);

/// The number with so many significant digits that is next to the value on the way to zero: of the digits of shortNumber, those are
/// kept. A certified bound that is shown this way is never shown as more than it is.
double towardsZero(double value, int digits);

/// The same on the way from zero; the value itself where a double has no such number.
double awayFromZero(double value, int digits);

/// A computed number for messages: with a float's digits, so without those that rounding made.
std::string roundedNumber(double value);
std::string roundedPoint(const Vector3& point);  ///< "(1.5, 2, 0.1)", numbers as roundedNumber gives them

/// "1.5 mm", or the text alone if the unit is empty.
std::string withUnit(const std::string& text, const std::string& unit);

/// Throws ArgumentError "NAME is VALUE, expected a finite number >= 0" unless it is one.
void requireNotNegative(const std::string& name, double value);

}  // namespace clearway

#pragma GCC visibility pop
