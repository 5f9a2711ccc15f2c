// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/library.h>

#include <dlfcn.h>

#include <rigor/simulate/engine/mujoco/mujoco_version.h>

namespace rigor::simulate {
namespace {

/// As Debian's package names it, then what a link of a development package or of /usr/local leads to.
constexpr const char* kMujocoNames[] = {"libmujoco.so.2.2.2", "libmujoco.so"};

/// 222 as "2.2.2", 3003002 as "3.3.2": from 3.3 on MuJoCo counts in thousands.
std::string mujoco_version_words(int number) {
  const int base = number >= 100'000 ? 1000 : 10;
  return std::to_string(number / base / base) + '.' + std::to_string(number / base % base) + '.' +
         std::to_string(number % base);
}

void* open_any_mujoco(const std::string& path) {
  if (!path.empty()) return ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  for (const char* name : kMujocoNames) {
    if (void* handle = ::dlopen(name, RTLD_NOW | RTLD_LOCAL)) return handle;
  }
  return nullptr;
}

}  // namespace

std::string mujoco_version() { return mujoco_version_words(mjVERSION_HEADER); }

MujocoLibrary open_mujoco(const std::string& path) {
  MujocoLibrary mujoco;
  const std::string name = path.empty() ? "libmujoco.so" : path;
  void* handle = open_any_mujoco(path);
  if (handle == nullptr) {
    const char* reason = path.empty() ? nullptr : ::dlerror();
    mujoco.problem = "MuJoCo's library is not found: " +
                     (reason ? std::string(reason) : name + " is not installed") +
                     "; Debian: apt install libmujoco2.2.2, or name one with --mujoco PATH";
    return mujoco;
  }
  const auto find = [&]<class Symbol>(const char* symbol, Symbol& found) {
    found = reinterpret_cast<Symbol>(::dlsym(handle, symbol));
    if (!found && mujoco.problem.empty()) {
      mujoco.problem = name + " is not MuJoCo's library: it has no " + symbol;
    }
  };
  decltype(&mj_version) version = nullptr;
  find("mj_version", version);
  if (version != nullptr && version() != mjVERSION_HEADER) {
    mujoco.problem = name + " is MuJoCo " + mujoco_version_words(version()) +
                     ": structs of each version differ, and rigor knows those of " +
                     mujoco_version() + " only";
    return mujoco;
  }
  find("mj_loadXML", mujoco.load_xml);
  find("mj_deleteModel", mujoco.delete_model);
  find("mj_makeData", mujoco.make_data);
  find("mj_deleteData", mujoco.delete_data);
  find("mj_step1", mujoco.step1);
  find("mj_step2", mujoco.step2);
  find("mj_fwdVelocity", mujoco.forward_velocity);
  find("mj_makeConstraint", mujoco.make_constraint);
  find("mj_projectConstraint", mujoco.project_constraint);
  find("mj_objectVelocity", mujoco.object_velocity);
  find("mj_contactForce", mujoco.contact_force);
  find("mju_user_error", mujoco.user_error);
  find("mju_user_warning", mujoco.user_warning);
  return mujoco;
}

}  // namespace rigor::simulate
