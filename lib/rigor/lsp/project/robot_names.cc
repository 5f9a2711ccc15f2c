// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/robot_names.h>

#include <rigor/model/motion.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

RobotNames robot_names(Analysis& analysis) {
  RobotNames names;
  const model::Root& root = analysis.loaded().root;
  for (const model::Link& link : root.links) names.links.insert(link.name.value);
  for (const model::Joint& joint : root.joints) {
    JointRange range;
    range.moves = joint.type != model::JointType::kFixed;
    range.in_meters = joint.type == model::JointType::kPrismatic;
    const bool is_limited =
        joint.type == model::JointType::kRevolute || joint.type == model::JointType::kPrismatic;
    if (is_limited && !joint.axes.empty() && joint.axes[0].limit_written) {
      range.lower = model::position_limit(joint.axes[0].lower.value);
      range.upper = model::position_limit(joint.axes[0].upper.value);
    }
    names.joints.emplace(joint.name.value, range);
  }
  return names;
}

std::string robot_name_in(std::string_view bytes) {
  constexpr std::string_view kRobot = "<robot";
  const std::size_t begin = bytes.find(kRobot);
  const std::size_t end = begin == std::string_view::npos ? begin : bytes.find('>', begin);
  if (end == std::string_view::npos) return {};
  std::string tag(bytes.substr(begin, end - begin));
  if (tag.ends_with('/')) tag.pop_back();
  tag += "/>";
  const xml::Document document = xml::parse_own(tag, SourceId{0});
  const auto root = document.root();
  const auto name = root ? root->attribute("name") : std::nullopt;
  if (!name || name->value().find('$') != std::string_view::npos) return {};
  return std::string(name->value());
}

}  // namespace rigor::lsp
