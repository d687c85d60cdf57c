// Storage that is filled anew for each node.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace clearway {

/// An array without initial values, reused from use to use. Growing forgets the values.
template <class T>
class ScratchArray {
    static_assert(std::is_trivially_default_constructible_v<T>);

  public:
    /// Room for at least this many.
    T* withRoomFor(std::size_t count) {
        if (count > capacity_) {
            capacity_ = count + count / 2;
            values_.reset(new T[capacity_]);
        }
        return values_.get();
    }

    T* data() { return values_.get(); }
    const T* data() const { return values_.get(); }

  private:
    std::unique_ptr<T[]> values_;
    std::size_t capacity_ = 0;
};

}  // namespace clearway
