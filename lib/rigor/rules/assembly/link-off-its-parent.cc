// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/attachment.h>
#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/assembly/written_places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::link_off_its_parent {

using model::Vector3;

// Other joints of the same robot, which say how its links are joined.
constexpr std::size_t kFewest = 2;

// Shares of the longest link: less is a bracket, a bearing or a rounded number.
constexpr double kApart = 0.03;
constexpr double kOutside = 0.15;
constexpr double kJoined = 0.01;

// Shares of a link's own volume that may be inside of its parent more than is usual in this robot.
constexpr double kDeep = 0.3;
constexpr double kAsUsual = 0.1;
constexpr double kPartly = 0.5;
constexpr double kLessInside = 0.25;
constexpr double kWithin = 0.6;

// One joint in so many may be odd without a slip: a sensor on a mast that is not drawn.
constexpr std::size_t kOddInTen = 10;

// The slip explains the distance when it moves the link by not much more: the share of what it moves.
constexpr double kByFactor = 0.75;
constexpr double kBySign = 0.3;

/// The most of each number at the other joints of the robot.
struct Usual {
  std::size_t joints = 0;
  Fit most;
  double longest = 0;  ///< m
};

/// The largest, but for one in ten.
double most_of(std::vector<double> numbers) {
  if (numbers.empty()) return 0;
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / kOddInTen);
  std::nth_element(numbers.begin(), at, numbers.end(), std::greater<>());
  return *at;
}

bool carries(const Attached& one, std::uint32_t link, Context& context) {
  const auto& ends = context.frames().ends(context.assembled().links[link].carrier);
  return std::find(one.moved.begin(), one.moved.end(), ends.parent.value) != one.moved.end();
}

/// The longest link of each model, m.
using Longest = std::map<model::Id<model::Model>, double>;

Longest longest_links(Context& context) {
  const robot::Assembled& robot = context.assembled();
  Longest result;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    double& longest = result[robot.links[i].top];
    longest = std::max(longest, robot.longest({i}));
  }
  return result;
}

Usual usual_beside(const Attached& one, const std::vector<Attached>& all, const Longest& longest,
                   Context& context) {
  const robot::Assembled& robot = context.assembled();
  Usual usual;
  std::vector<double> gaps, reaches, insides;
  for (const Attached& other : all) {
    if (&other == &one || robot.links[other.unit.link].top != robot.links[one.unit.link].top)
      continue;
    // What the link itself carries is where the link is, or is left behind by it.
    if (!context.is_urdf() && carries(one, other.unit.link, context)) continue;
    ++usual.joints;
    gaps.push_back(other.fit.gap);
    reaches.push_back(other.fit.reach);
    insides.push_back(other.fit.inside);
  }
  usual.most = {most_of(std::move(gaps)), most_of(std::move(reaches)), most_of(std::move(insides))};
  usual.longest = longest.at(robot.links[one.unit.link].top);
  return usual;
}

enum class Oddity { kNone, kGap, kReach, kInside };

bool is_far(double distance, double least, double usual, double longest) {
  return distance > least * longest && distance > 3 * usual + kJoined * longest;
}

Oddity oddity_of(const Fit& fit, const Usual& usual) {
  if (is_far(fit.gap, kApart, usual.most.gap, usual.longest)) return Oddity::kGap;
  if (is_far(fit.reach, kOutside, usual.most.reach, usual.longest)) return Oddity::kReach;
  if (fit.inside > kWithin && fit.inside > usual.most.inside + kDeep) return Oddity::kInside;
  return Oddity::kNone;
}

/// Whether it is joined as the others are, when as written it is `now`.
bool is_usual(const Fit& fit, const Fit& now, const Usual& usual) {
  const bool less_inside = fit.inside <= std::max(usual.most.inside + kAsUsual, kPartly) ||
                           fit.inside + kLessInside <= now.inside;
  return fit.gap <= std::max(usual.most.gap, kJoined * usual.longest) &&
         fit.reach <= std::max(usual.most.reach, kJoined * usual.longest) && less_inside;
}

/// Whether the slip leaves little doubt: the distance is that by which it moves the link. What is inside of
/// others may be mounted there, and a joint outside of its parent on a bracket that is not drawn.
bool is_explained(const Attached& one, Oddity oddity, const Undone& change) {
  if (oddity == Oddity::kInside) return false;
  const Vector3& written = one.unit.pose->pose.value.translation;
  const double moved = length(change.value - written);
  const bool same_length = std::abs(length(change.value) - length(written)) < 1e-9;
  if (oddity == Oddity::kReach) return same_length && one.fit.reach > kBySign * moved;
  return one.fit.gap > (same_length ? kBySign : kByFactor) * moved;
}

struct Change {
  Undone undone;
  bool clear =
      false;  ///< whether it explains the distance, and the one with which it is joined best does
  bool only = true;  ///< whether no other makes it so
};

/// The change with which the link is joined as all others are, and best; one that explains the distance first, and
/// one that leaves what is written elsewhere.
std::optional<Change> change_for(const Attached& one, const Usual& usual, Oddity oddity,
                                 const model::Root& root) {
  std::optional<Change> best;
  std::size_t count = 0;
  double least = 0, least_plain = 0;
  bool clear = false;
  for (Undone& change : placement_slips(one.unit.pose->pose.value.translation)) {
    const Fit then = fit_of(one, shift_of(one.unit.pose->pose.value, one.unit.X_WL, change.value));
    if (!is_usual(then, one.fit, usual)) continue;
    const bool explained = is_explained(one, oddity, change);
    const double plain = (then.gap + then.reach) / usual.longest + then.inside;
    if (count == 0 || plain < least_plain - kAsUsual) {
      least_plain = plain;
      clear = explained;
    }
    ++count;
    constexpr double kKnown = 0.5;
    const bool known = is_written_elsewhere(change.value, *one.unit.pose, root);
    const double score = plain + (explained ? 0 : 1) - (known ? kKnown : 0);
    if (best && score >= least - kAsUsual) continue;
    least = score;
    best = Change{std::move(change), explained, true};
  }
  if (!best) return best;
  best->only = count == 1;
  best->clear = best->clear && clear;
  return best;
}

std::string message_of(const Attached& one, const Usual& usual, Oddity oddity, Context& context) {
  const model::Root& root = context.root();
  const std::string& name = root.links[one.unit.link].name.value;
  const auto parent =
      context.frames().ends(context.assembled().links[one.unit.link].carrier).parent;
  switch (oddity) {
    case Oddity::kGap:
      return fmt::format("link '{}' is {:.3g} m away from what carries it; the other {} links of "
                         "the robot are at most {:.2g} m apart",
                         name, one.fit.gap, usual.joints, usual.most.gap);
    case Oddity::kReach:
      return fmt::format("the joint of link '{}' is {:.3g} m outside of its parent '{}'; the other "
                         "{} joints of the robot are at most {:.2g} m outside",
                         name, one.fit.reach, root[parent].name.value, usual.joints,
                         usual.most.reach);
    default:
      return fmt::format("{:.0f} % of link '{}' is inside of its parent; of the other {} links of "
                         "the robot at most {:.0f} % are",
                         100 * one.fit.inside, name, usual.joints, 100 * usual.most.inside);
  }
}

/// A link that is joined otherwise than most of its robot are.
struct OddLink {
  const Attached* link = nullptr;
  Usual usual;
  Oddity oddity = Oddity::kNone;
  std::optional<Change> change;
};

bool moves(const model::Joint& joint) { return joint.type != model::JointType::kFixed; }

/// The only joint of a URDF that moves and has no offset, when four others have one.
const model::Joint* only_one_at_zero(const model::Root& root, const Context& context) {
  constexpr std::size_t kOthers = 4;
  const auto has_body = [&](model::Id<model::Link> link) {
    return link && (!root[link].visuals.empty() || !root[link].collisions.empty());
  };
  const model::Joint* found = nullptr;
  std::size_t others = 0;
  for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
    const model::Joint& joint = root.joints[j];
    if (!moves(joint)) continue;
    if (nonzero_coordinates(joint.pose.pose.value.translation) > 0) {
      ++others;
      continue;
    }
    const auto& ends = context.frames().ends({j});
    if (found != nullptr || !has_body(ends.parent) || !has_body(ends.child)) return nullptr;
    found = &joint;
  }
  return others >= kOthers ? found : nullptr;
}

/// Whether a link that slides, and is apart from its parent at zero, meets it at another position within its limits.
bool slides_to_parent(const Attached& one, const robot::RigidGroups& rigid, Context& context) {
  const model::Root& root = context.root();
  const model::Id<model::Joint> carrier = context.assembled().links[one.unit.link].carrier;
  if (root[carrier].type != model::JointType::kPrismatic) return false;
  const auto range = robot::limited_range(root[carrier]);
  const auto sides = robot::sides_of(carrier, root, context.frames(), context.assembled(), rigid);
  if (!sides || !range) return false;
  const auto stands = sides->between(*range);
  return std::any_of(stands.begin(), stands.end(),
                     [](const robot::Stand& stand) { return stand.gap == 0; });
}

std::optional<OddLink> odd_link(const Attached& one, const std::vector<Attached>& all,
                                const Longest& longest, const robot::RigidGroups& rigid,
                                Context& context) {
  if (one.fit.gap == 0 && one.fit.reach == 0 && one.fit.inside <= kWithin) return std::nullopt;
  OddLink odd{&one, usual_beside(one, all, longest, context), Oddity::kNone, {}};
  if (odd.usual.joints < kFewest || !(odd.usual.longest > 0)) return std::nullopt;
  odd.oddity = oddity_of(one.fit, odd.usual);
  if (odd.oddity == Oddity::kNone) return std::nullopt;
  if (odd.oddity == Oddity::kGap && is_eye(one.unit.link, context)) return std::nullopt;
  if (odd.oddity == Oddity::kGap && slides_to_parent(one, rigid, context)) return std::nullopt;
  odd.change = change_for(one, odd.usual, odd.oddity, context.root());
  const model::Joint& joint = context.root()[context.assembled().links[one.unit.link].carrier];
  const bool left_out = odd.oddity == Oddity::kInside && moves(joint) &&
                        &joint != only_one_at_zero(context.root(), context) &&
                        nonzero_coordinates(one.unit.pose->pose.value.translation) == 0;
  if (!odd.change && !left_out) return std::nullopt;
  return odd;
}

void report(const OddLink& odd, Context& context) {
  const Attached& one = *odd.link;
  Finding finding{.where = place_of(*one.unit.pose, context),
                  .message = message_of(one, odd.usual, odd.oddity, context),
                  .subject = one.unit.joint ? context.subject(*one.unit.joint)
                                            : context.subject(context.root().links[one.unit.link])};
  if (odd.change) {
    const auto& [undone, clear, only] = *odd.change;
    finding.help = fmt::format("with {} it is joined as the others are: {}",
                               written_as(undone.value), undone.slip);
    // One of several that explain little is a guess.
    if (only || is_explained(one, odd.oddity, undone))
      finding.fix = translation_fix(*one.unit.pose, undone.value, context);
    if (!clear) finding.severity = Severity::kInfo;
  } else {
    finding.help = "its origin is that of its parent: write where the joint is";
    finding.severity = Severity::kInfo;
  }
  context.report(std::move(finding));
}

void report_zero(const model::Joint& joint, Context& context) {
  context.report(
      {.where = joint.pose.pose.written ? place_of(joint.pose, context) : joint.site.name,
       .message = fmt::format("the joint is at the origin of its parent '{}', and no other "
                              "joint of the robot that moves is",
                              joint.parent.value),
       .subject = context.subject(joint),
       .help = "was its origin left out?",
       .severity = Severity::kInfo});
}

void check(const model::Root& root, Context& context) {
  if (context.is_urdf()) {
    const model::Joint* zero = only_one_at_zero(root, context);
    if (zero != nullptr) report_zero(*zero, context);
  }
  if (root.links.size() <= kFewest + 1 || !context.frames().problems().empty()) return;
  AttachedLinks attached(context);
  const std::vector<Attached> all = attached.find();
  if (all.size() <= kFewest) return;
  std::vector<OddLink> found;
  const Longest longest = longest_links(context);
  for (const Attached& one : all) {
    if (auto odd = odd_link(one, all, longest, attached.rigid(), context))
      found.push_back(*std::move(odd));
  }
  const auto top = [&](const OddLink& odd) {
    return context.assembled().links[odd.link->unit.link].top;
  };
  for (const OddLink& odd : found) {
    // More of them are how the robot is made.
    constexpr std::ptrdiff_t kMax = 2;
    const auto beside = std::count_if(found.begin(), found.end(),
                                      [&](const OddLink& other) { return top(other) == top(odd); });
    if (beside <= kMax) report(odd, context);
  }
}

Rule rule() {
  return {
      .name = "link-off-its-parent",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one link is not joined to its parent as the robot's other links are",
      .why = "The link floats beside the robot, turns about a point in the air, or is inside of "
             "what carries it, while all other links of the robot meet their parents. One change "
             "of its origin makes it as they are: a unit, a decimal point, a sign, or two "
             "coordinates exchanged. Shapes are compared as boxes, with all joints at zero. An "
             "origin that was left out is an info, as nobody knows what it was, and so are a link "
             "inside of others and a change that moves the link by much more than it is off.",
      .what_to_do = "Write the origin of the joint in the frame of the parent, in meters. `rigor "
                    "inspect --assembled` prints the distances.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::link_off_its_parent
