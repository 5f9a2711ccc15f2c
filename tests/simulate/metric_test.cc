// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/metric/metric.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <rigor/simulate/advice/advice.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/test/tests.h>

#include "simulate/hand_robot.h"

namespace rigor {
namespace {

using namespace simulate;
using hand::tutorial_robot;

/// A record in which all stood still for the whole scenario.
Record still_record(const Scene& scene, const Scenario& scenario) {
  Record record;
  record.steps = static_cast<std::uint64_t>(std::lround(scenario.duration / 0.001));
  record.end_time = scenario.duration;
  std::vector<BodyState> bodies;
  for (const SceneBody& body : scene.bodies) {
    bodies.push_back({transform(body.X_WB, body.mass.com), body.X_WB.rotation, {}, {}});
  }
  const std::size_t axes = scene.joints.size();
  for (const Phase& phase : scenario.phases) {
    PhaseMeasures measures;
    measures.steps = static_cast<std::uint64_t>(std::lround((phase.end - phase.begin) / 0.001));
    measures.begin = measures.end = bodies;
    measures.vertical_square.assign(scene.models.size(), 0);
    measures.yaw_path.assign(scene.models.size(), 0);
    for (auto* list :
         {&measures.jitter_square, &measures.axis_min, &measures.axis_max, &measures.axis_begin,
          &measures.axis_end, &measures.axis_path, &measures.axis_effort}) {
      list->assign(axes, 0);
    }
    record.measures.phases.push_back(measures);
  }
  record.measures.settle_time = 0;
  record.final.bodies = bodies;
  return record;
}

struct Case {
  Scene scene = tutorial_robot();
  DriveTrain wheels = find_wheels(scene, {});
  Scenario scenario;
  Record record;

  explicit Case(std::string_view test) : scenario(*make_test(test, scene, wheels).scenario) {
    record = still_record(scene, scenario);
  }

  PhaseMeasures& phase(std::string_view name) {
    for (std::size_t i = 0; i < scenario.phases.size(); ++i) {
      if (scenario.phases[i].name == name) return record.measures.phases[i];
    }
    return record.measures.phases.front();
  }
  Metric metric(std::string_view id) {
    for (const Metric& metric : metrics_of(scene, scenario, record, wheels)) {
      if (metric.id == id) return metric;
    }
    return {.id = "none"};
  }
};

TEST(Metric, AStillRobotPassesAll) {
  Case one("settle");
  for (const Metric& metric : metrics_of(one.scene, one.scenario, one.record, one.wheels)) {
    EXPECT_EQ(metric.verdict, Verdict::kPass) << metric.id << " " << metric.value;
    EXPECT_FALSE(metric.fact);
  }
}

TEST(Metric, EachIsOfTheTableAndThereOnce) {
  const std::span<const MetricRow> rows = metric_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(rows[i].id, rows[k].id);
    if (!rows[i].warn || !rows[i].fail) continue;
    if (rows[i].bad == BadSide::kAbove) {
      EXPECT_LT(*rows[i].warn, *rows[i].fail) << rows[i].id;
    } else {
      EXPECT_GT(*rows[i].warn, *rows[i].fail) << rows[i].id;
    }
  }
}

/// A wheel of 0.16 m that lies across by 1.5708 begins 5 mm in the ground, and lower by half its width times the rest.
TEST(Metric, WhatIsAtALimitButForRoundingIsNotBeyondIt) {
  const double low = 0.005 + 0.08 * std::abs(std::cos(1.5708));
  EXPECT_GT(low, 0.005);
  EXPECT_EQ(make_metric("ground.sink", low, {}).verdict, Verdict::kWarn);
  EXPECT_EQ(make_metric("ground.sink", 0.00501, {}).verdict, Verdict::kFail);
}

TEST(Metric, BeyondALimitIsStrictAndNotANumberIsBeyondAll) {
  EXPECT_EQ(make_metric("ground.sink", 0.0015, {}).verdict, Verdict::kPass);
  EXPECT_EQ(make_metric("ground.sink", 0.0016, {}).verdict, Verdict::kWarn);
  EXPECT_EQ(make_metric("ground.sink", 0.0051, {}).verdict, Verdict::kFail);
  EXPECT_EQ(make_metric("rest.support_margin", 0.05, {}).verdict, Verdict::kWarn);
  EXPECT_EQ(make_metric("rest.support_margin", -0.01, {}).verdict, Verdict::kFail);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(make_metric("ground.sink", nan, {}).verdict, Verdict::kFail);
  const Metric warned = make_metric("ground.sink", 0.002, {.subject = "m"});
  ASSERT_TRUE(warned.fact);
  EXPECT_EQ(warned.fact->kind, FactKind::kSinks);
  EXPECT_EQ(warned.fact->limit, 0.0015);
  EXPECT_FALSE(warned.fact->severe);
}

TEST(Metric, SubjectsAreThoseOfDiagnostics) {
  EXPECT_EQ(subject_of("robot::arm::wheel", "link"), "robot::arm/link wheel");
  EXPECT_EQ(subject_of("wheel", "link"), "link wheel");
  Scene scene = tutorial_robot();
  EXPECT_EQ(about_axis(scene, 1).subject, "my_robot/joint right_wheel_hinge");
  scene.shapes[0].name = "my_robot::chassis::box";
  EXPECT_EQ(about_shape(scene, 0).subject, "my_robot/link chassis/collision box");
}

TEST(Metric, OfARobotThatRollsAsItsWheelsDo) {
  Case one("drive");
  PhaseMeasures& drive = one.phase("drive");
  drive.axis_path = {34, 34};  // rad, at a radius of 0.1 m
  drive.end[0].p_WBcm.x += 3.4;
  EXPECT_NEAR(one.metric("drive.ratio").value, 0, 1e-12);
  EXPECT_NEAR(one.metric("drive.direction").value, 1, 1e-12);
  // It was told 0.98 m/s for three seconds and half of one.
  const double told = 0.3 * std::sqrt(2 * 9.8 * one.scene.size) * 3.5;
  EXPECT_NEAR(one.metric("drive.reached").value, 3.4 / told, 1e-9);
  drive.end[0].p_WBcm.y += 0.034;
  EXPECT_NEAR(one.metric("drive.lateral").value, 0.01, 1e-9);
  EXPECT_EQ(one.metric("drive.lateral").verdict, Verdict::kWarn);
}

TEST(Metric, OfARobotThatGoesBackwards) {
  Case one("drive");
  PhaseMeasures& drive = one.phase("drive");
  drive.axis_path = {34, 34};
  drive.end[0].p_WBcm.x -= 0.5;
  const Metric metric = one.metric("drive.direction");
  EXPECT_EQ(metric.verdict, Verdict::kFail);
  ASSERT_TRUE(metric.fact);
  EXPECT_EQ(metric.fact->kind, FactKind::kDriveBackwards);
  EXPECT_EQ(metric.fact->subject, "my_robot");
  EXPECT_EQ(metric.fact->test, "drive");
  EXPECT_EQ(one.metric("drive.ratio").verdict, Verdict::kFail);
}

/// Wheels on two axles: what ODE's pyramid of friction holds is no failure of the robot's.
TEST(Metric, ASkidThatThePyramidHoldsIsAWarning) {
  Case one("turn");
  one.wheels.left.push_back(one.wheels.left.front());
  one.wheels.left.back().center_W.x -= 0.3;
  PhaseMeasures& spin = one.phase("spin");
  spin.axis_path = {-13, 13};
  spin.yaw_path[0] = 0;
  const Metric metric = one.metric("turn.spin");
  EXPECT_EQ(metric.value, 1);
  EXPECT_EQ(metric.verdict, Verdict::kWarn);
  ASSERT_TRUE(metric.fact);
  EXPECT_FALSE(metric.fact->severe);
  EXPECT_NE(metric.fact->help.find("pyramid"), std::string::npos);
}

TEST(Metric, ATurnMayBeOffByTheWheelsWidth) {
  Case one("turn");
  PhaseMeasures& spin = one.phase("spin");
  spin.axis_path = {-13, 13};  // 1.3 m each way, 2.6 m apart, over 0.26 m of track: 10 rad
  const auto of_yaw = [&](double yaw) {
    spin.yaw_path[0] = yaw;
    return one.metric("turn.spin").value;
  };
  EXPECT_NEAR(of_yaw(10), 0, 1e-12);
  EXPECT_NEAR(of_yaw(10 * 0.26 / 0.31), 0, 1e-9);  // on the wheels' outer edges
  EXPECT_NEAR(of_yaw(10 * 0.26 / 0.21), 0, 1e-9);  // on their inner ones
  EXPECT_NEAR(of_yaw(5), 1 - 0.5 / (0.26 / 0.31), 1e-9);
  EXPECT_NEAR(of_yaw(-10), 1 + 1 / (0.26 / 0.31), 1e-9);
}

TEST(Metric, RestIsHeldAgainstWeightAndSupport) {
  Case one("settle");
  PhaseMeasures& rest = one.phase("rest");
  const double weight = 6 * 9.8;
  rest.ground_force = {0, 0, 0.98 * weight * static_cast<double>(rest.steps)};
  EXPECT_NEAR(one.metric("rest.weight_balance").value, 0.02, 1e-9);
  EXPECT_EQ(one.metric("rest.weight_balance").verdict, Verdict::kFail);
  rest.end[0].p_WBcm.x += 0.001;
  EXPECT_NEAR(one.metric("rest.creep").value, 0.001 / 0.2, 1e-9);
  // A square of 0.2 m with the center of mass (x = 0.1 / 6) 0.0167 off its middle.
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.1, 0.1}) one.record.measures.support.push_back({0, {x, y, 0}});
  }
  EXPECT_NEAR(one.metric("rest.support_margin").value, (0.1 - 0.1 / 6) / 0.1, 1e-9);
}

TEST(Metric, NeverSettlingIsToldEvenInAShortRun) {
  Case one("settle");
  one.record.measures.settle_time = kInfinity;
  const Metric metric = one.metric("settle.time");
  ASSERT_TRUE(metric.fact);
  EXPECT_EQ(metric.warn, metric.fact->limit);  // the table and the finding refer to one limit
  EXPECT_EQ(metric.verdict, Verdict::kWarn);
  ASSERT_TRUE(metric.fact);
  EXPECT_EQ(metric.fact->kind, FactKind::kNeverSettles);
}

TEST(Metric, EnergyIsAShareOfWhatItsWeightHasOverItsSize) {
  Case one("settle");
  one.phase("settle").energy = {0.05 * 6 * 9.8 * one.scene.size, kWorld, 0.5};
  EXPECT_NEAR(one.metric("energy.gain").value, 0.05, 1e-12);
}

TEST(Metric, AControllersMarginIsOfTheTwoInertiasInSeries) {
  Case one("settle");
  one.scenario.commands.push_back(
      {.joint = 0, .kind = CommandKind::kPosition, .gains = Gains{.p = 1, .d = 2}});
  // The wheel's m r²/2 about its axis; the chassis' iyy about a line at x = 0.1, at its height.
  const double wheel = 0.5 * 0.01 / 2;
  const double chassis = 5 * 0.17 / 12 + 5 * 0.01;
  EXPECT_NEAR(one.metric("joint.pd_margin").value, 2 * 0.001 * (1 / wheel + 1 / chassis), 1e-9);
}

TEST(Metric, AnExplosionIsToldOfTheCulpritAndNothingOfTheEnd) {
  Case one("drive");
  one.record.end = Record::End::kFarAway;
  one.record.culprit = 2;
  const Metric metric = one.metric("state.oversize");
  ASSERT_TRUE(metric.fact);
  EXPECT_EQ(metric.fact->subject, "my_robot/link right_wheel");
  EXPECT_EQ(one.metric("drive.ratio").id, "none");
  EXPECT_EQ(one.metric("rest.creep").id, "none");
}

/// A hinge that is to go from -1 to 1 rad and ends at 0.5.
Case short_sweep() {
  Case one("settle");
  one.scenario.phases.push_back({"sweep my_robot::left_wheel_hinge", 1, 5});
  for (const double target : {-1.0, 1.0}) {
    one.scenario.commands.push_back(
        {.joint = 0, .kind = CommandKind::kPosition, .value = target, .begin = 1, .end = 5});
  }
  one.record = still_record(one.scene, one.scenario);
  PhaseMeasures& sweep = one.record.measures.phases.back();
  sweep.axis_min[0] = -1;
  sweep.axis_max[0] = 0.5;
  return one;
}

TEST(Metric, AJointThatStopsShortIsTooWeakOrStopped) {
  Case one = short_sweep();
  PhaseMeasures& sweep = one.record.measures.phases.back();
  EXPECT_NEAR(one.metric("joint.reach").value, 0.25, 1e-12);
  EXPECT_EQ(one.metric("joint.reach").fact->kind, FactKind::kJointShort);
  sweep.axis_effort[0] = 1;
  one.scene.joints[0].axes[0].effort = 5;
  EXPECT_EQ(one.metric("joint.reach").fact->kind, FactKind::kJointOverloaded);
}

/// The inertia of some link, which is a likely cause else, is none then.
TEST(Metric, AJointThatItsOwnLinksStopIsToldWhichMeet) {
  Case one = short_sweep();
  PhaseMeasures& sweep = one.record.measures.phases.back();
  sweep.self_contact = {0.00005, 0, 2};
  sweep.self_contact_with = 1;
  const Metric reach = one.metric("joint.reach");
  EXPECT_EQ(reach.verdict, Verdict::kWarn);
  for (const std::uint32_t shape : {0U, 1U}) {
    EXPECT_NE(reach.fact->help.find(about_shape(one.scene, shape).subject), std::string::npos)
        << reach.fact->help;
  }
  const Facts causes{{.kind = FactKind::kCauseInertia, .subject = "my_robot/link left_wheel"}};
  EXPECT_TRUE(explain(*reach.fact, causes).empty());
}

/// How it stands without them nobody knows; what joints do is known.
TEST(Metric, WithoutItsMeshesAModelsStanceIsNoFailure) {
  Case one("settle");
  one.record.measures.phases[0].tilt = {1.5, 0, 0};
  one.record.measures.phases[0].anchor_error = {0.1, 0, 0};
  EXPECT_EQ(one.metric("tilt.max").verdict, Verdict::kFail);
  one.scene.models[0].missing_shapes = 1;
  EXPECT_EQ(one.metric("tilt.max").verdict, Verdict::kWarn);
  EXPECT_FALSE(one.metric("tilt.max").fact->severe);
  EXPECT_EQ(one.metric("joint.anchor_error").verdict, Verdict::kFail);
}

}  // namespace
}  // namespace rigor
