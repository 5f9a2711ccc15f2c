// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names an entity the way people refer to it: "my_robot/joint elbow".

#pragma once

#include <string>

#include <rigor/model/model.h>

namespace rigor::model {

/// The model's scoped name, then kinds and names inward.
std::string subject(const Root& root, const World& world);
std::string subject(const Root& root, const Model& model);
std::string subject(const Root& root, const Link& link);
std::string subject(const Root& root, const Joint& joint);
std::string subject(const Root& root, const Frame& frame);
std::string subject(const Root& root, const Collision& collision);
std::string subject(const Root& root, const Visual& visual);
std::string subject(const Root& root, const Sensor& sensor);
std::string subject(const Root& root, const Light& light);
std::string subject(const Root& root, const Plugin& plugin);

}  // namespace rigor::model
