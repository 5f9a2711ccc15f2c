// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of the links, joints and frames that an MJCF file becomes. MuJoCo has a set of names for each kind of
// element, and elements without one; in the model a link and a frame are found by one name. What is repeated or
// taken gets a number: that two have one name is said elsewhere.
//
//   MjcfNaming naming;
//   naming.link("wheel", 0);  // "wheel"
//   naming.link("wheel", 1);  // "wheel_2"
//   naming.link("", 2);       // "body2"
//   naming.frame("wheel");    // "wheel_site"

#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>

#include <rigor/model/unique_names.h>

namespace rigor::read {

class MjcfNaming {
 public:
  /// `number` is the link's, which one without a name is called by.
  std::string link(const std::string& name, std::size_t number) {
    return links_and_frames_.add(name.empty() ? "body" + std::to_string(number) : name);
  }

  void joint(const std::string& name) { joints_.insert(name); }

  /// A name that a link or joint has is theirs: ask for frames after all of these.
  std::string frame(const std::string& name) {
    if (!joints_.contains(name) && links_and_frames_.insert(name)) return name;
    std::string free;
    do {
      free = links_and_frames_.add(name + "_site");
    } while (joints_.contains(free));
    return free;
  }

 private:
  model::UniqueNames links_and_frames_;
  std::unordered_set<std::string> joints_;
};

}  // namespace rigor::read
