#include "engine/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include <gtest/gtest.h>

namespace {

std::atomic<std::size_t> count{0}, bytes{0};

void* counted(std::size_t size, std::size_t alignment) {
    count.fetch_add(1, std::memory_order_relaxed);
    bytes.fetch_add(size, std::memory_order_relaxed);
    void* place = alignment <= alignof(std::max_align_t)
                      ? std::malloc(size ? size : 1)
                      : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (!place) throw std::bad_alloc();
    return place;
}

}  // namespace

// All other forms of new and delete come down to these. Never inline: the compiler would see memory of malloc
// deleted, or of new freed.
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(size, 1); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* place) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::size_t) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::size_t, std::align_val_t) noexcept {
    std::free(place);
}

namespace percuss::testing {

std::size_t allocations() { return count.load(std::memory_order_relaxed); }
std::size_t allocated_bytes() { return bytes.load(std::memory_order_relaxed); }

TEST(Allocations, AreCounted) {
    const std::size_t before = allocations(), bytes_before = allocated_bytes();
    const auto owned = std::make_unique<std::vector<double>>(100);
    EXPECT_EQ(allocations() - before, 2U);
    EXPECT_EQ(allocated_bytes() - bytes_before, sizeof(std::vector<double>) + 100 * sizeof(double));
    EXPECT_EQ(owned->size(), 100U);
}

}  // namespace percuss::testing
