// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers behind an input of a Collada geometry: a <source>, whose <accessor> says how a
// <float_array> is to be read.
//
//   ColladaNumbers normals = read_collada_source(index, "#cube-normals", 3);
//   if (!normals.problem) use(normals.numbers);

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <rigor/mesh/collada/index.h>

namespace rigor::mesh {

struct ColladaNumbers {
  std::vector<double> numbers;  ///< so many an item; no more than the accessor's count says
  std::uint64_t bytes_read = 0;
  const char* problem = nullptr;  ///< why there are none
};

/// The first `width` numbers of each item. Of colors without an opacity, the fourth is 1.
ColladaNumbers read_collada_source(const ColladaIndex& index, std::string_view url,
                                   std::size_t width);

}  // namespace rigor::mesh
