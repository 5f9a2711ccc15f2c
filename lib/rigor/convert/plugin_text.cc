// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/plugin_text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/convert/written_number.h>
#include <rigor/read/values.h>
#include <rigor/text/letter_case.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::convert {
namespace {

using model::Pose;
using model::Vector3;

/// Parameters whose value is the name of a link, as plugins of Gazebo Sim, Gazebo classic and
/// gazebo_ros call them.
constexpr std::string_view kLinkParameters[] = {
    "bodyName",    "body_name", "link_name", "linkName",  "link",        "parent_link",
    "comLinkName", "base_link", "body",      "palm_link", "gripper_link"};

/// Points and directions in the frame of the link that the plugin acts on.
constexpr std::string_view kPoints[] = {"cp"};
constexpr std::string_view kDirections[] = {"forward", "upward"};
constexpr std::string_view kOffset = "xyzOffset";
constexpr std::string_view kTurnOffset = "rpyOffset";

/// Systems whose scalars are along the axes of a link's frame.
constexpr std::string_view kInLinkAxes[] = {"hydrodynamics"};

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool names_joint(std::string_view parameter) {
  return lowered(parameter).find("joint") != std::string::npos;
}

std::string leaf_value(xml::Element element) { return std::string(read::trimmed(element.text())); }

std::optional<Vector3> vector_in(xml::Element element) {
  const auto numbers = write::numbers_in(element.text());
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return Vector3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

/// Computed numbers without the digits that rounding left.
std::string vector_text(const Vector3& v) {
  const double size = length(v);
  Number3 settled = numbers(v);
  for (Number& number : settled) number.value = write::settled(number.value, 0, size);
  return number_texts(settled);
}

class PluginRewriter {
 public:
  PluginRewriter(xml::Element plugin, const PluginNames& names) : plugin_(plugin), names_(names) {}

  PluginText rewrite(std::string_view own_link) && {
    find_frame(plugin_);
    if (frame_ == nullptr) {
      const auto found = names_.moved.find(own_link);
      if (found != names_.moved.end()) frame_ = &found->second;
    }
    visit(plugin_);
    if (frame_ != nullptr && !is_identity(frame_->X_NL)) finish_frame();
    return std::move(text_);
  }

 private:
  /// The first link of the plugin whose frame is elsewhere. Elements are as deep as the file.
  void find_frame(xml::Element element) {
    for (const xml::Element child : element.children()) {
      if (frame_ != nullptr) return;
      if (!child.children().empty()) {
        find_frame(child);
      } else if (is_one_of(kLinkParameters, child.name())) {
        const auto found = names_.moved.find(leaf_value(child));
        if (found != names_.moved.end()) {
          frame_ = &found->second;
          by_body_ = child.name() == "bodyName" || child.name() == "body_name";
        }
      }
    }
  }

  void visit(xml::Element element) {
    for (const xml::Element child : element.children()) {
      if (child.children().empty()) {
        leaf(child);
      } else {
        visit(child);
      }
    }
  }

  void leaf(xml::Element element) {
    const std::string value = leaf_value(element);
    if (value.empty()) return;
    if (const auto name = new_name(element.name(), value); name && *name != value) {
      replace(element, *name, PluginRemark::Kind::kRenamed);
    } else if (frame_ != nullptr && !is_identity(frame_->X_NL)) {
      in_frame(element);
    }
  }

  std::optional<std::string> new_name(std::string_view parameter, const std::string& value) const {
    const bool scoped = value.find("::") != std::string::npos;
    if (is_one_of(kLinkParameters, parameter) || scoped) {
      const auto moved = names_.moved.find(value);
      if (moved != names_.moved.end() && !scoped) return moved->second.link;
      if (const auto name = names_.links.find(value); name != names_.links.end()) {
        return name->second;
      }
    }
    if (names_joint(parameter) || scoped) {
      if (const auto name = names_.joints.find(value); name != names_.joints.end()) {
        return name->second;
      }
    }
    return std::nullopt;
  }

  void replace(xml::Element element, const std::string& text, PluginRemark::Kind kind) {
    if (kind == PluginRemark::Kind::kRewritten &&
        write::numbers_in(element.text()) == write::numbers_in(text)) {
      return;
    }
    text_.layout.replacements.push_back({element.text_span(), xml::escaped(text)});
    text_.remarks.push_back(
        {kind, element.text_span(), std::string(element.name()) + ' ' + leaf_value(element), text});
  }

  void in_frame(xml::Element element) {
    const Pose& X = frame_->X_NL;
    const std::string_view name = element.name();
    if (name == kOffset) {
      offset_ = element;
    } else if (name == kTurnOffset) {
      turn_offset_ = element;
    } else if (const auto v = vector_in(element); v && is_one_of(kPoints, name)) {
      replace(element, vector_text(transform(X, *v)), PluginRemark::Kind::kRewritten);
      has_point_ = true;
    } else if (v && is_one_of(kDirections, name)) {
      replace(element, vector_text(rotate(X.rotation, *v)), PluginRemark::Kind::kRewritten);
      has_direction_ = true;
    } else if (const auto all = write::numbers_in(element.text()); all && all->size() >= 3) {
      left(element.text_span(), std::string(name) + ' ' + leaf_value(element));
    }
  }

  void left(Span where, std::string written) {
    text_.remarks.push_back(
        {PluginRemark::Kind::kLeftInFrame, where, std::move(written), frame_->link});
  }

  void finish_frame() {
    const Pose& X = frame_->X_NL;
    if (by_body_ || offset_ || turn_offset_) {
      const Vector3 at = offset_ ? vector_in(*offset_).value_or(Vector3{}) : Vector3{};
      const Vector3 rpy = turn_offset_ ? vector_in(*turn_offset_).value_or(Vector3{}) : Vector3{};
      const UrdfOrigin origin =
          origin_of(compose(X, Pose{at, model::from_rpy(rpy.x, rpy.y, rpy.z)}));
      put(offset_, kOffset, number_texts(origin.xyz));
      put(turn_offset_, kTurnOffset, number_texts(origin.rpy));
    }
    // The defaults of LiftDrag's: at the origin, forward along x, upward along z.
    if (!is_lift_drag()) {
      const auto filename = plugin_.attribute("filename");
      const std::string library = lowered(filename ? filename->value() : std::string_view());
      for (const std::string_view system : kInLinkAxes) {
        if (library.find(system) != std::string::npos) left(plugin_.name_span(), library);
      }
      return;
    }
    if (!has_point_) text_.layout.added.push_back("<cp>" + vector_text(X.translation) + "</cp>");
    if (has_direction_) return;
    const auto add = [&](const char* name, const Vector3& v) {
      text_.layout.added.push_back('<' + std::string(name) + '>' +
                                   vector_text(rotate(X.rotation, v)) + "</" + name + '>');
    };
    add("forward", {1, 0, 0});
    add("upward", {0, 0, 1});
  }

  bool is_lift_drag() const {
    for (const char* attribute : {"filename", "name"}) {
      const auto value = plugin_.attribute(attribute);
      std::string word = lowered(value ? value->value() : std::string_view());
      std::erase_if(word, [](char c) { return c == '-' || c == '_'; });
      if (word.find("liftdrag") != std::string::npos) return true;
    }
    return false;
  }

  void put(const std::optional<xml::Element>& element, std::string_view name,
           const std::string& text) {
    if (element) {
      if (leaf_value(*element) != text) replace(*element, text, PluginRemark::Kind::kRewritten);
      return;
    }
    const std::string tag(name);
    text_.layout.added.push_back('<' + tag + '>' + text + "</" + tag + '>');
  }

  xml::Element plugin_;
  const PluginNames& names_;
  PluginText text_;
  const PluginNames::Moved* frame_ = nullptr;
  std::optional<xml::Element> offset_, turn_offset_;
  bool by_body_ = false, has_point_ = false, has_direction_ = false;
};

/// Elements are as deep as the file, at most xml::kMaxDepth.
void drop_scopes(xml::Element element, LayoutChanges& changes) {
  if (element.name() == "plugin" || element.name().find(':') != std::string_view::npos) return;
  if (const auto name = element.attribute("name")) {
    const std::string plain = without_scope(name->value());
    if (plain != name->value()) {
      changes.replacements.push_back({name->value_span(), xml::escaped(plain)});
    }
  }
  for (const xml::Element child : element.children()) drop_scopes(child, changes);
}

}  // namespace

PluginText plugin_text(xml::Element plugin, const PluginNames& names, std::string_view own_link) {
  return PluginRewriter(plugin, names).rewrite(own_link);
}

LayoutChanges without_scopes(xml::Element element) {
  LayoutChanges changes;
  drop_scopes(element, changes);
  return changes;
}

std::string without_scope(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool scope = name.substr(i, 2) == "::";
    plain += scope ? "__" : std::string(1, name[i]);
    if (scope) ++i;
  }
  return plain;
}

}  // namespace rigor::convert
