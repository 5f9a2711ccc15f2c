// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What metrics are made with: the table of limits, and what of a scene they all ask. For sources of this
// room.
//
//   MetricSheet sheet{scene, scenario, record, wheels, {}, footings_of(scene)};
//   sheet.add("tilt.max", phase->tilt.value, about_model(scene, phase->tilt.of));

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/simulate/footing.h>
#include <rigor/simulate/metric/metric.h>

namespace rigor::simulate {

/// Which side of a limit is bad.
enum class BadSide : std::uint8_t { kAbove, kBelow };

struct MetricRow {
  std::string_view id;
  std::string_view unit;
  FactKind kind = FactKind::kExplodes;
  std::optional<double> warn;
  std::optional<double> fail;
  BadSide bad = BadSide::kAbove;
};

/// In the order that metrics are listed in.
std::span<const MetricRow> metric_rows();

/// A metric of the table, judged. `about` has what the fact is to say besides: where, subject, name.
/// The limits are multiplied by `scale`.
Metric make_metric(std::string_view id, double value, Fact about, double scale = 1);

Fact about_body(const Scene& scene, std::uint32_t body);
Fact about_shape(const Scene& scene, std::uint32_t shape);
Fact about_joint(const Scene& scene, std::uint32_t joint);
Fact about_axis(const Scene& scene, std::uint32_t axis);  ///< counted over all joints
Fact about_model(const Scene& scene, std::uint32_t model);
/// Of all that moves, by the first model that does.
Fact about_scene(const Scene& scene);

/// "robot::arm::wheel" as a diagnostic has it: "robot::arm/link wheel".
std::string subject_of(std::string_view scoped, std::string_view kind);

/// Whether what a fact says depends on what touches what.
bool hangs_on_contacts(FactKind shown);

/// Whether no joint holds the model to the world.
bool stands_free(const Scene& scene, std::uint32_t model);

/// m/s² that speeds and forces are held against: that of the earth where the scene has none.
double gravity_scale(const Scene& scene);

struct MetricSheet {
  const Scene& scene;
  const Scenario& scenario;
  const Record& record;
  const DriveTrain& wheels;
  std::vector<Metric> metrics;
  std::vector<Footing> footings;  ///< of each model

  /// Whether a model moves and is kept up by the ground alone.
  bool stands(std::uint32_t model) const {
    return stands_free(scene, model) && footings[model].kind == Footing::Kind::kStands;
  }

  void add(std::string_view id, double value, Fact about = {}, double scale = 1);

  /// Null when there is none, or the run did not get there.
  const PhaseMeasures* phase(std::string_view name) const;
  double seconds(const PhaseMeasures& phase) const;
};

void add_spawn_metrics(MetricSheet& sheet);
void add_motion_metrics(MetricSheet& sheet);
void add_rest_metrics(MetricSheet& sheet);
void add_drive_metrics(MetricSheet& sheet);
void add_turn_metrics(MetricSheet& sheet);
void add_brake_metrics(MetricSheet& sheet);
void add_push_metrics(MetricSheet& sheet);
void add_tilt_table_metrics(MetricSheet& sheet);
void add_joint_metrics(MetricSheet& sheet);
void add_sweep_metrics(MetricSheet& sheet);
void add_hold_metrics(MetricSheet& sheet);

/// How a model's base has tilted since the scene was made, rad.
double tilt_since_start(const Scene& scene, std::uint32_t model, const BodyState& base);

}  // namespace rigor::simulate
