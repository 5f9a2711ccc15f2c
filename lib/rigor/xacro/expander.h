// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The walk from source nodes to result nodes. Source trees are never changed: a macro's body is read
// anew by each call, and results are appended to the element that they belong to.

#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/xacro/expand.h>
#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/text_template.h>
#include <rigor/xacro/scope.h>
#include <rigor/xacro/source_tree.h>

namespace rigor::xacro {

/// Where names are looked up.
struct Names {
  MacroScope* macros;
  Scope* values;
};

class Expander final : public Host {
 public:
  Expander(const World& world, const Options& options, Sources& sources);

  Expansion run(const std::string& path);

  // Of `Host`.
  std::optional<Value> look_up(Scope& scope, Symbol name) override;
  Value load_yaml(std::string_view path) override;
  std::optional<std::string_view> argument(std::string_view name) override;
  std::string absolute_path(std::string_view path) override;
  void message(std::string_view function, std::string text) override;
  std::string name_near(Scope& scope, std::string_view name) override;
  void used(Span place) override { used_ = place; }

 private:
  struct File {
    std::string path;
    SourceId source = kNoSource;
    SourceTree tree;
    bool readable = false;
    std::string problem;
  };
  struct Argument {
    std::string_view value;
    Place place;
    bool used = false;
    bool given = false;
    Span declared = {};  ///< the tag
  };
  struct Definition {
    std::string_view name;
    Span where;
    bool used = false;
  };

  // expander.cc: nodes.
  /// An error where the reference has none of that name.
  Value builtin(Symbol name);
  void expand_document(const File& file);
  void expand_children(const Node& source, Names names, Node& out);
  /// With the name that the element has when it is written, which may come from an expression.
  void expand_element(const Node& node, Tag tag, std::string_view name, Names names, Node& out);
  void expand_plain(const Node& node, std::string_view name, Names names, Node& out);
  void expand_attributes(const Node& node, Names names, Node& out);
  /// For what their expressions do and fail at; the values are of no use.
  void check_attributes(const Node& node, Names names);
  void expand_renamed(const Node& node, Names names, Node& out);
  void expand_attribute_tag(const Node& node, Names names, Node& out);
  void expand_condition(const Node& node, bool wanted, Names names, Node& out);
  void insert_block(const Node& node, Names names, Node& out);
  void define_argument(const Node& node, Names names, Node& out);
  Node& new_node(const Node& like);
  Node& fragment();
  Node& clone(const Node& node);
  bool enter(const Node& node);
  void leave() { --depth_; }
  /// Comments directly before a tag of xacro's go with it.
  void drop_comments_before(const Node& tag, Node& out);
  /// The marker that keeps comments of an expansion from a later tag; behind what is there.
  void place_marker(const Node& tag, Node& out);
  void append_content(Node& content, Node& out);
  void lift_namespaces(const Node& from, Node& to);

  // expand_names.cc: properties, macros, includes.
  void define_property(const Node& node, Names names, Node& out);
  void bind(Scope& scope, Symbol symbol, Value value, Binding binding);
  void define_macro(const Node& node, Names names, Node& out);
  void expand_include(const Node& node, Names names, Node& out);
  void include_file(const Node& node, const std::string& path, bool optional, Names names,
                    Node& content, Node& out);
  File& file_at(const std::string& path);
  /// Its bytes; `path` becomes where it lies, when that is elsewhere.
  ReadResult read_file(std::string& path);
  void report_if_outside(const std::string& path, Place place);
  std::string shown_path(const std::string& path) const;

  // expand_call.cc: calls of macros.
  void expand_call(const Node& node, std::string_view name, Names names, Node& out);
  void expand_dynamic_call(const Node& node, Names names, Node& out);
  Macro* find_macro(std::string_view name, Names& names);
  void bind_attributes(const Node& node, const Macro& macro, Names names, Scope& scope,
                       std::vector<bool>& given);
  enum class Blocks : std::uint8_t { kAll, kSomeLost };
  void bind_blocks(const Node& node, const Macro& macro, const Node& content, Scope& scope,
                   std::vector<bool>& given, Blocks blocks);
  void bind_defaults(const Node& node, const Macro& macro, Names caller, Names own, Scope& scope,
                     const std::vector<bool>& given);
  std::uint32_t push_call_frame(const Node& node, const Macro& macro, Scope& scope);
  std::string macro_near(std::string_view name, MacroScope& macros);

  // expand_text.cc: texts, expressions and commands.
  Value evaluate(std::string_view text, Scope& scope, Place place,
                 TextCode code = TextCode::kUnknown);
  /// Several segments as one text.
  Value evaluate_joined(const TextTemplate& parts, std::string_view text, Scope& scope,
                        Place place);
  Value evaluate_segment(const TextSegment& segment, Scope& scope, Place place);
  Value evaluate_expression(std::string_view text, const Expression& expression, Scope& scope,
                            Place place);
  /// `str` of it; nothing on failure.
  std::optional<std::string_view> evaluate_text(std::string_view text, Scope& scope, Place place,
                                                TextCode code = TextCode::kUnknown);
  std::optional<std::string_view> evaluate_text(const NodeAttribute& attribute, Names names) {
    return evaluate_text(attribute.value, *names.values, attribute.where, attribute.code);
  }
  std::optional<bool> evaluate_condition(const NodeAttribute& attribute, Names names);
  Value resolve(Binding& binding, Symbol name, Scope& scope);

  // substitution.cc: `$(…)`.
  Value run_command(std::string_view command, Scope& scope, Place place);
  std::optional<std::string> substitute(std::string_view text, bool only_find, Place place);
  /// Of what is between `$(` and `)`.
  std::optional<std::string> command_value(std::string_view command, Place place);
  std::optional<std::string> substitution_of(std::string_view command, std::string_view rest,
                                             Place place);
  Value evaluate_eval(std::string_view text, Place place);
  /// Whether what is read or decided next is a path in a package that is not found. Then it is an error.
  bool needs_missing_package(std::string_view path);

  // reporting.cc
  void report(FactKind kind, Place place, std::string name = {}, std::string detail = {},
              Span related = {});
  void report_degrees(const Expression& expression, Scope& scope, Place place);
  void report_missing_prefix(const Node& node, MacroScope& macros);
  void report_failure(const Failure& failure, Place place);
  /// The first: what a strict parser stops at.
  void report_faults(const File& file);
  /// Of names that were undefined where they were used, where a property of that name is.
  void relate_definitions();
  void report_unused();
  void report_unused_includes();
  /// Whether a file that was read has the name anywhere but in its definition.
  bool is_mentioned(std::string_view name, Span definition) const;
  const NodeAttribute* required(const Node& node, std::string_view attribute);
  void check_known(const Node& node, std::initializer_list<std::string_view> known);
  std::uint32_t push_frame(Frame frame);

  const World& world_;
  const Options& options_;
  Sources& sources_;
  Expansion result_;
  Heap& heap_;
  Nodes& nodes_;
  Symbols symbols_;
  TextTemplates templates_;
  Evaluator evaluator_;

  std::vector<Value>
      builtins_;  ///< by symbol: none is not asked for yet, an error is none of that name
  std::deque<Scope> scopes_;
  std::vector<Scope*> free_scopes_;
  std::deque<MacroScope> macro_scopes_;
  std::vector<MacroScope*> free_macro_scopes_;
  std::deque<Macro> macros_;
  std::deque<File> files_;
  std::unordered_map<std::string, File*> files_by_path_;
  struct Yaml {
    Value value;
    SourceId source = kNoSource;
    bool loading = false;
  };
  std::unordered_map<std::string, Yaml> yaml_;
  std::map<std::string, Argument, std::less<>> arguments_;
  /// Packages that are not found; their folders are `package://NAME` in texts.
  static constexpr std::string_view kPackageScheme = "package://";
  std::set<std::string> unresolved_;
  std::vector<Definition> definitions_;
  /// What the file itself includes, and what that includes in turn.
  struct IncludeUse {
    Place place;
    std::string path;
    std::vector<SourceId> sources;
    bool brings_elements = false;
  };
  std::vector<IncludeUse> includes_;

  // The ends of texts that are being joined, each behind the one that waits for it.
  std::string joined_;
  std::vector<PartOrigin> joined_origins_;
  std::vector<std::string_view> file_stack_;
  std::vector<std::string_view> resolving_;  // properties whose lazy texts are being evaluated
  Node* marker_ = nullptr;                   // see place_marker
  Span used_;                                // where the value used last is written
  Span reader_;                              // the text that is being evaluated, for messages
  std::uint32_t frame_ = 0;
  std::uint32_t depth_ = 0;
  std::uint64_t nodes_made_ = 0;
  bool name_spaces_made_ = false;           // so scopes may be referred to after their calls
  bool incomplete_ = false;                 // something failed, so names may be missing
  bool lacks_files_ = false;                // of those, a file or package that is not found
  bool stopped_ = false;                    // a bound was reached
  const Node* element_ = nullptr;           // whose attributes are being evaluated
  const Node* element_at_fault_ = nullptr;  // the one in which a type was wrong last
  const Node* lacks_attribute_ = nullptr;   // the tag that a fact said so of
  Span text_in_use_;                        // where the text in a failed expression is set
  bool unknown_parameter_ = false;          // in the call that is being bound
  std::size_t lost_blocks_ = 0;             // insertions of what an earlier fault left unknown
  bool own_path_is_absolute_ = false;
  std::map<std::pair<FactKind, std::pair<std::uint64_t, std::uint32_t>>, std::size_t>
      fact_by_place_;
};

}  // namespace rigor::xacro
