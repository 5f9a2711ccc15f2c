// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/simulate.h>

#include <gtest/gtest.h>

#include <rigor/simulate/confirm.h>
#include <rigor/simulate/engine_comparison.h>
#include <rigor/simulate/metric/assertion.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/test/tests.h>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"
#include "support/workers.h"

namespace rigor {
namespace {

using namespace simulate;
using hand::tutorial_robot;

simulate::Run failed_run() {
  simulate::Run run{.test = "t"};
  run.metrics = {make_metric("ground.sink", 1, {}), make_metric("rest.creep", 0, {})};
  return run;
}

std::vector<Again> agains_that_fail(std::size_t failing, std::size_t all) {
  std::vector<Again> agains(all);
  for (std::size_t i = 0; i < all; ++i) {
    agains[i].metrics = {make_metric("ground.sink", i < failing ? 1 : 0, {})};
  }
  return agains;
}

Again again_that_shows(bool failure) {
  Again again;
  again.metrics = {make_metric("ground.sink", failure ? 1 : 0, {})};
  return again;
}

TEST(Simulate, AFailureThatTheOtherSolverAndHalfTheStepLackIsTheSolvers) {
  simulate::Run run = failed_run();
  confirm(agains_that_fail(0, 2), run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kSolver);
  ASSERT_TRUE(run.metrics[0].fact);
  EXPECT_EQ(run.metrics[0].fact->kind, FactKind::kSolverDiffers);
  EXPECT_EQ(run.metrics[0].fact->name, "ground.sink");
  ASSERT_EQ(run.confirmations.size(), 2U);
  EXPECT_FALSE(run.confirmations[0].agrees);
}

/// Seeds share the run's solver and step: however many show it, they show those.
TEST(Simulate, SeedsNeverOutvoteTheOtherSolverAndHalfTheStep) {
  simulate::Run run = failed_run();
  confirm({again_that_shows(false), again_that_shows(false), again_that_shows(true),
           again_that_shows(true)},
          run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kSolver);
}

TEST(Simulate, AFailureThatTheOtherSolverShowsIsTheModels) {
  simulate::Run run = failed_run();
  confirm(agains_that_fail(1, 1), run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kFail);
  EXPECT_EQ(run.metrics[0].fact->kind, FactKind::kSinks);
}

/// Of the run, the other solver and half the step two that agree are enough.
TEST(Simulate, RunsAreMadeUntilTwoAgree) {
  const simulate::Run run = failed_run();
  struct Shown {
    std::vector<bool> shown;
    Next next;
  };
  for (const Shown& c :
       std::vector<Shown>{{{}, Next::kVariant},
                          {{true}, Next::kNone},
                          {{false}, Next::kVariant},
                          {{false, true}, Next::kVariant},  // of how much is chance
                          {{false, true, false}, Next::kNone},
                          {{false, false}, Next::kNone}}) {
    std::vector<Again> agains;
    for (const bool shown : c.shown) agains.push_back(again_that_shows(shown));
    EXPECT_EQ(next_of(agains, run), c.next) << c.shown.size();
  }
}

TEST(Simulate, WhatTookTooLongHasNoVote) {
  simulate::Run run = failed_run();
  std::vector<Again> agains = agains_that_fail(0, 3);
  agains[0].record.end = Record::End::kOutOfTime;
  agains[0].stopped = true;
  confirm(agains, run);  // one of three
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kSolver);
  EXPECT_FALSE(run.confirmations[0].in_time);
  EXPECT_TRUE(run.confirmations[0].lacking.empty());
  EXPECT_EQ(run.confirmations[1].lacking, std::vector<std::string_view>{"ground.sink"});
  // Nor does it end the search: with one against one a seed is asked.
  EXPECT_EQ(next_of({agains[0], agains[1]}, failed_run()), Next::kVariant);
}

simulate::Run restless_run() {
  simulate::Run run{.test = "t"};
  run.metrics = {make_metric("rest.residual_v", 0.01, {}), make_metric("tilt.max", 0.2, {})};
  return run;
}

Again exact_at_rest() {
  Again again;
  again.variant.other = Variant::Other::kSolver;
  again.variant.settings.solver = Solver::kDantzig;
  again.metrics = {make_metric("rest.residual_v", 0.0001, {}), make_metric("tilt.max", 0, {})};
  return again;
}

TEST(Simulate, AWarningOfRestThatTheExactSolverLacksPasses) {
  simulate::Run run = restless_run();
  confirm({exact_at_rest()}, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kPass);
  EXPECT_EQ(run.metrics[0].value, 0.0001);
  EXPECT_FALSE(run.metrics[0].fact);
  // Solvers agree on where a robot goes.
  EXPECT_EQ(run.metrics[1].verdict, Verdict::kWarn);
  ASSERT_EQ(run.confirmations.size(), 1U);
  EXPECT_EQ(run.confirmations[0].lacking, std::vector<std::string_view>{"rest.residual_v"});
}

TEST(Simulate, AWarningStaysWhereTheExactSolverHasItOrNothingToSay) {
  const auto verdict_after = [](const Again& again) {
    simulate::Run run = restless_run();
    confirm({again}, run);
    return run.metrics[0].verdict;
  };
  Again same = exact_at_rest();
  same.metrics[0] = make_metric("rest.residual_v", 0.006, {});
  EXPECT_EQ(verdict_after(same), Verdict::kWarn);
  Again late = exact_at_rest();
  late.record.end = Record::End::kOutOfTime;
  EXPECT_EQ(verdict_after(late), Verdict::kWarn);
  Again finer = exact_at_rest();
  finer.variant.other = Variant::Other::kStep;
  finer.variant.settings.solver = Solver::kQuick;
  EXPECT_EQ(verdict_after(finer), Verdict::kWarn);
}

/// Half the step shows what the iterative solver shows.
TEST(Simulate, AFailureOfRestThatTheExactSolverLacksPasses) {
  simulate::Run run{.test = "t"};
  run.metrics = {make_metric("rest.residual_v", 0.1, {})};
  Again half;
  half.variant.other = Variant::Other::kStep;
  half.metrics = {make_metric("rest.residual_v", 0.05, {})};
  EXPECT_EQ(next_of({exact_at_rest()}, run), Next::kNone);
  confirm({exact_at_rest(), half}, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kPass);
  // What is no matter of rest is voted on.
  run.metrics = {make_metric("accel.peak", 600, {})};
  Again exact = exact_at_rest();
  exact.metrics = {make_metric("accel.peak", 1, {})};
  half.metrics = {make_metric("accel.peak", 600, {})};
  confirm({exact, half}, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kFail);
}

TEST(Simulate, OfAWarningTheExactSolverAloneIsAsked) {
  SolverSettings settings;
  EXPECT_TRUE(has_doubtful_warning(restless_run(), settings));
  EXPECT_EQ(next_of({}, restless_run()), Next::kVariant);
  EXPECT_EQ(next_of({exact_at_rest()}, restless_run()), Next::kNone);
  settings.solver = Solver::kDantzig;
  EXPECT_FALSE(has_doubtful_warning(restless_run(), settings));
  settings.solver = Solver::kQuick;
  settings.engine = EngineKind::kMujoco;
  EXPECT_FALSE(has_doubtful_warning(restless_run(), settings));
}

/// Eight balls on an arm of 1.6 m that motors hold: 200 iterations let it swing.
Scene long_arm() {
  Scene scene = hand::scene();
  for (std::uint32_t i = 0; i < 8; ++i) {
    const double x = 0.2 * (i + 1);
    hand::add_body(scene, hand::ball_mass(0.1, 0.05), {x, 0, 1});
    hand::add_joint(scene, model::JointType::kRevolute, i == 0 ? kWorld : i - 1, i, {x - 0.2, 0, 1},
                    {{0, 1, 0}});
  }
  return scene;
}

TEST(Simulate, AnArmThatTheIterativeSolverLetsSwingIsAtRest) {
  const Scene scene = long_arm();
  const DriveTrain wheels;
  const Facts causes;
  const Task task{
      scene, causes, {*make_test("settle", scene, wheels).scenario}, wheels, scene.solver};
  SimulateOptions unconfirmed;
  unconfirmed.confirm = Confirm::kNo;
  EXPECT_NE(simulate::simulate({task}, unconfirmed, test::workers())[0].verdict, Verdict::kPass);
  const Simulation result = simulate::simulate({task}, {}, test::workers())[0];
  EXPECT_EQ(result.verdict, Verdict::kPass);
  ASSERT_EQ(result.runs[0].confirmations.size(), 1U);
  EXPECT_EQ(result.runs[0].confirmations[0].what, "dantzig");
}

Scene box_in_the_ground() {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(6, {0.2, 0.2, 0.2}), {0, 0, 0.05});
  scene.shapes.push_back(
      {.name = "b::c", .body = 0, .kind = mesh::Box{{0.2, 0.2, 0.2}}, .extent = 0.2});
  return scene;
}

Simulation simulated_within(double budget) {
  const Scene scene = box_in_the_ground();
  const DriveTrain wheels;
  const Facts causes;
  const Task task{
      scene, causes, {*make_test("settle", scene, wheels).scenario}, wheels, scene.solver};
  return simulate::simulate({task}, {.budget = budget}, test::workers())[0];
}

/// A box that begins in the ground is shown by the other solver: that is all that is asked.
TEST(Simulate, AFaultOfTheModelsNeedsOneRunMore) {
  const Simulation result = simulated_within(kInfinity);
  const simulate::Run& run = result.runs[0];
  EXPECT_EQ(run.verdict, Verdict::kFail);
  ASSERT_EQ(run.confirmations.size(), 1U);
  EXPECT_EQ(run.confirmations[0].what, "dantzig");
  EXPECT_TRUE(run.confirmations[0].agrees);
}

/// A chain that would use up its budget in one test is not begun. It has no shapes, so that any answer is quick.
TEST(Simulate, MoreJointsThanTheBudgetSufficesForAreLeftOutAndSaid) {
  Scene chain = hand::scene();
  hand::add_body(chain, hand::ball_mass(1, 0.1), {});
  for (std::uint32_t i = 1; i <= 60; ++i) {
    hand::add_body(chain, hand::ball_mass(1, 0.1), {0.2 * i, 0, 0});
    hand::add_joint(chain, model::JointType::kRevolute, i - 1, i, {0.2 * i - 0.1, 0, 0},
                    {{0, 0, 1}});
  }
  chain.gravity = {};
  const DriveTrain wheels;
  const Facts causes;
  const Task task{
      chain, causes, {Scenario{.name = "settle", .duration = 0.01}}, wheels, chain.solver};
  const auto within = [&](double budget) {
    return simulate::simulate({task}, {.budget = budget}, test::workers())[0];
  };
  const Simulation none = within(1);
  EXPECT_TRUE(none.runs.empty());
  ASSERT_EQ(none.left_out.size(), 1U);
  EXPECT_EQ(none.left_out[0].substr(0, 38), "settle: 60 joints are more than the 50");
  EXPECT_EQ(within(10).runs.size(), 1U);
}

TEST(Simulate, WhatTheBudgetDoesNotSufficeForIsLeftOutAndSaid) {
  const Simulation none = simulated_within(0.5);
  EXPECT_TRUE(none.runs.empty());
  ASSERT_EQ(none.left_out.size(), 1U);
  EXPECT_EQ(none.left_out[0].substr(0, 8), "settle: ");
  // The first run leaves less than the second one needs.
  const Simulation unconfirmed = simulated_within(1);
  ASSERT_EQ(unconfirmed.runs.size(), 1U);
  EXPECT_EQ(unconfirmed.verdict, Verdict::kWarn);
  ASSERT_EQ(unconfirmed.left_out.size(), 1U);
  EXPECT_EQ(unconfirmed.left_out[0].substr(0, 24), "confirmation of settle: ");
  EXPECT_EQ(simulated_within(kInfinity).verdict, Verdict::kFail);
}

/// What comes apart where the run itself did not is the other solver's own trouble: it has no say.
TEST(Simulate, AnExplosionElsewhereIsNoContradictionAndNoProof) {
  simulate::Run run = failed_run();
  std::vector<Again> agains = agains_that_fail(0, 4);
  for (Again& again : agains) again.record.end = Record::End::kNotFinite;
  confirm(agains, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kFail);
  agains = agains_that_fail(0, 3);
  agains[0].record.end = Record::End::kNotFinite;
  confirm(agains, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kSolver);
}

TEST(Simulate, ACrashIsInvalidOrTheSolvers) {
  simulate::Run run{.test = "t", .verdict = Verdict::kInvalid};
  run.record.end = Record::End::kCrashed;
  std::vector<Again> agains(4);
  confirm(agains, run);
  EXPECT_EQ(run.verdict, Verdict::kSolver);
  for (Again& again : agains) again.stopped = true;
  confirm(agains, run);
  EXPECT_EQ(run.verdict, Verdict::kInvalid);
}

TEST(Simulate, VariantsDifferInOneThingEach) {
  const std::vector<Variant> variants = variants_of({.step = 0.002, .seed = 7});
  ASSERT_EQ(variants.size(), 4U);
  EXPECT_EQ(variants[0].what, "dantzig");
  EXPECT_EQ(variants[0].settings.solver, Solver::kDantzig);
  EXPECT_EQ(variants[1].settings.step, 0.001);
  // The exact solver has half the step with itself first: it has no other luck than its step.
  EXPECT_EQ(variants_of({.solver = Solver::kDantzig})[0].what, "half the step");
  EXPECT_EQ(variants[2].settings.seed, 8U);
  EXPECT_EQ(variants[3].settings.seed, 9U);
  EXPECT_EQ(variants[3].settings.step, 0.002);
}

/// MuJoCo's solvers all solve the same: only a finer step is another opinion.
TEST(Simulate, MujocoIsHeldAgainstFinerSteps) {
  SolverSettings settings{.step = 0.002};
  settings.engine = EngineKind::kMujoco;
  const std::vector<Variant> variants = variants_of(settings);
  ASSERT_EQ(variants.size(), kMujocoVariants);
  EXPECT_EQ(variants[0].settings.step, 0.001);
  EXPECT_EQ(variants[1].settings.step, 0.0005);
  EXPECT_EQ(variants[1].settings.engine, EngineKind::kMujoco);
  simulate::Run run = failed_run();
  run.engine = EngineKind::kMujoco;
  const std::vector<Again> half{again_that_shows(false)};
  EXPECT_EQ(next_of(half, run), Next::kVariant);
  const std::vector<Again> both{again_that_shows(false), again_that_shows(false)};
  EXPECT_EQ(next_of(both, run), Next::kNone);
  confirm(both, run);
  EXPECT_EQ(run.metrics[0].verdict, Verdict::kSolver);
}

/// Two runs of a test that ended, which differ in one metric.
Simulation in_two_engines(double ode_sinks, double mujoco_sinks) {
  Simulation simulation;
  for (const EngineKind engine : {EngineKind::kOde, EngineKind::kMujoco}) {
    simulate::Run run{.test = "settle", .engine = engine};
    run.metrics = {
        make_metric("ground.sink", engine == EngineKind::kOde ? ode_sinks : mujoco_sinks, {})};
    run.verdict = run.metrics[0].verdict;
    simulation.runs.push_back(std::move(run));
  }
  return simulation;
}

TEST(Simulate, EnginesDifferWhereAMetricFailsInOneOnly) {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {});
  Simulation same = in_two_engines(0.0001, 0.002);  // passes, warns
  compare_engines(scene, same);
  ASSERT_EQ(same.comparisons.size(), 1U);
  EXPECT_TRUE(same.comparisons[0].differences.empty());
  EXPECT_TRUE(same.runs[1].facts.empty());
  Simulation other = in_two_engines(0.0001, 1);
  compare_engines(scene, other);
  ASSERT_EQ(other.comparisons.size(), 1U);
  EXPECT_EQ(other.comparisons[0].ode, Verdict::kPass);
  EXPECT_EQ(other.comparisons[0].mujoco, Verdict::kFail);
  ASSERT_EQ(other.runs[1].facts.size(), 1U);
  EXPECT_EQ(other.runs[1].facts[0].kind, FactKind::kEnginesDiffer);
  EXPECT_EQ(other.runs[1].facts[0].name,
            "ground.sink fails in MuJoCo only: 0.0001 m in ODE, 1 m in MuJoCo");
}

TEST(Simulate, ADifferenceOfEnginesIsExplainedByWhatTheSceneHas) {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(1, {0.2, 0.2, 0.2}), {});
  EngineComparison comparison{.test = "settle", .differences = {"ground.sink fails in ODE only"}};
  const auto begins = [&](const char* words) {
    return explanation_of(scene, comparison).find(words) == 0;
  };
  EXPECT_TRUE(begins("contact softness"));
  hand::add_body(scene, hand::box_mass(2000, {0.2, 0.2, 0.2}), {});
  EXPECT_TRUE(begins("mass ratios"));
  hand::add_shape(scene, 0, mesh::Sphere{0.1}).surface.restitution = 0.5;
  EXPECT_TRUE(begins("restitution"));
  hand::add_shape(scene, 0, TriangleSoup{0});
  EXPECT_TRUE(begins("a hulled mesh"));
}

TEST(Simulate, AnEngineThatIsNotThereIsSaid) {
  SolverSettings settings;
  EXPECT_EQ(engine_problem(settings, test::workers()), "");
  settings.engine = EngineKind::kMujoco;
  settings.library = "/no/libmujoco.so";
  EXPECT_NE(engine_problem(settings, test::workers()).find("apt install libmujoco"),
            std::string::npos);
  settings.library = RIGOR_TESTDATA "simulate/README.md";  // no library at all
  EXPECT_NE(engine_problem(settings, test::workers()), "");
}

TEST(Simulate, VerdictsHaveAnOrder) {
  const Verdict order[] = {Verdict::kPass, Verdict::kWarn, Verdict::kSolver, Verdict::kFail,
                           Verdict::kInvalid};
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_EQ(worse(order[i - 1], order[i]), order[i]);
    EXPECT_EQ(worse(order[i], order[i - 1]), order[i]);
  }
}

Scene grounded_robot() {
  Scene scene = tutorial_robot();
  for (SceneShape& shape : scene.shapes) shape.extent = 0.2;
  return scene;
}

TEST(Simulate, ASaneRobotSettlesAndDrivesAsFarAsItsWheelsRoll) {
  const Scene scene = grounded_robot();
  const DriveTrain wheels = find_wheels(scene, {});
  const Facts causes;
  Task task{scene, causes, {}, wheels, scene.solver};
  for (const char* test : {"settle", "drive"}) {
    task.scenarios.push_back(*make_test(test, scene, wheels).scenario);
  }
  const std::vector<Simulation> one = simulate::simulate({task}, {.jobs = 1}, test::workers());
  const std::vector<Simulation> two =
      simulate::simulate({task, task}, {.jobs = 2}, test::workers());
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].verdict, Verdict::kPass);
  ASSERT_EQ(one[0].runs.size(), 2U);
  for (const Metric& metric : one[0].runs[1].metrics) {
    if (metric.id == "drive.ratio" || metric.id == "drive.lateral") {
      EXPECT_LT(metric.value, 0.005) << metric.id;
    }
  }
  // The same bytes, however many ran at a time.
  for (const Simulation& simulation : two) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(encode(simulation.runs[i].record), encode(one[0].runs[i].record));
    }
  }
}

/// With one job a task is handed over before the next one begins, even when it fails and is run again:
/// whoever writes results as they come loses no more than one when the process is killed.
TEST(Simulate, ATaskIsHandedOverWhenItIsDone) {
  Scene sunk = hand::scene();
  hand::add_body(sunk, hand::box_mass(6, {0.2, 0.2, 0.2}), {0, 0, 0.05});
  sunk.shapes.push_back(
      {.name = "b::c", .body = 0, .kind = mesh::Box{{0.2, 0.2, 0.2}}, .extent = 0.2});
  const DriveTrain wheels;
  const Facts causes;
  const Task fails{
      sunk, causes, {*make_test("settle", sunk, wheels).scenario}, wheels, sunk.solver};
  const Task nothing{sunk, causes, {}, wheels, sunk.solver};
  std::size_t ended = 0;
  SimulateOptions options;
  options.progress = [&](std::size_t count, std::size_t) { ended = count; };
  std::vector<std::size_t> tasks;
  std::vector<std::size_t> ended_before;
  simulate::simulate({fails, nothing, fails}, options, test::workers(),
                     [&](std::size_t task, Simulation result) {
                       tasks.push_back(task);
                       ended_before.push_back(ended);
                       EXPECT_EQ(result.runs.size(), task == 1 ? 0U : 1U);
                       EXPECT_EQ(result.verdict, task == 1 ? Verdict::kPass : Verdict::kFail);
                     });
  // A failure is run twice: as asked for, and by the other solver.
  EXPECT_EQ(tasks, (std::vector<std::size_t>{1, 0, 2}));
  EXPECT_EQ(ended_before, (std::vector<std::size_t>{0, 2, 4}));
}

/// It falls, ever faster, and is never at rest: all of that is the missing mesh, which was said as the scene was built.
TEST(Simulate, WhereAllCollisionsAreMissingTheFallIsNotExplained) {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(6, {0.2, 0.2, 0.2}), {0, 0, 0.1});
  const DriveTrain wheels;
  const auto settled = [&] {
    const Facts causes;
    const Task task{
        scene, causes, {*make_test("settle", scene, wheels).scenario}, wheels, scene.solver};
    return simulate::simulate({task}, {}, test::workers()).at(0).runs.at(0);
  };
  EXPECT_EQ(settled().verdict, Verdict::kFail);
  EXPECT_FALSE(settled().facts.empty());
  scene.models[0].missing_shapes = 1;
  EXPECT_EQ(settled().verdict, Verdict::kWarn);
  EXPECT_TRUE(settled().facts.empty());
}

TEST(Simulate, ACauseThatNoRunShowedComesFirstAndWarns) {
  const Scene scene = grounded_robot();
  const DriveTrain wheels = find_wheels(scene, {});
  const Facts causes{{.kind = FactKind::kCauseMeshWheel, .subject = "w", .severe = true},
                     {.kind = FactKind::kCauseEffort, .subject = "e", .severe = false}};
  Task task{scene, causes, {*make_test("settle", scene, wheels).scenario}, wheels, scene.solver};
  const std::vector<Simulation> result = simulate::simulate({task}, {}, test::workers());
  EXPECT_EQ(result[0].verdict, Verdict::kWarn);
  ASSERT_EQ(result[0].runs[0].facts.size(), 1U);
  EXPECT_EQ(result[0].runs[0].facts[0].kind, FactKind::kCauseMeshWheel);
  EXPECT_FALSE(result[0].runs[0].facts[0].severe);
}

TEST(Simulate, AssertionsOfPosesJointsAndMetrics) {
  Scene scene = tutorial_robot();
  Record record;
  record.times = {0, 0.1, 0.2};
  for (int i = 0; i < 3; ++i) {
    for (std::size_t l = 0; l < 3; ++l) {
      record.link_poses.push_back({{0.5 * i, 0, 0}, model::from_rpy(0.1, 0.2, 0.3)});
    }
    for (const double value : {1.0 * i, 2.0, 3.0, 4.0}) record.axis_values.push_back(value);
  }
  EXPECT_NEAR(*quantity_at(scene, record, "x of chassis", 0.15), 0.75, 1e-12);
  EXPECT_NEAR(*quantity_at(scene, record, "x of my_robot::chassis", kInfinity), 1, 1e-12);
  EXPECT_NEAR(*quantity_at(scene, record, "pitch of chassis", 0.1), 0.2, 1e-12);
  EXPECT_NEAR(*quantity_at(scene, record, "position of left_wheel_hinge", 0.05), 0.5, 1e-12);
  EXPECT_NEAR(*quantity_at(scene, record, "velocity of right_wheel_hinge", 0.05), 4, 1e-12);
  EXPECT_FALSE(quantity_at(scene, record, "x of nobody", 0.1));
  EXPECT_FALSE(quantity_at(scene, record, "x of chassis", 0.3));
  Scenario scenario{.name = "s"};
  scenario.assertions = {
      {.name = "far", .quantity = "x of chassis", .at = 0.2, .least = 2},
      {.name = "near", .quantity = "x of chassis", .at = 0.2, .most = 2},
      {.name = "still", .metric = "rest.creep", .most = 1},
      {.name = "unknown", .metric = "rest.sleep", .most = 1},
  };
  const Facts broken =
      broken_assertions(scene, scenario, record, {make_metric("rest.creep", 0.5, {})});
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken[0].name, "far");
  EXPECT_EQ(broken[0].value, 1);
  EXPECT_EQ(broken[0].limit, 2);
  EXPECT_EQ(broken[1].name, "unknown");
}

}  // namespace
}  // namespace rigor
