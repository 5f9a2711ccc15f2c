// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/lump/link_settings.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>

namespace rigor::author {
namespace {

using model::Id;

constexpr std::string_view kMovableParts[] = {
    "collision", "visual",       "sensor",     "light",   "particle_emitter",
    "projector", "audio_source", "audio_sink", "battery", "plugin"};

/// Of an SDF link, with what it is where nothing is written.
constexpr std::pair<std::string_view, std::string_view> kLinkSettings[] = {
    {"gravity", "true"},
    {"enable_wind", "false"},
    {"self_collide", "false"},
    {"kinematic", "false"},
    {"must_be_base_link", "false"},
    {"velocity_decay/linear", "0"},
    {"velocity_decay/angular", "0"}};
/// Those that a link has of its model.
constexpr std::string_view kModelSettings[] = {"enable_wind", "self_collide"};

/// What a key of a `<gazebo reference>` is about, as libsdformat applies it.
enum class About : std::uint8_t { kCollisions, kVisuals, kLink };
constexpr std::string_view kCollisionKeys[] = {"mu",          "mu1",        "mu2",      "fdir1",
                                               "kp",          "kd",         "minDepth", "maxVel",
                                               "maxContacts", "laserRetro", "collision"};
constexpr std::string_view kVisualKeys[] = {"material", "visual"};
/// Keys of the link, with what says as much as nothing.
constexpr std::pair<std::string_view, std::string_view> kImpliedKeys[] = {
    {"gravity", "true"},     {"turnGravityOff", "false"}, {"selfCollide", "false"},
    {"dampingFactor", "0"},  {"kinematic", "false"},      {"self_collide", "false"},
    {"enable_wind", "false"}};

template <std::size_t Count>
bool is_among(std::string_view name, const std::string_view (&names)[Count]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

About about_key(std::string_view key) {
  if (is_among(key, kCollisionKeys)) return About::kCollisions;
  return is_among(key, kVisualKeys) ? About::kVisuals : About::kLink;
}

/// A number or a bool in one of its spellings.
std::string canonical_text(std::string_view text) {
  const std::string trimmed(read::trimmed(text));
  if (const auto number = write::number_in(trimmed)) return schema::to_shortest(*number);
  const auto parsed = schema::parse_bool(trimmed);
  const bool* const value = std::get_if<bool>(&parsed);
  return value == nullptr ? trimmed : *value ? "true" : "false";
}

/// "1" is a bool as well as a number.
std::string canonical_text(std::string_view text, std::string_view like) {
  const auto parsed = schema::parse_bool(read::trimmed(text));
  const bool* const value = std::get_if<bool>(&parsed);
  if (value != nullptr && (like == "true" || like == "false")) return *value ? "true" : "false";
  return canonical_text(text);
}

using Said = std::map<std::string, std::string, std::less<>>;  ///< by key, as canonical text

class SettingJudge {
 public:
  SettingJudge(const EditedModel& edited, const HeldBy& held_by,
               const std::set<std::string>& joints)
      : edited_(edited), root_(edited.root()), held_by_(held_by), joints_(joints) {}

  std::string fault() const {
    for (const std::string& joint : joints_) {
      if (std::string fault = fault_of_joint(joint); !fault.empty()) return fault;
    }
    for (const auto& [link, holder] : held_by_) {
      if (std::string fault = fault_of_content(link); !fault.empty()) return fault;
      std::string fault =
          edited_.is_urdf() ? fault_of_blocks(link, holder) : fault_of_link(link, holder);
      if (!fault.empty()) return fault;
    }
    return {};
  }

  void move_blocks(Draft& draft) const {
    std::map<std::string, Said> said;
    for (const auto& [link, holder] : held_by_) said.emplace(holder, all_keys(holder));
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const std::string& name = block.reference.value;
      if (const auto held = held_by_.find(name); held != held_by_.end()) {
        move_block(draft, block, held->second, said[held->second]);
      } else if (joints_.contains(name)) {
        draft.remove(edited_.element(block.site));
      }
    }
  }

 private:
  xml::Element element_of(const std::string& link) const {
    return edited_.element(root_[edited_.link(link)].site);
  }

  std::string place(xml::Element element) const {
    const Span tag = element.tag_span();
    return fmt::format("line {}", edited_.sources.position(tag.source, tag.begin).line);
  }

  // --- What has no place in another link ---

  static std::string name_of(xml::Element element) {
    const auto name = element.attribute("name");
    return std::string(element.name()) +
           (name ? " '" + std::string(name->value()) + '\'' : std::string());
  }

  std::string fault_of_joint(const std::string& joint) const {
    std::vector<xml::Element> holders;
    if (!edited_.is_urdf()) holders.push_back(edited_.element(root_[edited_.joint(joint)].site));
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const std::string& name = block.reference.value;
      if (name == joint && !edited_.link(name)) holders.push_back(edited_.element(block.site));
    }
    for (const xml::Element holder : holders) {
      for (const xml::Element child : holder.children()) {
        if (child.name() == "sensor" || child.name() == "plugin")
          return fmt::format("{}: {} is on joint '{}', which would go", place(child),
                             name_of(child), joint);
      }
    }
    return {};
  }

  std::string fault_of_content(const std::string& link) const {
    for (const xml::Element child : element_of(link).children()) {
      const std::string_view name = child.name();
      if (name == "inertial" && child.child("fluid_added_mass"))
        return fmt::format("{}: the <fluid_added_mass> of link '{}' would be lost", place(child),
                           link);
      const bool is_known = name == "inertial" || is_movable_part(name) ||
                            (!edited_.is_urdf() && (name == "pose" || is_link_setting(name)));
      if (!is_known)
        return fmt::format("{}: <{}> of link '{}' would be lost", place(child), name, link);
    }
    return {};
  }

  // --- SDF ---

  std::string setting(xml::Element element, std::string_view path) const {
    std::optional<xml::Element> at = element;
    for (std::size_t begin = 0; at && begin < path.size();) {
      const std::size_t end = std::min(path.find('/', begin), path.size());
      at = at->child(path.substr(begin, end - begin));
      begin = end + 1;
    }
    return at ? std::string(at->text()) : std::string();
  }

  std::string effective(const std::string& link, std::string_view path,
                        std::string_view absent) const {
    std::string text = setting(element_of(link), path);
    if (text.empty() && is_among(path, kModelSettings))
      text = setting(edited_.element(root_[edited_.model].site), path);
    return text.empty() ? std::string(absent) : canonical_text(text, absent);
  }

  std::string fault_of_link(const std::string& link, const std::string& holder) const {
    for (const auto& [path, absent] : kLinkSettings) {
      const std::string own = effective(link, path, absent);
      const std::string other = effective(holder, path, absent);
      if (own != other)
        return fmt::format("<{}> of link '{}' is {}, of link '{}' {}: as one they would share it",
                           path, link, own, holder, other);
    }
    return {};
  }

  // --- Blocks of URDF ---

  bool has(const std::string& link, About what) const {
    const model::Link& it = root_[edited_.link(link)];
    return what == About::kCollisions ? !it.collisions.empty()
           : what == About::kVisuals  ? !it.visuals.empty()
                                      : true;
  }

  bool has_any(const std::string& holder, About what) const {
    return has(holder, what) ||
           std::any_of(held_by_.begin(), held_by_.end(), [&](const auto& held) {
             return held.second == holder && has(held.first, what);
           });
  }

  std::string value_of(xml::Element key) const {
    if (const auto value = key.attribute("value")) return canonical_text(value->value());
    if (key.children().empty()) return canonical_text(key.text());
    return std::string(edited_.sources.bytes(key.span()));
  }

  static bool is_implied_key(std::string_view name, const std::string& value) {
    return std::any_of(std::begin(kImpliedKeys), std::end(kImpliedKeys), [&](const auto& each) {
      return each.first == name && canonical_text(value, each.second) == each.second;
    });
  }

  Said all_keys(const std::string& link) const {
    Said said;
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      if (block.reference.value != link) continue;
      for (const xml::Element child : edited_.element(block.site).children()) {
        const std::string name(child.name());
        if (!is_block_setting(name)) continue;
        std::string value = value_of(child);
        if (is_implied_key(name, value)) continue;
        std::string& all = said[name];
        all += (all.empty() ? "" : "\n") + value;
      }
    }
    return said;
  }

  Said keys(const std::string& link, About what) const {
    Said said = all_keys(link);
    std::erase_if(said, [&](const auto& each) { return about_key(each.first) != what; });
    return said;
  }

  /// Shapes of both, or of one where the other's word would be about them now.
  std::string fault_of_blocks(const std::string& link, const std::string& holder) const {
    for (const About what : {About::kCollisions, About::kVisuals, About::kLink}) {
      if (!has(link, what)) continue;
      for (const std::string& other : shapes_beside(link, holder, what)) {
        const Said own = keys(link, what), others = keys(other, what);
        if (std::string fault = difference(link, own, other, others); !fault.empty()) return fault;
      }
    }
    return {};
  }

  /// The links that would be one with it and have shapes, too, and the holder where it says something.
  std::vector<std::string> shapes_beside(const std::string& link, const std::string& holder,
                                         About what) const {
    std::vector<std::string> others;
    if (has(holder, what) || !keys(holder, what).empty()) others.push_back(holder);
    for (const auto& [other, by] : held_by_) {
      if (by == holder && other != link && has(other, what)) others.push_back(other);
    }
    return others;
  }

  static std::string difference(const std::string& a, const Said& of_a, const std::string& b,
                                const Said& of_b) {
    Said all = of_a;
    all.insert(of_b.begin(), of_b.end());
    for (const auto& [key, unused] : all) {
      const auto in_a = of_a.find(key), in_b = of_b.find(key);
      if (in_a != of_a.end() && in_b != of_b.end() && in_a->second == in_b->second) continue;
      const auto words = [&](const Said& said, Said::const_iterator at) {
        const bool is_short = at != said.end() && at->second.find('<') == std::string::npos;
        return at == said.end() ? "not given" : is_short ? at->second : std::string("another");
      };
      return fmt::format(
          "<{}> in <gazebo> is {} for link '{}' and {} for link '{}': as one they would share it",
          key, words(of_a, in_a), a, words(of_b, in_b), b);
    }
    return {};
  }

  /// `said` is what the holder says already, and then what of this block it does, too.
  void move_block(Draft& draft, const model::GazeboBlock& block, const std::string& holder,
                  Said& said) const {
    const xml::Element element = edited_.element(block.site);
    const std::string& link = block.reference.value;
    std::vector<xml::Element> dropped;
    std::size_t count = 0;
    Said added;
    for (const xml::Element child : element.children()) {
      ++count;
      const std::string name(child.name());
      const About what = about_key(name);
      if (!is_block_setting(name)) continue;
      const bool is_idle = !has(link, what) && has_any(holder, what);
      if (is_idle || said.contains(name))
        dropped.push_back(child);
      else
        added.emplace(name, value_of(child));
    }
    said.insert(added.begin(), added.end());
    if (count > 0 && dropped.size() == count) return draft.remove(element);
    for (const xml::Element child : dropped) draft.remove(child);
    draft.add({{block.reference.span, xml::escaped(holder)}});
  }

  const EditedModel& edited_;
  const model::Root& root_;
  const HeldBy& held_by_;
  const std::set<std::string>& joints_;
};

}  // namespace

bool is_movable_part(std::string_view element) { return is_among(element, kMovableParts); }

bool is_link_setting(std::string_view element) {
  return std::any_of(std::begin(kLinkSettings), std::end(kLinkSettings), [&](const auto& each) {
    return each.first.substr(0, each.first.find('/')) == element;
  });
}

bool is_block_setting(std::string_view key) {
  return !is_movable_part(key) || about_key(key) != About::kLink;
}

std::string fault_of_settings(const EditedModel& edited, const HeldBy& held_by,
                              const std::set<std::string>& joints) {
  return SettingJudge(edited, held_by, joints).fault();
}

void move_blocks(Draft& draft, const EditedModel& edited, const HeldBy& held_by,
                 const std::set<std::string>& joints) {
  SettingJudge(edited, held_by, joints).move_blocks(draft);
}

}  // namespace rigor::author
