// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/mesh_check/mesh_fault.h>

#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

std::string words(const mesh::Fault& fault) {
  using Kind = mesh::FaultKind;
  switch (fault.kind) {
    case Kind::kUnreadable: return fault.detail;
    case Kind::kTooLarge: return "is too large" + (fault.detail.empty() ? "" : ": " + fault.detail);
    case Kind::kLfsPointer: return "is a Git LFS pointer, not the file: run git lfs pull";
    case Kind::kUnknownFormat: return "has no known mesh format";
    case Kind::kEmpty:
      return "has no triangles" + (fault.detail.empty() ? "" : ": " + fault.detail);
    case Kind::kMalformed: return "cannot be read: " + fault.detail;
    case Kind::kImporterCrashed: return "cannot be read: the importer " + fault.detail;
    case Kind::kImporterMissing: return "cannot be read: assimp is not installed";
    case Kind::kWorkerMissing: return "cannot be read: the importer " + fault.detail;
    case Kind::kIndexOutOfRange: return "a face refers to a vertex that does not exist";
    case Kind::kNotFinite:
      return "a coordinate is not finite" + (fault.detail.empty() ? "" : ": " + fault.detail);
    case Kind::kTruncated:
      return counted(fault.count, "triangle") + " fewer than the header declares";
    case Kind::kTrailingBytes: return counted(fault.count, "byte") + " after the last triangle";
    case Kind::kSolidHeader:
      return "is a binary STL whose header begins with \"solid\", which some readers misread as "
             "ASCII";
    case Kind::kDecimalComma: return counted(fault.count, "number") + " with a decimal comma";
    case Kind::kNoEndsolid: return "ends without endsolid";
    case Kind::kSeveralSolids: return "contains " + counted(fault.count, "solid");
    case Kind::kNotTriangles:
      return counted(fault.count, "element") + " that is not a face is ignored";
    case Kind::kExtensionMismatch: return "is a " + fault.detail + " file, despite its extension";
  }
  return {};
}

}  // namespace

std::string fault_text(const mesh::Fault& fault) {
  std::string text = words(fault);
  if (fault.line > 0) text += " (line " + std::to_string(fault.line) + ")";
  return text;
}

}  // namespace rigor::report
