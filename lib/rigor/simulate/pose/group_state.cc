// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/pose/group_state.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace rigor::simulate {
namespace {

constexpr std::array<std::string_view, 6> kStances{"standing", "stand",   "half_sitting",
                                                   "home",     "default", "initial"};

/// A folder of configurations has few; a thousand files are something else.
constexpr std::size_t kMaxSrdfs = 16;

std::string_view attribute_of(const xml::Element& element, std::string_view name) {
  const auto attribute = element.attribute(name);
  return attribute ? attribute->value() : std::string_view{};
}

/// One number; a joint with several axes has more.
std::optional<double> state_position(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::string folder_beside(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

std::vector<std::string> srdfs_near(const std::string& model_path, const Disk& disk) {
  const std::string beside = folder_beside(model_path);
  const std::string above = beside == "." ? ".." : folder_beside(beside);
  std::vector<std::string> found;
  for (const std::string& base : {beside, above}) {
    for (const char* within : {"", "/srdf", "/config"}) {
      const std::string folder = base + within;
      for (const std::string& name : disk.list(folder)) {
        if (name.ends_with(".srdf") && found.size() < kMaxSrdfs) {
          found.push_back(folder + '/' + name);
        }
      }
    }
  }
  return found;
}

void add_state(const xml::Element& element, const std::string& file,
               std::vector<GroupState>& states) {
  const std::string name(attribute_of(element, "name"));
  if (std::find(kStances.begin(), kStances.end(), name) == kStances.end()) return;
  auto known = std::find_if(states.begin(), states.end(), [&](const GroupState& state) {
    return state.name == name && state.file == file;
  });
  if (known == states.end()) known = states.insert(states.end(), {name, file, {}});
  for (const xml::Element joint : element.children()) {
    const auto position = state_position(attribute_of(joint, "value"));
    if (joint.name() != "joint" || !position) continue;
    known->positions.emplace_back(attribute_of(joint, "name"), *position);
  }
}

}  // namespace

std::vector<GroupState> group_states(const std::string& model_path, std::string_view robot,
                                     read::Workspace& workspace) {
  std::vector<GroupState> states;
  for (const std::string& path : srdfs_near(model_path, workspace.disk())) {
    const read::File& file = workspace.open(path);
    if (!file.document || !file.document->root()) continue;
    const xml::Element root = *file.document->root();
    if (root.name() != "robot" || attribute_of(root, "name") != robot) continue;
    for (const xml::Element element : root.children()) {
      if (element.name() == "group_state")
        add_state(element, path.substr(path.rfind('/') + 1), states);
    }
  }
  const auto rank = [](const GroupState& state) {
    return std::find(kStances.begin(), kStances.end(), state.name) - kStances.begin();
  };
  std::stable_sort(states.begin(), states.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return states;
}

}  // namespace rigor::simulate
