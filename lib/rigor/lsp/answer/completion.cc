// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What may stand at the cursor.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/names/file_names.h>
#include <rigor/author/names/template_names.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/name_lookup.h>
#include <rigor/lsp/answer/uri_completion.h>
#include <rigor/lsp/document/schema_place.h>
#include <rigor/lsp/document/srdf_elements.h>
#include <rigor/lsp/document/xml_cursor.h>
#include <rigor/read/srdf/srdf.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/rules/plugin/systems.h>

namespace rigor::lsp {
namespace {

/// Of the protocol's CompletionItemKind.
enum class ItemKind : int {
  kFunction = 3,
  kField = 5,
  kVariable = 6,
  kProperty = 10,
  kValue = 12,
  kEnum = 13,
  kSnippet = 15,
  kFile = 17,
  kReference = 18,
  kFolder = 19
};

/// Of the protocol's InsertTextFormat.
constexpr int kSnippetFormat = 2;

/// A robot of 30,000 lines has 1,600 links.
constexpr std::size_t kMostNames = 200;

struct Snippet {
  std::string_view root;
  std::string_view parent;
  std::string_view label;
  std::string_view text;
};

constexpr Snippet kSnippets[] = {
    {"robot", "robot", "link with shapes",
     "link name=\"${1:link}\">\n  <inertial>\n    <mass value=\"${2:1}\"/>\n    <inertia "
     "ixx=\"${3:0.01}\" ixy=\"0\" "
     "ixz=\"0\" iyy=\"${4:0.01}\" iyz=\"0\" izz=\"${5:0.01}\"/>\n  </inertial>\n  <visual>\n    "
     "<geometry>\n      <box "
     "size=\"${6:0.1 0.1 0.1}\"/>\n    </geometry>\n  </visual>\n  <collision>\n    <geometry>\n   "
     "   <box "
     "size=\"${6:0.1 0.1 0.1}\"/>\n    </geometry>\n  </collision>\n</link>"},
    {"robot", "robot", "revolute joint",
     "joint name=\"${1:joint}\" type=\"revolute\">\n  <parent link=\"${2:parent}\"/>\n  <child "
     "link=\"${3:child}\"/>\n  <origin xyz=\"${4:0 0 0}\" rpy=\"0 0 0\"/>\n  <axis xyz=\"${5:0 0 "
     "1}\"/>\n  <limit "
     "lower=\"${6:-1.57}\" upper=\"${7:1.57}\" effort=\"${8:10}\" velocity=\"${9:1}\"/>\n</joint>"},
    {"robot", "link", "inertial",
     "inertial>\n  <origin xyz=\"${1:0 0 0}\"/>\n  <mass value=\"${2:1}\"/>\n  <inertia "
     "ixx=\"${3:0.01}\" ixy=\"0\" "
     "ixz=\"0\" iyy=\"${4:0.01}\" iyz=\"0\" izz=\"${5:0.01}\"/>\n</inertial>"},
    {"sdf", "model", "link with shapes",
     "link name=\"${1:link}\">\n  <inertial auto=\"true\"/>\n  <collision name=\"collision\">\n    "
     "<geometry>\n      "
     "<box>\n        <size>${2:0.1 0.1 0.1}</size>\n      </box>\n    </geometry>\n  "
     "</collision>\n  <visual "
     "name=\"visual\">\n    <geometry>\n      <box>\n        <size>${2:0.1 0.1 0.1}</size>\n      "
     "</box>\n    "
     "</geometry>\n  </visual>\n</link>"},
    {"sdf", "model", "revolute joint",
     "joint name=\"${1:joint}\" type=\"revolute\">\n  <parent>${2:parent}</parent>\n  "
     "<child>${3:child}</child>\n  "
     "<axis>\n    <xyz>${4:0 0 1}</xyz>\n    <limit>\n      <lower>${5:-1.57}</lower>\n      "
     "<upper>${6:1.57}</upper>\n    </limit>\n  </axis>\n</joint>"},
    {"sdf", "link", "inertial",
     "inertial>\n  <mass>${1:1}</mass>\n  <inertia>\n    <ixx>${2:0.01}</ixx>\n    "
     "<iyy>${3:0.01}</iyy>\n    "
     "<izz>${4:0.01}</izz>\n  </inertia>\n</inertial>"},
};

class Completer {
 public:
  Completer(State& state, OpenDocument& document, std::uint32_t offset)
      : state_(state),
        document_(document),
        offset_(offset),
        cursor_(xml_cursor(document.text(), offset)),
        is_srdf_(is_srdf(document.path())) {
    for (const OpenElement& element : cursor_.open) {
      path_.push_back(element.name);
      if (element.name == "sdf") version_ = attribute_in(element.tag, "version");
    }
  }

  /// An array, or a list that says that there is more.
  Json items() && {
    switch (cursor_.at) {
      case XmlCursor::At::kTagName: tag_names(); break;
      case XmlCursor::At::kEndTagName: end_tag(); break;
      case XmlCursor::At::kAttributeName: attribute_names(); break;
      case XmlCursor::At::kAttributeValue: attribute_value(); break;
      case XmlCursor::At::kText: text_value(); break;
      case XmlCursor::At::kElsewhere: break;
    }
    if (!incomplete_) return std::move(items_);
    return {{"isIncomplete", true}, {"items", std::move(items_)}};
  }

 private:
  std::string_view root() const { return path_.empty() ? std::string_view() : path_.front(); }
  std::string_view element() const { return path_.empty() ? std::string_view() : path_.back(); }
  std::string_view parent() const {
    return path_.size() < 2 ? std::string_view() : path_[path_.size() - 2];
  }
  std::optional<schema::Node> place() const {
    if (is_srdf_) return std::nullopt;
    return schema_place(state_.environment(), path_, version_);
  }

  void add(std::string_view label, ItemKind kind, std::string_view insert,
           std::string_view text = {}, std::string_view snippet = {}) {
    if (!labels_.insert(std::string(label)).second) return;
    const bool with_snippet = !snippet.empty() && state_.client.snippets;
    Json item{
        {"label", label},
        {"kind", static_cast<int>(kind)},
        {"textEdit",
         {{"range", range_json(document_.lines(), begin_ != 0 ? begin_ : cursor_.begin, offset_)},
          {"newText", with_snippet ? snippet : insert}}}};
    if (with_snippet) item["insertTextFormat"] = kSnippetFormat;
    if (!text.empty()) item["documentation"] = {{"kind", "markdown"}, {"value", text}};
    items_.push_back(std::move(item));
  }

  /// An element with its required attributes to be filled in.
  static std::string element_snippet(const schema::Node& node) {
    std::string snippet(node.name());
    int field = 1;
    for (const schema::Node attribute : node.required_attributes())
      snippet += fmt::format(" {}=\"${{{}}}\"", attribute.name(), field++);
    const bool has_content = !node.children().empty() || node.type() != schema::Type::kNone;
    if (!has_content) return snippet + "/>$0";
    return snippet + fmt::format(">$0</{}>", node.name());
  }

  void tag_names() {
    if (path_.empty()) {
      if (!is_srdf_) add("sdf", ItemKind::kField, "sdf");
      add("robot", ItemKind::kField, "robot");
      return;
    }
    if (is_srdf_) srdf_tag_names();
    if (const auto node = place()) {
      for (const schema::Node child : node->children()) {
        if (child.deprecated_since()) continue;
        add(child.name(), ItemKind::kField, child.name(), schema_text(child),
            element_snippet(child));
      }
    }
    for (const Snippet& snippet : kSnippets) {
      if (state_.client.snippets && !is_srdf_ && snippet.root == root() &&
          snippet.parent == element())
        add(snippet.label, ItemKind::kSnippet, snippet.label, {}, snippet.text);
    }
    if (element() == "plugin") plugin_parameters();
    macros();
    end_tag("/");
  }

  void srdf_tag_names() {
    for (const SrdfElement& each : srdf_elements()) {
      if (each.parent != element()) continue;
      std::string snippet(each.name);
      int field = 1;
      for (const std::string_view attribute : each.attributes)
        snippet += fmt::format(" {}=\"${{{}}}\"", attribute, field++);
      const auto elements = srdf_elements();
      const bool has_content =
          std::any_of(elements.begin(), elements.end(),
                      [&each](const SrdfElement& child) { return child.parent == each.name; });
      snippet += has_content ? fmt::format(">$0</{}>", each.name) : "/>$0";
      add(each.name, ItemKind::kField, each.name, each.text, snippet);
    }
  }

  void end_tag(std::string_view before = {}) {
    if (path_.empty()) return;
    const std::string name = fmt::format("{}{}>", before, element());
    add(name, ItemKind::kField, name);
  }

  void macros() {
    if (!read::is_template(document_.path())) return;
    for (const author::TemplateName& name : defined_names()) {
      if (name.kind != author::TemplateNameKind::kMacro) continue;
      std::string snippet = "xacro:" + name.name;
      int field = 1;
      bool has_block = false;
      for (const author::TemplateName& parameter : names_) {
        if (parameter.kind != author::TemplateNameKind::kParameter || parameter.owner != name.name)
          continue;
        has_block = has_block || parameter.is_block;
        if (!parameter.is_block) snippet += fmt::format(" {}=\"${{{}}}\"", parameter.name, field++);
      }
      snippet += has_block ? fmt::format(">$0</xacro:{}>", name.name) : "/>";
      add("xacro:" + name.name, ItemKind::kFunction, "xacro:" + name.name, {}, snippet);
    }
  }

  /// Of all files that the template reads.
  std::vector<author::TemplateName> defined_names() {
    if (names_.empty()) {
      Analysis& readable = document_.readable(state_.environment());
      const read::File& file = readable.file();
      if (file.expanded) {
        for (const xacro::FileUse& use : file.expanded->expansion().files) {
          if (use.source == kNoSource) continue;
          const xml::Document document =
              xml::parse_own(readable.sources().bytes(use.source), use.source);
          for (author::TemplateName& name : author::template_names(document)) {
            if (name.defines) names_.push_back(std::move(name));
          }
        }
      }
    }
    return names_;
  }

  bool has_attribute(std::string_view name) const {
    return !attribute_in(cursor_.open.back().tag, name).empty();
  }

  void add_attribute(std::string_view name, std::string_view text = {}) {
    if (has_attribute(name)) return;
    add(name, ItemKind::kProperty, fmt::format("{}=\"\"", name), text,
        fmt::format("{}=\"$1\"", name));
  }

  void attribute_names() {
    if (element().starts_with("xacro:")) return parameters();
    if (const auto node = place()) {
      for (const schema::Node attribute : node->attributes())
        add_attribute(attribute.name(), schema_text(attribute));
    }
    const SrdfElement* known = is_srdf_ ? find_srdf_element(parent(), element()) : nullptr;
    if (known == nullptr) return;
    for (const std::string_view attribute : known->attributes) add_attribute(attribute);
  }

  /// Of the macro that is called; its blocks are elements of the content.
  void parameters() {
    defined_names();
    for (const author::TemplateName& name : names_) {
      if (name.kind == author::TemplateNameKind::kParameter && !name.is_block &&
          name.owner == element().substr(6))
        add_attribute(name.name);
    }
  }

  void attribute_value() {
    if (expression()) return;
    const auto node = place();
    if (const auto attribute = node ? node->attribute(cursor_.attribute) : std::nullopt)
      values(*attribute);
    if (is_srdf_) srdf_values_here();
    if (const auto kinds = author::referenced_kinds(root(), parent(), element(), cursor_.attribute))
      names(*kinds);
    if (element() == "plugin" && cursor_.attribute == "filename") return plugins();
    if (cursor_.attribute == "filename" || cursor_.attribute == "url") uris();
  }

  void text_value() {
    if (path_.empty() || cursor_.typed.find_first_not_of(" \t\r\n") == std::string_view::npos)
      trim_typed();
    if (expression()) return;
    if (const auto node = place()) values(*node);
    if (is_joint_end("parent") || is_joint_end("child")) {
      names({author::NameKind::kLink, author::NameKind::kJoint, author::NameKind::kFrame});
    } else if (const auto kinds = author::referenced_kinds(root(), parent(), element(), "")) {
      names(*kinds);
    }
    if (element() == "uri") uris();
  }

  void trim_typed() {
    cursor_.begin = offset_;
    cursor_.typed = {};
  }

  void values(const schema::Node& node) {
    for (const std::string_view value : node.enumeration()) add(value, ItemKind::kEnum, value);
    if (node.type() == schema::Type::kBool) {
      for (const std::string_view value : {"true", "false"}) add(value, ItemKind::kValue, value);
    }
    if (const auto value = node.default_value(); value && !value->empty())
      add(*value, ItemKind::kValue, *value, "The default.");
  }

  void srdf_values_here() {
    for (const std::string_view value : srdf_values(element(), cursor_.attribute))
      add(value, ItemKind::kEnum, value);
    if (!refers_to_srdf_group(parent(), element(), cursor_.attribute)) return;
    const auto root = document_.readable(state_.environment()).written().root();
    if (!root) return;
    const std::string_view own = attribute_in(cursor_.open[cursor_.open.size() - 2].tag, "name");
    for (const std::string& group : read::read_srdf(*root).groups) {
      if (!group.empty() && (parent() != "group" || group != own))
        add(group, ItemKind::kReference, group);
    }
  }

  /// Of the innermost model around the cursor, and of models in it; of SRDF those of its robot.
  void names(author::NameKinds kinds) {
    Analysis& readable = document_.readable(state_.environment());
    if (is_srdf_) add_robots(readable.names(), workspace_files(state_, document_));
    const std::uint32_t at =
        readable.is_template() ? UINT32_MAX : document_.to_readable(scope_offset());
    const std::string_view own = own_name();
    for (const std::string& name : fitting(readable.names().visible(readable.path(), at, kinds))) {
      const bool is_own = !own.empty() && name.starts_with(own) &&
                          (name.size() == own.size() ||
                           std::string_view(name).substr(own.size()).starts_with("::"));
      if (!is_own) add(name, ItemKind::kReference, name);
    }
    if (root() != "sdf" || !kinds.has(author::NameKind::kFrame)) return;
    // The world is a frame of a world; in a model it is only a parent of joints. Older consumers do not take a model
    // as the end of a joint.
    const bool is_end = is_joint_end("parent") || is_joint_end("child");
    const bool in_model = is_in_model();
    if (in_model && !is_end) add("__model__", ItemKind::kReference, "__model__");
    if (in_model ? is_joint_end("parent") : !is_joint_end("child"))
      add("world", ItemKind::kReference, "world");
  }

  bool is_joint_end(std::string_view end) const {
    return root() == "sdf" && element() == end && parent() == "joint";
  }

  /// The pose of a model is one in the scope around the model.
  bool is_pose_of_model() const { return element() == "pose" && parent() == "model"; }

  bool is_in_model() const {
    return std::count(path_.begin(), path_.end(), "model") > (is_pose_of_model() ? 1 : 0);
  }

  std::uint32_t scope_offset() const {
    if (!is_pose_of_model()) return offset_;
    const std::string_view model = cursor_.open[cursor_.open.size() - 2].name;
    return static_cast<std::uint32_t>(model.data() - document_.text().data()) - 1;
  }

  /// Of what is placed or connected here, which cannot refer to itself.
  std::string_view own_name() const {
    static constexpr std::string_view kPlaced[] = {"link", "joint", "frame", "model"};
    const auto name_of = [](const OpenElement& open) { return attribute_in(open.tag, "name"); };
    if (element() == "mimic") {
      const auto joint = std::find_if(cursor_.open.rbegin(), cursor_.open.rend(),
                                      [](const OpenElement& open) { return open.name == "joint"; });
      return joint == cursor_.open.rend() ? std::string_view() : name_of(*joint);
    }
    if (root() != "sdf") return {};  // where a link may have the name of a joint
    if (element() == "frame") return name_of(cursor_.open.back());
    const bool is_of_parent =
        element() == "pose" || is_joint_end("parent") || is_joint_end("child");
    const bool is_placed =
        std::find(std::begin(kPlaced), std::end(kPlaced), parent()) != std::end(kPlaced);
    return is_of_parent && is_placed ? name_of(cursor_.open[cursor_.open.size() - 2])
                                     : std::string_view();
  }

  /// Of more names than anybody reads those that what was typed may become, which begin with it first. The client
  /// asks again with the next letter.
  std::vector<std::string> fitting(std::vector<std::string> names) {
    if (names.size() <= kMostNames) return names;
    const std::string_view typed = cursor_.typed;
    std::erase_if(names, [typed](const std::string& name) { return !may_become(typed, name); });
    std::stable_partition(names.begin(), names.end(),
                          [typed](const std::string& name) { return name.starts_with(typed); });
    if (names.size() > kMostNames) names.resize(kMostNames);
    incomplete_ = true;
    return names;
  }

  /// Whether its letters stand in the name in their order, as clients match.
  static bool may_become(std::string_view typed, std::string_view name) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    std::size_t matched = 0;
    for (const char c : name) {
      if (matched < typed.size() && lower(typed[matched]) == lower(c)) ++matched;
    }
    return matched == typed.size();
  }

  void plugins() {
    for (const rules::GazeboSystem& system : rules::kGazeboSystems) {
      const std::string library = fmt::format("gz-sim-{}-system", system.library);
      add(library, ItemKind::kFile, library);
    }
  }

  void plugin_parameters() {
    std::string_view library = attribute_in(cursor_.open.back().tag, "filename");
    const rules::GazeboSystem* system = rules::gazebo_system(library);
    if (system == nullptr) return;
    std::string_view words = system->parameters;
    while (!words.empty()) {
      const std::size_t blank = std::min(words.find(' '), words.size());
      const std::string_view name = words.substr(0, blank);
      add(name, ItemKind::kField, name, {}, fmt::format("{}>$1</{}>", name, name));
      words.remove_prefix(std::min(blank + 1, words.size()));
    }
  }

  void uris() {
    for (const UriStep& step : uri_steps(state_, document_.path(), cursor_.typed)) {
      begin_ = cursor_.begin + step.begin;
      add(step.text, step.is_folder ? ItemKind::kFolder : ItemKind::kFile, step.text);
    }
  }

  /// Within `${…}` or `$(arg …)`.
  bool expression() {
    const std::string_view typed = cursor_.typed;
    const std::size_t open = typed.rfind('$');
    if (open == std::string_view::npos || typed.find_first_of("})", open) != std::string_view::npos)
      return false;
    const bool is_argument = typed.substr(open).starts_with("$(arg ");
    if (!typed.substr(open).starts_with("${") && !is_argument) return false;
    const std::size_t word = typed.find_last_of("{ (+-*/,<>=!|&[") + 1;
    begin_ = cursor_.begin + static_cast<std::uint32_t>(word);
    std::string_view macro;
    for (const OpenElement& element : cursor_.open) {
      if (element.name == "xacro:macro") macro = attribute_in(element.tag, "name");
    }
    for (const author::TemplateName& name : defined_names()) {
      const bool fits = is_argument ? name.kind == author::TemplateNameKind::kArgument
                                    : name.kind == author::TemplateNameKind::kProperty ||
                                          (name.kind == author::TemplateNameKind::kParameter &&
                                           name.owner == macro);
      if (fits) add(name.name, ItemKind::kVariable, name.name);
    }
    return true;
  }

  State& state_;
  OpenDocument& document_;
  std::uint32_t offset_;
  XmlCursor cursor_;
  bool is_srdf_;
  std::vector<std::string_view> path_;
  std::string_view version_;
  std::vector<author::TemplateName> names_;
  std::uint32_t begin_ = 0;  // of what is replaced, where that is not all that was typed
  std::set<std::string> labels_;
  bool incomplete_ = false;
  Json items_ = Json::array();
};

}  // namespace

Json completion(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  return Completer(state, document, offset_in(document, member(params, "position"))).items();
}

}  // namespace rigor::lsp
