// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether what a scenario demands came true.
//
//   for (const Fact& broken : broken_assertions(scene, scenario, record, metrics)) fail(broken);

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <rigor/simulate/metric/metric.h>

namespace rigor::simulate {

/// "x|y|z|roll|pitch|yaw of LINK", "position|velocity of JOINT" at a time of the trajectory (the end
/// when infinite), between its samples linearly, angles by the nearer sample; m, rad, and per second.
/// Names are scoped, or the end of a scoped name. Nothing when there is no such thing.
std::optional<double> quantity_at(const Scene& scene, const Record& record,
                                  std::string_view quantity, double time);

/// Facts of kind kAssertion: `value` is what was, `limit` the bound that it is beyond. One that cannot
/// be told (no such metric, nothing at that time) is broken, with NaN.
Facts broken_assertions(const Scene& scene, const Scenario& scenario, const Record& record,
                        const std::vector<Metric>& metrics);

}  // namespace rigor::simulate
