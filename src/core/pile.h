// A growing array of plain values that keeps its memory when it is cleared, so that a query's scratch stops
// allocating once it is warm. All functions but grow() are simple enough to be inlined into code of any
// instruction set.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace clearway {

template <class T>
class Pile {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    Pile() = default;
    Pile(const Pile&) = delete;
    Pile& operator=(const Pile&) = delete;
    ~Pile() { std::free(data_); }

    void push(const T& value) {
        if (size_ == capacity_) grow();
        data_[size_++] = value;
    }
    T pop() { return data_[--size_]; }
    void clear() { size_ = 0; }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T& operator[](std::size_t i) { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }

  private:
    [[gnu::noinline]] void grow() {
        const std::size_t capacity = capacity_ == 0 ? 256 : 2 * capacity_;
        void* data = std::realloc(data_, capacity * sizeof(T));
        if (data == nullptr) throw std::bad_alloc();
        data_ = static_cast<T*>(data);
        capacity_ = capacity;
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace clearway
