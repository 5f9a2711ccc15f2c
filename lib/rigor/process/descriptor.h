// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file descriptor that is closed when nobody needs it any more.
//
//   std::array<int, 2> ends;
//   if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
//   const Descriptor reading(ends[0]);
//   const Descriptor writing(ends[1]);

#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace rigor::process {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      close();
      number_ = std::exchange(other.number_, -1);
    }
    return *this;
  }

  /// Negative when there is none.
  int number() const { return number_; }
  /// Zero, or the error's number: some file systems say only here that a write failed.
  int close() {
    const int number = std::exchange(number_, -1);
    return number >= 0 && ::close(number) != 0 ? errno : 0;
  }

 private:
  int number_;
};

}  // namespace rigor::process
