// Plain values as bytes and back. A reader checks every length before it uses it. A template that visits the fields of an object with a writer
// writes them; with a reader it reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "clearway/errors.h"
#include "clearway/types.h"

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
    void add(bool value) { add(std::uint64_t(value)); }
    void add(char value) { add(std::uint64_t(value)); }
    void add(const std::string& text) {
        add(std::uint64_t(text.size()));
        addBytes(text.data(), text.size());
    }
    void add(const Vector3& vector) {
        for (const double x : vector) add(x);
    }
    template <class... Fields>
    void visit(const Fields&... fields) {
        (add(fields), ...);
    }
    template <class Vector>
    void visitArray(const Vector& values) {
        add(std::uint64_t(values.size()));
        addBytes(values.data(), values.size() * sizeof(values[0]));
    }
    /// visit: called for each item. bytesEach: see ArchiveReader::readCount.
    template <class Item, class Visit>
    void visitEach(const std::vector<Item>& items, std::size_t /*bytesEach*/, const Visit& visit) {
        add(std::uint64_t(items.size()));
        for (const Item& item : items) visit(item);
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
    template <class... Fields>
    void visit(Fields&... fields) {
        (take(fields), ...);
    }
    template <class Vector>
    void visitArray(Vector& values) {
        values.resize(readCount(sizeof(values[0])));
        readBytes(values.data(), values.size() * sizeof(values[0]));
    }
    template <class Item, class Visit>
    void visitEach(std::vector<Item>& items, std::size_t bytesEach, const Visit& visit) {
        items.resize(readCount(bytesEach));
        for (Item& item : items) visit(item);
    }
    /// Reads a count and checks that the rest can hold that many items of at least bytesEach bytes.
    std::size_t readCount(std::size_t bytesEach) {
        const auto count = read<std::uint64_t>();
        if (count > rest_.size() / bytesEach) throw FileError("ends too early");
        return std::size_t(count);
    }
    bool isAtEnd() const { return rest_.empty(); }

  private:
    template <class T>
    void take(T& value) {
        value = read<T>();
    }
    void take(bool& value) { value = read<std::uint64_t>() != 0; }
    void take(char& value) { value = static_cast<char>(read<std::uint64_t>()); }
    void take(std::string& text) { text = readText(); }
    void take(Vector3& vector) {
        for (double& x : vector) x = read<double>();
    }
    void require(std::size_t bytes) const {
        if (bytes > rest_.size()) throw FileError("ends too early");
    }
    std::string_view rest_;
};

}  // namespace clearway
