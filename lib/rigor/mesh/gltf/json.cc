// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/gltf/json.h>

#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

namespace rigor::mesh {
namespace {

using Json = nlohmann::json;

/// All copies of an iterator move together, so that the parser's own tells how far it has come.
class SharedPlace {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  explicit SharedPlace(pointer& at) : at_(&at) {}
  reference operator*() const { return **at_; }
  SharedPlace& operator++() {
    ++*at_;
    return *this;
  }
  bool operator==(const SharedPlace& other) const { return *at_ == *other.at_; }
  bool operator!=(const SharedPlace& other) const { return *at_ != *other.at_; }

 private:
  pointer* at_;
};

class ScalarWalk final : public nlohmann::json_sax<Json> {
 public:
  ScalarWalk(std::string_view json, const std::function<void(const JsonScalar&)>& use)
      : begin_(json.data()), at_(begin_), end_(begin_ + json.size()), use_(use) {}

  bool run() {
    return Json::sax_parse(SharedPlace(at_), SharedPlace(end_), this, Json::input_format_t::json,
                           false);
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool number_integer(number_integer_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override { return tell(JsonScalar::Kind::kString, value, 0); }

  bool start_object(std::size_t) override {
    if (++depth_ == 3) item_ = objects_++;
    return true;
  }
  bool start_array(std::size_t) override {
    ++depth_;
    return true;
  }
  bool end_object() override { return end_array(); }
  bool end_array() override {
    --depth_;
    return true;
  }

  bool key(string_t& value) override {
    key_ = value;
    if (depth_ != 1) return true;
    section_ = value;
    objects_ = 0;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

 private:
  bool number(double value) { return tell(JsonScalar::Kind::kNumber, {}, value); }

  bool tell(JsonScalar::Kind kind, std::string_view text, double value) {
    use_(
        {kind, depth_, section_, item_, key_, text, value, static_cast<std::size_t>(at_ - begin_)});
    return true;
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  const std::function<void(const JsonScalar&)>& use_;
  std::uint64_t depth_ = 0;
  std::uint64_t item_ = 0;
  std::uint64_t objects_ = 0;  // of the section's list, so far
  std::string section_;
  std::string key_;
};

}  // namespace

bool for_each_scalar(std::string_view json, const std::function<void(const JsonScalar&)>& use) {
  return ScalarWalk(json, use).run();
}

}  // namespace rigor::mesh
