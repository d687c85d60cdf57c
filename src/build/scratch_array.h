// Storage that is filled anew for each node.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#include "core/large_vector.h"

namespace clearway {

/// An array without initial values, reused from use to use. Growing forgets the values.
template <class T>
class ScratchArray {
    static_assert(std::is_trivially_default_constructible_v<T>);

  public:
    /// Room for at least this many.
    T* withRoomFor(std::size_t count) {
        if (!values_ || count > values_.get_deleter().capacity) {
            const std::size_t capacity = count + count / 2;
            values_ = {LargePages<T>().allocate(capacity), Deallocate{capacity}};
        }
        return values_.get();
    }

    T* data() { return values_.get(); }
    const T* data() const { return values_.get(); }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }

  private:
    struct Deallocate {
        std::size_t capacity = 0;
        void operator()(T* values) const { LargePages<T>().deallocate(values, capacity); }
    };
    std::unique_ptr<T[], Deallocate> values_;
};

}  // namespace clearway
