// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collide/collider_module.h>

#include <dlfcn.h>

namespace rigor::mesh {

OpenedColliders open_colliders(const std::string& module) {
  void* handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* found = handle == nullptr ? nullptr : ::dlsym(handle, kMakeColliderEngine);
  if (found == nullptr) {
    const char* reason = ::dlerror();  // begins with the path
    return {nullptr, reason ? reason : module + ": not found"};
  }
  const auto make = reinterpret_cast<decltype(&rigor_make_collider_engine)>(found);
  OpenedColliders opened{std::unique_ptr<const ColliderEngine>(make(RIGOR_VERSION)), {}};
  if (!opened.engine) opened.problem = module + ": of another version than " RIGOR_VERSION;
  return opened;
}

}  // namespace rigor::mesh
