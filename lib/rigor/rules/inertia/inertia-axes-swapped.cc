// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/siblings.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_axes_swapped {

using Moments = std::array<const model::Field<double>*, 3>;

Fix put_where_they_belong(const Moments& moments, const std::array<std::size_t, 3>& belongs,
                          const Context& context) {
  Fix fix{"write each moment at its own axis", Applicability::kUnsafe, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (belongs[k] == k) continue;
    fix.edits.push_back({moments[belongs[k]]->span, std::string(context.bytes(moments[k]->span))});
  }
  return fix;
}

using Order = std::array<std::size_t, 3>;

/// How unevenly the mass is spread in the box around the shapes: along each axis root mean square, as a share of
/// the side, and of these the largest by the smallest. A solid box has 1.
double unevenness(const std::array<double, 3>& moments, const std::array<double, 3>& sides) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = (moments[(k + 1) % 3] + moments[(k + 2) % 3] - moments[k]) / 2;
    const double share = std::sqrt(std::max(0.0, along)) / sides[k];
    least = std::min(least, share);
    most = std::max(most, share);
  }
  return most / least;
}

struct BoxOrder {
  Order order{};
  double before = 0;  ///< unevenness
  double after = 0;
};

// What is more uneven is a warning: other bodies than slips have, too, half as much.
constexpr double kClearly = 8;

/// By the box around shapes that are no solids, such as open meshes: the moments fit it badly, and well at other
/// axes.
std::optional<BoxOrder> order_by_box(const model::Link& link, Context& context) {
  constexpr double kBad = 3.5;
  constexpr double kGood = 1.6;
  const model::Inertial& inertial = link.inertial;
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return std::nullopt;
  if (!(inertial.mass.value > 0) || !context.verdict(link).possible()) return std::nullopt;
  if (tensor_mistake::has_products(mass::tensor(inertial))) return std::nullopt;
  const std::array<double, 3> moments{inertial.ixx.value, inertial.iyy.value, inertial.izz.value};
  const auto [low, high] = std::minmax_element(moments.begin(), moments.end());
  constexpr double kAlike = 1.3;  // then it matters little where they are
  if (*high < kAlike * *low) return std::nullopt;
  Outline outline(link, context);
  if (!outline.add_collisions(link) || (outline.empty() && !outline.add_visuals(link)) ||
      outline.empty())
    return std::nullopt;
  const auto along = [&](const model::Vector3& axis_C) {
    return outline.extent(model::rotate(inertial.pose.pose.value.rotation, axis_C));
  };
  const std::array<double, 3> sides{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
  if (!(std::min({sides[0], sides[1], sides[2]}) > 0)) return std::nullopt;
  const double before = unevenness(moments, sides);
  if (before < kBad) return std::nullopt;
  // Two exchanged; three in a ring are nobody's slip.
  constexpr std::array<Order, 3> kOrders{{{1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  for (const Order& order : kOrders) {
    const std::array<double, 3> exchanged{moments[order[0]], moments[order[1]], moments[order[2]]};
    const double after = unevenness(exchanged, sides);
    if (after < kGood) return BoxOrder{order, before, after};
  }
  return std::nullopt;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (inertial.ixx.value == inertial.iyy.value && inertial.iyy.value == inertial.izz.value) return;
  MistakenTensor found = mistaken_tensor(link, context);
  std::optional<BoxOrder> by_box;
  if (found.mistake == TensorMistake::kNone) {
    by_box = order_by_box(link, context);
    if (by_box) found = {TensorMistake::kAxesSwapped, by_box->order};
  }
  if (found.mistake != TensorMistake::kAxesSwapped) return;
  const Moments moments{&inertial.ixx, &inertial.iyy, &inertial.izz};
  std::array<double, 3> right{};
  for (std::size_t k = 0; k < 3; ++k) right[found.belongs[k]] = moments[k]->value;
  context.report(
      {.where = inertial.tensor_site.name,
       .message =
           fmt::format("ixx, iyy and izz are {:.4g}, {:.4g} and {:.4g} kg·m², but fit {} only "
                       "as {:.4g}, {:.4g} and {:.4g}: they are at the wrong axes",
                       moments[0]->value, moments[1]->value, moments[2]->value,
                       by_box ? "the box around the link's shapes" : "the link's shapes", right[0],
                       right[1], right[2]),
       .subject = context.subject(link),
       .help = by_box ? fmt::format("as they are, the mass is spread {:.1f} times as unevenly as "
                                    "in a solid box, and {:.1f} times at the other axes",
                                    by_box->before, by_box->after)
                      : "",
       .fix = put_where_they_belong(moments, found.belongs, context),
       .severity =
           by_box && by_box->before < kClearly ? std::optional(Severity::kInfo) : std::nullopt});
}

/// Two moments exchanged between links that have the same mass and moments: their axes; nothing when they are the
/// same, or otherwise another.
std::optional<Order> exchange_between(const model::Inertial& a, const model::Inertial& b) {
  constexpr double kDigits = 1e-5;
  const auto same = [](double p, double q) {
    return std::abs(p - q) <= kDigits * std::max(std::abs(p), std::abs(q));
  };
  if (!same(a.mass.value, b.mass.value)) return std::nullopt;
  const std::array<double, 3> p{a.ixx.value, a.iyy.value, a.izz.value};
  const std::array<double, 3> q{b.ixx.value, b.iyy.value, b.izz.value};
  for (const Order& order : {Order{0, 1, 2}, Order{1, 0, 2}, Order{0, 2, 1}, Order{2, 1, 0}}) {
    if (same(p[0], q[order[0]]) && same(p[1], q[order[1]]) && same(p[2], q[order[2]])) return order;
  }
  return std::nullopt;
}

/// One of several like parts, by their names, that has the moments of the others at other axes.
void look_at_group(const std::vector<std::uint32_t>& group, Context& context) {
  constexpr std::size_t kFewestOthers = 2;
  constexpr std::size_t kMost = 30;  // a larger one is a table of parts
  const model::Root& root = context.root();
  if (group.size() > kMost) return;
  for (const std::uint32_t one : group) {
    const model::Inertial& inertial = root.links[one].inertial;
    std::vector<std::uint32_t> others;
    std::optional<Order> order;
    for (const std::uint32_t other : group) {
      if (other == one) continue;
      const auto found = exchange_between(inertial, root.links[other].inertial);
      if (!found || (order && *found != *order)) {
        others.clear();
        break;
      }
      order = found;
      others.push_back(other);
    }
    if (others.size() < kFewestOthers || *order == Order{0, 1, 2}) continue;
    const model::Link& link = root.links[one];
    if (mistaken_tensor(link, context).mistake == TensorMistake::kAxesSwapped) continue;
    const Moments moments{&inertial.ixx, &inertial.iyy, &inertial.izz};
    context.report(
        {.where = inertial.tensor_site.name,
         .message = fmt::format("ixx, iyy and izz ({:.4g}, {:.4g} and {:.4g} kg·m²) are at other "
                                "axes than in {} parts of the same kind, '{}' and others",
                                moments[0]->value, moments[1]->value, moments[2]->value,
                                others.size(), root.links[others.front()].name.value),
         .subject = context.subject(link),
         .related = {{root.links[others.front()].inertial.tensor_site.name, "as in the others"}},
         .fix = put_where_they_belong(moments, *order, context)});
  }
}

void check_siblings(const model::Root& root, Context& context) {
  constexpr std::size_t kFewest = 3;
  constexpr double kAlike = 1.3;
  for (const model::Model& model : root.models) {
    std::vector<std::uint32_t> links;
    std::vector<std::string> names;
    bool differ = false;
    for (const auto id : model.links) {
      const model::Inertial& inertial = root[id].inertial;
      const auto [low, high] =
          std::minmax({inertial.ixx.value, inertial.iyy.value, inertial.izz.value});
      if (!(low > 0) || high < kAlike * low || !root.own(root[id].site)) continue;
      links.push_back(id.value);
    }
    const auto key = [&](std::uint32_t i) {
      const model::Inertial& inertial = root.links[i].inertial;
      return std::pair(inertial.mass.value,
                       inertial.ixx.value + inertial.iyy.value + inertial.izz.value);
    };
    std::vector<std::uint32_t> alike = links;
    std::sort(alike.begin(), alike.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < alike.size() && !differ; ++i) {
      const auto order =
          exchange_between(root.links[alike[i - 1]].inertial, root.links[alike[i]].inertial);
      differ = order && *order != Order{0, 1, 2};
    }
    if (links.size() < kFewest || !differ) continue;
    for (const std::uint32_t i : links) names.push_back(root.links[i].name.value);
    for (std::vector<std::uint32_t> group : robot::siblings(names)) {
      if (group.size() < kFewest) continue;
      for (std::uint32_t& i : group) i = links[i];
      look_at_group(group, context);
    }
  }
}

Rule rule() {
  return {
      .name = "inertia-axes-swapped",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "moments of inertia are swapped between axes",
      .why =
          "The link rotates about each axis with the moment of another one. Formulas for a "
          "cylinder or a box assume its length along one axis; when the shape is rotated, or "
          "the formula has other axes, the moments must be permuted. Of shapes that are no solids "
          "the box around them is compared, and like parts (rotor_0, rotor_1, …) with each other.",
      .what_to_do = "Exchange the moments.",
      .checks = {on<model::Link>(check), on<model::Root>(check_siblings)},
  };
}

}  // namespace rigor::rules::inertia_axes_swapped
