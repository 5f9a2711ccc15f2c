// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/placed_units.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::twin_value_differs {

using robot::Side;
using robot::Twins;

// Numbers that agree beside the value that differs: else the two are not made alike.
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
  const std::size_t groups = list.numbers.empty() ? 0 : list.numbers.back().group;
  TwinNumbers more = NumberLister(context).of_link(link);
  for (TwinNumber& number : more) number.group += groups;
  std::move(more.begin(), more.end(), std::back_inserter(list.numbers));
  return list;
}

TwinList numbers_of_link(Context& context, std::uint32_t i) {
  TwinNumbers numbers = NumberLister(context).of_link(context.root().links[i]);
  const std::size_t own = numbers.size();
  return {std::move(numbers), own};
}
TwinList numbers_of_joint(Context& context, std::uint32_t i) {
  TwinNumbers own = NumberLister(context).of_joint(context.root().joints[i]);
  const auto child = context.frames().ends({i}).child;
  if (!child) {
    const std::size_t count = own.size();
    return {std::move(own), count};
  }
  return with_link(std::move(own), context.root()[child], context);
}
TwinList numbers_of_placement(Context& context, std::uint32_t i) {
  const model::Link& link = context.root().links[i];
  return with_link(NumberLister(context).of_placement(link), link, context);
}

/// The one value that two parts have not in common.
struct Odd {
  const TwinNumbers* wrong = nullptr;
  const TwinNumbers* right = nullptr;
  std::size_t begin = 0;  ///< of the value in both
  std::size_t end = 0;
  std::size_t same = 0;       ///< other numbers
  std::size_t confirmed = 0;  ///< other parts that have the right value
  bool first = false;         ///< whether the first of the pair is wrong
  double factor = 0;          ///< of the slip, where it is one
  bool left_out = false;      ///< whether a coordinate is 0 only in the wrong one
  bool by_shapes = false;     ///< whether the shapes, as solids, tell which is wrong

  /// The numbers that differ.
  std::vector<std::size_t> places() const {
    std::vector<std::size_t> result;
    for (std::size_t i = begin; i < end; ++i) {
      if (!same_size((*wrong)[i].value, (*right)[i].value)) result.push_back(i);
    }
    return result;
  }
};

bool has_same_value(const TwinNumbers& a, const TwinNumbers& b, const Odd& odd) {
  if (a.size() != b.size() || !a[odd.begin].is_of_same_kind(b[odd.begin])) return false;
  const ValueDifference found = value_difference(a, b, odd.begin);
  return found.end == odd.end && found.apart <= kSameValue * found.size;
}

/// Whether one of the two is zero and places a shape or link elsewhere than the other by more than any
/// calibration does.
bool is_left_out(const TwinNumber& a, const TwinNumber& b) {
  constexpr double kMin = 0.005;  // m
  const bool places = a.pose != nullptr && a.value_name != "center of mass";
  return places && (a.value == 0 || b.value == 0) &&
         std::max(std::abs(a.value), std::abs(b.value)) > kMin;
}

double largest(const TwinNumbers& numbers, const Odd& odd) {
  double most = 0;
  for (std::size_t i = odd.begin; i < odd.end; ++i)
    most = std::max(most, std::abs(numbers[i].value));
  return most;
}

bool is_moment(const TwinNumber& number) {
  return number.value_name.size() == 3 && number.value_name[1] == number.value_name[2];
}

/// A half turn, or none, about an axis of the body: its moments look the same.
bool is_half_turn(const TwinNumbers& numbers, const Odd& odd) {
  constexpr double kWhole = 0.999;
  return std::any_of(numbers.begin() + static_cast<std::ptrdiff_t>(odd.begin),
                     numbers.begin() + static_cast<std::ptrdiff_t>(odd.end),
                     [](const TwinNumber& part) { return std::abs(part.value) > kWhole; });
}

/// Whether a value tells by itself. Products of inertia are what bolts make of them, only one of two fingers is
/// driven, and what is zero is reported as such.
bool tells(const Odd& odd, const TwinNumbers& a, const TwinNumbers& b) {
  if (is_inertial(a[odd.begin])) return !is_half_turn(a, odd) || !is_half_turn(b, odd);
  const bool place = a[odd.begin].pose != nullptr;
  if (!place && (largest(a, odd) == 0 || largest(b, odd) == 0)) return false;
  if (a[odd.begin].value_name != "ixx") return true;
  for (std::size_t i = odd.begin; i < odd.end; ++i) {
    const double apart = std::abs(a[i].value - b[i].value);
    if (is_moment(a[i]) && apart > kOtherValue * largest(a, odd)) return true;
  }
  return false;
}

/// Which of the two is wrong: the one that others of the family (front and rear, the other fingers) do not
/// confirm; else the one that lacks a coordinate; else the larger.
void decide(Odd& odd, const TwinNumbers& a, const TwinNumbers& b,
            const std::vector<const TwinNumbers*>& others) {
  const auto confirm = [&](const TwinNumbers& numbers) {
    return static_cast<std::size_t>(std::count_if(
        others.begin(), others.end(),
        [&](const TwinNumbers* other) { return has_same_value(*other, numbers, odd); }));
  };
  const std::size_t of_a = confirm(a), of_b = confirm(b);
  odd.wrong = &a;
  odd.right = &b;
  const std::vector<std::size_t> places = odd.places();
  if (places.size() == 1) {
    const TwinNumber& p = a[places.front()];
    const TwinNumber& q = b[places.front()];
    odd.left_out = is_left_out(p, q);
    odd.factor = slip_factor(p.value, q.value).value_or(0);
  }
  odd.first = largest(a, odd) > largest(b, odd);
  if (odd.left_out) odd.first = a[places.front()].value == 0;
  if (of_a != of_b) odd.first = of_a < of_b;
  odd.confirmed = of_a != of_b && std::min(of_a, of_b) == 0 ? std::max(of_a, of_b) : 0;
  if (!odd.first) std::swap(odd.wrong, odd.right);
}

/// How far the tensor is from that of the shapes as solids of the mass: a share of its trace.
std::optional<double> off_shapes(const model::Link& link, Context& context) {
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || !(solid->mass > 0) || !(link.inertial.mass.value > 0)) continue;
    const mass::Inertia tensor =
        mass::rotated(link.inertial.pose.pose.value.rotation, mass::tensor(link.inertial));
    return tensor_mistake::difference(tensor,
                                      mass::with_mass(*solid, link.inertial.mass.value).about_com);
  }
  return std::nullopt;
}

/// Lets the shapes decide about a mass or a tensor that no other part confirms.
void decide_by_shapes(Odd& odd, const model::Link& a, const model::Link& b, Context& context) {
  const std::string_view name = (*odd.wrong)[odd.begin].value_name;
  if (odd.confirmed > 0 || (name != "mass" && name != "ixx")) return;
  const auto of_a = off_shapes(a, context), of_b = off_shapes(b, context);
  constexpr double kFits = 0.2;  // of the trace: a tensor that fits in neither tells nothing
  if (!of_a || !of_b || *of_a == *of_b || std::min(*of_a, *of_b) > kFits) return;
  odd.by_shapes = true;
  if (odd.first != (*of_a > *of_b)) std::swap(odd.wrong, odd.right);
  odd.first = *of_a > *of_b;
}

bool is_slip(const Odd& odd) { return odd.factor != 0 || odd.left_out; }

/// The numbers of the right one with the signs of the wrong one; nothing where a sign is not known.
std::optional<Fix> fix_for(const Odd& odd, const Context& context) {
  if (odd.factor == 0 && odd.confirmed == 0 && !odd.by_shapes) return std::nullopt;
  const std::vector<std::size_t> places = odd.places();
  const TwinNumber& number = (*odd.wrong)[odd.begin];
  // A mass, or a moment, may be too small as well as too large.
  if (odd.confirmed == 0 && !odd.by_shapes && (number.value_name == "mass" || is_moment(number)))
    return std::nullopt;
  model::Vector3 translation;
  if (number.pose) translation = number.pose->pose.value.translation;
  Fix fix{{}, Applicability::kUnsafe, {}};
  for (const std::size_t i : places) {
    const TwinNumber& wrong = (*odd.wrong)[i];
    if (wrong.value == 0 && (*odd.right)[i].value != 0) return std::nullopt;
    const double right = (*odd.right)[i].value;
    const double meant = right == 0 ? 0 : std::copysign(right, wrong.value);
    if (number.pose) {
      translation.*kCoordinates[wrong.coordinate] = meant;
      continue;
    }
    if (wrong.written_at.nowhere()) return std::nullopt;
    const auto written = write::number_in(context.bytes(wrong.written_at));
    if (!written || *written != wrong.value) return std::nullopt;
    const std::string text = write::joined({meant});
    fix.title += (fix.title.empty() ? "write " : ", ") + text;
    fix.edits.push_back({wrong.written_at, text});
  }
  if (number.pose) return translation_fix(*number.pose, translation, context);
  if (fix.edits.empty()) return std::nullopt;
  return fix;
}

std::string value_text(const TwinNumber& number) {
  return fmt::format("{:.6g}{}{}", number.value, *number.unit ? " " : "", number.unit);
}

/// "origin x" of one number, "origin" of two; of a tensor all their names.
std::string name_of(const Odd& odd) {
  const std::vector<std::size_t> places = odd.places();
  const TwinNumber& first = (*odd.wrong)[places.front()];
  if (places.size() == 1) return first.name();
  std::string names;
  for (const std::size_t i : places) {
    const std::string_view name = (*odd.wrong)[i].value_name;
    if (names.ends_with(name)) continue;
    if (!names.empty()) names += ", ";
    names += name;
  }
  return names;
}

std::string message_of(const Odd& odd, const std::string& twin) {
  const std::vector<std::size_t> places = odd.places();
  const TwinNumber& wrong = (*odd.wrong)[places.front()];
  const TwinNumber& right = (*odd.right)[places.front()];
  if (odd.left_out) {
    return fmt::format("{} is {}, and that of its twin '{}' {}", wrong.name(), value_text(wrong),
                       twin, value_text(right));
  }
  if (odd.factor != 0) {
    const bool larger = std::abs(wrong.value) > std::abs(right.value);
    return fmt::format("{} is {}, {:.0f} times {} than that of its twin '{}' ({:.6g})",
                       wrong.name(), value_text(wrong), odd.factor, larger ? "larger" : "smaller",
                       twin, right.value);
  }
  if (places.size() == 1) {
    return fmt::format("{} is {}, and that of its twin '{}' {}", wrong.name(), value_text(wrong),
                       twin, value_text(right));
  }
  std::string now, meant;
  for (const std::size_t i : places) {
    now += fmt::format("{}{:.6g}", now.empty() ? "" : ", ", (*odd.wrong)[i].value);
    meant += fmt::format("{}{:.6g}", meant.empty() ? "" : ", ", (*odd.right)[i].value);
  }
  return fmt::format("{} are {}, and those of its twin '{}' {}", name_of(odd), now, twin, meant);
}

template <class Entity>
class TwinCheck {
 public:
  TwinCheck(const std::vector<Entity>& all, ListOf list, Context& context)
      : all_(all), list_(list), context_(context) {}

  void run() {
    for (const Twins& pair : pairs()) check(pair, 0);
    for (const auto& [name, members] : numbered_families()) {
      // Two in a row are alike by chance; what all others have is what was meant.
      constexpr std::size_t kFewest = 2;
      for (std::size_t i = 1; i < members.size(); ++i) check({members[i - 1], members[i]}, kFewest);
    }
  }

 private:
  static bool is_where_it_stands(const TwinNumber& number) {
    return number.value_name == "origin" || number.value_name == "pose";
  }

  /// The link itself, or the child of the joint; of a joint without one the first.
  std::uint32_t link_of(std::uint32_t i) const {
    if constexpr (std::is_same_v<Entity, model::Link>) {
      return i;
    } else {
      const auto child = context_.frames().ends({i}).child;
      return child ? child.value : 0;
    }
  }

  const std::vector<Twins>& pairs() const {
    if constexpr (std::is_same_v<Entity, model::Link>) {
      return context_.assembled().link_twins;
    } else {
      return context_.assembled().joint_twins;
    }
  }

  using Families = std::map<std::pair<std::uint32_t, std::string>, std::vector<std::uint32_t>>;

  static constexpr std::size_t kSmallestFamily = 3;
  // A larger one is a chain, or scenery.
  static constexpr std::size_t kLargestFamily = 32;

  std::pair<std::uint32_t, std::string> family_of(std::uint32_t i) const {
    return {all_[i].model.value, robot::family_name(all_[i].name.value)};
  }

  const Families& families() {
    if (std::exchange(families_known_, true)) return families_;
    const model::Root& root = context_.root();
    for (const model::Model& model : root.models) {
      const auto& members = members_of<Entity>(model);
      if (members.size() < kSmallestFamily) continue;
      for (const auto id : members) {
        if (root.own(all_[id.value].site)) families_[family_of(id.value)].push_back(id.value);
      }
    }
    std::erase_if(families_, [](const auto& one) {
      return one.second.size() < kSmallestFamily || one.second.size() > kLargestFamily;
    });
    return families_;
  }

  /// Those that only numbers distinguish.
  Families numbered_families() {
    Families result;
    if (!any_number()) return result;
    for (const auto& [name, members] : families()) {
      if (name.second.find('*') == std::string::npos) result.emplace(name, members);
    }
    return result;
  }

  bool any_number() const {
    const auto has_digit = [](const Entity& one) {
      return one.name.value.find_first_of("0123456789") != std::string::npos;
    };
    return std::count_if(all_.begin(), all_.end(), has_digit) >=
           static_cast<std::ptrdiff_t>(kSmallestFamily);
  }

  const TwinList& numbers_of(std::uint32_t i) {
    const auto found = lists_.find(i);
    return found != lists_.end() ? found->second
                                 : lists_.emplace(i, list_(context_, i)).first->second;
  }

  void check(const Twins& pair, std::size_t least_confirmed) {
    const TwinList& a = numbers_of(pair.a);
    const TwinList& b = numbers_of(pair.b);
    const auto found = difference_of(a.numbers, b.numbers);
    if (!found || found->begins.size() != 1 || found->same < kAgreeing) return;
    Odd odd;
    odd.begin = found->begins.front();
    if (odd.begin >= a.own) return;
    odd.end = value_difference(a.numbers, b.numbers, odd.begin).end;
    if (!tells(odd, a.numbers, b.numbers)) return;
    odd.same = found->same;
    std::vector<const TwinNumbers*> others;
    const auto family = families().find(family_of(pair.a));
    if (family != families().end()) {
      for (const std::uint32_t i : family->second) {
        if (i != pair.a && i != pair.b) others.push_back(&numbers_of(i).numbers);
      }
    }
    decide(odd, a.numbers, b.numbers, others);
    if constexpr (std::is_same_v<Entity, model::Link>) {
      const bool bodies =
          context_.verdict(all_[pair.a]).possible() && context_.verdict(all_[pair.b]).possible();
      if (a.numbers[odd.begin].value_name == "ixx" && !bodies) return;  // reported of that tensor
      decide_by_shapes(odd, all_[pair.a], all_[pair.b], context_);
    }
    if (odd.confirmed < least_confirmed || odd.places().empty()) return;
    if (is_where_it_stands(a.numbers[odd.begin]) &&
        (may_be_anywhere(link_of(pair.a), link_of(pair.b), context_) || is_place_taken(pair, odd)))
      return;
    // A thumb is no finger: what only numbers tell apart may differ by intent.
    const bool meant = least_confirmed > 0 && !is_slip(odd);
    report(odd, odd.first ? pair.a : pair.b, odd.first ? pair.b : pair.a,
           meant ? Severity::kInfo : Severity::kWarning);
  }

  /// Of a joint, on which its origin counts; 0 for links, whose poses count in their model.
  std::uint32_t parent_of(std::uint32_t i) const {
    if constexpr (std::is_same_v<Entity, model::Link>) {
      return 0;
    } else {
      return context_.frames().ends({i}).parent.value;
    }
  }

  /// Whether one number of a value has the other sign, and all have the same size.
  static bool is_mirror_image(const TwinNumbers& a, const TwinNumbers& b, const Odd& odd) {
    if (b.size() < odd.end) return false;
    std::size_t signs = 0;
    for (std::size_t k = odd.begin; k < odd.end; ++k) {
      if (!a[k].is_of_same_kind(b[k]) || !same_size(a[k].value, b[k].value)) return false;
      signs += !same_size(a[k].value - b[k].value, 0);
    }
    return signs == 1;
  }

  /// Whether a part of another family is at the mirror image of the place of one of the two. Then parts in a row are
  /// counted from one side, as sensors along a bumper: left and front_left, front_right and right.
  bool is_place_taken(const Twins& pair, const Odd& odd) {
    for (std::uint32_t i = 0; i < all_.size(); ++i) {
      if (i == pair.a || i == pair.b || all_[i].model != all_[pair.a].model) continue;
      if (parent_of(i) != parent_of(pair.a) || family_of(i) == family_of(pair.a)) continue;
      const TwinNumbers& other = numbers_of(i).numbers;
      if (is_mirror_image(*odd.wrong, other, odd) || is_mirror_image(*odd.right, other, odd))
        return true;
    }
    return false;
  }

  void report(const Odd& odd, std::uint32_t wrong_index, std::uint32_t right_index,
              Severity severity) {
    if (!reported_.insert(wrong_index).second) return;
    const std::size_t i = odd.places().front();
    const Span at = place_of_number((*odd.wrong)[i], context_);
    const Span at_twin = place_of_number((*odd.right)[i], context_);
    const Entity& entity = all_[wrong_index];
    const Entity& twin = all_[right_index];
    std::string help = fmt::format("their {} other numbers are the same but for signs", odd.same);
    if (odd.confirmed > 0) help += fmt::format(", and {} more have the twin's", odd.confirmed);
    context_.report({.where = at.nowhere() ? entity.site.name : at,
                     .message = message_of(odd, twin.name.value),
                     .subject = context_.subject(entity),
                     .related = {{at_twin.nowhere() ? twin.site.name : at_twin, "its twin's"}},
                     .help = std::move(help),
                     .fix = fix_for(odd, context_),
                     .severity = severity});
  }

  const std::vector<Entity>& all_;
  ListOf list_;
  Context& context_;
  Families families_;
  bool families_known_ = false;
  std::map<std::uint32_t, TwinList> lists_;
  std::set<std::uint32_t> reported_;
};

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 3 || !context.frames().problems().empty()) return;
  TwinCheck(root.links, numbers_of_link, context).run();
  TwinCheck(root.joints, numbers_of_joint, context).run();
  if (context.is_sdf()) TwinCheck(root.links, numbers_of_placement, context).run();
}

Rule rule() {
  return {
      .name = "twin-value-differs",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one value of two parts that are made alike differs",
      .why = "The robot is lopsided: it leans, pulls to one side, or one leg is weaker than the "
             "other. Left and right, or the fingers of a hand by their numbers, have the same "
             "mass, moments, origins, sizes and limits but for signs, except this value. Of two "
             "parts the finding is at the one that others of that name do not confirm, else at "
             "the larger number. Of parts that only have other numbers it is an info, unless a "
             "decimal point slipped.",
      .what_to_do = "Write the same numbers in both.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::twin_value_differs
