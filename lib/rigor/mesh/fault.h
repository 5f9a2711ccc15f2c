// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with a mesh file, as data. A rule or a command puts it into words.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigor::mesh {

enum class FaultKind : std::uint8_t {
  // There is no mesh: the rest of what was read is empty.
  kUnreadable,       ///< the disk said no; `detail` is its reason
  kTooLarge,         ///< over kMaxMeshBytes, or more vertices or triangles than the bounds
  kLfsPointer,       ///< a Git LFS pointer stands in place of the file
  kUnknownFormat,    ///< neither by its ending nor by its bytes; `detail` is the ending
  kEmpty,            ///< no bytes, or no triangles
  kMalformed,        ///< cannot be parsed; `detail` says at what, `line` where
  kImporterCrashed,  ///< the scene importer died or ran out of time or memory; `detail` says which
  kImporterMissing,  ///< no importer for scenes is installed
  kWorkerMissing,    ///< no worker to import it in could be started; `detail` says why
  kIndexOutOfRange,  ///< a face names a vertex that there is not
  kNotFinite,        ///< a coordinate is NaN or infinite; `count` of them, `line` of the first
  // The mesh could be read all the same.
  kTruncated,          ///< fewer triangles than the file promises; `count` are missing
  kTrailingBytes,      ///< `count` bytes behind the last triangle
  kSolidHeader,        ///< a binary STL that begins with "solid"
  kDecimalComma,       ///< numbers written 1,5; `count` of them
  kNoEndsolid,         ///< an ASCII STL that ends without `endsolid`
  kSeveralSolids,      ///< `count` solids in one STL
  kNotTriangles,       ///< `count` lines or points, which are passed over
  kExtensionMismatch,  ///< the bytes are of another format than the ending says; `detail` names it
};

struct Fault {
  FaultKind kind = FaultKind::kMalformed;
  std::string detail = {};
  std::uint64_t count = 0;
  std::uint64_t line = 0;  ///< 1-based in a text format; else 0
};

/// Whether the fault means that there is no mesh.
constexpr bool fatal(FaultKind kind) { return kind <= FaultKind::kNotFinite; }

}  // namespace rigor::mesh
