// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/arena.h>

namespace rigor::xacro {

void* Arena::take_of_new_block(std::size_t size, std::size_t alignment) {
  // What is larger than a block gets one of its own, and the rest of the block at hand stays in use.
  if (size + alignment > kBlock / 4) {
    blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(size + alignment));
    void* begin = blocks_.back().get();
    std::size_t room = size + alignment;
    return std::align(alignment, size, begin, room);
  }
  blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlock));
  next_ = blocks_.back().get();
  left_ = kBlock;
  return take(size, alignment);
}

}  // namespace rigor::xacro
