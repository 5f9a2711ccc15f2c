// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/oriented_box.h>
#include <rigor/robot/assembled/siblings.h>
#include <rigor/rules/assembly/placed_units.h>
#include <rigor/rules/assembly/sibling_fields.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sibling_value_differs {

using Fields = std::vector<SiblingField>;

// Fields that are not all zero and agree: else the parts are not made alike.
constexpr std::size_t kAgreeing = 3;
constexpr std::size_t kAgreeingSides =
    2;  // of a left and a right part, whose names say that they are

// Parts that agree with each other: one may be alike by chance, and so may two.
constexpr std::size_t kFewest = 2;
constexpr std::size_t kMany = 3;

// A larger group is a table of parts; each is compared with all others.
constexpr std::size_t kMaxMembers = 30;

bool is_empty(const SiblingField& field) {
  return std::all_of(field.values.begin(), field.values.end(),
                     [](double value) { return value == 0 || std::isinf(value); });
}

bool is_place(const SiblingField& field) {
  return field.part.empty() && (field.name == "origin" || field.name == "pose");
}

std::string name_of(const SiblingField& field) {
  return field.part.empty() ? std::string(field.name)
                            : fmt::format("{} {}", field.part, field.name);
}

struct Comparison {
  std::size_t agreeing = 0;
  std::size_t differing = 0;  ///< fields, but for where they are; counted up to two
  std::size_t different = 0;  ///< the last of them
  bool same_place = true;
};

std::optional<Comparison> compared_fields(const Fields& a, const Fields& b) {
  if (a.size() != b.size()) return std::nullopt;
  Comparison result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same_text(a[i].name, b[i].name) || !same_text(a[i].part, b[i].part)) return std::nullopt;
    if (same_field(a[i], b[i])) {
      result.agreeing += is_empty(a[i]) ? 0 : 1;
    } else if (is_place(a[i])) {
      result.same_place = false;
    } else {
      result.different = i;
      if (++result.differing > 1) break;
    }
  }
  return result;
}

/// One field of one part, and the parts that have it as it should be.
struct Odd {
  std::uint32_t wrong = 0;
  std::size_t field = 0;
  std::vector<std::uint32_t> right;
  bool decided = true;  ///< whether it is known that not the other one is wrong
};

std::optional<std::size_t> place_field(const Fields& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (is_place(fields[i])) return i;
  }
  return std::nullopt;
}

/// The others that agree with it in all but this field, when they agree in that among each other.
void add_odd(std::uint32_t one, std::size_t field, const std::vector<std::uint32_t>& others,
             const std::vector<Fields>& all, std::vector<Odd>& result) {
  if (others.size() < kFewest) return;
  for (const std::uint32_t other : others) {
    if (!same_field(all[other][field], all[others.front()][field])) return;
  }
  result.push_back({one, field, others});
}

double size_of(const SiblingField& field) {
  double sum = 0;
  for (const double value : field.values) sum += value * value;
  return std::sqrt(sum);
}

/// Whether the numbers of one are ten, a hundred or a thousand times those of the other, and at least two are not 0.
bool is_slipped_point(const SiblingField& a, const SiblingField& b) {
  const double ratio = size_of(a) / size_of(b);
  const double power = std::abs(std::log10(ratio));
  if (!std::isfinite(power) || power < 0.5 || power > 3.5) return false;
  const double factor = std::pow(10, std::round(std::log10(ratio)));
  std::size_t used = 0;
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    if (a.values[k] == 0 && b.values[k] == 0) continue;
    if (!same_size(std::abs(a.values[k]), std::abs(b.values[k] * factor))) return false;
    ++used;
  }
  return used >= 2;
}

/// Of parts in several places, one that is nowhere near as far from their parent as any other, and is where another
/// would be with a slipped decimal point.
void add_slipped(std::uint32_t one, std::size_t place, const std::vector<std::uint32_t>& others,
                 const std::vector<Fields>& all, std::vector<Odd>& result) {
  constexpr double kOther = 3;
  const double size = size_of(all[one][place]);
  for (const std::uint32_t other : others) {
    const double that = size_of(all[other][place]);
    if (size < kOther * that && that < kOther * size) return;
  }
  for (const std::uint32_t other : others) {
    if (!is_slipped_point(all[one][place], all[other][place])) continue;
    result.push_back({one, place, {other}});
    return;
  }
}

std::vector<Odd> odd_ones(const std::vector<std::uint32_t>& group, const std::vector<Fields>& all) {
  std::vector<Odd> result;
  for (const std::uint32_t one : group) {
    std::map<std::size_t, std::vector<std::uint32_t>> by_field;
    std::set<std::size_t> shared;  // fields in which a like part has the same
    std::vector<std::uint32_t> elsewhere;
    bool alone = true, alone_in_place = true;
    for (const std::uint32_t other : group) {
      if (other == one) continue;
      const auto found = compared_fields(all[one], all[other]);
      if (!found) continue;
      if (found->differing == 0 && found->same_place) alone_in_place = false;
      if (found->agreeing < kAgreeing) continue;
      if (found->differing == 1) by_field[found->different].push_back(other);
      if (found->differing > 0) continue;
      alone = false;
      if (!found->same_place) elsewhere.push_back(other);
    }
    // Another part that is the same confirms all but the place.
    if (alone) {
      for (const auto& [field, others] : by_field) add_odd(one, field, others, all, result);
    }
    const auto place = place_field(all[one]);
    if (!place || !alone_in_place) continue;
    const std::size_t before = result.size();
    add_odd(one, *place, elsewhere, all, result);
    if (result.size() == before && elsewhere.size() >= kFewest)
      add_slipped(one, *place, elsewhere, all, result);
  }
  return result;
}

/// What makes the one of the other by a slip: a factor, a number left out, an exchange.
std::string slip_between(const SiblingField& wrong, const SiblingField& right) {
  const SmallList &a = wrong.values, &b = right.values;
  if (wrong.kind == FieldKind::kType) return "another type is written";
  if (is_empty(wrong)) return "it was left out";
  std::vector<double> p, q;
  for (const double value : a) p.push_back(std::abs(value));
  for (const double value : b) q.push_back(std::abs(value));
  if (wrong.kind == FieldKind::kLimits && same_size(p[0], q[0]) && same_size(p[1], q[1]))
    return "a sign was lost";
  std::sort(p.begin(), p.end());
  std::sort(q.begin(), q.end());
  if (std::equal(p.begin(), p.end(), q.begin(), same_size)) return "two numbers are exchanged";
  constexpr double kDegrees = 180 / 3.14159265358979323846;
  constexpr double kExact = 1e-3;
  for (const double factor : {2.0, 10.0, 25.4, 100.0, 1000.0, kDegrees}) {
    std::size_t scaled = 0, same = 0, used = 0, gone = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (b[k] == 0 && a[k] == 0) continue;
      ++used;
      if (same_size(a[k], b[k])) ++same;
      if (a[k] == 0) ++gone;
      const double ratio = std::abs(a[k] / b[k]);
      if (std::abs(ratio / factor - 1) < kExact || std::abs(ratio * factor - 1) < kExact) ++scaled;
    }
    if (scaled + same == used && scaled > 0)
      return fmt::format("it is off by a factor of {:g}", factor);
    if (gone + same == used && gone > 0) return "a number was left out";
  }
  return {};
}

/// As they are written: what is compared has no signs.
std::string numbers_of(const SiblingField& field, const Context& context) {
  if (field.kind == FieldKind::kType) {
    const auto type = static_cast<model::JointType>(static_cast<int>(field.values.front()));
    return fmt::format(" '{}'", model::to_string(type));
  }
  const std::string_view written = read::trimmed(context.bytes(field.span));
  const auto blanks = static_cast<std::size_t>(std::count(written.begin(), written.end(), ' '));
  const bool plain = blanks + 1 == field.values.size() &&
                     written.find_first_not_of("+-.0123456789eE ") == written.npos;
  return ' ' +
         (plain ? std::string(written)
                : write::joined({field.values.begin(), field.values.end()})) +
         (*field.unit ? ' ' + std::string(field.unit) : "");
}

/// The sign that the wrong number had, where it has one.
double signed_as(double right, const std::array<double, 3>& wrong, std::size_t k) {
  for (const std::size_t i : {k, (k + 1) % 3, (k + 2) % 3}) {
    if (same_size(wrong[i], right)) return std::copysign(right, wrong[i]);
  }
  return wrong[k] == 0 ? 0 : std::copysign(right, wrong[k]);
}

/// The values of the others, with the signs of this one; nothing where a sign is not known.
std::optional<model::Vector3> with_signs(const model::Vector3& wrong, const SmallList& right) {
  const std::array<double, 3> from{wrong.x, wrong.y, wrong.z};
  std::array<double, 3> to{};
  for (std::size_t k = 0; k < 3; ++k) {
    to[k] = signed_as(right[k], from, k);
    if (std::abs(to[k]) != right[k]) return std::nullopt;
  }
  return model::Vector3{to[0], to[1], to[2]};
}

std::optional<Fix> fix_for(const SiblingField& wrong, const SiblingField& right,
                           const Context& context) {
  if (wrong.span.nowhere()) return std::nullopt;
  if (wrong.kind == FieldKind::kType && !right.span.nowhere()) {
    const std::string type(context.bytes(right.span));
    return Fix{"write " + type, Applicability::kUnsafe, {{wrong.span, type}}};
  }
  if (wrong.pose) {
    const auto value = with_signs(wrong.pose->pose.value.translation, right.values);
    return value ? translation_fix(*wrong.pose, *value, context) : std::nullopt;
  }
  std::string text;
  if (wrong.number) {
    text = write::joined({right.number->value});
  } else if (wrong.vector) {
    const auto value = with_signs(wrong.vector->value, right.values);
    if (!value) return std::nullopt;
    text = written_as(*value);
  } else {
    return std::nullopt;
  }
  return Fix{"write " + text, Applicability::kUnsafe, {{wrong.span, text}}};
}

/// Of a pair the one that was left out; else the larger.
bool is_the_wrong_one(const SiblingField& one, const SiblingField& other) {
  if (is_empty(one) || is_empty(other)) return is_empty(one);
  return size_of(one) > size_of(other);
}

std::optional<std::uint32_t> link_of(const model::Link& link, std::uint32_t i,
                                     Context& /*context*/) {
  return link.site.span.nowhere() ? std::nullopt : std::optional(i);
}
std::optional<std::uint32_t> link_of(const model::Joint& /*joint*/, std::uint32_t i,
                                     Context& context) {
  const auto child = context.frames().ends({i}).child;
  return child ? std::optional(child.value) : std::nullopt;
}

/// What speaks against a link in this field: how far it is from the rest of the robot, m, or how little its
/// collisions and visuals have in common, 0 to 1. Nothing where that is not known.
std::optional<double> oddity_of(std::uint32_t link, const SiblingField& field, Context& context) {
  const robot::Assembled& robot = context.assembled();
  if (is_place(field)) return robot.gap(robot.subtree(link));
  if (field.part.empty()) return std::nullopt;
  const auto touched = robot.bounds(link, robot::ShapeRole::kCollision);
  const auto seen = robot.bounds(link, robot::ShapeRole::kVisual);
  if (!touched || !seen) return std::nullopt;
  return 1 - robot::likeness(*touched, *seen);
}

/// Whether the first of two parts is the odd one; nothing where neither is known to be.
std::optional<bool> is_first_odd(std::uint32_t a, std::uint32_t b, const SiblingField& field,
                                 Context& context) {
  const auto of_a = oddity_of(a, field, context), of_b = oddity_of(b, field, context);
  constexpr double kClear = 1.3;
  constexpr double kLeast = 1e-3;
  if (!of_a || !of_b || std::max(*of_a, *of_b) < kLeast) return std::nullopt;
  if (*of_a > kClear * *of_b) return true;
  if (*of_b > kClear * *of_a) return false;
  return std::nullopt;
}

/// Whether two origins are apart by more than a calibration or a rounded number.
bool is_elsewhere(const SiblingField& a, const SiblingField& b) {
  constexpr double kApart = 1e-3;  // m
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    if (std::abs(a.values[k] - b.values[k]) > kApart) return true;
  }
  return false;
}

/// Of two alone: where they are, where a shape is or how large, and that by a slip.
template <class Support>
std::vector<Odd> odd_of_pair(std::uint32_t a, std::uint32_t b, const std::vector<Fields>& all,
                             const Support& support, std::size_t enough) {
  const auto found = compared_fields(all[a], all[b]);
  if (!found) return {};
  std::optional<std::size_t> field;
  if (found->differing == 1 && found->same_place) field = found->different;
  if (found->differing == 0 && !found->same_place) field = place_field(all[a]);
  if (!field || (found->agreeing < enough && found->agreeing + support(a, b) < enough)) return {};
  const SiblingField& one = all[a][*field];
  const SiblingField& other = all[b][*field];
  if (one.kind != FieldKind::kOrigin && one.kind != FieldKind::kSize) return {};
  if (one.kind == FieldKind::kOrigin && !is_elsewhere(one, other)) return {};
  if (slip_between(one, other).empty() && slip_between(other, one).empty()) return {};
  const bool decided = is_empty(one) || is_empty(other);
  if (is_the_wrong_one(one, other)) return {{a, *field, {b}, decided}};
  return {{b, *field, {a}, decided}};
}

/// Whether one of the names says left and the other right. Of two in a row each may be elsewhere.
bool are_sides(const std::string& a, const std::string& b) {
  const std::vector<std::string> names = robot::mirrored_names(a, robot::Side::kAcross);
  return std::find(names.begin(), names.end(), b) != names.end();
}

/// Of two parts alone, exchanges which is wrong where the robot says so. False where nothing holds them in a
/// place: then they may be anywhere.
template <class Entity>
bool settle(Odd& odd, const std::vector<Entity>& all, const std::vector<Fields>& fields,
            Context& context) {
  if (odd.right.size() > 1) return true;
  const SiblingField& field = fields[odd.wrong][odd.field];
  const auto a = link_of(all[odd.wrong], odd.wrong, context);
  const auto b = link_of(all[odd.right.front()], odd.right.front(), context);
  if (!a || !b) return true;
  if (is_place(field) && may_be_anywhere(*a, *b, context)) return false;
  if (odd.decided) return true;
  const auto first = is_first_odd(*a, *b, field, context);
  odd.decided = first.has_value();
  if (first && !*first) std::swap(odd.wrong, odd.right.front());
  return true;
}

template <class Entity>
void report(const Odd& odd, const std::vector<Entity>& all, const std::vector<Fields>& fields,
            Context& context) {
  const SiblingField& wrong = fields[odd.wrong][odd.field];
  const SiblingField& right = fields[odd.right.front()][odd.field];
  std::string slip = slip_between(wrong, right);
  if (slip.empty() && odd.right.size() == 1) slip = slip_between(right, wrong);
  const bool many = odd.right.size() >= kMany;
  const bool place = is_place(wrong);
  // What was left out is reported as such; but an origin of zero need not be written.
  if (slip.empty() || (wrong.span.nowhere() && !place)) return;
  Finding finding{
      .where = wrong.span.nowhere() ? all[odd.wrong].site.name : wrong.span,
      .message =
          odd.right.size() == 1
              ? fmt::format("{}{} differs from that of the part of the same kind, '{}':{}",
                            name_of(wrong), numbers_of(wrong, context),
                            all[odd.right.front()].name.value, numbers_of(right, context))
              : fmt::format(
                    "{}{} differs from that of {} parts of the same kind, '{}' and others:{}",
                    name_of(wrong), numbers_of(wrong, context), odd.right.size(),
                    all[odd.right.front()].name.value, numbers_of(right, context)),
      .subject = context.subject(all[odd.wrong]),
      .related = {{right.span.nowhere() ? all[odd.right.front()].site.name : right.span,
                   "as in the others"}},
      .help = "all their other values are the same: " + slip,
      .fix = odd.decided ? fix_for(wrong, right, context) : std::nullopt,
      .cause = all[odd.wrong].name.value + name_of(wrong)};
  // One rudder among ailerons.
  const bool pair = odd.right.size() == 1 &&
                    are_sides(all[odd.wrong].name.value, all[odd.right.front()].name.value);
  const bool doubtful =
      (!many && !pair) || wrong.kind == FieldKind::kAxis || wrong.kind == FieldKind::kNumber;
  if (doubtful) finding.severity = Severity::kInfo;
  context.report(std::move(finding));
}

/// Whether a joint holds any of them: bodies that lie about are no parts of a robot.
bool is_jointed(const std::vector<std::uint32_t>& links, const std::vector<model::Link>& /*all*/,
                Context& context) {
  const robot::Assembled& robot = context.assembled();
  return std::any_of(links.begin(), links.end(), [&](std::uint32_t i) {
    return robot.links[i].carrier || !robot.links[i].links_carried.empty();
  });
}
bool is_jointed(const std::vector<std::uint32_t>& /*joints*/,
                const std::vector<model::Joint>& /*all*/, Context& /*context*/) {
  return true;
}

const std::vector<robot::Twins>& pairs_of(const std::vector<model::Link>& /*all*/,
                                          const robot::Assembled& robot) {
  return robot.link_twins;
}
const std::vector<robot::Twins>& pairs_of(const std::vector<model::Joint>& /*all*/,
                                          const robot::Assembled& robot) {
  return robot.joint_twins;
}

/// Of a model's members, by their index among all. The larger groups first, which say more; then pairs, of which
/// those of two sides are in larger ones, too.
std::vector<std::vector<std::uint32_t>> family_groups(const std::vector<std::uint32_t>& members,
                                                      const std::vector<std::string>& names,
                                                      const std::vector<robot::Twins>& pairs) {
  auto groups = robot::siblings(names);
  for (auto& group : groups) {
    for (std::uint32_t& i : group) i = members[i];
  }
  for (const robot::Twins& pair : pairs) groups.push_back({pair.a, pair.b});
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return groups;
}

/// `support` counts what else of two parts agrees: of a joint, the link that it carries.
template <class Entity, class List, class Support>
void check_family(const std::vector<Entity>& all, const List& list, const Support& support,
                  Context& context) {
  const model::Root& root = context.root();
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_model;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (root.own(all[i].site) && all[i].model) by_model[all[i].model.value].push_back(i);
  }
  std::map<std::uint32_t, std::vector<robot::Twins>> pairs;
  for (const robot::Twins& pair : pairs_of(all, context.assembled()))
    pairs[all[pair.a].model.value].push_back(pair);
  std::set<std::pair<std::uint32_t, std::size_t>> reported;
  for (const auto& [model, members] : by_model) {
    if (members.size() < kFewest || !is_jointed(members, all, context)) continue;
    std::vector<std::string> names;
    std::vector<Fields> fields;
    for (const std::uint32_t i : members) names.push_back(all[i].name.value);
    const auto groups = family_groups(members, names, pairs[model]);
    if (groups.empty()) continue;
    std::vector<Fields> of_all(all.size());
    for (const std::vector<std::uint32_t>& group : groups) {
      if (group.size() > kMaxMembers) continue;
      for (const std::uint32_t i : group) {
        if (of_all[i].empty()) of_all[i] = list(all[i]);
      }
      std::vector<Odd> found = [&] {
        if (group.size() > kFewest) return odd_ones(group, of_all);
        const bool sides = are_sides(all[group[0]].name.value, all[group[1]].name.value);
        return odd_of_pair(group[0], group[1], of_all, support, sides ? kAgreeingSides : kAgreeing);
      }();
      for (Odd& odd : found) {
        if (!settle(odd, all, of_all, context)) continue;
        const bool known = std::any_of(group.begin(), group.end(), [&](std::uint32_t one) {
          return reported.contains({one, odd.field});
        });
        if (known && (group.size() == kFewest || reported.contains({odd.wrong, odd.field})))
          continue;
        reported.emplace(odd.wrong, odd.field);
        report(odd, all, of_all, context);
      }
    }
  }
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() <= kFewest) return;
  SiblingLister lister(context);
  const auto links_agree = [&](std::uint32_t a, std::uint32_t b) -> std::size_t {
    const auto child_a = context.frames().ends({a}).child,
               child_b = context.frames().ends({b}).child;
    if (!child_a || !child_b) return 0;
    const auto found =
        compared_fields(lister.of_link(root[child_a]), lister.of_link(root[child_b]));
    return found && found->differing == 0 ? found->agreeing : 0;
  };
  check_family(
      root.links, [&](const model::Link& link) { return lister.of_link(link); },
      [](std::uint32_t, std::uint32_t) { return std::size_t{0}; }, context);
  check_family(
      root.joints, [&](const model::Joint& joint) { return lister.of_joint(joint); }, links_agree,
      context);
}

Rule rule() {
  return {
      .name = "sibling-value-differs",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one of several like parts has one value that the others have not",
      .why = "One of four wheels is smaller, one rotor is elsewhere, one finger does not bend. The "
             "names say that the parts are of one kind (rotor_0, rotor_1, …; FL_calf, RR_calf), at "
             "least three of them have the same values but for signs, and so has this one but for "
             "a single value, which a slip explains: a factor of 2, 10, 25.4, 100 or 1000, a "
             "number that was left out or exchanged, another type. With less evidence it is an "
             "info.",
      .what_to_do = "Write the value of the others.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sibling_value_differs
