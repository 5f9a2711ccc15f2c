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
/// Of Gazebo classic's BuoyancyPlugin: "in the link frame" (BuoyancyPlugin.hh).
constexpr std::string_view kCenterOfVolume = "center_of_volume";

/// Systems whose scalars are along the axes of a link's frame.
constexpr std::string_view kInLinkAxes[] = {"hydrodynamics"};

/// In names of parameters whose text is no link, though it may equal the name of one.
constexpr std::string_view kNamesOfOthers[] = {"joint", "topic", "namespace", "service", "model"};

/// In names of parameters for joints whose text is no joint: `joint_topic`.
constexpr std::string_view kNamesBesideJoints[] = {"topic", "namespace", "service"};

/// In names of parameters whose numbers are in no frame.
constexpr std::string_view kFrameless[] = {"color", "ambient", "diffuse", "specular", "emissive"};

constexpr std::string_view kScope = "::";

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool names_joint(std::string_view parameter) {
  return lowered(parameter).find("joint") != std::string::npos;
}

template <class Words>
bool has_one_of(std::string_view name, const Words& words) {
  const std::string low = lowered(name);
  return std::any_of(std::begin(words), std::end(words),
                     [&low](std::string_view word) { return low.find(word) != std::string::npos; });
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
  PluginRewriter(xml::Element plugin, const PluginNames& names, const PluginPlace& place)
      : plugin_(plugin), names_(names), place_(place) {}

  PluginText rewrite() && {
    FrameScope around;
    if (const auto found = names_.moved.find(place_.link);
        found != names_.moved.end() && !is_identity(found->second.X_NL)) {
      around = {true, false, &found->second, &found->second};
    }
    const FrameScope scope = scope_of(plugin_, around);
    anywhere_ = scope.any;
    if (anywhere_ == nullptr) find_anywhere(plugin_);
    visit(plugin_, scope);
    if (scope.acting != nullptr) add_defaults(*scope.acting);
    warn_of_axes(scope);
    return std::move(text_);
  }

 private:
  using Moved = PluginNames::Moved;

  /// What parameters that are side by side say of the link in whose frame those beside them are.
  struct FrameScope {
    bool is_named = false;          ///< a parameter for links names one
    bool by_body = false;           ///< that is `bodyName`
    const Moved* acting = nullptr;  ///< the first that is named so, if its frame moved
    const Moved* any = nullptr;     ///< one whose frame moved and that is named in whatever way
  };
  struct Offsets {
    std::optional<xml::Element> at, turn;
  };

  // --- Names ---

  /// What a text may mean, in the order in which Gazebo looks for it: inside the plugin's own model,
  /// inside the model that is converted, or with that model's name in front, which stays.
  struct Reading {
    std::string front, name;
  };
  std::vector<Reading> readings(const std::string& value) const {
    std::vector<Reading> all;
    if (!place_.model.empty()) {
      all.push_back({{}, std::string(place_.model) + std::string(kScope) + value});
    }
    all.push_back({{}, value});
    if (names_.model.empty()) return all;
    const std::string front = names_.model + std::string(kScope);
    const std::size_t at = value.find(front);
    const bool is_front =
        at == 0 || (at != std::string::npos && at >= kScope.size() &&
                    value.compare(at - kScope.size(), kScope.size(), kScope) == 0);
    if (is_front) {
      const std::size_t end = at + front.size();
      all.push_back({value.substr(0, end), value.substr(end)});
    }
    return all;
  }

  const Moved* moved_by(const std::string& value) const {
    for (const Reading& reading : readings(value)) {
      const auto found = names_.moved.find(reading.name);
      if (found == names_.moved.end()) continue;
      return is_identity(found->second.X_NL) ? nullptr : &found->second;
    }
    return nullptr;
  }

  std::optional<std::string> new_name(std::string_view parameter, const std::string& value) const {
    const bool scoped = value.find(kScope) != std::string::npos;
    const bool is_link = is_one_of(kLinkParameters, parameter) || scoped;
    const bool is_joint = names_joint(parameter) || scoped;
    for (const auto& [front, name] : readings(value)) {
      if (is_link) {
        // A name that holds `::` itself is not looked for among frames.
        const auto moved = names_.moved.find(name);
        if (moved != names_.moved.end() && (!scoped || !front.empty())) {
          return front + moved->second.link;
        }
        const auto link = names_.links.find(name);
        if (link != names_.links.end()) return front + link->second;
      }
      if (is_joint) {
        const auto joint = names_.joints.find(name);
        if (joint != names_.joints.end()) return front + joint->second;
      }
    }
    return std::nullopt;
  }

  /// Those of the joints that a parameter names which the result lacks: "hinge, wrist".
  std::string lost_joints_in(std::string_view parameter, const std::string& value) const {
    std::string lost;
    if (names_.lost_joints.empty() || !names_joint(parameter)) return lost;
    if (has_one_of(parameter, kNamesBesideJoints)) return lost;
    constexpr std::string_view kBetween = ", \t\r\n";
    std::size_t end = 0;
    for (std::size_t at = value.find_first_not_of(kBetween); at != std::string::npos;
         at = value.find_first_not_of(kBetween, end)) {
      end = std::min(value.find_first_of(kBetween, at), value.size());
      const std::string name = value.substr(at, end - at);
      if (is_lost_joint(name)) lost += (lost.empty() ? "" : ", ") + name;
    }
    return lost;
  }

  bool is_lost_joint(const std::string& value) const {
    const std::vector<Reading> all = readings(value);
    return std::any_of(all.begin(), all.end(), [&](const Reading& reading) {
      return names_.lost_joints.contains(reading.name);
    });
  }

  /// Whether that is so; the text stays as it is then.
  bool tell_lost_joints(std::string_view parameter, const std::string& value, Span where) {
    std::string lost = lost_joints_in(parameter, value);
    if (lost.empty()) return false;
    text_.remarks.push_back({PluginRemark::Kind::kNoJoint, where, std::move(lost), {}});
    return true;
  }

  /// `<link name='wing'>` and `<link><name>wing</name></link>` name a link as `<link>wing</link>` does.
  static std::string_view parameter_of(std::string_view name, xml::Element owner) {
    return name == "name" ? owner.name() : name;
  }

  /// Calls with the name and the value of each parameter that is an attribute.
  template <class Use>
  void each_attribute(xml::Element element, const Use& use) const {
    if (element == plugin_) return;  // its name and its file
    for (const xml::Attribute attribute : element.attributes()) {
      use(parameter_of(attribute.name(), element), attribute);
    }
  }

  // --- Frames ---

  FrameScope scope_of(xml::Element element, const FrameScope& outer) const {
    FrameScope own;
    const Moved* framed = nullptr;
    const auto consider = [&](std::string_view parameter, const std::string& value, bool acts) {
      if (value.empty()) return;
      const Moved* moved = moved_by(value);
      if (acts && !own.is_named && is_one_of(kLinkParameters, parameter)) {
        const bool by_body = parameter == "bodyName" || parameter == "body_name";
        own = {true, by_body, moved, own.any};
      }
      if (moved == nullptr || has_one_of(parameter, kNamesOfOthers)) return;
      const bool is_frame = lowered(parameter).find("frame") != std::string::npos;
      if (const Moved*& found = is_frame ? framed : own.any; found == nullptr) found = moved;
    };
    const auto of_attributes = [&](xml::Element one, bool acts) {
      each_attribute(one, [&](std::string_view parameter, xml::Attribute attribute) {
        consider(parameter, std::string(read::trimmed(attribute.value())), acts);
      });
    };
    of_attributes(element, true);
    for (const xml::Element child : element.children()) {
      if (!child.children().empty()) continue;
      consider(parameter_of(child.name(), element), leaf_value(child), true);
      of_attributes(child, false);
    }
    // A frame that results are told in is not the link's that the plugin acts on.
    if (!own.is_named && own.any == nullptr) own.any = framed;
    if (own.is_named) return own;
    return {outer.is_named, outer.by_body, outer.acting, own.any != nullptr ? own.any : outer.any};
  }

  /// For numbers that stand apart from the name. Elements are as deep as the file.
  void find_anywhere(xml::Element element) {
    for (const xml::Element child : element.children()) {
      if (anywhere_ != nullptr) return;
      if (child.children().empty()) continue;
      anywhere_ = scope_of(child, {}).any;
      if (anywhere_ == nullptr) find_anywhere(child);
    }
  }

  /// The link in whose frame numbers may be that no parameter is known to mean.
  const Moved* may_be_in(const FrameScope& scope) const {
    if (scope.acting != nullptr) return scope.acting;
    if (scope.any != nullptr) return scope.any;
    return scope.is_named ? nullptr : anywhere_;
  }

  void visit(xml::Element element, const FrameScope& scope) {
    Offsets offsets;
    attributes(element, scope);
    for (const xml::Element child : element.children()) {
      const FrameScope inner = scope_of(child, scope);
      if (!child.children().empty()) {
        visit(child, inner);
        continue;
      }
      attributes(child, inner);
      leaf(child, parameter_of(child.name(), element), scope, offsets);
    }
    finish_offsets(element, scope, offsets);
  }

  void attributes(xml::Element element, const FrameScope& scope) {
    each_attribute(element, [&](std::string_view parameter, xml::Attribute attribute) {
      const std::string value(read::trimmed(attribute.value()));
      if (tell_lost_joints(parameter, value, attribute.value_span())) return;
      if (const auto name = new_name(parameter, value); name && *name != value) {
        text_.layout.replacements.push_back({attribute.value_span(), xml::escaped(*name)});
        text_.remarks.push_back({PluginRemark::Kind::kRenamed, attribute.value_span(),
                                 std::string(parameter) + ' ' + value, *name});
      } else {
        leave_if_numbers(attribute.name(), value, attribute.value_span(), may_be_in(scope));
      }
    });
  }

  void leaf(xml::Element element, std::string_view parameter, const FrameScope& scope,
            Offsets& offsets) {
    const std::string value = leaf_value(element);
    if (value.empty() || tell_lost_joints(parameter, value, element.text_span())) return;
    if (const auto name = new_name(parameter, value); name && *name != value) {
      replace(element, *name, PluginRemark::Kind::kRenamed);
    } else {
      in_frame(element, scope, offsets);
    }
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

  bool is_point(std::string_view name) const {
    return is_one_of(kPoints, name) || (name == kCenterOfVolume && is_called("buoyancy"));
  }

  void in_frame(xml::Element element, const FrameScope& scope, Offsets& offsets) {
    const std::string_view name = element.name();
    std::optional<xml::Element>* offset = name == kOffset       ? &offsets.at
                                          : name == kTurnOffset ? &offsets.turn
                                                                : nullptr;
    const bool is_known = offset != nullptr || is_point(name) || is_one_of(kDirections, name);
    if (element.parent() == plugin_) written_.push_back(name);
    const auto v = vector_in(element);
    if (is_known && scope.is_named && scope.acting == nullptr)
      return;  // of a link that did not move
    if (is_known && v && scope.acting != nullptr) {
      const Pose& X = scope.acting->X_NL;
      if (offset != nullptr) {
        if (!*offset) *offset = element;
      } else {
        const Vector3 there = is_point(name) ? transform(X, *v) : rotate(X.rotation, *v);
        replace(element, vector_text(there), PluginRemark::Kind::kRewritten);
      }
      return;
    }
    const bool is_unread = is_known && is_called("liftdrag") && scope.acting != nullptr;
    if (is_unread) {
      left(element.text_span(), std::string(name) + ' ' + leaf_value(element), *scope.acting);
    } else {
      leave_if_numbers(name, leaf_value(element), element.text_span(), may_be_in(scope));
    }
  }

  void leave_if_numbers(std::string_view name, const std::string& value, Span where,
                        const Moved* moved) {
    if (moved == nullptr || has_one_of(name, kFrameless)) return;
    const auto all = write::numbers_in(value);
    if (all && all->size() >= 3) left(where, std::string(name) + ' ' + value, *moved);
  }

  void left(Span where, std::string written, const Moved& moved) {
    text_.remarks.push_back(
        {PluginRemark::Kind::kLeftInFrame, where, std::move(written), moved.link});
  }

  void finish_offsets(xml::Element element, const FrameScope& scope, const Offsets& offsets) {
    if (scope.acting == nullptr) return;
    const bool is_plugin = element == plugin_;
    if (!offsets.at && !offsets.turn && !(scope.by_body && is_plugin)) return;
    const Vector3 at = offsets.at ? vector_in(*offsets.at).value_or(Vector3{}) : Vector3{};
    const Vector3 rpy = offsets.turn ? vector_in(*offsets.turn).value_or(Vector3{}) : Vector3{};
    const UrdfOrigin origin =
        origin_of(compose(scope.acting->X_NL, Pose{at, model::from_rpy(rpy.x, rpy.y, rpy.z)}));
    const auto put = [&](const std::optional<xml::Element>& one, std::string_view name,
                         const std::string& text, bool is_zero) {
      const std::string tag(name);
      if (one) {
        if (leaf_value(*one) != text) replace(*one, text, PluginRemark::Kind::kRewritten);
      } else if (is_plugin) {
        text_.layout.added.push_back('<' + tag + '>' + text + "</" + tag + '>');
      } else if (!is_zero) {
        left(element.name_span(), std::string(element.name()) + " without " + tag, *scope.acting);
      }
    };
    const auto is_zero = [](const Number3& three) {
      return std::all_of(three.begin(), three.end(),
                         [](const Number& number) { return number.value == 0; });
    };
    put(offsets.at, kOffset, number_texts(origin.xyz), is_zero(origin.xyz));
    put(offsets.turn, kTurnOffset, number_texts(origin.rpy), is_zero(origin.rpy));
  }

  /// What LiftDrag takes where nothing is written: at the origin, forward along x, upward along z.
  void add_defaults(const Moved& moved) {
    if (!is_called("liftdrag")) return;
    const auto add = [this](std::string_view name, const Vector3& v) {
      if (std::find(written_.begin(), written_.end(), name) != written_.end()) return;
      const std::string tag(name);
      text_.layout.added.push_back('<' + tag + '>' + vector_text(v) + "</" + tag + '>');
    };
    add("cp", moved.X_NL.translation);
    add("forward", rotate(moved.X_NL.rotation, {1, 0, 0}));
    add("upward", rotate(moved.X_NL.rotation, {0, 0, 1}));
  }

  void warn_of_axes(const FrameScope& scope) {
    const Moved* moved = may_be_in(scope);
    if (moved == nullptr || is_called("liftdrag")) return;
    const auto filename = plugin_.attribute("filename");
    const std::string library = lowered(filename ? filename->value() : std::string_view());
    for (const std::string_view system : kInLinkAxes) {
      if (library.find(system) != std::string::npos) left(plugin_.name_span(), library, *moved);
    }
  }

  /// `word` without hyphens and underscores.
  bool is_called(std::string_view word) const {
    for (const char* attribute : {"filename", "name"}) {
      const auto value = plugin_.attribute(attribute);
      std::string text = lowered(value ? value->value() : std::string_view());
      std::erase_if(text, [](char c) { return c == '-' || c == '_'; });
      if (text.find(word) != std::string::npos) return true;
    }
    return false;
  }

  xml::Element plugin_;
  const PluginNames& names_;
  const PluginPlace& place_;
  PluginText text_;
  const Moved* anywhere_ = nullptr;        // the first whose frame moved
  std::vector<std::string_view> written_;  // parameters of the plugin that have a value
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

PluginText plugin_text(xml::Element plugin, const PluginNames& names, const PluginPlace& place) {
  return PluginRewriter(plugin, names, place).rewrite();
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
