// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/moment_slips.h>
#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_triangle_inequality {

const model::Field<double>* entry(const model::Inertial& inertial, std::string_view name) {
  if (name == "ixx") return &inertial.ixx;
  if (name == "iyy") return &inertial.iyy;
  return name == "izz" ? &inertial.izz : nullptr;
}

// Moments of thin plates, rounded to a few digits, miss by about this share.
constexpr double kRounding = 1e-3;

std::string rounding(const mass::Verdict::Triangle& triangle) {
  if (triangle.largest - triangle.sum > kRounding * triangle.largest) return {};
  return "the difference is small: the numbers may have lost digits by rounding";
}

// Times the sum of the others: what breaks the inequality by less is another slip than a decimal point.
constexpr double kFarOff = 2;

/// The largest moment with its decimal point back in place, when the tensor is a body's then, and one like the shapes.
std::optional<Fix> fix_of_point(const model::Link& link, const mass::Verdict::Triangle& triangle,
                                const model::Field<double>* largest, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (largest == nullptr || triangle.largest < kFarOff * triangle.sum) return std::nullopt;
  for (const double power : {1e-1, 1e-2, 1e-3}) {
    mass::Inertia tensor = mass::tensor(inertial);
    double& entry = largest == &inertial.ixx   ? tensor.ixx
                    : largest == &inertial.iyy ? tensor.iyy
                                               : tensor.izz;
    entry *= power;
    if (entry > triangle.sum) continue;
    if (!mass::judge(inertial.mass.value, tensor).possible()) return std::nullopt;
    const auto share = share_of_solid(link, inertial.mass.value, tensor, context);
    if (share && !plausible(*share)) return std::nullopt;
    const std::string text = times_power_of_ten(largest->value, power);
    return Fix{fmt::format("write {} = {}", triangle.names[2], text),
               Applicability::kUnsafe,
               {{largest->span, text}}};
  }
  return std::nullopt;
}

std::optional<Fix> fix_for(const model::Link& link, const mass::Verdict::Triangle& triangle,
                           const model::Field<double>* largest, Context& context) {
  auto fix = fix_of_point(link, triangle, largest, context);
  return fix ? std::move(fix) : fix_from_shapes(link, context);
}

void check(const model::Link& link, Context& context) {
  if (!has_tensor(link, context)) return;
  const mass::Verdict& verdict = context.verdict(link);
  if (!verdict.tensor_finite || verdict.smallest == mass::Verdict::Sign::kNegative) return;
  const auto& triangle = verdict.triangle;
  if (triangle.holds) return;
  const bool refused = refuses_inertia(link, context);
  if (!refused && !rounding(triangle).empty()) return;
  const model::Field<double>* largest = entry(link.inertial, triangle.names[2]);
  // Of principal moments the smaller ones can be zero but for rounding.
  const double sum = triangle.sum < 1e-12 * triangle.largest ? 0 : triangle.sum;
  const char* what = largest != nullptr ? "" : " (the principal moments)";
  context.report(
      {.where = largest != nullptr ? largest->span : link.inertial.tensor_site.name,
       .message = fmt::format("{} + {} ({:.6g}) < {} ({:.6g}) kg·m²{}: no rigid body has "
                              "this",
                              triangle.names[0], triangle.names[1], sum, triangle.names[2],
                              triangle.largest, what),
       .subject = context.subject(link),
       .help = rounding(triangle),
       .fix = rounding(triangle).empty() ? fix_for(link, triangle, largest, context) : std::nullopt,
       .refused = refused,
       .why = refused ? ""
                      : "MuJoCo rejects the model; libsdformat (Gazebo) adds the link to the one "
                        "that it is fixed to, and their sum is valid.",
       .severity = refused ? std::nullopt : std::optional(Severity::kWarning)});
}

Rule rule() {
  return {
      .name = "inertia-triangle-inequality",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "inertia tensor violates the triangle inequality",
      .why = "libsdformat (Gazebo) and MuJoCo reject the model, libsdformat without naming the "
             "number (error 18); Drake warns and takes a ball of water in its place. For any rigid "
             "body the sum of two moments of inertia is at least the third. In a URDF link that is "
             "fixed to another, whose sum is valid, "
             "libsdformat accepts it: that is a warning. urdfdom does not check it. A difference "
             "of less than 0.1 % "
             "that libsdformat accepts is not reported.",
      .what_to_do = "Compute the tensor again from the mass and the shapes. Where the difference "
                    "is small, write more digits.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_triangle_inequality
