// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/resolver.h>

#include <rigor/report/resolution.h>
#include "command/command.h"
#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct ResolveFormat {
  std::string_view name;
  std::string (*emit)(std::string_view uri, const read::Resolution&);
};

constexpr ResolveFormat kResolveFormats[] = {{"text", report::resolution_text},
                                             {"json", report::resolution_json}};

/// A file that would lie in the working folder, whose configuration counts.
constexpr const char* kHere = "./model.sdf";

class Resolve final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "resolve", "Show which file a URI names, and the search",
                                {"rigor resolve model://arm/meshes/base.stl --from arm/model.sdf"});
    app->add_option("uri", uri_, "model://, package://, file:// or a path")
        ->required()
        ->type_name("URI");
    app->add_option("--from", from_, "The file that contains the URI")->type_name("FILE");
    output_.declare(*app, {"text", "json"});
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
    const GuardedDisk disk = search_.disk({from_.empty() ? "." : from_});
    if (uri_.substr(uri_.find("://") == std::string::npos ? 0 : uri_.find("://") + 3).empty()) {
      throw UsageError("\"" + uri_ + "\" names no file");
    }
    if (!from_.empty() && disk.kind(from_) != PathKind::kFile) {
      throw UsageError("--from " + from_ + ": no such file");
    }
    const read::Resolver resolver(disk, search_.paths());
    const read::Resolution found = resolver.resolve(uri_, from_.empty() ? kHere : from_);
    for (const Target& target : targets)
      write(target, kResolveFormats[target.format].emit(uri_, found));
    return found.path ? kClean : kFindings;
  }

 private:
  std::string uri_;
  std::string from_;
  OutputOptions output_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> resolve_command() { return std::make_unique<Resolve>(); }

}  // namespace rigor::tool
