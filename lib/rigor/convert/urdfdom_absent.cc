// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the judge without urdfdom (RIGOR_WITH_URDFDOM=OFF).

#include <rigor/convert/urdfdom.h>

#include <stdexcept>

namespace rigor::convert {

UrdfdomVerdict judge_by_urdfdom(std::string_view, const process::Workers&) {
  return {.robot = {}, .messages = {"rigor was built without urdfdom"}, .asked = false};
}

process::Service urdfdom_service() {
  return {"convert.urdfdom", [](const std::string&, const process::Ask&) -> process::Reply {
            throw std::logic_error("rigor was built without urdfdom");
          }};
}

}  // namespace rigor::convert
