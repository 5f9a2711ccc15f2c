// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/contact.h>

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

constexpr std::uint32_t kOwnKindBit = 1U << 30U;
constexpr std::uint32_t kAllModelBits = kOwnKindBit - 1;
/// Further models share the last bit.
constexpr std::uint32_t kMaxModelBit = 29;

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
  const auto& of = draft.assembly.model_of;
  const bool alone =
      std::all_of(of.begin(), of.end(), [](auto m) { return m == 0 || m == robot::kNoIndex; });
  if (!alone) {
    bits.type = 1U << std::min(model + 1, kMaxModelBit);
    bits.affinity = kAllModelBits & ~bits.type;
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
