// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor view`: a model in a page that a browser opens.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <rigor/report/number.h>
#include <rigor/report/page/changes.h>
#include <rigor/report/page/model_page.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "model/page_maker.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"
#include "watch/asked_disk.h"
#include "watch/folder_events.h"
#include "watch/page_server.h"

namespace rigor::tool {
namespace {

using report::PageUse;

/// By which a page is known as ours: such a one may be replaced without being named.
constexpr std::string_view kPageTitle = "<title>rigor view</title>";
constexpr std::uint64_t kWhereTheTitleIs = 4096;

constexpr const char* kNoPage =
    "rigor was built without its page (RIGOR_PAGE=OFF): view is not available. Build rigor with "
    "node and npm "
    "(Debian: apt install nodejs npm), or use a released one; `rigor render` makes images";

class ViewPage final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "view", "Look at a model in a browser: one page, offline",
                                {"rigor view my_robot", "rigor view arm.urdf -o review.html",
                                 "rigor view my_robot --serve"});
    app->add_option("model", path_, "A model file, or a folder with a model.config")
        ->required()
        ->type_name("MODEL");
    CLI::Option* out =
        app->add_option("-o,--out", out_, "The page; default NAME.html in this folder")
            ->type_name("FILE");
    CLI::Option* serve =
        app->add_flag("--serve", serve_,
                      "Serve the page to this machine only, and update it on changes; Ctrl-C ends")
            ->excludes(out);
    app->add_option("--port", port_, "Port of --serve; 0, the default: any free port")
        ->type_name("N")
        ->needs(serve);
    search_.declare(*app);
    return app;
  }

  int run() override {
    if (report::page_template(serve_ ? PageUse::kServed : PageUse::kFile).empty()) {
      throw UsageError(kNoPage);
    }
    search_.config().open();
    return serve_ ? serve() : write_page();
  }

 private:
  int write_page() const {
    const GuardedDisk disk = search_.disk({path_});
    const MadePage made = make_page(disk, search_, path_, PageUse::kFile);
    if (!made.problem.empty()) return refuse(made);
    const std::string file = out_.empty() ? default_file(RealDisk(), made.path) : out_;
    const std::string html = report::model_page(made.data, report::page_template(PageUse::kFile));
    if (out_.empty()) {
      put_file(".", file, html);
    } else {
      replace_file(file, html);
    }
    say("rigor: " + report::printable(file) + " is written, " +
        report::number(static_cast<double>(html.size()) / 1e6, 2) + " MB: open it in a browser");
    return kClean;
  }

  static int refuse(const MadePage& made) {
    say("rigor: " + report::printable(made.path + ": " + made.problem));
    return kFindings;
  }

  /// "my_robot.html" of my_robot/model.sdf, in the working folder, which a model need not reach. A UsageError when something else is called so.
  static std::string default_file(const Disk& disk, const std::string& model) {
    const std::string_view name = file_name(model);
    const std::string_view folder = file_name(parent_path(model));
    // Models of a folder are all called so.
    const bool general = name.starts_with("model.") || name.starts_with("model-");
    const bool known = folder != "." && folder != ".." && folder != "/";
    std::string file(general && known ? folder : name.substr(0, name.rfind('.')));
    file += ".html";
    if (disk.kind(file) == PathKind::kMissing) return file;
    const std::unique_ptr<OpenFile> there = disk.open(file);
    std::string begin(kWhereTheTitleIs, '\0');
    begin.resize(there ? there->read(0, begin.data(), begin.size()) : 0);
    if (begin.find(kPageTitle) == std::string::npos) {
      throw UsageError(file +
                       " already exists and was not written by rigor: choose another file with -o");
    }
    return file;
  }

  int serve() const {
    // Shared with a thread that never ends.
    const auto server = std::make_shared<PageServer>(port_);
    end_well_on_interrupt();
    std::optional<report::PageFacts> before;
    const GuardedDisk real = search_.disk({path_});
    while (true) {
      const AskedDisk disk(real);
      search_.config().reopen(disk);
      try {
        MadePage made = make_page(disk, search_, path_, PageUse::kServed);
        if (!made.problem.empty() && !before) return refuse(made);
        if (!made.problem.empty()) throw UsageError(made.path + ": " + made.problem);
        publish(*server, made.data);
        if (before) {
          tell(*server, report::page_changes(*before, made.facts));
          made.facts.findings = report::remembered(before->findings, made.facts.findings);
        } else {
          std::thread([server] { server->run(); }).detach();
          write({0, {}},
                report::printable(made.path) + " is at " + server->address() + " ; Ctrl-C ends\n");
        }
        before = std::move(made.facts);
      } catch (const UsageError& error) {
        if (!before) throw;
        tell(*server, {error.what()});
      }
      const FolderEvents events(disk.folders(), "--serve");
      // What changed since it was read and before it was watched is no event.
      while (disk.still_so()) events.wait();
    }
  }

  static void publish(PageServer& server, const report::PageData& data) {
    server.publish({report::model_page(data, report::page_template(PageUse::kServed)),
                    "{\"data\":" + data.json + ",\"bytes\":\"" + data.bytes + "\"}"});
  }

  /// To the pages, and here.
  static void tell(PageServer& server, const std::vector<std::string>& changes) {
    server.tell("changed", report::page_changes_json(changes));
    std::string said;
    for (const std::string& sentence : changes) said += report::printable(sentence) + '\n';
    write({0, {}}, changes.empty() ? "nothing about the model changed\n" : said);
  }

  std::string path_;
  std::string out_;
  bool serve_ = false;
  std::uint16_t port_ = 0;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> view_command() { return std::make_unique<ViewPage>(); }

}  // namespace rigor::tool
