// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/context.h>

#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <rigor/mass/link_body.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/subject.h>
#include <rigor/read/resolver.h>
#include <rigor/read/values.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/names.h>
#include <rigor/rules/package/assets.h>
#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/sdformat_robot.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/text/grouping.h>
#include <rigor/text/path.h>

namespace rigor::rules {

namespace {

/// A message quotes values; one of a megabyte helps no one. Longer than any sentence we write.
constexpr std::size_t kLongestMessage = 1000;

/// Places of one cause cost a line each in a report, so that more of them are listed than of causes.
constexpr std::size_t kPlacesPerCause = 10;

constexpr std::string_view kLeftoverXacro = "xml-leftover-xacro";

std::string shortened(std::string message) {
  if (message.size() <= kLongestMessage) return message;
  std::size_t end = kLongestMessage;
  while (end > 0 && (static_cast<unsigned char>(message[end]) & 0xC0U) == 0x80U)
    --end;  // whole code points
  message.resize(end);
  return message + "…";
}

}  // namespace

struct Context::Found {
  /// The findings of a rule: how many, and what says how many are not listed.
  struct Tally {
    std::size_t listed = 0;
    std::size_t counted = 0;
    std::unordered_set<std::string> causes;  // of those listed
    Diagnostic rest;
  };
  std::unordered_map<std::string_view, Tally> tallies;  // by rule
  std::unordered_map<std::string, read::Resolution> resolved;
  std::optional<std::vector<xml::Element>> elements_about_files;
  std::optional<std::vector<Uri>> uris;
  std::optional<std::vector<NameScope>> repeated_names;
  std::optional<SdformatRobot> sdformat_robot;
  std::map<std::pair<const model::Link*, mass::From>, mass::LinkBody> bodies;
  std::optional<robot::Assembled> assembled;
  std::vector<std::optional<mass::Verdict>> verdicts;  // by the link's index
  std::set<std::tuple<std::string_view, std::string, std::string>> reported_of_meshes;
};

Context::Context(const Inputs& inputs, Diagnostics& diagnostics)
    : inputs_(inputs), diagnostics_(diagnostics), found_(std::make_unique<Found>()) {}

Context::~Context() = default;

const Disk& Context::disk() const { return inputs_.resolver.disk(); }

/// What the innermost element around a place is part of.
std::string Context::subject_at(Span where) const {
  if (inputs_.document == nullptr || where.source != inputs_.document->source()) return {};
  const auto element = inputs_.document->element_at(where.begin);
  return element ? subject_of(*element) : std::string();
}

Severity Context::severity_of(const Finding& finding) const {
  const Severity severity = graded_ ? finding.severity.value_or(severity_) : severity_;
  if (!refusal_) return severity;
  const bool refused =
      *refusal_ == Refusal::kAlways || (*refusal_ == Refusal::kSays && finding.refused);
  if (refused) return Severity::kError;
  return severity == Severity::kError ? Severity::kWarning : severity;
}

Diagnostic Context::diagnostic_of(const Finding& finding) {
  if (!page_) page_ = page_in_brief(prose_, inputs_.root.format);
  Diagnostic diagnostic;
  diagnostic.rule = rule_;
  diagnostic.category = category_;
  diagnostic.page_why = page_->why;
  diagnostic.page_help = page_->help;
  diagnostic.severity = severity_of(finding);
  diagnostic.where = finding.where;
  if (finding.where.nowhere()) diagnostic.path = inputs_.path;
  return diagnostic;
}

/// Without the white space around it, which belongs to an element's value: a URI on a line of its own
/// is marked there, and not behind the tag before it.
Span Context::written(Span where) const {
  const std::string_view all = bytes(where);
  const std::string_view part = read::trimmed(all);
  if (part.empty()) return where;
  where.begin += static_cast<std::uint32_t>(part.data() - all.data());
  where.end = where.begin + static_cast<std::uint32_t>(part.size());
  return where;
}

void Context::report(Finding finding) {
  finding.where = written(finding.where);
  for (Label& label : finding.related) label.where = written(label.where);
  // What xacro was to write is reported by that rule, and nothing else of it is known.
  const bool is_about_xacro = category_ == to_string(Category::kXacro) || rule_ == kLeftoverXacro;
  if (!is_about_xacro && has_xacro(bytes(finding.where))) return;
  if (!mesh_.empty() && !found_->reported_of_meshes.insert({rule_, mesh_, finding.message}).second)
    return;
  Diagnostic diagnostic = diagnostic_of(finding);
  diagnostic.message = shortened(std::move(finding.message));
  diagnostic.of_file = mesh_.empty() ? std::move(finding.of_file) : mesh_;
  diagnostic.measured = finding.measured && !mesh_.empty();
  diagnostic.subject =
      finding.subject.empty() ? subject_at(finding.where) : std::move(finding.subject);
  diagnostic.related = std::move(finding.related);
  diagnostic.help = std::move(finding.help);
  // What is wrong with one mesh has another cause than the same of another mesh.
  diagnostic.cause = mesh_.empty() || !finding.cause.empty() ? std::move(finding.cause)
                                                             : mesh_ + '\n' + diagnostic.message;
  diagnostic.why = std::move(finding.why);
  // Of another format's elements; a rule on MJCF itself, or on XML, knows what it edits.
  const bool of_others = root().format == model::Format::kMjcf &&
                         category_ != to_string(Category::kMjcf) &&
                         category_ != to_string(Category::kXml);
  if (finding.fix && !of_others) diagnostic.fixes.push_back(std::move(*finding.fix));
  list_or_count(std::move(diagnostic));
}

void Context::list_or_count(Diagnostic diagnostic) {
  Found::Tally& tally = found_->tallies[rule_];
  std::string cause = cause_of(diagnostic);
  const bool is_new = tally.causes.count(cause) == 0;
  const bool is_listed = is_new ? tally.causes.size() < inputs_.max_listed
                                : tally.listed < kPlacesPerCause * inputs_.max_listed;
  if (is_listed) {
    ++tally.listed;
    if (is_new) tally.causes.insert(std::move(cause));
    diagnostics_.add(std::move(diagnostic));
    return;
  }
  const Severity severity = diagnostic.severity;
  if (tally.counted++ == 0) {
    tally.rest = Diagnostic{};
    tally.rest.rule = diagnostic.rule;
    tally.rest.category = diagnostic.category;
    tally.rest.page_why = diagnostic.page_why;
    tally.rest.page_help = diagnostic.page_help;
    tally.rest.severity = severity;
    tally.rest.where = diagnostic.where;
    tally.rest.path = diagnostic.path;
  }
  tally.rest.severity = std::min(tally.rest.severity, severity);  // the gravest
}

void Context::report_counted() {
  for (auto& [rule, tally] : found_->tallies) {
    if (tally.counted == 0) continue;
    tally.rest.count = tally.counted;
    tally.rest.message = "from here on " + std::to_string(tally.rest.count) +
                         " more of this kind are counted and not listed";
    diagnostics_.add(std::move(tally.rest));
  }
  found_->tallies.clear();
}

const read::Resolution& Context::resolve(const std::string& uri) {
  const auto found = found_->resolved.find(uri);
  if (found != found_->resolved.end()) return found->second;
  return found_->resolved.emplace(uri, inputs_.resolver.resolve(uri, inputs_.path)).first->second;
}

const std::vector<xml::Element>& Context::elements_about_files() {
  if (!found_->elements_about_files)
    found_->elements_about_files = rules::elements_about_files(document());
  return *found_->elements_about_files;
}

const std::vector<Uri>& Context::uris() {
  if (!found_->uris) found_->uris = uris_of(elements_about_files());
  return *found_->uris;
}

const std::vector<NameScope>& Context::repeated_names() {
  if (!found_->repeated_names) found_->repeated_names = NameCollector(document(), root()).collect();
  return *found_->repeated_names;
}

const SdformatRobot& Context::sdformat_robot() {
  if (!found_->sdformat_robot) found_->sdformat_robot = rules::sdformat_robot(root(), frames());
  return *found_->sdformat_robot;
}

const mass::MeshSurvey* Context::survey(const model::Mesh& mesh) {
  if (inputs_.meshes == nullptr || mesh.uri.value.empty()) return nullptr;
  const read::Resolution& found = resolve(mesh.uri.value);
  if (!found.path) return nullptr;
  return &inputs_.meshes->find({*found.path, mesh.submesh.value, mesh.center.value});
}

const mass::LinkBody& Context::body(const model::Link& link, mass::From from) {
  const auto known = found_->bodies.find({&link, from});
  if (known != found_->bodies.end()) return known->second;
  const model::Id<model::Link> id{static_cast<std::uint32_t>(&link - root().links.data())};
  const auto find = [this](const model::Mesh& mesh) { return survey(mesh); };
  return found_->bodies.emplace(std::pair{&link, from}, link_body(root(), frames(), id, from, find))
      .first->second;
}

/// As deep as the mesh is examined in any case, so that no file is read for this alone.
std::optional<mesh::Bounds> Context::bounds(const model::Mesh& mesh, robot::ShapeRole role) {
  if (inputs_.files == nullptr || mesh.uri.value.empty()) return std::nullopt;
  if (!mesh.submesh.value.empty()) {
    const mass::MeshSurvey* part = survey(mesh);
    if (part == nullptr || !part->usable() || part->triangles == 0) return std::nullopt;
    return part->bounds;
  }
  const read::Resolution& found = resolve(mesh.uri.value);
  if (!found.path) return std::nullopt;
  const auto depth =
      role == robot::ShapeRole::kCollision ? mass::MeshDepth::kShape : mass::MeshDepth::kFile;
  const mass::MeshFacts& facts = inputs_.files->find(*found.path, depth);
  if (!facts.usable() || facts.triangles == 0) return std::nullopt;
  return facts.bounds;
}

const robot::Assembled& Context::assembled() {
  if (!found_->assembled) {
    found_->assembled = robot::assemble(
        root(), frames(),
        [this](const model::Mesh& mesh, robot::ShapeRole role) { return bounds(mesh, role); });
  }
  return *found_->assembled;
}

const mass::Verdict& Context::verdict(const model::Link& link) {
  found_->verdicts.resize(root().links.size());
  auto& known = found_->verdicts[static_cast<std::size_t>(&link - root().links.data())];
  if (!known) known = mass::judge(link.inertial.mass.value, mass::tensor(link.inertial));
  return *known;
}

std::string_view Context::folder() const { return parent_path(inputs_.path); }

std::string Context::subject(const model::World& world) const {
  return model::subject(root(), world);
}
std::string Context::subject(const model::Model& model) const {
  return model::subject(root(), model);
}
std::string Context::subject(const model::Link& link) const { return model::subject(root(), link); }
std::string Context::subject(const model::Joint& joint) const {
  return model::subject(root(), joint);
}
std::string Context::subject(const model::Frame& frame) const {
  return model::subject(root(), frame);
}
std::string Context::subject(const model::Collision& collision) const {
  return model::subject(root(), collision);
}
std::string Context::subject(const model::Visual& visual) const {
  return model::subject(root(), visual);
}
std::string Context::subject(const model::Sensor& sensor) const {
  return model::subject(root(), sensor);
}
std::string Context::subject(const model::Light& light) const {
  return model::subject(root(), light);
}
std::string Context::subject(const model::Plugin& plugin) const {
  return model::subject(root(), plugin);
}

}  // namespace rigor::rules
