// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/test/tests.h>

#include <rigor/simulate/test/parts.h>

namespace rigor::simulate {
namespace {

using TestMaker = MadeTest (*)(const Scene&, const DriveTrain&);

/// As in kTestNames.
constexpr std::array<TestMaker, kTestNames.size()> kTestMakers{
    make_settle, make_drop,        make_drive, make_turn,      make_brake,
    make_push,   make_joint_sweep, make_hold,  make_tilt_table};

}  // namespace

MadeTest make_test(std::string_view name, const Scene& scene, const DriveTrain& wheels) {
  for (std::size_t i = 0; i < kTestNames.size(); ++i) {
    if (kTestNames[i] == name) return kTestMakers[i](scene, wheels);
  }
  return {{}, "there is no such test"};
}

}  // namespace rigor::simulate
