// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The size of a camera's picture.

#pragma once

#include <fmt/core.h>

#include <rigor/rules/context.h>

namespace rigor::rules {

/// Reports each picture with a side, in pixels, that is written and wrong.
template <class Predicate>
void report_pictures(const model::Sensor& sensor, Predicate is_wrong, Context& context) {
  for (const model::Camera& camera : sensor.cameras) {
    for (const auto* size : {&camera.width, &camera.height}) {
      if (!size->written || !is_wrong(size->value)) continue;
      context.report({.where = size->span,
                      .message = fmt::format("the picture is {} by {} pixels", camera.width.value,
                                             camera.height.value),
                      .subject = context.subject(sensor)});
      break;
    }
  }
}

}  // namespace rigor::rules
