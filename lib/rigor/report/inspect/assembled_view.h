// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is seen of a model that stands assembled: its size, the plane that it is mirrored in, its parts in
// pairs, its wheels, and how far each link is from the one that carries it.
//
//   std::fputs(assembled_text(inspection).c_str(), stdout);

#pragma once

#include <string>

#include <rigor/report/inspect/inspect.h>

namespace rigor::report {

/// For people. Shapes are compared as boxes around them; those of meshes that cannot be read are counted.
std::string assembled_text(const Inspection& inspection);

/// The same for programs; what is not known is null.
std::string assembled_json(const Inspection& inspection);

}  // namespace rigor::report
