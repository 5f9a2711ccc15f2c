// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// rigor-worker: the program in which the library runs what may crash, hang or eat memory. It is started by the
// library (rigor/process/workers.h), not by hand.

#include <cstdio>

#include <rigor/convert/urdfdom.h>
#include <rigor/mesh/importer/scene.h>
#include <rigor/process/serve.h>
#include <rigor/simulate/run.h>

int main() {
  const int code = rigor::process::serve({
      rigor::mesh::import_service(),
      rigor::mesh::importer_name_service(),
      rigor::convert::urdfdom_service(),
      rigor::simulate::run_service(),
      rigor::simulate::engine_service(),
  });
  if (code != 0)
    std::fputs("rigor-worker is started by rigor, which tells it what to do\n", stderr);
  return code;
}
