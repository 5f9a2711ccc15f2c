// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot as bytes, to come out of a worker process; private to the room. Spans, frames and placement
// stay behind. Numbers keep every bit.

#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/robot/robot.h>

namespace rigor::robot {

class ByteWriter {
 public:
  void number(double value) { append(&value, sizeof value); }
  void count(std::size_t value) {
    const std::uint64_t wide = value;
    append(&wide, sizeof wide);
  }
  void text(std::string_view value) {
    count(value.size());
    bytes_ += value;
  }
  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  std::string bytes_;
};

/// Beyond the end everything is zero and empty, and `good` is false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  double number() { return raw<double>(); }
  /// Of things that take a byte each at least: never more than there are bytes left.
  std::size_t count() {
    const auto value = raw<std::uint64_t>();
    if (value > bytes_.size()) good_ = false;
    return good_ ? static_cast<std::size_t>(value) : 0;
  }
  std::string text() {
    const std::size_t size = count();
    const std::string value(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return value;
  }
  bool good() const { return good_; }

 private:
  template <class T>
  T raw() {
    T value{};
    if (bytes_.size() < sizeof value) good_ = false;
    if (!good_) return value;
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  std::string_view bytes_;
  bool good_ = true;
};

void write_robot(ByteWriter& out, const Robot& robot);
/// Nothing when the bytes are not whole.
std::optional<Robot> read_robot(ByteReader& in);

}  // namespace rigor::robot
