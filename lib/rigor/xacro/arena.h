// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Memory that is given out piece by piece and ends all at once, for the thousands of small things that an
// expansion makes. As a `std::pmr::memory_resource` it serves containers, too.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <vector>

namespace rigor::xacro {

class Arena final : public std::pmr::memory_resource {
 public:
  void* take(std::size_t size, std::size_t alignment) {
    const std::size_t padding =
        (alignment - reinterpret_cast<std::uintptr_t>(next_)) & (alignment - 1);
    if (padding + size > left_) return take_of_new_block(size, alignment);
    std::byte* const taken = next_ + padding;
    next_ = taken + size;
    left_ -= padding + size;
    return taken;
  }

 private:
  /// Small enough that the allocator needs not ask the kernel for each.
  static constexpr std::size_t kBlock = std::size_t{32} << 10U;

  void* take_of_new_block(std::size_t size, std::size_t alignment);
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    return take(size, alignment);
  }
  void do_deallocate(void*, std::size_t, std::size_t) override {}
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace rigor::xacro
