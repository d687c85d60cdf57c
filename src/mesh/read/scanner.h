// Reads numbers and words from a text in memory, without copies. Numbers are read to the nearest double.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "core/text.h"
#include "mesh/read/collector.h"
#include "mesh/read/decimal.h"

namespace clearway {

/// A place in a text. Lines end with "\n", "\r\n" or "\r". All refusals name the line.
class Scanner {
  public:
    Scanner(std::string_view text, const MeshCollector& mesh)
        : at_(text.data()), end_(text.data() + text.size()), mesh_(mesh) {
        const std::string_view start = text.substr(0, 2);
        if (start == "\xFF\xFE" || start == "\xFE\xFF")
            mesh.refuse("it is text in UTF-16, expected UTF-8 or ASCII");
        if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ += kByteOrderMark.size();
    }

    /// Leaves out the zeros and the Ctrl-Z with which some writers end a text.
    void trimEnd() {
        while (end_ != at_ && (end_[-1] == '\0' || end_[-1] == '\x1A')) --end_;
    }

    std::size_t bytesLeft() const { return std::size_t(end_ - at_); }
    const char* at() const { return at_; }

    /// Passes over bytes that are not text; the caller knows that so many are left.
    const char* take(std::size_t bytes) {
        at_ += bytes;
        return at_ - bytes;
    }

    bool isAtEnd() const { return at_ == end_; }

    bool isAtLineEnd() {
        for (; at_ != end_; ++at_) {
            if (isBlank(*at_)) continue;
            if (!isContinuation(at_)) return *at_ == '\n' || *at_ == '\r' || *at_ == comment_;
            ++line_;
            ++at_;
            if (*at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n') ++at_;
        }
        return true;
    }

    /// From this character on, where a word could begin, the rest of a line counts as blank.
    void passOverComments(char begin) { comment_ = begin; }

    /// Whether a backslash at a line's end joins the next line to it.
    void joinLines(bool areJoined) { areLinesJoined_ = areJoined; }

    /// Goes to the start of the next line, wherever in the line it is.
    void nextLine() {
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
        if (at_ == end_) return;
        if (*at_++ == '\r' && at_ != end_ && *at_ == '\n') ++at_;
        ++line_;
    }

    /// Goes to the next character that is not white space, over lines; false at the end of the text.
    bool skipSpace() {
        while (isAtLineEnd()) {
            if (isAtEnd()) return false;
            nextLine();
        }
        return true;
    }

    /// The next word of the line; empty at its end.
    std::string_view word() {
        if (isAtLineEnd()) return {};
        const char* const first = at_;
        while (!endsWord(at_)) ++at_;
        return {first, std::size_t(at_ - first)};
    }

    /// The line from here on, without blanks at its ends.
    std::string_view restOfLine() {
        isAtLineEnd();
        const char* const first = at_;
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
        return trimmed({first, std::size_t(at_ - first)});
    }

    /// The number that is the line's next word. what: says what it belongs to, such as "vertex 3"; called for a refusal only.
    template <class What>
    double number(const What& what) {
        double value = 0;
        const auto [last, error] = fromDecimal(startOfNumber(), end_, value);
        if (error != std::errc() || !endsWord(last)) refuseWord(what, "a number");
        at_ = last;
        return value;
    }

    /// The whole number that is the line's next word.
    template <class What>
    std::int64_t integer(const What& what) {
        return integerBefore('\0', what);
    }

    /// The whole number up to the end of the word, or to a separator.
    template <class What>
    std::int64_t integerBefore(char separator, const What& what) {
        std::int64_t value = 0;
        const auto [last, error] = std::from_chars(startOfNumber(), end_, value);
        const bool isSeparated = last != end_ && separator != '\0' && *last == separator;
        if (error != std::errc() || !(isSeparated || endsWord(last))) refuseWord(what, "a whole number");
        at_ = last;
        return value;
    }

    bool isAtWordEnd() const { return endsWord(at_); }
    bool isAt(char c) const { return at_ != end_ && *at_ == c; }
    bool skip(char c) {
        if (!isAt(c)) return false;
        ++at_;
        return true;
    }

    /// Refuses the file because of what stands in this line.
    [[noreturn]] void refuse(const std::string& reason) const { mesh_.refuse("line {}: {}", line_, reason); }
    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> reason, Values&&... values) const {
        refuse(fmt::format(reason, std::forward<Values>(values)...));
    }

  protected:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

    bool endsWord(const char* place) const {
        return place == end_ || isBlank(*place) || *place == '\n' || *place == '\r' || isContinuation(place);
    }

    bool isContinuation(const char* place) const {
        return areLinesJoined_ && *place == '\\' && end_ - place > 1 &&
               (place[1] == '\n' || place[1] == '\r');
    }

    const char* at_;
    const char* end_;

  private:
    const char* startOfNumber() {
        isAtLineEnd();
        const bool hasPlus = end_ - at_ > 1 && at_[0] == '+' && at_[1] != '-';
        return hasPlus ? at_ + 1 : at_;
    }

    template <class What>
    [[noreturn]] void refuseWord(const What& what, const char* expected) {
        const std::string_view found = word();
        refuse("{}{}, expected {}", what(), found.empty() ? " ends too soon" : " has " + quote(found),
               expected);
    }

    const MeshCollector& mesh_;
    std::size_t line_ = 1;
    bool areLinesJoined_ = false;
    char comment_ = '\n';
};

}  // namespace clearway
