// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev bench convert`: how long a model of the corpus takes to be converted, in process once it is
// read, without and with the proof, and as a process; and to MJCF, of models without meshes. Medians over the
// models; one thread.
//
//   rigor_conversion_bench RIGOR_BINARY [SET]     a folder of RIGOR_CORPUS, default all

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <unistd.h>

#include <fmt/core.h>

#include <rigor/author/conversion.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/drawing/looks.h>

#include "measure.h"

namespace {

namespace fs = std::filesystem;
using rigor::author::Conversion;
using rigor::author::Losses;
using rigor::author::Proof;
using rigor::bench::median;
using rigor::bench::seconds;

/// Of each model, of which the least counts: what else the machine does only ever adds.
constexpr int kRounds = 7;
/// A process costs milliseconds: every so-many-th model is measured as one.
constexpr std::size_t kProcessStride = 8;

struct Times {
  std::vector<double> plain, proved, process, mjcf, mjcf_proved;
};

enum class Target { kOther /* URDF of SDF, SDF of URDF */, kMjcf };

double least(const std::vector<double>& rounds) {
  return *std::min_element(rounds.begin(), rounds.end());
}

/// A file that holds one model with links.
class Subject {
 public:
  Subject(const rigor::Environment& environment, std::string path)
      : environment_(environment), path_(std::move(path)) {
    rigor::Sources sources;
    rigor::read::Workspace workspace(environment.disk, sources);
    const rigor::read::Loaded loaded = load(workspace);
    const auto& models = loaded.root.models;
    is_urdf_ = loaded.root.format == rigor::model::Format::kUrdf;
    const auto is_mesh = [](const auto& part) {
      return std::holds_alternative<rigor::model::Mesh>(part.geometry.shape);
    };
    has_meshes_ =
        std::any_of(loaded.root.visuals.begin(), loaded.root.visuals.end(), is_mesh) ||
        std::any_of(loaded.root.collisions.begin(), loaded.root.collisions.end(), is_mesh);
    is_model_ = loaded.file->document->complete() && !loaded.root.links.empty() &&
                std::count_if(models.begin(), models.end(),
                              [](const rigor::model::Model& model) { return !model.parent; }) == 1;
  }

  bool is_model() const { return is_model_; }
  bool is_urdf() const { return is_urdf_; }
  bool has_meshes() const { return has_meshes_; }
  const std::string& path() const { return path_; }

  /// Nothing when it cannot be converted.
  std::optional<double> time(Proof proof, Target target = Target::kOther) const {
    std::vector<double> rounds;
    for (int round = 0; round < kRounds; ++round) {
      // Read anew: no conversion finds what the one before has left.
      rigor::Sources sources;
      rigor::read::Workspace workspace(environment_.disk, sources);
      const rigor::read::Loaded loaded = load(workspace);
      bool done = false;
      rounds.push_back(seconds([&] {
        const Conversion result = convert(sources, workspace, loaded, proof, target);
        done = result.text && result.diagnostics.count(rigor::Severity::kError) == 0;
      }));
      if (!done) return std::nullopt;
    }
    return least(rounds);
  }

 private:
  rigor::read::Loaded load(rigor::read::Workspace& workspace) const {
    return rigor::read::load(
        {workspace, environment_.resolver, environment_.sdf, environment_.urdf},
        workspace.open(path_));
  }

  Conversion convert(rigor::Sources& sources, rigor::read::Workspace& workspace,
                     const rigor::read::Loaded& loaded, Proof proof, Target target) const {
    const rigor::author::ConversionOptions options{
        .proof = proof, .losses = Losses::kAllowed, .out = "/nowhere/robot"};
    if (target == Target::kMjcf) {
      rigor::mass::MeshReads reads(environment_.disk, environment_.workers);
      const auto files = rigor::view::files_of(environment_.resolver, sources, reads);
      return rigor::author::to_mjcf(environment_, sources, workspace, loaded,
                                    {.looks = rigor::view::looks_of(loaded.root, sources, files)},
                                    options);
    }
    return is_urdf_ ? rigor::author::to_sdf(environment_, sources, workspace, loaded, {}, options)
                    : rigor::author::to_urdf(environment_, sources, workspace, loaded, {}, options);
  }

  const rigor::Environment& environment_;
  std::string path_;
  bool is_urdf_ = false;
  bool is_model_ = false;
  bool has_meshes_ = false;
};

double time_of_process(const char* rigor, const Subject& subject) {
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) {
    rounds.push_back(rigor::bench::child([&] {
                       ::close(STDERR_FILENO);
                       rigor::bench::run_program({rigor,
                                                  subject.is_urdf() ? "urdf2sdf" : "sdf2urdf",
                                                  subject.path(), "--allow-loss"});
                     }).seconds);
  }
  return least(rounds);
}

std::vector<std::string> models_in(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".sdf" || ending == ".urdf") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void tell(const char* what, std::vector<double> times, double limit) {
  std::sort(times.begin(), times.end());
  fmt::print(
      "{:<16}{:8.3f} ms, 90 % below {:8.3f} ms, most {:8.3f} ms; limit {} ms: {:.2f} of it\n", what,
      1e3 * median(times), 1e3 * times[times.size() * 9 / 10], 1e3 * times.back(), 1e3 * limit,
      median(times) / limit);
}

}  // namespace

int main(int argc, char** argv) {
  const char* corpus = std::getenv("RIGOR_CORPUS");
  if (corpus == nullptr || argc < 2) {
    fmt::print(stderr, "set RIGOR_CORPUS to a folder of model files\n");
    return 2;
  }
  const fs::path set = argc > 2 ? fs::path(corpus) / argv[2] : fs::path(corpus);
  const rigor::RealDisk disk;
  const rigor::Environment environment(disk, {});
  Times times;
  for (const std::string& path : models_in(set)) {
    const Subject subject(environment, path);
    if (!subject.is_model()) continue;
    if (!subject.has_meshes()) {
      const auto mjcf = subject.time(Proof::kNone, Target::kMjcf);
      const auto proved = subject.time(Proof::kVerify, Target::kMjcf);
      if (mjcf && proved) {
        times.mjcf.push_back(*mjcf);
        times.mjcf_proved.push_back(*proved);
      }
    }
    const auto plain = subject.time(Proof::kNone);
    const auto proved = subject.time(Proof::kVerify);
    if (!plain || !proved) continue;
    times.plain.push_back(*plain);
    times.proved.push_back(*proved);
    if (times.plain.size() % kProcessStride != 1) continue;
    times.process.push_back(time_of_process(argv[1], subject));
  }
  if (times.plain.empty() || times.mjcf.empty()) {
    fmt::print(stderr, "no model is converted\n");
    return 1;
  }
  fmt::print("{} models, {} of them as a process; medians\n", times.plain.size(),
             times.process.size());
  tell("without a proof", times.plain, 0.5e-3);
  tell("with it", times.proved, 3e-3);
  tell("as a process", times.process, 15e-3);
  fmt::print("{} models without meshes\n", times.mjcf.size());
  tell("to MJCF", times.mjcf, 2e-3);
  tell("with the proof", times.mjcf_proved, 4e-3);
}
