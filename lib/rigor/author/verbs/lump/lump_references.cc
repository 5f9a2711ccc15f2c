// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/lump/lump_references.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/read/values.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

constexpr int kFirstThatKeepsNames = 7;  // as those of frames

/// Elements whose names of links and joints are rewritten, or mean frames.
constexpr std::string_view kRewritten[] = {"pose",  "parent", "child", "xyz",
                                           "frame", "gazebo", "model"};

bool is_rewritten(xml::Element element) {
  return std::find(std::begin(kRewritten), std::end(kRewritten), element.name()) !=
         std::end(kRewritten);
}

bool is_in_plugin(xml::Element element) {
  for (std::optional<xml::Element> at = element; at; at = at->parent()) {
    if (at->name() == "plugin") return true;
  }
  return false;
}

class LeftNames {
 public:
  LeftNames(const EditedModel& edited, const HeldBy& held_by, const std::set<std::string>& joints)
      : edited_(edited),
        held_by_(held_by),
        joints_(joints),
        graph_(edited.workspace, edited.environment.resolver) {}

  std::vector<std::string> list() {
    find_uses();
    find_texts();
    std::vector<std::string> lines;
    for (auto& [offset, line] : lines_) lines.push_back(std::move(line));
    return lines;
  }

 private:
  /// "link hand, which is part of arm now"; empty of what stays.
  std::string what_became(const NamedEntity& entity) const {
    const auto is_it = [&](const model::Site& site) {
      return site.span.begin == entity.element.begin;
    };
    if (entity.kind == NameKind::kLink) {
      const auto held = held_by_.find(entity.name);
      if (held != held_by_.end() && is_it(edited_.root()[edited_.link(held->first)].site))
        return became_part(held->first, held->second);
    }
    if (entity.kind == NameKind::kJoint && joints_.contains(entity.name) &&
        is_it(edited_.root()[edited_.joint(entity.name)].site))
      return became_nothing(entity.name);
    return {};
  }
  static std::string became_part(const std::string& link, const std::string& holder) {
    return fmt::format("link {}, which is part of {} now", link, holder);
  }
  static std::string became_nothing(const std::string& joint) {
    return fmt::format("joint {}, which is gone", joint);
  }

  void find_uses() {
    graph_.add_robot(edited_.path());
    const std::string path = normalize_path(edited_.path());
    for (const NameUse& use : graph_.uses(edited_.path())) {
      if (use.defines || use.target.path != path) continue;
      const std::string what = what_became(graph_.entity(use.target));
      const auto element = edited_.document().element_at(use.where.begin);
      if (what.empty() || !element) continue;
      const bool in_plugin = is_in_plugin(*element);
      if (!in_plugin && is_rewritten(*element)) continue;
      note(
          *element,
          (in_plugin ? "a plugin names " : "<" + std::string(element->name()) + "> names ") + what);
    }
  }

  /// Texts that are such a name, in plugins; before there were frames of those names, anywhere.
  void find_texts() {
    const model::Model& model = edited_.root()[edited_.model];
    const bool anywhere = !edited_.is_urdf() && model.version < kFirstThatKeepsNames;
    for (std::uint32_t i = 0; i < edited_.document().element_count(); ++i) {
      const xml::Element element = edited_.document().element(i);
      const std::string text(read::trimmed(element.text()));
      if (text.empty()) continue;
      const auto held = held_by_.find(text);
      if (held == held_by_.end() && !joints_.contains(text)) continue;
      const bool in_plugin = is_in_plugin(element);
      if (!in_plugin && (!anywhere || is_rewritten(element))) continue;
      note(element, fmt::format("<{}> may still name {}", element.name(),
                                held == held_by_.end() ? became_nothing(text)
                                                       : became_part(text, held->second)));
    }
  }

  /// One of an element.
  void note(xml::Element element, const std::string& text) {
    const Span tag = element.tag_span();
    lines_.emplace(tag.begin,
                   fmt::format("{}:{}: {}", edited_.path(),
                               edited_.sources.position(tag.source, tag.begin).line, text));
  }

  const EditedModel& edited_;
  const HeldBy& held_by_;
  const std::set<std::string>& joints_;
  NameGraph graph_;
  std::map<std::uint32_t, std::string> lines_;  ///< by the offset of the element
};

}  // namespace

std::vector<std::string> names_left(const EditedModel& edited, const HeldBy& held_by,
                                    const std::set<std::string>& joints) {
  return LeftNames(edited, held_by, joints).list();
}

}  // namespace rigor::author
