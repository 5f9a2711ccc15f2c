// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/subject.h>
#include <rigor/report/page/json_page.h>

namespace rigor::report {
namespace {

/// The link or joint that a finding is about.
struct Concerned {
  int link = -1;
  int joint = -1;
};

class Concerns {
 public:
  explicit Concerns(const ModelPage& page) : sources_(page.sources) {
    const model::Root& root = page.root;
    for (std::size_t i = 0; i < root.links.size(); ++i) {
      add(root, root.links[i], {.link = static_cast<int>(i)});
    }
    for (std::size_t i = 0; i < root.joints.size(); ++i) {
      add(root, root.joints[i], {.joint = static_cast<int>(i)});
    }
  }

  /// By where it stands, the innermost element; else by the thing that it names.
  Concerned find(const Diagnostic& diagnostic) const {
    const Element* best = nullptr;
    const Span where = diagnostic.where;
    const std::string_view path = where.nowhere() ? "" : sources_.path(where.source);
    const auto here = elements_.find(path);
    if (!where.nowhere() && here != elements_.end()) {
      for (const Element& each : here->second) {
        if (where.begin < each.span.begin || where.end > each.span.end) continue;
        if (best == nullptr || each.span.size() < best->span.size()) best = &each;
      }
    }
    return best != nullptr ? best->concerned : by_subject(diagnostic.subject);
  }

 private:
  struct Element {
    Span span;
    Concerned concerned;
  };

  template <class T>
  void add(const model::Root& root, const T& thing, Concerned concerned) {
    subjects_.try_emplace(subject(root, thing), concerned);
    const Span span = thing.site.span;
    if (!span.nowhere()) elements_[sources_.path(span.source)].push_back({span, concerned});
  }

  /// "arm/link palm/visual shell" is about "arm/link palm".
  Concerned by_subject(std::string_view subject) const {
    while (!subject.empty()) {
      const auto found = subjects_.find(subject);
      if (found != subjects_.end()) return found->second;
      const std::size_t slash = subject.rfind('/');
      if (slash == std::string_view::npos) break;
      subject = subject.substr(0, slash);
    }
    return {};
  }

  const Sources& sources_;
  std::map<std::string_view, std::vector<Element>> elements_;  // by path: a file may be read twice
  std::map<std::string, Concerned, std::less<>> subjects_;
};

}  // namespace

void add_findings(Json& data, const ModelPage& page, PageFiles& files) {
  const Concerns concerns(page);
  Json list = Json::array();
  for (const Diagnostic& diagnostic : page.findings.list()) {
    const Concerned concerned = concerns.find(diagnostic);
    const std::string fix = diagnostic.fixes.empty() ? "" : diagnostic.fixes.front().title;
    Json json = {{"rule", diagnostic.rule},
                 {"severity", to_string(diagnostic.severity)},
                 {"message", diagnostic.message},
                 {"hint", fix.empty() ? diagnostic.help : fix},
                 {"file", files.index_of(diagnostic)},
                 {"line", nullptr},
                 {"column", nullptr},
                 {"endLine", nullptr},
                 {"endColumn", nullptr},
                 {"link", concerned.link},
                 {"joint", concerned.joint},
                 {"where", diagnostic.subject}};
    if (!diagnostic.where.nowhere()) {
      const Position begin = files.places().begin(diagnostic.where);
      const Position end = files.places().end(diagnostic.where);
      json["line"] = begin.line;
      json["column"] = begin.column;
      json["endLine"] = end.line;
      json["endColumn"] = end.column;
    }
    list.push_back(std::move(json));
  }
  data["findings"] = std::move(list);
}

}  // namespace rigor::report
