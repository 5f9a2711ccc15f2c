// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/conversion.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rigor/author/mjcf_proof.h>
#include <rigor/author/reported_differences.h>
#include <rigor/convert/urdfdom.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/model/subject.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/lookups.h>
#include <rigor/robot/lumping.h>
#include <rigor/robot/robot.h>
#include <rigor/rules/compat.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/rules/meshes.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/suppression.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

using convert::Note;
using convert::NoteKind;
using convert::Notes;
using convert::Outcome;
using robot::Difference;
using robot::DifferenceKind;

constexpr std::string_view kProof[] = {"convert-not-the-same", "convert-rejected"};

rules::Selection selection_of(const ConversionOptions& options, const rules::Registry& registry) {
  rules::Selection selection = options.selection;
  if (selection.select.empty())
    selection.select = {std::string(to_string(rules::Category::kConvert))};
  if (options.losses == Losses::kRefused) return selection;
  for (const rules::Rule& rule : registry.rules()) {
    const bool proof =
        std::find(std::begin(kProof), std::end(kProof), rule.name) != std::end(kProof);
    if (proof || rule.category != rules::Category::kConvert) continue;
    if (rule.severity != Severity::kError) continue;
    // In front: what the user says of a rule comes later and holds.
    selection.severity.insert(selection.severity.begin(),
                              {std::string(rule.name), Severity::kWarning});
  }
  return selection;
}

/// The account in two lines for the head of a result: a reader of the file sees what it is not.
std::vector<std::string> head(const std::string& path, const convert::Account& account) {
  std::string counts;
  for (std::size_t i = 0; i < account.counts.size(); ++i) {
    if (account.counts[i] == 0) continue;
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", account.counts[i],
                          to_string(static_cast<Outcome>(i)));
  }
  return {fmt::format("Converted from {} by rigor.", file_name(path)),
          fmt::format("Elements and attributes: {}.", counts)};
}

std::string value_text(const robot::DifferenceValue& value, std::string_view unit) {
  if (value.numbers.empty()) return value.text.empty() ? "nothing" : value.text;
  std::string text = fmt::format("{}", fmt::join(value.numbers, " "));
  if (!unit.empty()) text += fmt::format(" {}", unit);
  return text;
}

std::string words_of(const Difference& difference) {
  const std::string_view kind = robot::to_string(difference.kind);
  const auto is_empty = [](const robot::DifferenceValue& value) {
    return value.numbers.empty() && value.text.empty();
  };
  if (!is_empty(difference.from) || !is_empty(difference.to)) {
    return fmt::format("{}: {}, in the result {}", kind,
                       value_text(difference.from, difference.unit),
                       value_text(difference.to, difference.unit));
  }
  // What is there on one side only, or has another name, has no values.
  if (difference.a.empty()) return fmt::format("{}: {} is in the result only", kind, difference.b);
  if (difference.b.empty()) return fmt::format("{}: {} is not in the result", kind, difference.a);
  return fmt::format("{}: {}, in the result {}", kind, difference.a, difference.b);
}

Note note_of(const Difference& difference) {
  return {.kind = NoteKind::kNotTheSame,
          .outcome = Outcome::kLost,
          .where = difference.span_a,
          .subject = difference.a.empty() ? difference.b : difference.a,
          .written = words_of(difference)};
}

/// Links and joints of SDF that stand in `<gazebo>` blocks are parts of the result, and none of the robot that URDF
/// describes.
void remove_blocks_parts(const model::Root& root, robot::Robot& after) {
  robot::PartNames links, joints;
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    for (const model::Parameter& part : block.content) {
      const auto* name = attribute(part, "name");
      if (name == nullptr) continue;
      if (part.name == "link") links.insert(name->value);
      if (part.name == "joint") joints.insert(name->value);
    }
  }
  if (!links.empty() || !joints.empty()) robot::remove(after, links, joints);
}

/// What is done to the robot of a result before it is compared.
using Settle = std::function<void(robot::Robot&)>;

/// Both sides of a proof look files up from where they stand.
class Prover {
 public:
  Prover(const Environment& environment, Sources& sources, read::Workspace& workspace,
         const ConversionOptions& options, const Conversion& result)
      : environment_(environment),
        sources_(sources),
        workspace_(workspace),
        surveys_(environment.disk, {.workers = &environment.workers}),
        options_(options),
        result_(result) {}

  /// What is not the same though no note has told so.
  Notes prove(const read::Loaded& source, model::Id<model::Model> model) {
    const model::Frames frames(source.root);
    return prove(source, robot::robot_of(source.root, frames, model, lookups(source.root)),
                 [&source](robot::Robot& after) { remove_blocks_parts(source.root, after); });
  }

  /// `before` is what the result should be; `settle` takes from the result what was added by choice.
  Notes prove(const read::Loaded& source, const robot::Robot& before, const Settle& settle) {
    const read::File& file = workspace_.put(options_.out, *result_.text);
    const read::Loaded written =
        read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf}, file);
    const model::Frames written_frames(written.root);
    if (written.root.models.empty()) {
      return {
          {.kind = NoteKind::kRefused, .where = source.root.site.tag, .written = "no model in it"}};
    }
    robot::Robot after = robot::robot_of(written.root, written_frames, model::Id<model::Model>{0},
                                         lookups(written.root));
    if (settle) settle(after);
    const ReportedDifferences reported(source.root, result_.account.notes);
    Notes notes = differences(before, after, reported);
    if (written.root.format == model::Format::kUrdf)
      ask_urdfdom(source, before, after, reported, settle, notes);
    return notes;
  }

 private:
  robot::Lookups lookups(const model::Root& root) {
    robot::Lookups lookups = robot::lookups_in(root, workspace_, environment_.resolver);
    lookups.find_mesh = rules::mesh_finder(environment_.resolver, sources_, surveys_);
    lookups.find_file = [this, find = lookups.find_file](const std::string& uri, SourceId from) {
      return whole_path(find(uri, from));
    };
    return lookups;
  }

  /// From two places one file has two names.
  std::string whole_path(const std::string& path) const {
    return path.empty() ? path : join_path(options_.working_folder, path);
  }

  /// A robot that urdfdom has read names files and looks none up.
  void look_up_files(robot::Robot& robot) {
    const auto look_up = [this](std::vector<robot::Part>& parts) {
      for (robot::Part& part : parts) {
        if (part.shape.uri.empty()) continue;
        const auto path =
            workspace_.resolve(environment_.resolver, part.shape.uri, options_.out).path;
        part.shape.path = whole_path(path.value_or(""));
      }
    };
    for (robot::Body& body : robot.bodies) {
      look_up(body.collisions);
      look_up(body.visuals);
    }
  }

  static bool has_capsule(const std::vector<robot::Part>& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [](const auto& part) { return part.shape.kind == "capsule"; });
  }
  static bool has_capsule(const robot::Robot& robot) {
    return std::any_of(robot.bodies.begin(), robot.bodies.end(), [](const auto& body) {
      return has_capsule(body.collisions) || has_capsule(body.visuals);
    });
  }

  /// The subjects of shapes that a urdfdom leaves out that does not know URDF 1.1's capsules: those, and
  /// the other collisions, or visuals, of their links.
  static std::set<std::string> beside_capsules(const robot::Robot& robot) {
    std::set<std::string> subjects;
    const auto add = [&](std::string_view kind, const std::string& body, const auto& parts) {
      if (!has_capsule(parts)) return;
      for (const auto& part : parts)
        subjects.insert(fmt::format("{} {}/{}", kind, body, part.name));
    };
    for (const robot::Body& body : robot.bodies) {
      add("collision", body.name, body.collisions);
      add("visual", body.name, body.visuals);
    }
    return subjects;
  }

  Notes differences(const robot::Robot& before, const robot::Robot& after,
                    const ReportedDifferences& reported,
                    const std::set<std::string>& left_out = {}) const {
    Notes notes;
    for (const Difference& difference : robot::compare(before, after, result_.names)) {
      // Readers of one format disagree on colors: two materials of one name, a script and a color.
      if (difference.kind == DifferenceKind::kColor || reported.include(difference)) continue;
      if (difference.b.empty() && left_out.contains(difference.a)) continue;
      if (difference.kind == DifferenceKind::kMesh && is_side_file(difference.to.text)) continue;
      notes.push_back(note_of(difference));
    }
    return notes;
  }

  /// A mesh that is written beside the result, when that is.
  bool is_side_file(const std::string& mesh) const {
    return std::any_of(result_.files.begin(), result_.files.end(),
                       [&mesh](const auto& file) { return mesh.ends_with(file.name); });
  }

  /// The parser that everything in ROS reads URDF with.
  void ask_urdfdom(const read::Loaded& source, const robot::Robot& before,
                   const robot::Robot& after, const ReportedDifferences& reported,
                   const Settle& settle, Notes& notes) {
    convert::UrdfdomVerdict verdict =
        convert::judge_by_urdfdom(*result_.text, environment_.workers);
    if (!verdict.asked) return;
    if (!verdict.robot) {
      notes.push_back({.kind = NoteKind::kRefused,
                       .where = source.root.site.tag,
                       .written = fmt::format("{}", fmt::join(verdict.messages, "; "))});
      return;
    }
    if (!notes.empty()) return;  // it would say the same once more
    look_up_files(*verdict.robot);
    if (settle) settle(*verdict.robot);
    const bool misses_capsules = has_capsule(after) && !has_capsule(*verdict.robot);
    notes = differences(before, *verdict.robot, reported,
                        misses_capsules ? beside_capsules(before) : std::set<std::string>());
  }

  const Environment& environment_;
  Sources& sources_;
  read::Workspace& workspace_;
  mass::MeshSurveys surveys_;
  const ConversionOptions& options_;
  const Conversion& result_;
};

/// What libsdformat, and who looks up a plugin's references, would say of an SDF result.
class SdfJudge {
 public:
  SdfJudge(const Environment& environment, Sources& sources, read::Workspace& workspace,
           const read::Loaded& source)
      : environment_(environment), sources_(sources), workspace_(workspace), source_(source) {
    const model::Root& root = source.root;
    for (const model::Link& link : root.links) keep(model::subject(root, link), link.site.name);
    for (const model::Joint& joint : root.joints) {
      keep(model::subject(root, joint), joint.site.name);
    }
  }

  Notes judge(const std::string& path, const std::string& text) {
    const read::Loaded written =
        read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                   workspace_.put(path, text));
    Notes notes;
    const rules::Runner compat(environment_.registry, {.compat = rules::Compat::kSdformat});
    const Diagnostics judged = run(compat, written);
    for (const Diagnostic& found : judged.list()) {
      if (found.severity != Severity::kError) continue;
      notes.push_back(note_of_finding(NoteKind::kRefusedSdf, found));
    }
    const rules::Runner references(environment_.registry,
                                   {.select = {std::begin(kReferences), std::end(kReferences)}});
    const Diagnostics before = run(references, source_);
    const Diagnostics after = run(references, written);
    for (const Diagnostic& found : after.list()) {
      const auto same = [&found](const Diagnostic& other) {
        return other.message == found.message;
      };
      if (std::any_of(before.list().begin(), before.list().end(), same)) continue;
      notes.push_back(note_of_finding(NoteKind::kDangling, found));
    }
    return notes;
  }

 private:
  static constexpr std::string_view kReferences[] = {"plugin-joint-missing", "sensor-frame-missing",
                                                     "contact-sensor-collision-missing"};

  Diagnostics run(const rules::Runner& runner, const read::Loaded& loaded) const {
    return runner.run(environment_, sources_, loaded, rules::Meshes{});
  }

  void keep(std::string subject, Span where) {
    if (!where.nowhere()) places_.try_emplace(std::move(subject), where);
  }

  /// At the link or joint of the source that it is about, else at the robot.
  Note note_of_finding(NoteKind kind, const Diagnostic& found) const {
    Note note{.kind = kind,
              .outcome = Outcome::kConverted,
              .where = source_.root.models[0].site.name,
              .subject = found.subject,
              .written = found.message,
              .instead = std::string(found.rule)};
    for (std::string subject = found.subject; !subject.empty();) {
      if (const auto place = places_.find(subject); place != places_.end()) {
        note.where = place->second;
        break;
      }
      const std::size_t end = subject.rfind('/');
      subject.resize(end == std::string::npos ? 0 : end);
    }
    return note;
  }

  const Environment& environment_;
  Sources& sources_;
  read::Workspace& workspace_;
  const read::Loaded& source_;
  std::map<std::string, Span> places_;
};

/// What both directions do once they have a result, or none.
class Conclusion {
 public:
  Conclusion(const Environment& environment, Sources& sources, read::Workspace& workspace,
             const read::Loaded& loaded, const ConversionOptions& options)
      : environment_(environment),
        sources_(sources),
        workspace_(workspace),
        loaded_(loaded),
        options_(options) {}

  Conversion of(Conversion result) {
    const bool sdf = loaded_.root.format == model::Format::kUrdf;
    return of(
        std::move(result), sdf ? Result::kSdf : Result::kUrdf,
        [&](Prover& prover, const Conversion& made) { return prover.prove(loaded_, made.model); });
  }

  enum class Result : std::uint8_t { kSdf, kUrdf };

  template <class Prove>
  Conversion of(Conversion result, Result format, const Prove& prove) {
    const rules::Runner runner = runner_for(result);
    find(runner, result, format == Result::kSdf ? "SDF" : "URDF");
    if (result.text && options_.proof == Proof::kVerify && format == Result::kSdf) {
      SdfJudge judge(environment_, sources_, workspace_, loaded_);
      result.diagnostics.take(
          runner.run(environment_, sources_, loaded_, judge.judge(options_.out, *result.text)));
      result.diagnostics.sort();
    }
    if (result.text && options_.proof == Proof::kVerify) {
      Prover prover(environment_, sources_, workspace_, options_, result);
      const Notes found = prove(prover, result);
      // A proof that fails is no property of the source, and no comment there refers to it.
      result.diagnostics.take(runner.run(environment_, sources_, loaded_, found));
      result.diagnostics.sort();
      result.configurations = robot::Tolerance{}.configurations;
    }
    return result;
  }

  /// The same of a result in MJCF, with a proof of its own: what that has found.
  Conversion proved(Conversion result, const Notes& proof) {
    const rules::Runner runner = runner_for(result);
    find(runner, result, "MJCF");
    if (!result.text || options_.proof != Proof::kVerify) return result;
    result.diagnostics.take(runner.run(environment_, sources_, loaded_, proof));
    result.diagnostics.sort();
    result.configurations = robot::Tolerance{}.configurations;
    return result;
  }

 private:
  /// Nothing to write is an error, whatever losses are allowed.
  rules::Runner runner_for(const Conversion& result) const {
    ConversionOptions options = options_;
    if (!result.text) options.losses = Losses::kRefused;
    return rules::Runner(environment_.registry, selection_of(options, environment_.registry));
  }

  void find(const rules::Runner& runner, Conversion& result, std::string_view target) const {
    for (Note& note : result.account.notes) note.target = target;
    result.diagnostics = runner.run(environment_, sources_, loaded_, result.account.notes);
    const auto& document = loaded_.file->document;
    if (document) {
      result.diagnostics = rules::Suppressions(*document).uncovered(std::move(result.diagnostics));
    }
  }

  const Environment& environment_;
  Sources& sources_;
  read::Workspace& workspace_;
  const read::Loaded& loaded_;
  const ConversionOptions& options_;
};

}  // namespace

std::string_view to_string(Outcome outcome) {
  constexpr std::array<std::string_view, 6> kWords{"converted", "implied",     "rewritten",
                                                   "carried",   "substituted", "lost"};
  return kWords[static_cast<std::size_t>(outcome)];
}

Conversion to_urdf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                   const read::Loaded& loaded, const convert::UrdfOptions& how,
                   const ConversionOptions& options) {
  const model::Frames frames(loaded.root);
  const read::Documents documents(workspace);
  convert::UrdfConversion converted = convert::sdf_to_urdf(
      {loaded.root, frames, documents, environment.resolver, environment.sdf, environment.workers,
       loaded.file->path, options.out, options.working_folder},
      how);
  Conversion result;
  result.model = converted.model;
  if (converted.robot) {
    if (options.header == AccountHeader::kComment) {
      converted.robot->head = head(loaded.file->path, converted.account);
    }
    result.text = convert::urdf_text(*converted.robot);
  }
  result.files = std::move(converted.files);
  result.account = std::move(converted.account);
  result.names.links = std::move(converted.links);
  result.names.joints = std::move(converted.joints);
  result.names.unlimited = how.unlimited;
  result.names.from_world = converted.from_world;
  return Conclusion(environment, sources, workspace, loaded, options).of(std::move(result));
}

Conversion to_sdf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                  const read::Loaded& loaded, const convert::SdfOptions& how,
                  const ConversionOptions& options) {
  const model::Frames frames(loaded.root);
  const read::Documents documents(workspace);
  convert::SdfConversion converted = convert::urdf_to_sdf(
      {loaded.root, frames, documents, environment.resolver, environment.urdf, environment.workers,
       loaded.file->path, options.out, options.working_folder},
      how);
  Conversion result;
  result.model = {0};  // a URDF file holds one
  if (converted.robot) {
    if (options.header == AccountHeader::kComment) {
      converted.robot->head = head(loaded.file->path, converted.account);
    }
    result.text = convert::sdf_text(*converted.robot);
  }
  result.files = std::move(converted.files);
  result.account = std::move(converted.account);
  result.names.links = std::move(converted.links);
  result.names.joints = std::move(converted.joints);
  result.names.held_by = std::move(converted.held_by);
  return Conclusion(environment, sources, workspace, loaded, options).of(std::move(result));
}

Conversion to_mjcf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                   const read::Loaded& loaded, const convert::MjcfOptions& how,
                   const ConversionOptions& options) {
  const model::Frames frames(loaded.root);
  const read::Documents documents(workspace);
  mass::MeshSurveys surveys(environment.disk, {.workers = &environment.workers});
  robot::Lookups lookups = robot::lookups_in(loaded.root, workspace, environment.resolver);
  lookups.find_mesh = rules::mesh_finder(environment.resolver, sources, surveys);
  const convert::Source source{
      loaded.root,
      frames,
      documents,
      environment.resolver,
      loaded.root.format == model::Format::kUrdf ? environment.urdf : environment.sdf,
      environment.workers,
      loaded.file->path,
      options.out,
      options.working_folder};
  convert::MjcfConversion converted = convert::to_mjcf({source, lookups}, how);
  Conversion result;
  if (!converted.models.empty()) result.model = converted.models.front();
  Notes proof;
  if (converted.root) {
    if (options.header == AccountHeader::kComment) {
      converted.root->comments = head(loaded.file->path, converted.account);
    }
    result.text = convert::mjcf_text(*converted.root);
    if (options.proof == Proof::kVerify) {
      proof = prove_mjcf(converted, *result.text, loaded.root.site.tag);
    }
  }
  result.files = std::move(converted.files);
  result.account = std::move(converted.account);
  result.names.links = std::move(converted.links);
  result.names.joints = std::move(converted.joints);
  result.names.held_by = std::move(converted.held_by);
  return Conclusion(environment, sources, workspace, loaded, options)
      .proved(std::move(result), proof);
}

namespace {

/// As the result is but for what was chosen: links between joints have no mass, what they carry has it; joints
/// that close loops, which the expected robot lacks, are left out.
void settle_mjcf(const convert::FromMjcfConversion& converted, robot::Robot& robot) {
  std::unordered_map<std::string_view, std::uint32_t> index;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) index.emplace(robot.bodies[i].name, i);
  std::vector<bool> is_between(robot.bodies.size());
  for (const std::string& name : converted.between) {
    if (const auto found = index.find(name); found != index.end()) is_between[found->second] = true;
  }
  std::vector<std::uint32_t> first_child(robot.bodies.size(), robot::kNoIndex);
  for (const robot::Joint& joint : robot.joints) {
    if (!joint.closes_loop && first_child[joint.parent] == robot::kNoIndex)
      first_child[joint.parent] = joint.child;
  }
  for (const std::string& name : converted.between) {
    const auto between = index.find(name);
    if (between == index.end()) continue;
    std::uint32_t carried = between->second;
    while (is_between[carried] && first_child[carried] != robot::kNoIndex)
      carried = first_child[carried];
    if (carried == between->second) continue;
    mass::MassProperties& own = robot.bodies[between->second].mass;
    robot.bodies[carried].mass = mass::add(robot.bodies[carried].mass, own);
    own = {};
  }
  const std::size_t before = robot.joints.size();
  std::erase_if(robot.joints, [](const robot::Joint& joint) { return joint.closes_loop; });
  if (robot.joints.size() != before) robot::connect(robot);
}

Conversion from_mjcf(const Environment& environment, Sources& sources, read::Workspace& workspace,
                     const read::Loaded& loaded, const convert::FromMjcfOptions& how,
                     const ConversionOptions& options, decltype(convert::mjcf_to_urdf)& convert) {
  const model::Frames frames(loaded.root);
  const read::Documents documents(workspace);
  mass::MeshSurveys surveys(environment.disk, {.workers = &environment.workers});
  robot::Lookups lookups = robot::lookups_in(loaded.root, workspace, environment.resolver);
  lookups.find_mesh = rules::mesh_finder(environment.resolver, sources, surveys);
  const convert::Source source{loaded.root,          frames,           documents,
                               environment.resolver, environment.urdf, environment.workers,
                               loaded.file->path,    options.out,      options.working_folder};
  convert::FromMjcfConversion converted = convert({source, lookups, workspace}, how);
  Conversion result;
  result.model = converted.model;
  if (options.header == AccountHeader::kComment) {
    const auto lines = head(loaded.file->path, converted.account);
    if (converted.urdf) converted.urdf->head = lines;
    if (converted.sdf) converted.sdf->head = lines;
  }
  if (converted.urdf) result.text = convert::urdf_text(*converted.urdf);
  if (converted.sdf) result.text = convert::sdf_text(*converted.sdf);
  result.files = converted.files;
  result.account = converted.account;
  result.names.links = converted.links;
  result.names.joints = converted.joints;
  result.names.held_by = converted.held_by;
  result.names.unlimited = how.urdf.unlimited;
  using Result = Conclusion::Result;
  for (robot::Body& body : converted.robot.bodies) {
    for (auto* parts : {&body.collisions, &body.visuals}) {
      for (robot::Part& part : *parts) {
        if (part.shape.path.empty()) continue;
        part.shape.path = join_path(options.working_folder, part.shape.path);
      }
    }
  }
  return Conclusion(environment, sources, workspace, loaded, options)
      .of(std::move(result), converted.sdf ? Result::kSdf : Result::kUrdf,
          [&](Prover& prover, const Conversion&) {
            return prover.prove(loaded, converted.robot,
                                [&](robot::Robot& robot) { settle_mjcf(converted, robot); });
          });
}

}  // namespace

Conversion from_mjcf_to_urdf(const Environment& environment, Sources& sources,
                             read::Workspace& workspace, const read::Loaded& loaded,
                             const convert::FromMjcfOptions& how,
                             const ConversionOptions& options) {
  return from_mjcf(environment, sources, workspace, loaded, how, options, convert::mjcf_to_urdf);
}

Conversion from_mjcf_to_sdf(const Environment& environment, Sources& sources,
                            read::Workspace& workspace, const read::Loaded& loaded,
                            const convert::FromMjcfOptions& how, const ConversionOptions& options) {
  return from_mjcf(environment, sources, workspace, loaded, how, options, convert::mjcf_to_sdf);
}

}  // namespace rigor::author
