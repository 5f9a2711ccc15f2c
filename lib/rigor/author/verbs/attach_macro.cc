// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/attach_macro.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rigor/author/verbs/block.h>
#include <rigor/text/path.h>
#include <rigor/xacro/scope.h>
#include <rigor/xml/document.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Pose;

constexpr std::uint64_t kMaxMacroFile = std::uint64_t{16} << 20U;

/// What macros of public grippers and sensors call the link that they are mounted on, and what is put before names.
constexpr std::array<std::string_view, 9> kParents{"parent",       "parent_link", "parent_name",
                                                   "connected_to", "attach_to",   "attach_link",
                                                   "mount_link",   "base_parent", "parent_frame"};
constexpr std::array<std::string_view, 4> kPrefixes{"prefix", "tf_prefix", "ns", "name_prefix"};

template <std::size_t N>
bool is_named_as(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct MacroDefinition {
  std::string name;
  std::vector<xacro::MacroParameter> parameters;
};

class MacroAttacher {
 public:
  MacroAttacher(ModelReader& reader, const EditedModel& arm, std::string tool,
                const MacroRequest& request)
      : reader_(reader), arm_(arm), tool_(std::move(tool)), request_(request) {}

  Change attach() {
    const AttachRequest& asked = request_.attach;
    if (!arm_.loaded.file->expanded || !arm_.is_urdf())
      return refusal(tool_ + " is no robot by itself, and only a template can call its macro");
    if (arm_.body_index(asked.link) == robot::kNoIndex)
      return refusal(fmt::format("no link is named '{}'", asked.link));
    if (asked.joint != AttachJoint::kFixed || !asked.frame.empty() || !asked.tool_frame.empty())
      return refusal("a macro makes its joint itself: --joint and frames have no place in a call");
    for (const auto step : {&MacroAttacher::find_macro, &MacroAttacher::make_call,
                            &MacroAttacher::make_alone, &MacroAttacher::fault_of_names}) {
      if (std::string fault = (this->*step)(); !fault.empty()) return refusal(std::move(fault));
    }
    const std::string in = child_indentation(arm_.document(), holder());
    std::string text;
    for (const std::string& line : lines_) text += in + line + line_end();
    const auto block = block_in_template(arm_, trimmed_lines(std::move(text)));
    if (!block) return refusal("its file has no content to add to");
    Change change;
    change.steps.push_back({*block});
    change.expected = joined();
    change.asks_for_setting = [](const robot::Difference& difference) {
      return difference.a.empty() || difference.kind == robot::DifferenceKind::kAttachmentOnlyInB;
    };
    return change;
  }

 private:
  xml::Element holder() const { return arm_.element(arm_.root()[arm_.model].site); }
  std::string line_end() const { return std::string(xml::line_end(arm_.document(), 0)); }

  std::string find_macro() {
    ReadResult read = arm_.environment.disk.read(tool_, kMaxMacroFile);
    if (!read.bytes) return tool_ + ": " + read.problem;
    bytes_ = *std::move(read.bytes);
    const xml::Document document = xml::parse_own(bytes_, kNoSource);
    std::vector<MacroDefinition> found;
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      const auto name = element.attribute("name");
      if (element.name() != "xacro:macro" || !name) continue;
      if (!request_.macro.empty() && name->value() != request_.macro) continue;
      const auto params = element.attribute("params");
      params_.emplace_back(params ? params->value() : std::string_view());
      found.push_back({std::string(name->value()), {}});
    }
    if (found.empty()) return tool_ + " defines no such macro";
    if (found.size() > 1) {
      std::string names;
      for (const MacroDefinition& each : found) names += (names.empty() ? "" : ", ") + each.name;
      return fmt::format("{} has several macros: choose one with --macro: {}", tool_, names);
    }
    macro_ = std::move(found.front());
    macro_.parameters = xacro::parse_parameters(params_.front(), {}, symbols_);
    return {};
  }

  std::string make_call() {
    const AttachRequest& asked = request_.attach;
    std::string attributes, missing;
    bool has_origin = false;
    for (const auto& given : request_.parameters) {
      const bool known = std::any_of(macro_.parameters.begin(), macro_.parameters.end(),
                                     [&](const auto& each) { return each.name == given.first; });
      if (!known) return fmt::format("macro '{}' has no parameter '{}'", macro_.name, given.first);
    }
    for (const xacro::MacroParameter& parameter : macro_.parameters) {
      const std::string name(parameter.name);
      const auto set = [&](const std::string& value) {
        attributes += fmt::format(" {}=\"{}\"", name, xml::escaped(value));
      };
      const auto given = request_.parameters.find(name);
      if (given != request_.parameters.end()) {
        set(given->second);
      } else if (name.starts_with('*')) {
        const bool is_pose = name == "*origin" || name == "*pose" || name == "*mount_pose";
        if (is_pose && !has_origin) {
          has_origin = true;
        } else {
          missing += (missing.empty() ? "" : ", ") + name;
        }
      } else if (is_named_as(name, kParents)) {
        has_parent_ = true;
        set(asked.link);
      } else if (is_named_as(name, kPrefixes) &&
                 (!asked.prefix.empty() || !parameter.has_default)) {
        set(asked.prefix);
      } else if (!parameter.has_default) {
        missing += (missing.empty() ? "" : ", ") + name;
      }
    }
    if (!missing.empty()) {
      return fmt::format("macro '{}' needs {}: give each as --param NAME=VALUE", macro_.name,
                         missing);
    }
    if (has_parent_ && !has_origin && !(asked.X_LG == Pose{}))
      return fmt::format("macro '{}' has no block for the pose", macro_.name);
    lines_.push_back(fmt::format("<xacro:include filename=\"{}\"/>",
                                 xml::escaped(relative_path(parent_path(arm_.path()), tool_))));
    if (has_origin) {
      lines_.push_back(fmt::format("<xacro:{}{}>", macro_.name, attributes));
      lines_.push_back("  " + origin_element());
      lines_.push_back(fmt::format("</xacro:{}>", macro_.name));
    } else {
      lines_.push_back(fmt::format("<xacro:{}{}/>", macro_.name, attributes));
    }
    return {};
  }

  std::string origin_element() const {
    const Pose& X = request_.attach.X_LG;
    return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", xyz_text(X), rpy_text(X));
  }

  static std::vector<std::uint32_t> roots_of(const robot::Robot& robot) {
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
      if (robot.bodies[i].carrier == robot::kNoIndex) roots.push_back(i);
    }
    return roots;
  }

  /// The tool on a link of that name and nothing else. Its only other root is put on it.
  std::string make_alone() {
    for (int tries = 0; tries < 2; ++tries) {
      std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"tool\" xmlns:xacro=\"" +
                         std::string("http://www.ros.org/wiki/xacro\">\n") +
                         fmt::format("<link name=\"{}\"/>\n", request_.attach.link);
      for (const std::string& line : lines_) text += line + '\n';
      const std::string path =
          join_path(parent_path(arm_.path()), "rigor_attached_tool.urdf.xacro");
      OpenedModel opened = reader_.open_changed(path, {}, {{path, text + "</robot>\n"}});
      if (!opened.model)
        return fmt::format("macro '{}' makes no robot: {}", macro_.name, opened.problem);
      alone_ = std::move(opened.model);
      const std::vector<std::uint32_t> roots = roots_of(alone_->robot);
      const std::uint32_t link = alone_->body_index(request_.attach.link);
      if (roots.size() == 1 && roots.front() == link && alone_->robot.bodies.size() > 1) return {};
      if (tries > 0 || roots.size() != 2 || alone_->robot.bodies[link].carrier != robot::kNoIndex)
        break;
      add_joint(alone_->robot.bodies[roots[0] == link ? roots[1] : roots[0]].name);
    }
    return fmt::format("macro '{}' makes no tool with one root on '{}'", macro_.name,
                       request_.attach.link);
  }

  void add_joint(const std::string& child) {
    lines_.push_back(
        fmt::format("<joint name=\"{}_to_{}\" type=\"fixed\">", request_.attach.link, child));
    lines_.push_back("  " + origin_element());
    lines_.push_back(fmt::format("  <parent link=\"{}\"/>", request_.attach.link));
    lines_.push_back(fmt::format("  <child link=\"{}\"/>", child));
    lines_.emplace_back("</joint>");
  }

  std::string fault_of_names() {
    for (const robot::Body& body : alone_->robot.bodies) {
      if (body.name != request_.attach.link && arm_.body_index(body.name) != robot::kNoIndex)
        return fmt::format("link '{}' is taken: choose a --prefix", body.name);
    }
    for (const robot::Joint& joint : alone_->robot.joints) {
      if (arm_.joint_index(joint.name) != robot::kNoIndex)
        return fmt::format("joint '{}' is taken: choose a --prefix", joint.name);
    }
    return {};
  }

  /// The arm, and on its link what the macro puts on a link.
  robot::Robot joined() const {
    robot::Robot all = arm_.robot;
    const robot::Robot& part = alone_->robot;
    const std::uint32_t link = alone_->body_index(request_.attach.link);
    const std::uint32_t arm_link = arm_.body_index(request_.attach.link);
    std::vector<std::uint32_t> place(part.bodies.size(), arm_link);
    for (std::uint32_t i = 0; i < part.bodies.size(); ++i) {
      if (i == link) continue;
      place[i] = static_cast<std::uint32_t>(all.bodies.size());
      all.bodies.push_back(part.bodies[i]);
    }
    for (robot::Joint joint : part.joints) {
      joint.parent = place[joint.parent];
      joint.child = place[joint.child];
      all.joints.push_back(std::move(joint));
    }
    for (robot::Frame frame : part.frames) {
      if (frame.body != robot::kNoIndex) frame.body = place[frame.body];
      all.frames.push_back(std::move(frame));
    }
    robot::connect(all);
    return all;
  }

  ModelReader& reader_;
  const EditedModel& arm_;
  std::string tool_;
  const MacroRequest& request_;
  std::string bytes_;  ///< of the tool's file
  std::vector<std::string> params_;
  xacro::Symbols symbols_;
  MacroDefinition macro_;
  bool has_parent_ = false;
  std::vector<std::string> lines_;  ///< that are added to the arm, without their indentation
  std::unique_ptr<EditedModel> alone_;
};

}  // namespace

Change attached_by_macro(ModelReader& reader, const EditedModel& arm, const std::string& tool,
                         const MacroRequest& request) {
  return MacroAttacher(reader, arm, tool, request).attach();
}

}  // namespace rigor::author
