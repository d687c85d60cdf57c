#include "problem/name_lists.h"

#include "core/text.h"

namespace clearway {
namespace {

constexpr char kQuote = '"';

}  // namespace

std::string_view beforeUnquoted(std::string_view text, char character) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == character) return text.substr(0, i);
        if (text[i] != kQuote) continue;
        const std::size_t closing = text.find(kQuote, i + 1);
        if (closing != std::string_view::npos) i = closing;
    }
    return text;
}

std::optional<std::vector<std::string>> splitNames(std::string_view text) {
    std::vector<std::string> names;
    for (bool isLast = false; !isLast;) {
        const std::string_view whole = beforeUnquoted(text, ',');
        isLast = whole.size() == text.size();
        std::string_view item = trimmed(whole);
        if (item.size() >= 2 && item.front() == kQuote && item.back() == kQuote) {
            item = item.substr(1, item.size() - 2);
        }
        if (item.empty() || item.find(kQuote) != std::string_view::npos) return std::nullopt;
        names.emplace_back(item);
        if (!isLast) text.remove_prefix(whole.size() + 1);
    }
    return names;
}

std::optional<std::string> writtenName(const std::string& name) {
    if (name.empty() || name.find_first_of("\"\n\r") != std::string::npos) return std::nullopt;
    const bool isPlain = trimmed(name) == name && name.find_first_of(",#=[]") == std::string::npos;
    return isPlain ? name : kQuote + name + kQuote;
}

std::optional<std::string> writtenNames(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) {
        const std::optional<std::string> written = writtenName(name);
        if (!written) return std::nullopt;
        all += (all.empty() ? "" : ", ") + *written;
    }
    return all;
}

}  // namespace clearway
