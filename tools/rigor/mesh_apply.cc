// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check MODEL --apply`: operations on all meshes of a model, each written beside the old
// file, and the model edited so that it looks as before.

#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/apply_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/read/load.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>
#include <rigor/text/path.h>

#include "atomic_file.h"
#include "command.h"
#include "mesh_check.h"
#include "model_file.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kMark = "_edited";

/// Other models may use the old file, so the new one has a name of its own; what was written by an
/// earlier run is replaced. Formats that are not written become .glb.
std::string name_of_result(const std::string& path) {
  constexpr std::string_view kWritten[] = {".stl", ".obj", ".dae", ".glb", ".ply"};
  const std::string ending = extension(path);
  const std::string stem = path.substr(0, path.size() - ending.size());
  const bool known =
      std::find(std::begin(kWritten), std::end(kWritten), ending) != std::end(kWritten);
  return stem + (stem.ends_with(kMark) ? "" : std::string(kMark)) + (known ? ending : ".glb");
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
  author::MeshReplacement replacement;
  author::OperatedMesh done;
};

class Application {
 public:
  Application(const MeshCheckArguments& a, const MeshChecking& checking)
      : a_(a), checking_(checking), workspace_(checking.disk(), sources_) {}

  int run() {
    const Environment& environment = checking_.environment();
    const read::Reader reader{workspace_, environment.resolver, environment.sdf, environment.urdf};
    const std::string model =
        std::filesystem::absolute(a_.paths.front()).lexically_normal().generic_string();
    const read::Loaded loaded = load(reader, open_model(workspace_, model));
    for (const rules::CheckedMesh& mesh : checking_.result().meshes) operate_on(*mesh.facts);
    std::vector<author::MeshReplacement> replacements;
    for (const Result& result : results_) replacements.push_back(result.replacement);
    const author::ModelEdits edits =
        author::apply_mesh(environment, sources_, loaded, replacements);
    for (const author::LeftUse& left : edits.left) {
      say("rigor: " + report::printable(left.subject.empty() ? edits.path : left.subject) +
          " keeps the old mesh: " + std::string(author::words(left.why)));
    }
    write_all(edits);
    return checking_.conclude(work_);
  }

 private:
  void operate_on(const mass::MeshFacts& facts) {
    const std::string path =
        std::filesystem::absolute(facts.path).lexically_normal().generic_string();
    if (!facts.whole() || !seen_.insert(path).second) return;
    mesh::LoadedMesh loaded = mesh::read_mesh(checking_.disk(), facts.path);
    author::OperatedMesh done = author::operate(std::move(loaded.mesh), operations_of(a_, facts));
    if (!done.problem.empty()) {
      say("rigor: " + report::printable(facts.path) + " stays as it is: " + done.problem);
      return;
    }
    const author::MeshReplacement replacement{path, name_of_result(path), done.transform,
                                              done.translation};
    results_.push_back({replacement, std::move(done)});
  }

  void write_all(const author::ModelEdits& edits) {
    const std::filesystem::path here = std::filesystem::current_path();
    for (const Result& result : results_) {
      for (report::WrittenFile& file : write_meshes(result.done, result.replacement.new_file)) {
        file.path = std::filesystem::path(file.path).lexically_proximate(here).generic_string();
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
    replace_file(edits.path, *text);
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
