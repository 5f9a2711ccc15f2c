// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_no_sdf {
namespace {

void check(const read::ConfigFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "no <sdf> names the file to load"});
}

/// Of a folder that the file includes.
void check_included(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the folder of this model cannot be loaded: " + fact.name +
                             " is missing, or names no SDF file"});
}

}  // namespace

Rule rule() {
  return {
      .name = "model-config-no-sdf",
      .category = Category::kPackage,
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a model.config names no SDF file",
      .why = "Whoever includes the folder gets an error: there is nothing to load.",
      .what_to_do = "Write the file to load, as in <sdf version=\"1.9\">model.sdf</sdf>.",
      .bad = {{R"(<sdf version="1.9">
  <world name="lab">
    <include>
      <uri>«box»</uri>
    </include>
  </world>
</sdf>
=== box/readme.txt
a box
)"},
              {R"(<sdf version="1.9">
  <world name="lab">
    <include>
      <uri>«box»</uri>
    </include>
  </world>
</sdf>
=== box/model.config
<model><name>box</name></model>
)"}},
      .good = {{R"(<?xml version="1.0"?>
<model>
  <name>box</name>
  <sdf version="1.9">model.sdf</sdf>
</model>
=== model.sdf
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_config({read::ConfigFactKind::kNoSdf}, check),
                 on_read({read::FactKind::kConfigWithoutSdf}, check_included)},
  };
}

}  // namespace rigor::rules::model_config_no_sdf
