#include "core/text.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "clearway/errors.h"

namespace clearway {

namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n\v\f";
constexpr std::size_t kLongestQuote = 60;   // characters
constexpr std::size_t kLeastBeginning = 2;  // characters of a name that a longer word may begin with

[[noreturn]] void refuse(const std::string& file, const std::string& reason, const char* expected) {
    throw FileError("cannot read '" + file + "': " + reason + ", expected " + expected);
}

/// How many letters must be changed, inserted, left out or swapped with their neighbour to make one word of the other;
/// upper and lower case count as one. Source: F. J. Damerau, A technique for computer detection and correction of
/// spelling errors (1964).
std::size_t editsBetween(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    const auto isSame = [](char one, char other) {
        return boost::iequals(std::string(1, one), std::string(1, other));
    };
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                edits[i][j] = i + j;
                continue;
            }
            edits[i][j] = std::min({edits[i - 1][j - 1] + !isSame(a[i - 1], b[j - 1]), edits[i - 1][j] + 1,
                                    edits[i][j - 1] + 1});
            const bool isSwap = i > 1 && j > 1 && isSame(a[i - 1], b[j - 2]) && isSame(a[i - 2], b[j - 1]);
            if (isSwap) edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
        }
    }
    return edits[a.size()][b.size()];
}

/// Both words without the parts between dots that they share at their beginnings and ends: "w" and "x" of "start.w" and
/// "start.x". How much of a word is wrong then counts in the part that is wrong.
std::pair<std::string_view, std::string_view> differingParts(std::string_view a, std::string_view b) {
    const auto [beginA, beginB] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const std::size_t dot = a.substr(0, std::size_t(beginA - a.begin())).rfind('.');
    if (dot != std::string_view::npos) {
        a.remove_prefix(dot + 1);
        b.remove_prefix(dot + 1);
    }
    const auto [endA, endB] = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    const std::size_t ending = a.substr(a.size() - std::size_t(endA - a.rbegin())).find('.');
    if (ending == std::string_view::npos) return {a, b};
    const std::size_t shared = std::size_t(endA - a.rbegin()) - ending;
    a.remove_suffix(shared);
    b.remove_suffix(shared);
    return {a, b};
}

}  // namespace

std::vector<std::string> readLines(const std::string& file, const char* expected) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) refuse(file, "it is a folder", expected);
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse(file, errno ? std::strerror(errno) : "it cannot be opened", expected);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (line.find('\0') != std::string::npos) refuse(file, "it is no text", expected);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        lines.push_back(line);
    }
    if (stream.bad()) refuse(file, "reading failed", expected);
    if (!lines.empty() && lines[0].compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) {
        lines[0].erase(0, kByteOrderMark.size());
    }
    return lines;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kWhiteSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1);
}

std::vector<std::string_view> words(std::string_view line) {
    std::vector<std::string_view> found;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t length = std::min(line.find_first_of(kWhiteSpace), line.size());
        found.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
    return found;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& names) {
    const std::string* nearest = nullptr;
    std::size_t least = word.size();
    const auto isAbove = [&](const std::string& name) { return boost::istarts_with(word, name + "."); };
    for (const std::string& name : names) {
        if (isAbove(name)) continue;
        const auto [asked, known] = differingParts(word, name);
        const std::size_t changes = editsBetween(asked, known);
        if (changes > asked.size() / 3 || changes >= least) continue;
        least = changes;
        nearest = &name;
    }
    for (const std::string& name : names) {
        const bool isBeginning = name.size() >= kLeastBeginning && boost::istarts_with(word, name);
        if (!nearest && isBeginning && !isAbove(name)) nearest = &name;
    }
    return nearest ? " (did you mean '" + *nearest + "'?)" : "";
}

std::string place(const std::string& file, int line) {
    return file + ":" + std::to_string(line) + ": ";
}

std::string quote(std::string_view text) {
    std::string shown(text.substr(0, kLongestQuote));
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
    }
    return "'" + shown + (text.size() > kLongestQuote ? "...'" : "'");
}

std::string joined(const std::vector<std::string>& texts, const std::string& separator) {
    std::string all;
    for (const std::string& text : texts) {
        if (&text != &texts.front()) all += separator;
        all += text;
    }
    return all;
}

}  // namespace clearway
