// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs one model in MuJoCo as a test of `rigor simulate` does, and prints what its base and joints did.
//
//   run convert IN.urdf OUT.xml      MuJoCo's own reading of a URDF, as MJCF
//   run MODEL.xml < PLAN             PLAN: a line each of
//     start JOINT VALUE              position at the start, rad or m
//     limit JOINT EFFORT             N·m or N; or inf. Gives it a servo
//     velocity|position JOINT VALUE BEGIN END RAMP
//     down | drop METERS             set down on the floor, and raised above it
//     duration SECONDS
//
// Prints: "tilt" (deg, largest, of the base), "way" (m, x and y of the base), "yaw" (rad), "creep" (mm/s, over the last
// fifth), "speed" (mm/s, largest of a body then), "off" (rad or m: the largest error of a position or of a standing joint), "effort"
// (the largest share of a limit, for 20 ms), "height" (m, of the base).

#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kMostCommands = 4096, kMostJoints = 1024, kRow = 20 };

static const double kRise = 0.02;  // s: in which the integral part of a servo takes over a load
static const double kGain = 0.1;  // of what a step can take: explicit, and stable below 2

typedef struct {
  int joint, is_position;
  double value, begin, end, ramp, before;
} Command;

typedef struct {
  const mjModel* m;
  mjData* d;
  Command commands[kMostCommands];
  int count;
  double limit[kMostJoints], force[kMostJoints], integral[kMostJoints], row[kMostJoints][kRow], drop, duration;
  mjtNum begin[kMostJoints];  // qpos
  int down;
} Run;

static int joint_of(const Run* run, const char* name) { return mj_name2id(run->m, mjOBJ_JOINT, name); }

static int read_plan(Run* run) {
  char line[1024], what[64], name[512];
  run->duration = 1;
  while (fgets(line, sizeof line, stdin)) {
    Command c = {0};
    if (sscanf(line, "duration %lf", &run->duration) == 1) continue;
    if (sscanf(line, "drop %lf", &run->drop) == 1 || !strncmp(line, "down", 4)) {
      run->down = 1;
      continue;
    }
    if (sscanf(line, "%63s %511s %lf %lf %lf %lf", what, name, &c.value, &c.begin, &c.end, &c.ramp) < 3) continue;
    c.joint = joint_of(run, name);
    if (c.joint < 0) {
      printf("no joint %s; ", name);
      continue;
    }
    if (!strcmp(what, "limit")) {
      run->limit[c.joint] = c.value;
    } else if (!strcmp(what, "start")) {
      run->d->qpos[run->m->jnt_qposadr[c.joint]] = c.value;
    } else if (run->count < kMostCommands) {
      c.is_position = !strcmp(what, "position");
      run->commands[run->count++] = c;
    }
  }
  return 0;
}

static int floor_of(const mjModel* m) { return mj_name2id(m, mjOBJ_GEOM, "rigor_floor"); }

static int touches_floor(const Run* run) {
  const int plane = floor_of(run->m);
  for (int i = 0; i < run->d->ncon; ++i) {
    const mjContact* c = &run->d->contact[i];
    if ((c->geom1 == plane || c->geom2 == plane) && c->dist < 0) return 1;
  }
  return 0;
}

static void set_down(Run* run, int free_joint) {
  double* z = &run->d->qpos[run->m->jnt_qposadr[free_joint] + 2];
  double low = *z - 20, high = *z + 20;
  for (int i = 0; i < 60; ++i) {
    *z = (low + high) / 2;
    mj_forward(run->m, run->d);
    *(touches_floor(run) ? &low : &high) = *z;
  }
  *z = high + run->drop;
}

/// The speed that a joint is told; 0 where it is to stand.
static double target_of(const Run* run, int j) {
  const Command* active = NULL;
  for (int i = 0; i < run->count; ++i) {
    const Command* c = &run->commands[i];
    if (c->joint == j && run->d->time >= c->begin - 1e-9 && run->d->time < c->end - 1e-9) active = c;
  }
  if (!active) return 0;
  if (active->is_position) {
    const int stands = active->begin == 0 && active->end >= run->duration - 1e-9;
    const double speed = 20 * (active->value - run->d->qpos[run->m->jnt_qposadr[j]]);
    return stands ? 0 : fmax(-5, fmin(5, speed));
  }
  const double t = run->d->time - active->begin;
  const double share = active->ramp > 0 && t < active->ramp ? t / active->ramp : 1;
  return active->before + share * (active->value - active->before);
}

/// What dry friction does to a joint, N·m or N.
static double friction_force(const Run* run, int dof) {
  for (int i = 0; i < run->d->nefc; ++i) {
    if (run->d->efc_type[i] == mjCNSTR_FRICTION_DOF && run->d->efc_id[i] == dof) return run->d->efc_force[i];
  }
  return 0;
}

/// A servo of each joint that the plan gives a limit. What is to stand is held by dry friction of that size, which is solved with the
/// contacts; what is to move, by a damper about its speed on top of what its own load takes.
static void control(Run* run) {
  for (int j = 0; j < run->m->njnt && j < kMostJoints; ++j) {
    if (!(run->limit[j] > 0)) continue;
    const int a = run->m->jnt_dofadr[j];
    const double target = target_of(run, j);
    mjtNum* impedance = run->m->dof_solimp + mjNIMP * a;
    impedance[0] = impedance[1] = 0.9999;  // else dry friction creeps
    run->m->dof_frictionloss[a] = target == 0 ? fmin(run->limit[j], 1e6) : 0;
    const double gain = kGain * run->m->dof_M0[a] / run->m->opt.timestep;
    const double error = target - run->d->qvel[a];
    run->integral[j] = target == 0 ? 0 : run->integral[j] + error * run->m->opt.timestep;
    const double force = target == 0 ? 0 : run->d->qfrc_bias[a] + gain * (error + run->integral[j] / kRise);
    run->d->qfrc_applied[a] = fmax(-run->limit[j], fmin(run->limit[j], force));
    run->force[j] = target == 0 ? friction_force(run, a) : run->d->qfrc_applied[a];
  }
}

/// Ramps begin where the command before them ended.
static void link_ramps(Run* run) {
  for (int i = 0; i < run->count; ++i) {
    for (int k = 0; k < run->count; ++k) {
      const Command* other = &run->commands[k];
      const int precedes = other->joint == run->commands[i].joint && !other->is_position && fabs(other->end - run->commands[i].begin) < 1e-9;
      if (precedes) run->commands[i].before = other->value;
    }
  }
}

static double effort_share(Run* run, long step) {
  double most = 0;
  for (int j = 0; j < run->m->njnt && j < kMostJoints; ++j) {
    if (!(run->limit[j] > 0) || isinf(run->limit[j])) continue;
    run->row[j][step % kRow] = fabs(run->force[j]) / run->limit[j];
    double least = INFINITY;
    for (int i = 0; i < kRow; ++i) least = fmin(least, run->row[j][i]);
    if (step >= kRow) most = fmax(most, least);
  }
  return most;
}

static double fastest(const Run* run) {
  double most = 0;
  for (int b = 1; b < run->m->nbody; ++b) {
    mjtNum v[6];
    mj_objectVelocity(run->m, run->d, mjOBJ_BODY, b, v, 0);
    most = fmax(most, sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]));
  }
  return most;
}

static double farthest_off(const Run* run) {
  double most = 0;
  for (int i = 0; i < run->count; ++i) {
    const Command* c = &run->commands[i];
    const int a = run->m->jnt_qposadr[c->joint];
    const int whole = c->begin == 0 && c->end >= run->duration - 1e-9;
    if (!whole || (!c->is_position && c->value != 0)) continue;
    most = fmax(most, fabs(run->d->qpos[a] - (c->is_position ? c->value : run->begin[a])));
  }
  return most;
}

static void simulate(Run* run) {
  const mjModel* m = run->m;
  mjData* d = run->d;
  int free_joint = -1;
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] == mjJNT_FREE) free_joint = j;
  }
  if (free_joint >= 0 && run->down && floor_of(m) >= 0) set_down(run, free_joint);
  mj_forward(m, d);
  memcpy(run->begin, d->qpos, sizeof(mjtNum) * (size_t)(m->nq < kMostJoints ? m->nq : kMostJoints));
  const int base = free_joint >= 0 ? m->jnt_bodyid[free_joint] : (m->nbody > 1 ? 1 : 0);
  const double* R = d->xmat + 9 * base;
  const double up[3] = {R[6], R[7], R[8]};
  double first[3], late[3], last_yaw = 0, yaw = 0, tilt = 0, speed = 0, off = 0, effort = 0;
  memcpy(first, d->xpos + 3 * base, sizeof first);
  const double yaw0 = atan2(R[3], R[0]);
  last_yaw = yaw0;
  const long steps = lround(run->duration / m->opt.timestep), rest = steps - steps / 5;
  for (long i = 0; i < steps; ++i) {
    control(run);
    mj_step(m, d);
    double turned = atan2(R[3], R[0]) - last_yaw;
    last_yaw += turned;
    if (turned > mjPI) turned -= 2 * mjPI;
    if (turned < -mjPI) turned += 2 * mjPI;
    yaw += turned;
    double upright = 0;
    for (int r = 0; r < 3; ++r) upright += (r == 2) * (R[3 * r] * up[0] + R[3 * r + 1] * up[1] + R[3 * r + 2] * up[2]);
    tilt = fmax(tilt, acos(fmax(-1, fmin(1, upright))));
    if (i == rest) memcpy(late, d->xpos + 3 * base, sizeof late);
    if (i >= rest) {
      speed = fmax(speed, fastest(run));
      off = fmax(off, farthest_off(run));
    }
    effort = fmax(effort, effort_share(run, i));
  }
  const double* p = d->xpos + 3 * base;
  const double creep = hypot(p[0] - late[0], p[1] - late[1]) / ((steps - rest) * m->opt.timestep);
  printf("tilt %.2f way %.4f %.4f yaw %.4f creep %.3f speed %.2f off %.4f effort %.2f height %.3f\n", tilt * 180 / mjPI, p[0] - first[0],
         p[1] - first[1], yaw, 1e3 * creep, 1e3 * speed, off, effort, p[2]);
}

int main(int count, char** words) {
  char error[2000] = "";
  static Run run;
  if (count == 4) {
    mjModel* m = mj_loadXML(words[2], NULL, error, sizeof error);
    if (!m || !mj_saveLastXML(words[3], m, error, sizeof error)) return printf("rejected: %s\n", error), 1;
    return 0;
  }
  mjModel* m = mj_loadXML(words[1], NULL, error, sizeof error);
  if (!m) return printf("rejected: %s\n", error), 1;
  run.m = m;
  run.d = mj_makeData(m);
  read_plan(&run);
  link_ramps(&run);
  simulate(&run);
  return 0;
}
