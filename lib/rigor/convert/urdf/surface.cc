// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

/// A key of the block, and where a collision has its value.
struct SurfaceKey {
  std::string_view key;
  std::array<std::string_view, 3> containers;  ///< empty where there are fewer
  std::string_view name;
};

constexpr std::array<std::string_view, 3> kFrictionOde{"surface", "friction", "ode"};
constexpr std::array<std::string_view, 3> kContactOde{"surface", "contact", "ode"};
constexpr std::array kSurfaceKeys{SurfaceKey{"mu1", kFrictionOde, "mu"},
                                  SurfaceKey{"mu2", kFrictionOde, "mu2"},
                                  SurfaceKey{"fdir1", kFrictionOde, "fdir1"},
                                  SurfaceKey{"kp", kContactOde, "kp"},
                                  SurfaceKey{"kd", kContactOde, "kd"},
                                  SurfaceKey{"maxVel", kContactOde, "max_vel"},
                                  SurfaceKey{"minDepth", kContactOde, "min_depth"},
                                  SurfaceKey{"maxContacts", {}, "max_contacts"},
                                  SurfaceKey{"laserRetro", {}, "laser_retro"}};

/// How many different values a note lists.
constexpr std::size_t kMaxListedValues = 4;

/// What is written and is not the default.
std::optional<read::Text> surface_value(const Source& source, const model::Collision& collision,
                                        const SurfaceKey& key) {
  xml::Element at = source.documents.element(collision.site);
  for (const std::string_view container : key.containers) {
    if (container.empty()) break;
    const auto child = at.child(container);
    if (!child) return std::nullopt;
    at = *child;
  }
  if (const auto leaf = at.child(key.name)) {
    if (is_implied(source, collision.site, *leaf)) return std::nullopt;
    return read::Text{leaf->text(), leaf->text_span()};
  }
  const auto attribute = at.attribute(key.name);
  if (!attribute || is_implied(source, at, *attribute)) return std::nullopt;
  return read::Text{attribute->value(), attribute->value_span()};
}

bool says_same(const std::optional<read::Text>& a, const std::optional<read::Text>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto numbers = write::numbers_in(a->text);
  return numbers ? numbers == write::numbers_in(b->text)
                 : read::trimmed(a->text) == read::trimmed(b->text);
}

using SurfaceValues = std::vector<std::optional<read::Text>>;

/// "mu1 0.5, 1, default"
std::string listed(std::string_view key, const SurfaceValues& values) {
  std::vector<std::string> words;
  for (const auto& value : values) {
    std::string word = value ? std::string(read::trimmed(value->text)) : "default";
    if (std::find(words.begin(), words.end(), word) != words.end()) continue;
    if (words.size() == kMaxListedValues) {
      words.emplace_back("…");
      break;
    }
    words.push_back(std::move(word));
  }
  std::string text(key);
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? " " : ", ") + words[i];
  return text;
}

}  // namespace

std::string surface_lines(UrdfDraft& draft, model::Id<model::Link> link,
                          const std::vector<model::Id<model::Collision>>& collisions) {
  const model::Root& root = draft.source.root;
  std::string lines;
  for (const SurfaceKey& key : kSurfaceKeys) {
    SurfaceValues values;
    for (const auto id : collisions) values.push_back(surface_value(draft.source, root[id], key));
    const auto first = std::find_if(values.begin(), values.end(),
                                    [](const auto& value) { return value.has_value(); });
    if (first == values.end()) continue;
    const bool agree = std::all_of(values.begin(), values.end(),
                                   [&](const auto& value) { return says_same(value, *first); });
    std::size_t count = 0;
    for (const auto& value : values) {
      if (!value) continue;
      draft.ledger.take_value(value->span, agree ? Outcome::kCarried : Outcome::kLost);
      ++count;
    }
    if (agree) {
      const std::string name(key.key);
      lines += '<' + name + '>' + std::string(read::trimmed((*first)->text)) + "</" + name + ">\n";
    } else {
      draft.ledger.note({.kind = NoteKind::kSurface,
                         .outcome = Outcome::kLost,
                         .where = (*first)->span,
                         .subject = subject(root, root[link]),
                         .written = listed(key.key, values),
                         .instead = {},
                         .count = count});
    }
  }
  return lines;
}

}  // namespace rigor::convert
