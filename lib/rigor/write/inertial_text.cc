// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/inertial_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <rigor/schema/value.h>

namespace rigor::write {
namespace {

using mass::Inertia;
using mass::MassProperties;

double rounded_to_digits(double value, int digits) {
  std::array<char, 32> buffer;  // sign, 17 digits, point, exponent
  char* const begin = buffer.data();
  const auto written =
      std::to_chars(begin, begin + buffer.size(), value, std::chars_format::scientific, digits - 1);
  std::from_chars(begin, written.ptr, value);
  return value + 0.0;  // of -0 this makes 0
}

Inertia rounded_to_digits(const Inertia& i, int digits) {
  return {rounded_to_digits(i.ixx, digits), rounded_to_digits(i.ixy, digits),
          rounded_to_digits(i.ixz, digits), rounded_to_digits(i.iyy, digits),
          rounded_to_digits(i.iyz, digits), rounded_to_digits(i.izz, digits)};
}

/// How far the two smaller principal moments exceed the largest, kg·m²: below zero no body has them,
/// and a negative moment makes it so too.
double margin(const Inertia& inertia) {
  const auto [small, middle, large] = mass::principal_moments(inertia);
  return small + middle - large;
}

/// With the fewest digits that take nothing from the body: where rounding leaves a margin, it is one
/// that libsdformat takes as well, whose tolerance is that of the last bits.
Inertia rounded_to_digits(const Inertia& exact) {
  const double needed = std::min(margin(exact), 0.0);
  for (int digits = kDigits; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    const Inertia candidate = rounded_to_digits(exact, digits);
    if (margin(candidate) >= needed) return candidate;
  }
  return rounded_to_digits(exact, std::numeric_limits<double>::max_digits10);
}

double without_noise(double value, double scale) {
  return std::abs(value) < kNoise * scale ? 0 : value;
}

Inertia without_noise(Inertia inertia) {
  const double scale = trace(inertia);
  for (double* product : {&inertia.ixy, &inertia.ixz, &inertia.iyz}) {
    *product = without_noise(*product, scale);
  }
  // A rod's own moment is zero; what noise leaves of it may be kept, but not below zero.
  for (double* moment : {&inertia.ixx, &inertia.iyy, &inertia.izz}) {
    if (*moment < 0) *moment = without_noise(*moment, scale);
  }
  return inertia;
}

/// How far a body reaches from the origin, m: its center of mass and its radius of gyration.
double size_of(const MassProperties& body) {
  const double gyration = body.mass > 0 ? std::sqrt(trace(body.about_com) / 2 / body.mass) : 0;
  return length(body.com) + gyration;
}

std::string joined_texts(const std::array<std::string, 3>& parts) {
  return parts[0] + ' ' + parts[1] + ' ' + parts[2];
}

std::string sdf(const InertialNumbers& numbers, std::string_view rotation) {
  std::string text = "<inertial>\n";
  if (!numbers.com_is_zero() || !rotation.empty()) {
    text += "  <pose>" + joined_texts(numbers.com) + ' ';
    text.append(rotation.empty() ? "0 0 0" : rotation).append("</pose>\n");
  }
  text += "  <mass>" + numbers.mass + "</mass>\n  <inertia>\n";
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    text.append("    <").append(kEntries[i]).append(">").append(numbers.inertia[i]);
    text.append("</").append(kEntries[i]).append(">\n");
  }
  return text + "  </inertia>\n</inertial>";
}

std::string urdf(const InertialNumbers& numbers, std::string_view rotation) {
  std::string text = "<inertial>\n";
  if (!numbers.com_is_zero() || !rotation.empty()) {
    text += "  <origin xyz=\"" + joined_texts(numbers.com) + "\" rpy=\"";
    text.append(rotation.empty() ? "0 0 0" : rotation).append("\"/>\n");
  }
  text += "  <mass value=\"" + numbers.mass + "\"/>\n  <inertia";
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    text.append(" ").append(kEntries[i]).append("=\"").append(numbers.inertia[i]).append("\"");
  }
  return text + "/>\n</inertial>";
}

std::string mjcf(const InertialNumbers& numbers) {
  const auto& [ixx, ixy, ixz, iyy, iyz, izz] = numbers.inertia;
  return "<inertial pos=\"" + joined_texts(numbers.com) + "\" mass=\"" + numbers.mass +
         "\" fullinertia=\"" + joined_texts({ixx, iyy, izz}) + ' ' + joined_texts({ixy, ixz, iyz}) +
         "\"/>";
}

}  // namespace

MassProperties rounded(const MassProperties& body) {
  const double size = size_of(body);
  const auto coordinate = [size](double value) {
    return rounded_to_digits(without_noise(value, size), kDigits);
  };
  return {rounded_to_digits(body.mass, kDigits),
          {coordinate(body.com.x), coordinate(body.com.y), coordinate(body.com.z)},
          rounded_to_digits(without_noise(body.about_com))};
}

InertialNumbers inertial_numbers(const MassProperties& body) {
  using schema::to_shortest;
  const auto& [mass, com, i] = rounded(body);
  return {to_shortest(mass),
          {to_shortest(com.x), to_shortest(com.y), to_shortest(com.z)},
          {to_shortest(i.ixx), to_shortest(i.ixy), to_shortest(i.ixz), to_shortest(i.iyy),
           to_shortest(i.iyz), to_shortest(i.izz)}};
}

std::string inertial_text(const MassProperties& body, BlockFormat format,
                          std::string_view rotation) {
  const InertialNumbers numbers = inertial_numbers(body);
  switch (format) {
    case BlockFormat::kSdf: return sdf(numbers, rotation);
    case BlockFormat::kUrdf: return urdf(numbers, rotation);
    case BlockFormat::kMjcf: break;
  }
  return mjcf(numbers);
}

}  // namespace rigor::write
