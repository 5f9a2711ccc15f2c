// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/srdf_elements.h>

#include <array>

#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

template <std::size_t Count>
using Words = std::array<std::string_view, Count>;

constexpr Words<1> kNameOnly{"name"};
constexpr Words<2> kChainEnds{"base_link", "tip_link"};
constexpr Words<2> kStateNames{"name", "group"};
constexpr Words<2> kJointPosition{"name", "value"};
constexpr Words<4> kEndEffector{"name", "parent_link", "group", "parent_group"};
constexpr Words<4> kVirtualJoint{"name", "type", "parent_frame", "child_link"};
constexpr Words<3> kJointProperty{"joint_name", "property_name", "value"};
constexpr Words<3> kLinkPair{"link1", "link2", "reason"};
constexpr Words<1> kOneLink{"link"};
constexpr Words<2> kSphere{"center", "radius"};

// https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
constexpr SrdfElement kSrdfElements[] = {
    {"robot", "group", kNameOnly, "A group of joints that are planned for together."},
    {"robot", "group_state", kStateNames, "Named positions of the joints of a group."},
    {"robot", "end_effector", kEndEffector, "A group that is attached to a link as its tool."},
    {"robot", "virtual_joint", kVirtualJoint, "The joint between the world and the robot."},
    {"robot", "passive_joint", kNameOnly, "A joint that is not actuated."},
    {"robot", "joint_property", kJointProperty, "A property of a joint, for planners."},
    {"robot", "disable_collisions", kLinkPair, "Two links that are not checked for collision."},
    {"robot", "enable_collisions", kLinkPair,
     "Two links that are checked although one has its collisions disabled by default."},
    {"robot", "disable_default_collisions", kOneLink,
     "A link that is only checked against those of `enable_collisions`."},
    {"robot", "link_sphere_approximation", kOneLink, "Spheres in place of the link's collisions."},
    {"group", "link", kNameOnly, "The joint above this link is in the group."},
    {"group", "joint", kNameOnly, "This joint is in the group."},
    {"group", "chain", kChainEnds, "All joints from the base link to the tip link."},
    {"group", "group", kNameOnly, "All joints of another group."},
    {"group_state", "joint", kJointPosition, "The position of a joint, in rad or m."},
    {"link_sphere_approximation", "sphere", kSphere, "A sphere in the frame of the link, in m."},
};

constexpr Words<3> kVirtualTypes{"fixed", "planar", "floating"};
// As the setup assistant of MoveIt writes them.
constexpr Words<5> kReasons{"Adjacent", "Never", "Default", "Always", "User"};

}  // namespace

std::span<const SrdfElement> srdf_elements() { return kSrdfElements; }

const SrdfElement* find_srdf_element(std::string_view parent, std::string_view name) {
  for (const SrdfElement& element : kSrdfElements) {
    if (element.parent == parent && element.name == name) return &element;
  }
  return nullptr;
}

std::span<const std::string_view> srdf_values(std::string_view element,
                                              std::string_view attribute) {
  if (element == "virtual_joint" && attribute == "type") return kVirtualTypes;
  if (attribute == "reason") return kReasons;
  return {};
}

bool refers_to_srdf_group(std::string_view parent, std::string_view element,
                          std::string_view attribute) {
  if (parent == "group" && element == "group") return attribute == "name";
  if (element == "group_state") return attribute == "group";
  return element == "end_effector" && (attribute == "group" || attribute == "parent_group");
}

bool is_srdf(std::string_view path) {
  return extension(path) == ".srdf" || path.ends_with(".srdf.xacro");
}

}  // namespace rigor::lsp
