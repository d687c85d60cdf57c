// How fuzz targets read their input and report faults. A target is a body for one input (fuzzOne) and the
// inputs that fuzzing starts from (seeds). libfuzzer.cpp hands it to libFuzzer; replay.cpp makes a plain
// program of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace clearway::testing {

/// Takes any input. A fault ends the program, by require or by a sanitizer.
void fuzzOne(std::string_view input);

/// Sound inputs that reach deep into the code; mutations start from them.
std::vector<std::string> seeds();

/// If set, require calls it to print more about the input at hand.
inline std::function<void()> tellMore;

/// Ends the program if a promise is broken, so that libFuzzer and replay keep the input.
inline void require(bool isKept, const std::string& promise) {
    if (isKept) return;
    std::cerr << "broken promise: " << promise << std::endl;
    if (tellMore) tellMore();
    std::abort();
}

/// Reads choices and numbers from the input; gives zeros when the input is used up.
class Bytes {
  public:
    explicit Bytes(std::string_view input) : rest_(input) {}

    template <typename T>
    T take() {
        T value{};
        const std::size_t size = std::min(sizeof value, rest_.size());
        if (size > 0) std::memcpy(&value, rest_.data(), size);
        rest_.remove_prefix(size);
        return value;
    }
    std::uint8_t byte() { return take<std::uint8_t>(); }
    std::size_t below(std::size_t end) { return byte() % end; }  ///< 0 .. end - 1, of at most 256
    bool isAtEnd() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
};

}  // namespace clearway::testing
