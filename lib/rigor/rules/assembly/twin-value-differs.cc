// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::twin_value_differs {

using robot::Side;
using robot::Twins;

// Numbers that agree for each one that differs: else the two are not made alike.
constexpr std::size_t kAgreeing = 4;

/// The numbers of a part, and behind them those of the link that it places, which must agree as well.
struct TwinList {
  TwinNumbers numbers;
  std::size_t own = 0;
};

using ListOf = TwinList (*)(Context&, std::uint32_t);

TwinList with_link(TwinNumbers own, const model::Link& link, const Context& context) {
  TwinList list{std::move(own), 0};
  list.own = list.numbers.size();
  TwinNumbers more = NumberLister(context).of_link(link);
  std::move(more.begin(), more.end(), std::back_inserter(list.numbers));
  return list;
}

TwinList numbers_of_link(Context& context, std::uint32_t i) {
  TwinNumbers numbers = NumberLister(context).of_link(context.root().links[i]);
  return {numbers, numbers.size()};
}
TwinList numbers_of_joint(Context& context, std::uint32_t i) {
  TwinNumbers own = NumberLister(context).of_joint(context.root().joints[i]);
  const auto child = context.frames().ends({i}).child;
  if (!child) return {own, own.size()};
  return with_link(std::move(own), context.root()[child], context);
}
TwinList numbers_of_placement(Context& context, std::uint32_t i) {
  const model::Link& link = context.root().links[i];
  return with_link(NumberLister(context).of_placement(link), link, context);
}

/// Of the two, the one that a third and fourth part (front and rear) do not confirm; else the larger.
bool first_is_wrong(double a, double b, const std::vector<double>& others) {
  const auto confirmed = [&](double value) {
    return std::count_if(others.begin(), others.end(),
                         [value](double other) { return same_size(other, value); });
  };
  const auto of_a = confirmed(a), of_b = confirmed(b);
  if (of_a != of_b) return of_a < of_b;
  return std::abs(a) > std::abs(b);
}

/// A pair whose numbers are the same but for one, or for those of one vector.
struct Odd {
  TwinNumber wrong;
  TwinNumber right;
  double factor = 0;  ///< zero where the wrong one was left out
};

/// Whether one of the two is zero and places a shape or link elsewhere than the other by more than any
/// calibration does.
bool is_left_out(const TwinNumber& a, const TwinNumber& b) {
  constexpr double kMin = 0.005;  // m
  const bool places = a.pose != nullptr && a.name.find("mass") == std::string::npos;
  return places && (a.value == 0 || b.value == 0) &&
         std::max(std::abs(a.value), std::abs(b.value)) > kMin;
}

std::optional<Odd> odd_one(const TwinNumbers& a, const TwinNumbers& b,
                           const std::vector<TwinNumbers>& others) {
  const auto found = difference_of(a, b);
  if (!found || found->different.size() != 1) return std::nullopt;
  const std::size_t i = found->different.front();
  const auto factor = slip_factor(a[i].value, b[i].value);
  if (found->same < kAgreeing) return std::nullopt;
  if (is_left_out(a[i], b[i])) return a[i].value == 0 ? Odd{a[i], b[i], 0} : Odd{b[i], a[i], 0};
  if (!factor) return std::nullopt;
  std::vector<double> third;
  for (const TwinNumbers& other : others) {
    if (other.size() == a.size() && other[i].name == a[i].name) third.push_back(other[i].value);
  }
  const bool first = first_is_wrong(a[i].value, b[i].value, third);
  return Odd{first ? a[i] : b[i], first ? b[i] : a[i], *factor};
}

std::optional<Fix> fix_for(const Odd& odd, const Context& context) {
  if (odd.factor == 0) return std::nullopt;  // nobody knows its sign
  const bool larger = std::abs(odd.wrong.value) > std::abs(odd.right.value);
  const double meant =
      write::settled(larger ? odd.wrong.value / odd.factor : odd.wrong.value * odd.factor,
                     odd.wrong.value, odd.right.value);
  if (odd.wrong.pose) {
    model::Vector3 value = odd.wrong.pose->pose.value.translation;
    value.*kCoordinates[odd.wrong.coordinate] = meant;
    return translation_fix(*odd.wrong.pose, value, context);
  }
  if (odd.wrong.span.nowhere()) return std::nullopt;
  const auto number = write::number_in(context.bytes(odd.wrong.span));
  if (!number || *number != odd.wrong.value) return std::nullopt;
  const std::string text = write::joined({meant});
  return Fix{"write " + text, Applicability::kUnsafe, {{odd.wrong.span, text}}};
}

std::string message_of(const Odd& odd, const std::string& twin) {
  const std::string_view blank = *odd.wrong.unit ? " " : "";
  if (odd.factor == 0) {
    return fmt::format("{} is 0, and that of its twin '{}' {:.6g}{}{}", odd.wrong.name, twin,
                       odd.right.value, blank, odd.right.unit);
  }
  const bool larger = std::abs(odd.wrong.value) > std::abs(odd.right.value);
  return fmt::format("{} is {:.6g}{}{}, {:.0f} times {} than that of its twin '{}' ({:.6g})",
                     odd.wrong.name, odd.wrong.value, blank, odd.wrong.unit, odd.factor,
                     larger ? "larger" : "smaller", twin, odd.right.value);
}

template <class Entity>
void check_twins(const std::vector<Entity>& all, ListOf list, Context& context) {
  const model::Root& root = context.root();
  std::vector<Twins> along;
  bool along_known = false;
  for (const Twins& pair : twins_of(all, Side::kAcross, root)) {
    const auto [a, own] = list(context, pair.a);
    const TwinNumbers b = list(context, pair.b).numbers;
    const auto found = difference_of(a, b);
    if (!found || found->different.size() != 1 || found->different.front() >= own) continue;
    if (!std::exchange(along_known, true)) along = twins_of(all, Side::kAlong, root);
    std::vector<TwinNumbers> others;
    for (const Twins& other : along) {
      if (other.a == pair.a || other.a == pair.b) others.push_back(list(context, other.b).numbers);
      if (other.b == pair.a || other.b == pair.b) others.push_back(list(context, other.a).numbers);
    }
    const auto odd = odd_one(a, b, others);
    if (!odd) continue;
    const std::size_t i = found->different.front();
    const bool first = odd->wrong.value == a[i].value;
    const Entity& wrong = all[first ? pair.a : pair.b];
    const Entity& right = all[first ? pair.b : pair.a];
    Finding finding{
        .where = odd->wrong.span.nowhere() ? wrong.site.name : odd->wrong.span,
        .message = message_of(*odd, right.name.value),
        .subject = context.subject(wrong),
        .related = {{odd->right.span.nowhere() ? right.site.name : odd->right.span, "its twin's"}},
        .help = "all their other numbers are the same but for signs",
        .fix = fix_for(*odd, context)};
    context.report(std::move(finding));
  }
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 3) return;
  check_twins(root.links, numbers_of_link, context);
  check_twins(root.joints, numbers_of_joint, context);
  if (context.is_sdf()) check_twins(root.links, numbers_of_placement, context);
}

Rule rule() {
  return {
      .name = "twin-value-differs",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one number of two mirrored parts differs by a power of ten, or was left out",
      .why = "The robot is lopsided: it leans, pulls to one side, or one leg is weaker than the "
             "other. Left and right have the same numbers but for signs, except this one, which "
             "is 10, 100 or 1000 times as large: a decimal point slipped, or a unit. Of two parts "
             "the finding is at the one that others (front and rear) do not confirm, else at the "
             "larger number.",
      .what_to_do = "Write the same number in both.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::twin_value_differs
