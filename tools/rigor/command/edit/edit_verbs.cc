// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The verbs of `rigor edit`: words and options → one library call.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <rigor/author/verbs/add/add.h>
#include <rigor/author/verbs/attach.h>
#include <rigor/author/verbs/attach_macro.h>
#include <rigor/author/verbs/lump/lump.h>
#include <rigor/author/verbs/merge.h>
#include <rigor/author/verbs/mirror.h>
#include <rigor/author/verbs/move_frame.h>
#include <rigor/author/verbs/prefix.h>
#include <rigor/author/verbs/remove.h>
#include <rigor/author/verbs/reroot.h>
#include <rigor/author/verbs/scale.h>
#include <rigor/author/verbs/set_value.h>
#include <rigor/author/verbs/simplify/simplify.h>
#include <rigor/author/verbs/split.h>
#include <rigor/read/template/template_expander.h>

#include "command/command.h"
#include "command/edit/edit.h"
#include "option/numbers.h"
#include "option/search.h"

namespace rigor::tool {
namespace {

using author::Change;
using author::EditedModel;
using author::ModelReader;

const std::string& prefix_of(const EditRequest& request) {
  if (request.words[0].empty()) throw UsageError("PREFIX is empty");
  return request.words[0];
}

Change prefix(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::prefixed(edited, prefix_of(request), {request.files, request.found});
}

Change unprefix(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::unprefixed(edited, prefix_of(request), {request.files, request.found});
}

Change remove(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  const auto subtree =
      request.options.subtree ? author::Subtree::kRemoved : author::Subtree::kRefused;
  return author::removed(edited, request.words[0], subtree, {request.files, request.found});
}

Change extract(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::extracted(edited, request.words[0], {request.files, request.found});
}

Change reroot(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::rerooted(edited, request.words[0]);
}

Change scale(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::scaled(edited, positive_number("edit scale: FACTOR", request.words[0], ""),
                        {request.files, request.found});
}

/// "x y z" or "x y z roll pitch yaw", m and rad.
model::Pose pose_of(const std::string& option, const std::string& text) {
  const std::vector<double> n = finite_numbers(option, {text});
  if (n.size() != 3 && n.size() != 6)
    throw UsageError(option + " \"" + text + "\": takes x y z, or x y z roll pitch yaw");
  model::Pose X{{n[0], n[1], n[2]}, {}};
  if (n.size() == 6) X.rotation = model::from_rpy(n[3], n[4], n[5]);
  return X;
}

std::optional<double> given_number(const std::string& option, const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(finite_number(option, text));
}

std::optional<double> number_from_zero(const std::string& option, const std::string& text) {
  const auto number = given_number(option, text);
  if (number && *number < 0) throw UsageError(option + ' ' + text + ": takes a number from 0 on");
  return number;
}

author::NewLimits limits_of(const EditOptions& options) {
  const author::NewLimits limits{given_number("--lower", options.lower),
                                 given_number("--upper", options.upper),
                                 number_from_zero("--effort", options.effort),
                                 number_from_zero("--velocity", options.velocity)};
  if (limits.lower && limits.upper && *limits.lower > *limits.upper)
    throw UsageError("--lower " + options.lower + " is above --upper " + options.upper);
  return limits;
}

/// The options of attach and merge, but for the link.
author::AttachRequest attach_request(const EditOptions& options) {
  constexpr std::array<std::string_view, 2> kJoints{"fixed", "revolute"};
  author::AttachRequest asked;
  asked.link = options.to;
  asked.frame = options.frame;
  asked.tool_frame = options.tool_frame;
  asked.prefix = options.prefix;
  if (options.include) asked.by = author::AttachBy::kInclude;
  if (!options.pose.empty()) asked.X_LG = pose_of("--pose", options.pose);
  if (!options.joint.empty() && choice("--joint", options.joint, kJoints) == 1) {
    asked.joint = author::AttachJoint::kRevolute;
    for (const std::string* given :
         {&options.lower, &options.upper, &options.effort, &options.velocity}) {
      if (given->empty())
        throw UsageError("a revolute joint needs --lower, --upper, --effort and --velocity");
    }
    const author::NewLimits limits = limits_of(options);
    asked.lower = *limits.lower;
    asked.upper = *limits.upper;
    asked.effort = *limits.effort;
    asked.velocity = *limits.velocity;
  }
  return asked;
}

Change attach(const EditRequest& request, ModelReader& reader, const EditedModel& arm) {
  const EditOptions& options = request.options;
  if (options.to.empty() && options.frame.empty())
    throw UsageError("edit attach needs --to LINK or --frame FRAME");
  const author::AttachRequest asked = attach_request(options);
  const bool is_macro = !options.macro.empty() || !options.macro_parameters.empty();
  const author::OpenedModel gripper = is_macro ? author::OpenedModel{} : reader.open(request.tool);
  if (gripper.model) return author::attached(reader, arm, *gripper.model, asked);
  if (!is_macro && !read::is_template(request.tool)) throw InputError(gripper.problem);
  author::MacroRequest call{asked, options.macro, {}};
  for (const std::string& each : options.macro_parameters)
    call.parameters.insert(split_assignment("--param", each));
  return author::attached_by_macro(reader, arm, request.tool, call);
}

Change merge(const EditRequest& request, ModelReader& reader, const EditedModel& first) {
  const EditOptions& options = request.options;
  const author::OpenedModel second = reader.open(request.tool);
  if (!second.model) throw InputError(second.problem);
  if (!options.to.empty()) {
    if (!first.is_urdf())
      return author::refusal("it is SDF: use attach, or leave out --to for a world of both");
    return author::merged_robot(reader, first, *second.model, attach_request(options));
  }
  if (!options.include && first.is_urdf() && second.model->is_urdf()) {
    return author::refusal(
        "URDF has one robot a file: name a new root for both with --to, use attach to put one on a "
        "link of the other, or --include for a world");
  }
  author::WorldRequest asked;
  asked.out = request.out.empty() ? "world.sdf" : request.out;
  asked.name = options.name;
  if (!options.pose.empty()) asked.X_WB = pose_of("--pose", options.pose);
  if (options.include) asked.parts = author::WorldParts::kIncluded;
  author::MergedWorld world = author::merged_world(first, *second.model, asked);
  if (!world.refused.empty()) return author::refusal(world.refused);
  if (!world.holds()) {
    const robot::Difference& one = world.unasked.front();
    return author::refusal("the world would have other models: " +
                           std::string(robot::to_string(one.kind)) + ' ' + one.a + one.b);
  }
  Change change;
  change.expected = first.robot;
  change.product = std::move(world.text);
  change.notes = std::move(world.notes);
  change.notes.push_back("a world with the models " + world.names[0] + " and " + world.names[1] +
                         ", each as in its file");
  return change;
}

/// "a,b" as a and b.
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (end > begin) names.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

/// Of an --at that is no name of the model.
model::Pose pose_at(const std::string& text) {
  try {
    return pose_of("--at", text);
  } catch (const UsageError&) {
    throw UsageError(
        "--at \"" + text +
        "\": no link, joint or frame has that name, and a pose is x y z, or x y z roll "
        "pitch yaw");
  }
}

Change split(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  const EditOptions& options = request.options;
  const std::string& link = request.words[0];
  if (options.frame.empty())
    throw UsageError("edit split needs --at FRAME or --at \"X Y Z R P Y\"");
  author::SplitRequest asked;
  asked.name = options.name;
  asked.take = names_in(options.take);
  const auto place = author::place_in_link(edited, link, options.frame);
  asked.X_LN = place ? *place : pose_at(options.frame);
  if (options.mass == "shapes") {
    asked.share = author::SplitMass::kShapes;
  } else if (!options.mass.empty()) {
    asked.share = author::SplitMass::kGiven;
    asked.mass = positive_number("--mass", options.mass, "kg");
  }
  return author::split(edited, link, asked);
}

Change simplify(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  constexpr std::array<std::string_view, 2> kFrom{"collision", "visual"};
  author::SimplifyRequest asked;
  if (!request.options.max_error.empty())
    asked.max_error = positive_number("--max-error", request.options.max_error, "");
  if (!request.options.from.empty() && choice("--from", request.options.from, kFrom) == 1)
    asked.missing = author::MissingCollisions::kFromVisuals;
  return author::simplified(edited, asked);
}

Change mirror(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  constexpr std::array<std::string_view, 3> kPlanes{"yz", "xz", "xy"};
  author::MirrorRequest asked;
  if (!request.options.plane.empty())
    asked.plane =
        static_cast<author::MirrorPlane>(choice("--plane", request.options.plane, kPlanes));
  if (const std::string& rename = request.options.rename; !rename.empty()) {
    const std::size_t colon = rename.find(':');
    if (colon == std::string::npos || colon == 0)
      throw UsageError("--rename " + rename + ": takes FROM:TO");
    asked.from = rename.substr(0, colon);
    asked.to = rename.substr(colon + 1);
  }
  return author::mirrored(edited, request.words[0], asked);
}

Change lump(const EditRequest&, ModelReader&, const EditedModel& edited) {
  return author::lumped(edited, {});
}

Change add(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  const EditOptions& options = request.options;
  const std::vector<std::string_view> names = author::addition_names();
  author::AddRequest asked;
  asked.what = names[choice("template of edit add", request.words[0], names)];
  asked.to = options.to;
  if (const auto place = author::needed_place(asked.what); options.to.empty() && !place.empty())
    throw UsageError("edit add " + asked.what + " needs --to " + std::string(place));
  asked.parameters = options.parameters;
  if (!options.pose.empty()) asked.X = pose_of("--pose", options.pose);
  if (!options.target.empty()) {
    const std::vector<std::string_view> targets = rules::target_names();
    asked.target = rules::target_named(targets[choice("--target", options.target, targets)]);
  }
  return author::added(edited, asked);
}

Change set_pose(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  return author::with_pose(edited, request.words[0],
                           pose_of("edit set-pose: POSE", request.words[1]));
}

Change set_limit(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  const author::NewLimits limits = limits_of(request.options);
  if (!limits.lower && !limits.upper && !limits.effort && !limits.velocity)
    throw UsageError("edit set-limit needs --lower, --upper, --effort or --velocity");
  return author::with_limits(edited, request.words[0], limits);
}

Change move_frame(const EditRequest& request, ModelReader&, const EditedModel& edited) {
  const std::string& link = request.words[0];
  const std::string& to = request.options.to;
  if (to.empty()) throw UsageError("edit move-frame needs --to \"X Y Z R P Y\", com or joint");
  if (to != "com" && to != "joint") return author::with_frame(edited, link, pose_of("--to", to));
  const auto place = to == "com" ? author::FramePlace::kCenterOfMass : author::FramePlace::kJoint;
  const auto X_LN = author::frame_at(edited, link, place);
  if (!X_LN && !edited.link(link)) return author::refusal("no link is named '" + link + "'");
  if (!X_LN && to == "com") {
    return author::refusal("link '" + link +
                           "' has no <inertial>, which would say where its center of mass is");
  }
  if (!X_LN) return author::refusal("link '" + link + "' is on no joint");
  return author::with_frame(edited, link, *X_LN);
}

constexpr EditVerb kEditVerbs[] = {
    {"prefix", "PREFIX", "", prefix, false, true},
    {"unprefix", "PREFIX", "", unprefix, false, true},
    {"remove", "LINK", "--subtree", remove, false, true},
    {"extract", "LINK", "", extract, false, true},
    {"reroot", "LINK", "", reroot},
    {"scale", "FACTOR", "", scale, false, true},
    {"mirror", "LINK", "--plane --rename", mirror},
    {"attach", "",
     "--to --frame --tool-frame --include --macro --param --pose --joint --lower --upper --effort "
     "--velocity --prefix",
     attach, true},
    {"set-pose", "NAME POSE", "", set_pose},
    {"set-limit", "JOINT", "--lower --upper --effort --velocity", set_limit},
    {"move-frame", "LINK", "--to", move_frame},
    {"lump", "", "", lump},
    {"add", "WHAT", "--to --pose --target --parameters", add},
    {"merge", "",
     "--to --pose --joint --lower --upper --effort --velocity --prefix --include --name", merge,
     true},
    {"split", "LINK", "--at --take --mass --name", split},
    {"simplify-collisions", "", "--max-error --from", simplify},
};

}  // namespace

std::span<const EditVerb> edit_verbs() { return kEditVerbs; }

}  // namespace rigor::tool
