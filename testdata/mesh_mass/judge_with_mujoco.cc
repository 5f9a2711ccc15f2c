// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What MuJoCo 2.2 makes of meshes, as facts for tests/corpus/mesh_mass_test.cc. Not part of the build:
//
//   g++ -O1 judge_with_mujoco.cc -lmujoco -o judge && ./judge < paths_of_binary_stl_files
//
// MuJoCo reads binary STL only, so other formats were written as such before (float32 coordinates,
// which are what an importer gives). It holds coordinates in float32 after centring them, which shows
// in the seventh digit of bodies that are thin or far from their origin: of the meshes where it is
// further off than 1e-6, the facts are an evaluation in exact fractions instead (exact.py).

#include <mujoco/mujoco.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

int main() {
  std::string path;
  while (std::getline(std::cin, path)) {
    const std::string scene = "judge_scene.xml";
    std::ofstream(scene)
        << "<mujoco><compiler exactmeshinertia='true'/><asset><mesh name='m' file='" << path
        << "'/></asset><worldbody><body><freejoint/><geom type='mesh' mesh='m' "
           "density='1000'/></body></worldbody></mujoco>";
    char error[1000] = "";
    mjModel* model = mj_loadXML(scene.c_str(), nullptr, error, sizeof error);
    if (model == nullptr) continue;
    mjtNum R[9];
    mju_quat2Mat(R, model->body_iquat + 4);
    const mjtNum* principal = model->body_inertia + 3;
    mjtNum I[9] = {};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) I[3 * i + j] += R[3 * i + k] * principal[k] * R[3 * j + k];
      }
    }
    const mjtNum* com = model->body_ipos + 3;
    std::printf("%s\t%.12g\t%.12g %.12g %.12g\t%.12g %.12g %.12g %.12g %.12g %.12g\n", path.c_str(),
                model->body_mass[1] / 1000, com[0], com[1], com[2], I[0] / 1000, I[1] / 1000,
                I[2] / 1000, I[4] / 1000, I[5] / 1000, I[8] / 1000);
    mj_deleteModel(model);
  }
}
