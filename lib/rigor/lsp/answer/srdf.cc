// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/srdf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/file_names.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/report/number.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

/// What people write for a limit has few digits; a state at the limit is within it.
constexpr double kLimitTolerance = 1e-4;

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r') {
      ++at;
      continue;
    }
    double number = 0;
    const auto [past, error] = std::from_chars(at, end, number);
    if (error != std::errc()) return {};
    numbers.push_back(number);
    at = past;
  }
  return numbers;
}

class SrdfCheck {
 public:
  SrdfCheck(std::vector<const RobotNames*> robots, std::string robot)
      : robots_(std::move(robots)), robot_(std::move(robot)) {}

  std::vector<CompanionFinding> check(xml::Element root) && {
    for (const xml::Element child : root.children()) {
      const auto name = child.attribute("name");
      if (child.name() == "group" && name) groups_.emplace(name->value());
      if (child.name() == "virtual_joint" && name) virtual_joints_.emplace(name->value());
    }
    for (const xml::Element child : root.children()) visit(child);
    return std::move(found_);
  }

 private:
  void visit(xml::Element element) {
    const auto parent = element.parent();
    const std::string_view parent_name = parent ? parent->name() : std::string_view();
    for (const xml::Attribute attribute : element.attributes()) {
      const bool names_group =
          attribute.name() == "group" || attribute.name() == "parent_group" ||
          (element.name() == "group" && parent_name == "group" && attribute.name() == "name");
      if (names_group) check_group(attribute);
      if (const auto kinds =
              author::referenced_kinds("robot", parent_name, element.name(), attribute.name()))
        check_name(attribute, *kinds);
    }
    if (parent_name == "group_state" && element.name() == "joint") check_state(element);
    for (const xml::Element child : element.children()) visit(child);
  }

  void say(Span where, std::string message) {
    found_.push_back({where, Severity::kError, std::move(message)});
  }

  void check_group(xml::Attribute attribute) {
    if (!groups_.contains(attribute.value()))
      say(attribute.value_span(), fmt::format("group '{}' is not defined", attribute.value()));
  }

  void check_name(xml::Attribute attribute, author::NameKinds kinds) {
    const std::string_view name = attribute.value();
    const bool is_link = kinds.has(author::NameKind::kLink);
    const bool exists = std::any_of(robots_.begin(), robots_.end(), [&](const RobotNames* robot) {
      return is_link ? robot->links.contains(name) : robot->joints.contains(name);
    });
    // The joint that ties the robot to the world is the SRDF's own.
    if (exists || (!is_link && virtual_joints_.contains(name))) return;
    say(attribute.value_span(), fmt::format("{} '{}' does not exist in robot '{}'",
                                            is_link ? "link" : "joint", name, robot_));
  }

  void check_state(xml::Element state) {
    const auto name = state.attribute("name");
    const auto value = state.attribute("value");
    if (!name || !value) return;
    const std::vector<double> numbers = numbers_in(value->value());
    if (numbers.size() != 1) return;  // of a joint with several degrees of freedom
    const JointRange* range = nullptr;
    for (const RobotNames* robot : robots_) {
      const auto joint = robot->joints.find(name->value());
      if (joint == robot->joints.end()) continue;
      range = &joint->second;
      if (numbers[0] >= range->lower - kLimitTolerance &&
          numbers[0] <= range->upper + kLimitTolerance)
        return;
    }
    if (range == nullptr) return;
    const std::string_view unit = range->in_meters ? "m" : "rad";
    say(value->value_span(),
        fmt::format("{} {} is outside the limits {} to {} {} of joint '{}'",
                    report::number(numbers[0], 4), unit, report::number(range->lower, 4),
                    report::number(range->upper, 4), unit, name->value()));
  }

  std::vector<const RobotNames*> robots_;
  std::string robot_;
  std::set<std::string, std::less<>> groups_;
  std::set<std::string, std::less<>> virtual_joints_;
  std::vector<CompanionFinding> found_;
};

}  // namespace

std::vector<CompanionFinding> srdf_findings(State& state, OpenDocument& document) {
  const xml::Document& written = document.analysis(state.environment()).written();
  const auto root = written.root();
  if (!root || root->name() != "robot") return {};
  const auto name = root->attribute("name");
  if (!name) return {{root->name_span(), Severity::kError, "the robot has no name"}};
  const std::string robot(name->value());
  const std::vector<const RobotNames*> robots =
      state.robots_named(robot, [&] { return workspace_files(state, document); });
  if (robots.empty()) {
    return {{name->value_span(), Severity::kInfo,
             fmt::format("no robot in the workspace is named '{}': names are not checked", robot)}};
  }
  return SrdfCheck(robots, robot).check(*root);
}

}  // namespace rigor::lsp
