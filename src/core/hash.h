// A hash of values and bytes, and the mixing of 64 bits on which it rests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "clearway/types.h"

namespace clearway {

/// 2^64 divided by the golden ratio, the step between states of splitmix64.
constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;

/// The finaliser of splitmix64 (Steele, Lea, Flood 2014): a bijection in which every bit of the input affects
/// all bits of the result.
constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// A hash that detects damaged and foreign data. It is not cryptographic, so it does not detect forgery.
class Hash {
  public:
    void add(const void* data, std::size_t bytes) {
        const char* from = static_cast<const char*>(data);
        for (; bytes >= 8; bytes -= 8, from += 8) mix(word(from, 8));
        mix(word(from, bytes) ^ (std::uint64_t(bytes) << 56) ^ kGoldenStep);
    }
    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T>);
        add(&value, sizeof value);
    }
    void add(const std::string& text) {
        add(std::uint64_t(text.size()));
        add(text.data(), text.size());
    }
    void add(const Vector3& vector) {
        for (const double x : vector) add(x);
    }
    /// As ArchiveWriter::visit.
    template <class... Fields>
    void visit(const Fields&... fields) {
        (add(fields), ...);
    }
    template <class T>
    void addArray(const std::vector<T>& values) {
        add(std::uint64_t(values.size()));
        add(values.data(), values.size() * sizeof(T));
    }
    std::uint64_t value() const { return state_; }

  private:
    static std::uint64_t word(const char* from, std::size_t bytes) {
        std::uint64_t value = 0;
        std::memcpy(&value, from, bytes);
        return value;
    }
    /// For every word a bijection of the state, so that a change of one bit changes the hash.
    void mix(std::uint64_t input) { state_ = mixed(state_ + kGoldenStep + input); }
    std::uint64_t state_ = 0;
};

}  // namespace clearway
