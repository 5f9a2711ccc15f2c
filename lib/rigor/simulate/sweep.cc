// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/sweep.h>

#include <charconv>
#include <cmath>

namespace rigor::simulate {
namespace {

/// The shortest text that reads back as the same number.
std::string sweep_number(double value) {
  std::array<char, 32> text;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

double value_at(const GridAxis& axis, std::size_t i) {
  if (axis.count < 2) return axis.from;
  const double last = axis.count - 1;
  const double at = static_cast<double>(i);
  return (axis.from * (last - at) + axis.to * at) /
         last;  // 0.6 between 0.2 and 1, not 0.6000000000000001
}

void set_friction(Scene& scene, double mu) {
  for (SceneShape& shape : scene.shapes) shape.surface.mu = shape.surface.mu2 = mu;
}

void scale_mass(Scene& scene, double factor) {
  for (SceneBody& body : scene.bodies) {
    body.mass.mass *= factor;
    body.mass.about_com = factor * body.mass.about_com;
  }
}

void set_gravity(Scene& scene, double size) {
  const double now = model::length(scene.gravity);
  scene.gravity = now > 0 ? size / now * scene.gravity : Vector3{0, 0, -size};
}

}  // namespace

std::vector<Case> cases_of(const std::vector<GridAxis>& grid, const Seeds& seeds) {
  std::size_t total = seeds.count;
  for (const GridAxis& axis : grid) {
    if (axis.count == 0 || total > kMaxCases / axis.count) return {};
    total *= axis.count;
  }
  std::vector<Case> cases(total);
  for (std::size_t index = 0; index < total; ++index) {
    Case& one = cases[index];
    one.index = index;
    std::size_t rest = index;
    one.seed = seeds.first + rest % seeds.count;
    rest /= seeds.count;
    one.values.resize(grid.size());
    for (std::size_t a = grid.size(); a-- > 0; rest /= grid[a].count) {
      one.values[a] = {grid[a].parameter, value_at(grid[a], rest % grid[a].count)};
    }
    for (const auto& [name, value] : one.values) one.id += name + '=' + sweep_number(value) + ' ';
    one.id += "seed=" + std::to_string(one.seed);
  }
  return cases;
}

void vary(Scene& scene, const Case& one) {
  for (const auto& [name, value] : one.values) {
    if (name == "friction") set_friction(scene, value);
    if (name == "mass") scale_mass(scene, value);
    if (name == "inertia") {
      for (SceneBody& body : scene.bodies) body.mass.about_com = value * body.mass.about_com;
    }
    if (name == "gravity") set_gravity(scene, value);
    if (name == "time-step") scene.solver.step = value;
  }
  scene.solver.cfm = std::min(scene.solver.cfm, softest_cfm(scene));
  scene.solver.seed = one.seed;
}

std::string bad_value(std::string_view parameter, double value) {
  if (!std::isfinite(value)) return "must be a finite number";
  const bool may_be_zero = parameter == "friction" || parameter == "gravity";
  if (value < 0 || (value == 0 && !may_be_zero)) {
    return may_be_zero ? "must not be negative" : "must be above zero";
  }
  return {};
}

}  // namespace rigor::simulate
