// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The wheels that a drive plugin turns, and what it is informed of them: a plugin of any library that names
// joints of its model under left and right.
//
//   const auto drive = drive_of(plugin, context);
//   if (drive) compare(drive->separations, drive->left.front().center, drive->right.front().center);

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

struct DrivenWheel {
  model::Id<model::Joint> joint;
  const model::Parameter* named;  ///< the parameter that names the joint; null without a plugin
  model::Vector3 position;        ///< of the joint, m, in the frame of `Frames`
  model::Vector3 center;          ///< of the link's shapes; the joint's where it has none
  model::Vector3 axis;            ///< unit vector, in that frame
  std::vector<double> radii;  ///< m, of the link's shapes, as far as they are round about the axis
  /// m, of the widest tread; 0 of a ball; nothing where no shape is round
  std::optional<double> width = std::nullopt;
  bool across = false;  ///< they are round about another one, which wheel-axis-mismatch reports
};

struct Drive {
  std::vector<DrivenWheel> left;
  std::vector<DrivenWheel> right;
  // The joints that steer, where the plugin names them.
  std::vector<DrivenWheel> left_steering;
  std::vector<DrivenWheel> right_steering;
  // Those of several pairs of wheels, one after another.
  std::vector<const model::Parameter*> separations;
  std::vector<const model::Parameter*> radii;
  std::vector<const model::Parameter*> diameters;
};

/// Nothing unless at least one joint of each side is one of the model that turns about an axis; steering
/// joints do not count.
std::optional<Drive> drive_of(const model::Plugin& plugin, Context& context);

/// The wheel that a joint turns; nothing where it does not turn about one axis or has no place.
std::optional<DrivenWheel> wheel_of(model::Id<model::Joint> joint, Context& context);

/// The text of a parameter without the blanks around it.
Span trimmed(const model::Parameter& parameter, const Context& context);

/// The parameter's number; nothing when it is none or not positive.
std::optional<double> positive_number(const model::Parameter& parameter);

/// What should be written in place of `written`, m, where the wheels have `actual`: the author's digits where a
/// factor of 2, 10, 100 or 1000 makes them it to one in a hundred, else what the wheels have.
std::string value_with_digits(double written, double actual);

}  // namespace rigor::rules
