// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check MODEL --apply`: operations on all meshes of a model, each written beside the old
// file, and the model edited so that it looks as before.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <rigor/author/apply_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/read/load.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "command/mesh/mesh_check.h"
#include "model/model_file.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kMark = "_edited";

/// Whether a name is that of an earlier run's result: "arm_edited", "arm_edited_2".
bool is_of_result(std::string_view stem) {
  const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
  const bool has_number = digits > 0 && digits < stem.size() && stem[digits - 1] == '_';
  return (has_number ? stem.substr(0, digits - 1) : stem).ends_with(kMark);
}

/// Other models may use the old file, so the new one has a name of its own; what was written by an
/// earlier run is replaced. Formats that are not written become .glb. Where the first name will not do,
/// the others are "arm_edited_2.stl" and so on.
std::string name_of_result(const std::string& path, int number) {
  constexpr std::string_view kWritten[] = {".stl", ".obj", ".dae", ".glb", ".ply"};
  const std::string ending = extension(path);
  const std::string stem = path.substr(0, path.size() - ending.size());
  const bool known =
      std::find(std::begin(kWritten), std::end(kWritten), ending) != std::end(kWritten);
  return stem + (is_of_result(stem) ? "" : std::string(kMark)) +
         (number == 1 ? "" : "_" + std::to_string(number)) + (known ? ending : ".glb");
}

/// One file has one such path, whatever links lead to it.
std::string file_behind_links(const std::string& path) {
  std::error_code error;
  const auto real = std::filesystem::weakly_canonical(path, error);
  return error ? path : real.generic_string();
}

bool is_link(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_symlink(path, error);
}

/// Empty in a folder that is gone.
std::string folder_of_run() {
  std::error_code error;
  return std::filesystem::current_path(error).generic_string();
}

void refuse_products(const author::MeshOperations& operations) {
  using author::MeshProduct;
  const bool one =
      operations.product == MeshProduct::kMesh || operations.product == MeshProduct::kConvexHull;
  if (!one)
    throw UsageError(
        "--apply puts one mesh in the place of one: not with --convex-pieces, --fit or --split");
}

struct Result {
  author::MeshReplacement replacement;  ///< named when all are known
  author::OperatedMesh done;
};

class Application {
 public:
  Application(const MeshCheckArguments& a, const MeshChecking& checking)
      : a_(a), checking_(checking), workspace_(checking.disk(), sources_) {}

  int run() {
    const Environment& environment = checking_.environment();
    const read::Reader reader{workspace_, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded =
        load(reader, open_plain_model(workspace_, join_path(here_, a_.paths.front())));
    for (const rules::CheckedMesh& mesh : checking_.result().meshes) operate_on(*mesh.facts);
    author::ModelEdits edits = edits_of(loaded, InPlace::kEarlierResults);
    // What keeps a mesh needs its file as it is.
    if (!edits.left.empty()) edits = edits_of(loaded, InPlace::kNothing);
    for (const author::LeftUse& left : edits.left) {
      say("rigor: " + report::printable(left.subject.empty() ? edits.path : left.subject) +
          " keeps the old mesh: " + std::string(author::words(left.why)));
    }
    write_all(edits);
    return checking_.conclude(work_);
  }

 private:
  enum class InPlace : std::uint8_t { kEarlierResults, kNothing };

  author::ModelEdits edits_of(const read::Loaded& loaded, InPlace in_place) {
    name_results(in_place);
    std::vector<author::MeshReplacement> replacements;
    for (const Result& result : results_) replacements.push_back(result.replacement);
    return author::apply_mesh(checking_.environment(), sources_, loaded, replacements);
  }

  /// No two get one name, and none that of another mesh of the model.
  void name_results(InPlace in_place) {
    std::set<std::string> taken;
    for (const rules::CheckedMesh& mesh : checking_.result().meshes) {
      taken.insert(file_behind_links(join_path(here_, mesh.facts->path)));
    }
    for (Result& result : results_) {
      author::MeshReplacement& by = result.replacement;
      const bool may_stay = in_place == InPlace::kEarlierResults && !is_link(by.file);
      bool free = false;
      for (int number = 1; !free; ++number) {
        by.new_file = name_of_result(by.file, number);
        free = (may_stay && by.new_file == by.file) ||
               taken.insert(file_behind_links(by.new_file)).second;
      }
    }
  }

  void operate_on(const mass::MeshFacts& facts) {
    const std::string path = join_path(here_, facts.path);
    if (!facts.whole() || !seen_.insert(path).second) return;
    mesh::LoadedMesh loaded =
        mesh::read_mesh(checking_.disk(), facts.path, checking_.environment().workers);
    author::OperatedMesh done = author::operate(std::move(loaded.mesh), operations_of(a_, facts));
    if (!done.problem.empty()) {
      say("rigor: " + report::printable(facts.path) + " stays as it is: " + done.problem);
      return;
    }
    const author::MeshReplacement replacement{path, {}, done.transform, done.translation};
    results_.push_back({replacement, std::move(done)});
  }

  /// Whatever links and URIs of the model say.
  void refuse_what_is_out_of_reach() const {
    for (const Result& result : results_) {
      const std::string& path = result.replacement.new_file;
      if (checking_.reach().holds(path)) continue;
      throw UsageError(path +
                       " is out of reach: name its package with --package or its folder with "
                       "--model-path");
    }
  }

  void write_all(const author::ModelEdits& edits) {
    refuse_what_is_out_of_reach();
    for (const Result& result : results_) {
      for (report::WrittenFile& file :
           write_meshes(result.done, result.replacement.new_file, NamedBy::kRigor)) {
        file.path = std::filesystem::path(file.path).lexically_proximate(here_).generic_string();
        work_.written.push_back(std::move(file));
      }
      const std::string name(file_name(result.replacement.new_file));
      for (const author::MeshStep& step : result.done.steps) {
        work_.steps.push_back({name + ": " + step.name, step.what});
      }
    }
    const SourceId source = workspace_.open(edits.path).source;
    const auto text = apply_edits(sources_.bytes(source), edits.edits);
    if (!text) throw std::logic_error("the edits of " + edits.path + " overlap");
    if (edits.edits.empty()) return;
    replace_found({join_path(here_, a_.paths.front())}, edits.path, *text);
    say("rigor: " + report::counted(edits.uses, "use") + " of " +
        report::counted(results_.size(), "mesh", "meshes") + " fitted in " +
        report::printable(a_.paths.front()));
  }

  const MeshCheckArguments& a_;
  const MeshChecking& checking_;
  Sources sources_;
  read::Workspace workspace_;
  std::set<std::string> seen_;
  std::vector<Result> results_;
  MeshWork work_;
  const std::string here_ = folder_of_run();
};

}  // namespace

int apply_to_model(const MeshCheckArguments& a) {
  if (a.paths.size() != 1) throw UsageError("--apply needs one model");
  if (!a.out.empty()) throw UsageError("--apply names the new meshes itself: leave out -o");
  refuse_products(a.operations.operations());
  const MeshChecking checking(a);
  if (!checking.result().unusable.empty()) return checking.conclude();
  return Application(a, checking).run();
}

}  // namespace rigor::tool
