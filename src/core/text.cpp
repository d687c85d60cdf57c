#include "core/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace clearway {

namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestQuote = 60;  // characters

[[noreturn]] void refuse(const std::string& file, const std::string& reason, const char* expected) {
    throw std::runtime_error("cannot read '" + file + "': " + reason + ", expected " + expected);
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
    std::size_t least = word.size() / 3 + 1;
    const std::string* nearest = nullptr;
    for (const std::string& name : names) {
        // V. Levenshtein, Binary codes capable of correcting deletions, insertions and reversals (1966).
        std::vector<std::size_t> row(name.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t(0));
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::size_t diagonal = row[0]++;
            for (std::size_t j = 0; j < name.size(); ++j) {
                const std::size_t changed = diagonal + (word[i] != name[j]);
                diagonal = row[j + 1];
                row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
            }
        }
        if (row.back() >= least) continue;
        least = row.back();
        nearest = &name;
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
