// Vectors for the large arrays of trees and of what they are built from.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace clearway {

/// Allocates large arrays in pages of 2 MB where the system has them. To get small pages takes longer than to fill them, above all on
/// virtual machines.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t count) {
        if (count > std::size_t(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < kLeast) return static_cast<T*>(::operator new(bytes, kAlignment));
        const std::size_t pages = (bytes + kPage - 1) / kPage * kPage;
        void* const memory = std::aligned_alloc(kPage, pages);
        if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        madvise(memory, pages, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < kLeast) return ::operator delete(memory, kAlignment);
        std::free(memory);
    }

    friend bool operator==(LargePages, LargePages) {
        return true;
    }
    friend bool operator!=(LargePages, LargePages) {
        return false;
    }

  private:
    static constexpr std::size_t kPage = std::size_t(1) << 21, kLeast = 2 * kPage;
    static constexpr std::align_val_t kAlignment{alignof(T)};
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace clearway
