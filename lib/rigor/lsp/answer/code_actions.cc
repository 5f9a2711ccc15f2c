// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be done about findings, and about the link or joint at the cursor.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/edit_set.h>
#include <rigor/author/fix.h>
#include <rigor/author/model_inertia.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/baseline_action.h>
#include <rigor/lsp/answer/diagnostics.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/answer/property_actions.h>
#include <rigor/lsp/answer/suppress.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/xml/edit.h>

namespace rigor::lsp {
namespace {

constexpr std::string_view kFixAll = "source.fixAll.rigor";
constexpr std::string_view kQuickFix = "quickfix";
constexpr std::string_view kRewrite = "refactor.rewrite";

/// Whether the client asks for actions of a kind: "source" asks for all of "source.fixAll.rigor".
class WantedKinds {
 public:
  explicit WantedKinds(const Json& only) {
    for (const Json& kind : only) {
      if (kind.is_string()) kinds_.push_back(kind.get<std::string>());
    }
  }
  bool has(std::string_view kind) const { return kinds_.empty() || named(kind); }
  /// Asked for by its name, and not just along with everything.
  bool named(std::string_view kind) const {
    return std::any_of(kinds_.begin(), kinds_.end(), [kind](const std::string& wanted) {
      return kind == wanted || kind.starts_with(wanted + '.');
    });
  }

 private:
  std::vector<std::string> kinds_;
};

struct CodeActionRequest {
  State& state;
  OpenDocument& document;
  const CheckedDocument& checked;
  std::uint32_t begin;
  std::uint32_t end;
  WantedKinds kinds;

  bool touches(const Diagnostic& finding) const {
    if (!stands_in(document, checked, finding)) return false;
    if (finding.where.nowhere()) return begin == 0;
    return finding.where.begin <= end && begin <= finding.where.end;
  }
};

std::vector<Edit> fixes_of_rule(const CodeActionRequest& request, std::string_view rule,
                                Applicability applicability) {
  author::EditSet set;
  for (const Diagnostic& finding : request.checked.result.diagnostics.list()) {
    if (finding.rule != rule) continue;
    for (const Fix& fix : finding.fixes) {
      if (fix.applicability == applicability) set.take(fix.edits);
    }
  }
  return set.list();
}

void add_fixes(const CodeActionRequest& request, const Diagnostic& finding, const Json& diagnostic,
               std::set<std::string_view>& rules, Json& actions) {
  for (const Fix& fix : finding.fixes) {
    if (fix.edits.empty()) continue;
    Json action{{"title", fix.title},
                {"kind", kQuickFix},
                {"diagnostics", Json::array({diagnostic})},
                {"edit", workspace_edit(request.state, *request.checked.sources, fix.edits)}};
    if (fix.applicability == Applicability::kSafe) action["isPreferred"] = true;
    actions.push_back(std::move(action));
    if (fix.applicability == Applicability::kManual || !rules.insert(finding.rule).second) continue;
    const std::vector<Edit> all = fixes_of_rule(request, finding.rule, fix.applicability);
    if (all.size() <= fix.edits.size()) continue;
    actions.push_back({{"title", "fix all: " + std::string(finding.rule)},
                       {"kind", kQuickFix},
                       {"diagnostics", Json::array({diagnostic})},
                       {"edit", workspace_edit(request.state, *request.checked.sources, all)}});
  }
}

void add_suppressions(const CodeActionRequest& request, const Diagnostic& finding,
                      const Json& diagnostic, Json& actions) {
  if (finding.where.nowhere()) return;
  Analysis& analysis = request.document.analysis(request.state.environment());
  if (!analysis.written().complete()) return;  // no comment hides what ends the reading
  const auto add = [&](std::string title, const std::vector<Edit>& edits) {
    if (edits.empty()) return;
    actions.push_back({{"title", std::move(title)},
                       {"kind", kQuickFix},
                       {"diagnostics", Json::array({diagnostic})},
                       {"edit", workspace_edit(request.state, request.document, edits)}});
  };
  const std::string rule(finding.rule);
  add("suppress " + rule + " here", suppressed_here(analysis.written(), finding.where, rule));
  add("suppress " + rule + " in this file", suppressed_in_file(analysis.written(), rule));
  Json baseline = baseline_action(request.state, request.document, request.checked, finding);
  if (baseline.is_null()) return;
  baseline["diagnostics"] = Json::array({diagnostic});
  actions.push_back(std::move(baseline));
}

void add_finding_actions(const CodeActionRequest& request, const std::vector<Diagnostic>& findings,
                         Json& actions) {
  PlacesJson places(*request.checked.sources, request.state.client.encoding);
  std::set<std::string_view> rules;
  std::set<std::pair<std::string_view, std::uint32_t>> suppressed;
  for (const Diagnostic& finding : findings) {
    if (!request.touches(finding)) continue;
    const Json diagnostic = diagnostic_json(request.state, finding, places);
    add_fixes(request, finding, diagnostic, rules, actions);
    if (suppressed.emplace(finding.rule, finding.where.begin).second)
      add_suppressions(request, finding, diagnostic, actions);
  }
}

void add_fix_all(const CodeActionRequest& request, Json& actions) {
  const std::string& path = request.document.path();
  const auto options = check_options(*request.state.project, path, rules::MeshPolicy::kLeaveOut);
  const auto fixed = author::fix_files(request.state.environment(), options, request.checked.result,
                                       *request.checked.sources, Applicability::kSafe);
  for (const author::FixedFile& file : fixed) {
    if (!file.changed()) continue;
    actions.push_back(
        {{"title", "fix all that is safe"},
         {"kind", kFixAll},
         {"edit", workspace_edit(request.state, *request.checked.sources, file.edits)}});
  }
}

/// The element of that name at a place, or around it.
std::optional<xml::Element> enclosing(const xml::Document& document, std::uint32_t offset,
                                      std::string_view name) {
  for (auto element = document.element_at(offset); element; element = element->parent()) {
    if (element->name() == name) return element;
  }
  return std::nullopt;
}

/// What takes a look at the model is done when it is chosen.
void add_rewrites(const CodeActionRequest& request, Json& actions) {
  Analysis& analysis = request.document.analysis(request.state.environment());
  if (analysis.is_template() || !analysis.written().complete()) return;
  const auto add = [&](std::string title, std::string_view what, xml::Element element) {
    actions.push_back({{"title", std::move(title)},
                       {"kind", kRewrite},
                       {"data",
                        {{"what", what},
                         {"uri", request.document.uri()},
                         {"version", request.document.version()},
                         {"element", element.index()}}}});
  };
  const auto link = enclosing(analysis.written(), request.begin, "link");
  if (link && (link->child("collision") || link->child("visual")))
    add("compute this inertial from the link's shapes", "inertial", *link);
  const auto joint = enclosing(analysis.written(), request.begin, "joint");
  if (!joint) return;
  const auto type = joint->attribute("type");
  const bool is_urdf = analysis.written().root()->name() == "robot";
  const auto axis = joint->child("axis");
  const auto parent = is_urdf ? joint : axis;
  if (!type || !parent || parent->child("limit")) return;
  if (type->value() == "revolute" || type->value() == "prismatic")
    add("add the missing limit", "limit", *joint);
}

std::vector<Edit> inertial_edits(State& state, OpenDocument& document, std::uint32_t element) {
  Analysis& analysis = document.analysis(state.environment());
  const read::Loaded& loaded = analysis.loaded();
  mass::MeshSurveys surveys(state.disk);
  author::InertiaOptions options;
  options.only = author::Only::kAll;
  options.bake = true;
  const author::ModelInertia table =
      author::model_inertia(state.environment(), analysis.sources(), loaded, surveys, options);
  for (const author::LinkInertia& link : table.links) {
    const model::Site& site = loaded.root[link.link].site;
    if (site.element != element) continue;
    if (!link.chosen) {
      throw RequestError(ErrorCode::kRequestFailed, "the inertial of link '" + link.name +
                                                        "' cannot be computed: " + link.reason);
    }
    std::vector<Edit> own;
    for (const Edit& edit : table.edits) {
      if (edit.span.begin >= site.span.begin && edit.span.end <= site.span.end) own.push_back(edit);
    }
    return own;
  }
  throw RequestError(ErrorCode::kRequestFailed, "the link is in no model");
}

/// A half turn or half a meter each way, and the effort and velocity that a URDF needs: to be changed by who
/// knows the motor.
std::vector<Edit> limit_edits(Analysis& analysis, std::uint32_t index) {
  const xml::Element joint = analysis.written().element(index);
  const bool prismatic = joint.attribute("type") && joint.attribute("type")->value() == "prismatic";
  const std::string bound = prismatic ? "0.5" : "3.14159";
  if (analysis.written().root()->name() == "robot") {
    std::optional<xml::Element> last;
    for (const xml::Element child : joint.children()) last = child;
    return xml::insert_child(
        analysis.written(), joint, last,
        "<limit lower=\"-" + bound + "\" upper=\"" + bound + "\" effort=\"10\" velocity=\"1\"/>");
  }
  const auto axis = joint.child("axis");
  if (!axis) return {};
  std::optional<xml::Element> last;
  for (const xml::Element child : axis->children()) last = child;
  return xml::insert_child(
      analysis.written(), *axis, last,
      "<limit>\n  <lower>-" + bound + "</lower>\n  <upper>" + bound + "</upper>\n</limit>");
}

}  // namespace

Json code_actions(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const WantedKinds kinds(member(params, "context", "only"));
  const CodeActionRequest request{
      state,
      document,
      kinds.named(kFixAll) ? state.checked_whole(document) : state.checked(document),
      offset_in(document, member(params, "range", "start")),
      offset_in(document, member(params, "range", "end")),
      kinds};
  Json actions = Json::array();
  if (request.kinds.has(kQuickFix)) {
    add_finding_actions(request, request.checked.result.diagnostics.list(), actions);
    if (const State::MeshCheck* meshes = state.mesh_check(document)) {
      add_finding_actions(
          {state, document, meshes->checked, request.begin, request.end, request.kinds},
          meshes->findings, actions);
    }
  }
  if (request.kinds.has(kRewrite)) add_rewrites(request, actions);
  for (Json& action : property_actions(state, document, request.begin, request.end)) {
    if (request.kinds.has(text_at(action, "kind"))) actions.push_back(std::move(action));
  }
  if (request.kinds.named(kFixAll)) add_fix_all(request, actions);
  return actions;
}

Json resolved_code_action(State& state, const Json& params) {
  Json action = params;
  const Json& data = member(params, "data");
  const auto found = state.documents.find(text_at(data, "uri"));
  if (found == state.documents.end() || found->second->version() != number_at(data, "version"))
    throw RequestError(ErrorCode::kContentModified, "the document has changed");
  OpenDocument& document = *found->second;
  if (std::optional<Json> edit = property_edit(state, document, data)) {
    action["edit"] = *std::move(edit);
    return action;
  }
  Analysis& analysis = document.analysis(state.environment());
  const auto element = static_cast<std::uint32_t>(number_at(data, "element"));
  if (element >= analysis.written().element_count())
    throw RequestError(ErrorCode::kInvalidParams, "no such element");
  const std::vector<Edit> edits = text_at(data, "what") == "inertial"
                                      ? inertial_edits(state, document, element)
                                      : limit_edits(analysis, element);
  action["edit"] = workspace_edit(state, document, edits);
  return action;
}

}  // namespace rigor::lsp
