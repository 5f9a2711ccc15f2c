// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// YAML files as values, read as PyYAML's safe loader reads them (YAML 1.1: `yes` is true, `010` is 8,
// `1e3` is a text), with the place of each value kept, and xacro's tags of units.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/text/span.h>
#include <rigor/xacro/fact.h>
#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

struct YamlTrouble {
  FactKind kind = FactKind::kYaml;
  Span where;
  std::string detail;
};

struct YamlResult {
  Value value;  ///< an error when there is trouble
  std::optional<YamlTrouble> trouble;
};

/// `evaluate` gives the value of an expression behind a unit's tag (`!degrees 45*2`), an error when it
/// has reported one.
YamlResult read_yaml(std::string_view bytes, SourceId source, Heap& heap,
                     const std::function<Value(std::string_view expression, Span where)>& evaluate);

}  // namespace rigor::xacro
