// Source: Unicode 15, table 3-7 (well-formed UTF-8); RFC 8259 (JSON).
#include "core/json_text.h"

#include <cstdio>

namespace clearway {

namespace {

/// Bytes of the UTF-8 character that begins there, 0 when none does.
std::size_t utf8Length(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(i) >> 6 != 2) return 0;
    }
    const bool isTooLong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool isNoCharacter = (first == 0xed && byte(1) > 0x9f) || (first == 0xf4 && byte(1) > 0x8f);
    return isTooLong || isNoCharacter ? 0 : length;
}

std::string escape(char character) {
    char text[7];
    std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(character)));
    return text;
}

}  // namespace

std::string jsonText(const std::string& text) {
    std::string json = "\"";
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8Length(text, i);
        const char character = text[i];
        if (length == 0 || static_cast<unsigned char>(character) < 0x20 || character == '<') {
            json += escape(character);
        } else {
            if (character == '"' || character == '\\') json += '\\';
            json.append(text, i, length);
        }
        i += length == 0 ? 1 : length;
    }
    return json + '"';
}

}  // namespace clearway
