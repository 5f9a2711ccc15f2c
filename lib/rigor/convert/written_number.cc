// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/written_number.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/schema/value.h>

namespace rigor::convert {
namespace {

/// No value holds more: a pose with a quaternion.
constexpr std::size_t kMaxWrittenNumbers = 7;

std::vector<std::string_view> words_at(const read::Documents& documents, Span span) {
  std::vector<std::string_view> words;
  if (span.nowhere()) return words;
  constexpr std::string_view kSpace = " \t\r\n";
  std::string_view text = documents.of(span.source).bytes().substr(span.begin, span.size());
  while (words.size() <= kMaxWrittenNumbers) {
    const std::size_t begin = text.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find_first_of(kSpace)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

/// The digits are kept where they are those of the value.
Number with_digits(double value, std::string_view word) {
  const auto parsed = schema::parse_double(word);
  const double* read = std::get_if<double>(&parsed);
  return {value, read != nullptr && *read == value ? std::string(word) : std::string()};
}

Number number_among(const std::vector<std::string_view>& words, std::size_t i, double value) {
  return i < words.size() ? with_digits(value, words[i]) : Number{value, {}};
}

bool has_angles_in_radians(xml::Element pose) {
  const auto format = read::attribute_text(pose, "rotation_format");
  const bool quaternion = format && read::trimmed(format->text) == "quat_xyzw";
  return !quaternion && !bool_field(read::attribute_text(pose, "degrees"), false).value;
}

}  // namespace

Number written_number(const read::Documents& documents, const model::Field<double>& field) {
  return number_among(words_at(documents, field.span), 0, field.value);
}

Number3 written_numbers(const read::Documents& documents,
                        const model::Field<model::Vector3>& field) {
  const auto words = words_at(documents, field.span);
  return {number_among(words, 0, field.value.x), number_among(words, 1, field.value.y),
          number_among(words, 2, field.value.z)};
}

UrdfOrigin written_origin(const read::Documents& documents, const model::PoseField& pose) {
  UrdfOrigin origin = origin_of(pose.pose.value);
  if (!pose.pose.written || pose.site.span.nowhere()) return origin;
  const auto words = words_at(documents, pose.pose.span);
  const model::Vector3& p = pose.pose.value.translation;
  const std::array translation{p.x, p.y, p.z};
  for (std::size_t i = 0; i < 3; ++i) origin.xyz[i] = number_among(words, i, translation[i]);
  if (words.size() != 6 || !has_angles_in_radians(documents.element(pose.site))) return origin;
  Number3 rpy;
  for (std::size_t i = 0; i < rpy.size(); ++i) {
    const auto parsed = schema::parse_double(words[i + 3]);
    const double* angle = std::get_if<double>(&parsed);
    if (angle == nullptr) return origin;  // not the value's own digits: all three or none
    rpy[i] = {*angle, std::string(words[i + 3])};
  }
  origin.rpy = rpy;
  return origin;
}

bool is_identity(const model::Pose& X) {
  const model::Vector3& p = X.translation;
  const model::Quaternion& q = X.rotation;
  const std::array parts{p.x, p.y, p.z, 2 * q.x, 2 * q.y, 2 * q.z};
  return std::all_of(parts.begin(), parts.end(),
                     [](double part) { return std::abs(part) <= kSameFrame; });
}

}  // namespace rigor::convert
