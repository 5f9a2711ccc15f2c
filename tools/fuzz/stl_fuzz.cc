// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz 60 stl`: any bytes, as an STL and as an OBJ.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/mesh/obj/obj.h>
#include <rigor/mesh/stl/stl.h>

#include "sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  rigor::fuzz::expect_sound(rigor::mesh::read_stl(bytes));
  rigor::fuzz::expect_sound(rigor::mesh::read_obj(bytes));
  return 0;
}
