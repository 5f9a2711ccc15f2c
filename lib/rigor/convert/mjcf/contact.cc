// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/contact.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <fmt/core.h>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

constexpr std::uint32_t kOwnKindBit = 1U << 30U;
constexpr std::uint32_t kAllModelBits = kOwnKindBit - 1;
constexpr std::uint32_t kSharedBit = 1U << 1U;

/// MuJoCo's own torsional and rolling coefficients, m.
constexpr double kTorsional = 0.005;
constexpr double kRolling = 0.0001;

/// Those of all links that no file says anything of.
constexpr double kDefaultFriction = 1;

const model::GazeboBlock* block_of(const MjcfDraft& draft, const std::string& link,
                                   std::string_view key) {
  for (const model::GazeboBlock& block : draft.root().gazebo_blocks) {
    if (block.reference.value == link && find(block.content, key) != nullptr) return &block;
  }
  return nullptr;
}

/// The value of a key of a link's `<gazebo>` block, which is text or an attribute; takes it.
std::optional<double> block_number(MjcfDraft& draft, const std::string& link,
                                   std::string_view key) {
  const model::GazeboBlock* block = block_of(draft, link, key);
  if (block == nullptr) return std::nullopt;
  const model::Parameter& given = *find(block->content, key);
  const auto number = read::number_field(given);
  draft.ledger.take(block->site);
  draft.ledger.take(block->reference);
  draft.ledger.take_all(given.site);
  return number.written ? std::optional(number.value) : std::nullopt;
}

bool block_flag(MjcfDraft& draft, const std::string& link, std::string_view key) {
  const model::GazeboBlock* block = block_of(draft, link, key);
  if (block == nullptr) return false;
  const model::Parameter& given = *find(block->content, key);
  draft.ledger.take_all(given.site);
  return is_true(given);
}

bool collides_with_itself(MjcfDraft& draft, const model::Link& link) {
  if (draft.options.self_collision == MjcfSelfCollision::kAll) return true;
  draft.ledger.take(link.self_collide);
  if (link.self_collide.written) return link.self_collide.value;
  if (draft.root().format == model::Format::kUrdf) {
    return block_flag(draft, link.name.value, "selfCollide") ||
           block_flag(draft, link.name.value, "self_collide");
  }
  const model::Model& model = draft.root()[link.model];
  draft.ledger.take(model.self_collide);
  return model.self_collide.value;
}

/// SDF's bitmask; nothing where it is not written.
std::optional<std::uint32_t> bitmask(MjcfDraft& draft, const model::Collision& collision) {
  if (draft.root().format != model::Format::kSdf || !collision.surface.chooses_contacts) return {};
  const xml::Element element = draft.source.source.documents.element(collision.site);
  const auto surface = element.child("surface");
  const auto contact = surface ? surface->child("contact") : std::nullopt;
  const auto mask = contact ? contact->child("collide_bitmask") : std::nullopt;
  const auto number = mask ? write::number_in(read::trimmed(mask->text())) : std::nullopt;
  if (!number || *number < 0 || *number > kAllModelBits) return {};
  // Others than 0 are lost.
  if (*number == 0) draft.ledger.take(*mask);
  return static_cast<std::uint32_t>(*number);
}

MjcfContactBits bits_of(MjcfDraft& draft, std::uint32_t body, const model::Collision& collision) {
  if (bitmask(draft, collision) == 0U) return {0, 0};
  const std::uint32_t model = draft.assembly.model_of[body];
  if (model == robot::kNoIndex) return {};
  MjcfContactBits bits = kMjcfOneModel;
  if (!draft.model_bits.only_one()) {
    bits.type = draft.model_bits.of(model);
    bits.affinity = bits.type == kSharedBit ? kAllModelBits : kAllModelBits & ~bits.type;
  }
  if (collides_with_itself(draft, draft.root()[collision.link])) {
    bits.type |= kOwnKindBit;
    bits.affinity |= kOwnKindBit;
  }
  return bits;
}

void set_friction(MjcfDraft& draft, const model::Collision& collision, MjcfElement& geom) {
  std::optional<double> mu, mu2;
  Span where;
  if (draft.root().format == model::Format::kUrdf) {
    const std::string& link = draft.root()[collision.link].name.value;
    mu = block_number(draft, link, "mu1");
    mu2 = block_number(draft, link, "mu2");
  } else {
    const model::Surface& surface = collision.surface;
    draft.ledger.take(surface.mu);
    draft.ledger.take(surface.mu2);
    if (surface.mu.written) mu = surface.mu.value;
    if (surface.mu2.written) mu2 = surface.mu2.value;
    where = surface.mu2.span;
  }
  if (!mu && !mu2) return;
  const double first = mu.value_or(kDefaultFriction), second = mu2.value_or(first);
  if (!(first >= 0)) return;
  geom.set("friction", mjcf_numbers({first, kTorsional, kRolling}));
  geom.set("priority", "1");
  if (first == second) return;
  draft.ledger.note({.kind = NoteKind::kMjcfContact,
                     .outcome = Outcome::kSubstituted,
                     .where = where.nowhere() ? collision.site.name : where,
                     .subject = model::subject(draft.root(), collision),
                     .written = fmt::format("the second friction coefficient {}", second),
                     .instead = fmt::format("becomes the first one, {}", first)});
}

}  // namespace

MjcfModelBits::MjcfModelBits(const MjcfAssembly& assembly) {
  const robot::Robot& robot = assembly.robot;
  // MuJoCo lets bodies that are welded to each other, or to the world, pass through each other.
  std::vector<std::uint32_t> weld(robot.bodies.size());
  std::vector<std::set<std::uint32_t>> parts;  // of each model, that touch something
  for (const std::uint32_t i : robot.order) {
    weld[i] = i;
    const std::uint32_t carrier = robot.bodies[i].carrier;
    if (carrier != robot::kNoIndex && robot.joints[carrier].type == model::JointType::kFixed)
      weld[i] = weld[robot.joints[carrier].parent];
    const std::uint32_t model = assembly.model_of[i];
    if (model == robot::kNoIndex) continue;
    if (parts.size() <= model) parts.resize(model + 1);
    if (!robot.bodies[i].collisions.empty()) parts[model].insert(weld[i]);
  }
  std::uint32_t next = kSharedBit;
  for (const auto& moving : parts) {
    const bool needs_bit = moving.size() > 1;
    const bool has_bit = needs_bit && (next << 1U) < kOwnKindBit;
    if (has_bit) next <<= 1U;
    models_.push_back({has_bit ? next : kSharedBit, needs_bit && !has_bit});
  }
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> bodies_to_exclude(MjcfDraft& draft) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (draft.model_bits.only_one()) return pairs;
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_model;
  for (std::uint32_t i = 0; i < draft.robot().bodies.size(); ++i) {
    const std::uint32_t model = draft.assembly.model_of[i];
    const bool touches = !draft.robot().bodies[i].collisions.empty();
    if (model != robot::kNoIndex && touches && draft.model_bits.is_excluded(model))
      by_model[model].push_back(i);
  }
  const auto touches_own = [&draft](std::uint32_t body) {
    const model::Link* link = draft.entities.link(draft.robot().bodies[body].span);
    return link != nullptr && collides_with_itself(draft, *link);
  };
  for (const auto& [model, bodies] : by_model) {
    for (std::size_t a = 0; a < bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < bodies.size(); ++b) {
        if (!touches_own(bodies[a]) || !touches_own(bodies[b]))
          pairs.emplace_back(bodies[a], bodies[b]);
      }
    }
  }
  return pairs;
}

void set_contact(MjcfDraft& draft, std::uint32_t body, const model::Collision& collision,
                 MjcfElement& geom) {
  const MjcfContactBits bits = bits_of(draft, body, collision);
  if (bits.type != kMjcfOneModel.type) geom.set("contype", std::to_string(bits.type));
  if (bits.affinity != kMjcfOneModel.affinity) {
    geom.set("conaffinity", std::to_string(bits.affinity));
  }
  set_friction(draft, collision, geom);
}

}  // namespace rigor::convert
