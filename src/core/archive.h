// Plain values as bytes and back. A reader checks every length before it uses it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "clearway/errors.h"

namespace clearway {

class ArchiveWriter {
  public:
    /// Appends raw bytes; use it only for numbers without padding between them.
    void addBytes(const void* data, std::size_t bytes) {
        bytes_.append(static_cast<const char*>(data), bytes);
    }
    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T>);
        addBytes(&value, sizeof value);
    }
    void add(const std::string& text) {
        add(std::uint64_t(text.size()));
        addBytes(text.data(), text.size());
    }
    template <class Vector>
    void addArray(const Vector& values) {
        add(std::uint64_t(values.size()));
        addBytes(values.data(), values.size() * sizeof(values[0]));
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// Every read throws FileError("ends too early") when fewer bytes are left than it needs.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

    void readBytes(void* to, std::size_t bytes) {
        require(bytes);
        if (bytes > 0) std::memcpy(to, rest_.data(), bytes);
        rest_.remove_prefix(bytes);
    }
    template <class T>
    T read() {
        static_assert(std::is_arithmetic_v<T>);
        T value;
        readBytes(&value, sizeof value);
        return value;
    }
    std::string readText() {
        std::string text(readCount(1), '\0');
        readBytes(text.data(), text.size());
        return text;
    }
    template <class Vector>
    void readArray(Vector& values) {
        values.resize(readCount(sizeof(values[0])));
        readBytes(values.data(), values.size() * sizeof(values[0]));
    }
    /// Reads a count and checks that the rest can hold that many items of at least bytesEach bytes.
    std::size_t readCount(std::size_t bytesEach) {
        const auto count = read<std::uint64_t>();
        if (count > rest_.size() / bytesEach) throw FileError("ends too early");
        return std::size_t(count);
    }
    bool isAtEnd() const { return rest_.empty(); }

  private:
    void require(std::size_t bytes) const {
        if (bytes > rest_.size()) throw FileError("ends too early");
    }
    std::string_view rest_;
};

}  // namespace clearway
