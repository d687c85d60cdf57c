#include "core/number.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include "clearway/errors.h"

namespace clearway {

namespace {

/// Removes a leading plus sign, which from_chars does not accept.
std::string_view withoutPlus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
    text = withoutPlus(text);
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

template <typename Float, typename... Format>
std::string formatWith(Float value, Format... format) {
    if (std::isnan(value)) return "nan";  // to_chars may write its sign
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, value, format...).ptr);
}

/// The decimal of at most so many digits that is next to the value's shortest one, on the way to zero or from it.
double toDigits(double value, int digits, bool isUp) {
    if (value == 0 || !std::isfinite(value)) return value;
    const std::string text = formatWith(std::abs(value), std::chars_format::scientific);
    const std::size_t end = text.find('e');
    std::string kept = text.substr(0, 1) + (end > 2 ? text.substr(2, end - 2) : "");
    if (kept.size() <= static_cast<std::size_t>(digits)) return value;
    kept.resize(digits);
    const std::int64_t whole = *parseInteger(kept) + (isUp ? 1 : 0);
    const std::int64_t exponent = *parseInteger(text.substr(end + 1)) + 1 - digits;
    const auto next = parseNumber(std::to_string(whole) + "e" + std::to_string(exponent));
    return next ? std::copysign(*next, value) : value;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
    const std::optional<double> value = parseWhole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
    return parseWhole<std::int64_t>(text);
}

std::string formatNumber(double value) {
    return formatWith(value, std::chars_format::general, 17);
}

std::string shortNumber(double value) {
    return formatWith(value);
}

double towardsZero(double value, int digits) {
    return toDigits(value, digits, false);
}

double awayFromZero(double value, int digits) {
    return toDigits(value, digits, true);
}

std::string roundedNumber(double value) {
    const auto single = static_cast<float>(value);
    // A float holds neither 1e300 nor 1e-300.
    const bool isHeld = std::isnormal(single) || value == 0 || !std::isfinite(value);
    return isHeld ? formatWith(single) : formatWith(value, std::chars_format::general, 7);
}

std::string roundedPoint(const Vector3& point) {
    return "(" + roundedNumber(point.x()) + ", " + roundedNumber(point.y()) + ", " +
           roundedNumber(point.z()) + ")";
}

std::string withUnit(const std::string& text, const std::string& unit) {
    return unit.empty() ? text : text + " " + unit;
}

void requireNotNegative(const std::string& name, double value) {
    if (value >= 0 && std::isfinite(value)) return;
    throw ArgumentError(name + " is " + shortNumber(value) + ", expected a finite number >= 0");
}

}  // namespace clearway
