// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/mujoco/session.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include <rigor/simulate/engine/engine.h>
#include <rigor/simulate/engine/mujoco/mujoco_engine.h>
#include <rigor/text/write_all.h>

namespace rigor::simulate {
namespace {

// MuJoCo's handlers get no pointer of ours, so what they count has to stand here. A session only speaks of the
// difference since it was made.
std::uint64_t mujoco_warnings = 0;

[[noreturn]] void throw_mujoco_error(const char* message) { throw EngineError(message); }

void count_mujoco_warning(const char*) { ++mujoco_warnings; }

/// A file in memory, which MuJoCo opens by its name: its own way to read from memory differs between versions.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes)
      : number_(::memfd_create("scene.xml", MFD_CLOEXEC)) {
    if (number_ < 0) throw EngineError("there is no room for MuJoCo's model");
    if (write_all(number_, bytes) == 0) return;
    ::close(number_);
    throw EngineError("there is no room for MuJoCo's model");
  }
  ~MemoryFile() { ::close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

/// Its words are on several lines.
std::string in_one_line(std::string words) {
  while (!words.empty() && words.back() == '\n') words.pop_back();
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words;
}

}  // namespace

std::string mujoco_problem(const std::string& path) { return open_mujoco(path).problem; }

MujocoSession::MujocoSession(const std::string& xml, const std::string& library)
    : mujoco(open_mujoco(library)), messages_before_(mujoco_warnings) {
  if (!mujoco.problem.empty()) throw EngineError(mujoco.problem);
  *mujoco.user_error = throw_mujoco_error;
  *mujoco.user_warning = count_mujoco_warning;
  const MemoryFile file(xml);
  std::array<char, 1000> error{};
  model_ = mujoco.load_xml(file.path().c_str(), nullptr, error.data(), error.size());
  if (model_ == nullptr) throw EngineError("MuJoCo: " + in_one_line(error.data()));
  data_ = mujoco.make_data(model_);
  if (data_ == nullptr) {
    mujoco.delete_model(model_);
    throw EngineError("MuJoCo has no room for the scene");
  }
}

MujocoSession::~MujocoSession() {
  mujoco.delete_data(data_);
  mujoco.delete_model(model_);
  *mujoco.user_error = nullptr;
  *mujoco.user_warning = nullptr;
}

std::uint64_t MujocoSession::messages() const { return mujoco_warnings - messages_before_; }

}  // namespace rigor::simulate
