// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/argument_sets.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/xacro/scope.h>
#include <rigor/xml/document.h>

namespace rigor::read {
namespace {

using ArgumentValues = std::map<std::string, std::set<std::string>, std::less<>>;

bool is_word_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// What is between quotes of a condition: 'robotiq' of `${gripper == 'robotiq'}`.
std::vector<std::string> quoted_texts(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\'' && text[at] != '"') continue;
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string_view::npos) break;
    found.emplace_back(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return found;
}

/// A property, or a parameter of a macro: what has a value within a macro, or in the file (no macro).
struct TemplateName {
  std::string macro;
  std::string name;
  bool operator<(const TemplateName& other) const {
    return std::tie(macro, name) < std::tie(other.macro, other.name);
  }
};

/// From a property to a macro's parameter, and on to the parameter of a macro that it calls: so many steps.
constexpr int kMaxArgumentSteps = 8;

/// The name in a text that is nothing but one reference: `model` of `${ model }`; empty otherwise.
std::string_view only_name(std::string_view text) {
  if (!text.starts_with("${") || !text.ends_with('}')) return {};
  text = text.substr(2, text.size() - 3);
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::all_of(text.begin(), text.end(), is_word_byte) ? text : std::string_view();
}

bool compares_texts(std::string_view text) {
  return text.find("==") != text.npos || text.find("!=") != text.npos ||
         text.find(" in ") != text.npos;
}

/// The macro that an element is in; empty outside of all.
std::string macro_around(xml::Element element) {
  for (auto outer = element.parent(); outer; outer = outer->parent()) {
    if (outer->name() != "xacro:macro") continue;
    const auto name = outer->attribute("name");
    return name ? std::string(name->value()) : std::string();
  }
  return {};
}

/// Arguments, and the names that are given one as it is.
class ArgumentReader {
 public:
  void declare(const xml::Document& document) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      const xacro::Tag tag = xacro::tag_of(element.name());
      if (tag == xacro::Tag::kCall) declare_call(element);
      if (tag == xacro::Tag::kMacro) declare_parameters(element);
      const auto name = element.attribute("name");
      const auto value = element.attribute("value");
      const auto otherwise = element.attribute("default");
      if (name && tag == xacro::Tag::kArgument)
        defaults_.try_emplace(std::string(name->value()), otherwise ? otherwise->value() : "");
      if (name && tag == xacro::Tag::kProperty && (value || otherwise))
        assign({macro_around(element), std::string(name->value())}, element,
               (value ? value : otherwise)->value());
    }
  }

  /// Once all documents are declared: which arguments reach which names.
  void follow() {
    for (int step = 0; step < kMaxArgumentSteps; ++step) {
      bool is_new = false;
      for (const Assignment& assignment : assignments_) {
        for (const std::string& argument : given(assignment))
          is_new = reaching_[assignment.to].insert(argument).second || is_new;
      }
      if (!is_new) return;
    }
  }

  void read_conditions(const xml::Document& document) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      if (element.name() != "xacro:if" && element.name() != "xacro:unless") continue;
      if (const auto value = element.attribute("value"))
        read_condition(value->value(), macro_around(element));
    }
    // A comparison whose result is given to a name is a condition of whatever asks for that name.
    for (const Assignment& assignment : assignments_) {
      if (compares_texts(assignment.text)) read_condition(assignment.text, assignment.macro);
    }
    assignments_.clear();
  }

  /// What else a path may hold in the place of an argument's default: of `config/ur5/limits.yaml`, with the
  /// default `ur5`, the folders beside that have a `limits.yaml`.
  void read_paths(const xml::Document& document, const std::vector<std::string>& paths,
                  const Disk& disk) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      for (const xml::Attribute attribute : element.attributes()) {
        const std::string_view text = attribute.value();
        if (text.find('/') == text.npos || text.find('$') == text.npos) continue;
        read_path(text, macro_around(element), paths, disk);
      }
    }
  }

  ArgumentValues values;

  const std::map<std::string, std::string, std::less<>>& defaults() const { return defaults_; }

 private:
  struct Assignment {
    TemplateName to;
    std::string macro;  ///< that the text is written in
    std::string text;
  };

  void assign(TemplateName to, xml::Element element, std::string_view text) {
    if (text.find('$') != text.npos)
      assignments_.push_back({std::move(to), macro_around(element), std::string(text)});
  }

  void declare_call(xml::Element call) {
    const std::string_view name = call.name().substr(xacro::kTagPrefix.size());
    const std::string macro(name.substr(name.rfind('.') + 1));
    for (const xml::Attribute attribute : call.attributes())
      assign({macro, std::string(attribute.name())}, call, attribute.value());
  }

  void declare_parameters(xml::Element macro) {
    const auto name = macro.attribute("name");
    const auto params = macro.attribute("params");
    if (!name || !params) return;
    xacro::Symbols symbols;
    for (const xacro::MacroParameter& each :
         xacro::parse_parameters(params->value(), {}, symbols)) {
      const TemplateName to{std::string(name->value()), std::string(each.name)};
      if (each.forwards) assign(to, macro, "${" + to.name + '}');
      if (each.has_default) assign(to, macro, each.text);
    }
  }

  std::set<std::string> given(const Assignment& assignment) const {
    std::set<std::string> arguments;
    const std::string_view text = assignment.text;
    if (text.starts_with("$(arg ") && text.ends_with(')')) {
      const std::string argument(text.substr(6, text.size() - 7));
      if (defaults_.contains(argument)) arguments.insert(argument);
    } else if (const std::string_view name = only_name(text); !name.empty()) {
      arguments = reaching(assignment.macro, std::string(name));
    }
    return arguments;
  }

  /// A macro's own names hide those of the file.
  std::set<std::string> reaching(const std::string& macro, const std::string& name) const {
    auto found = reaching_.find({macro, name});
    if (found == reaching_.end()) found = reaching_.find({{}, name});
    return found == reaching_.end() ? std::set<std::string>() : found->second;
  }

  bool is_truth_value(const std::string& argument) const {
    const std::string& value = defaults_.find(argument)->second;
    return value == "true" || value == "false" || value == "True" || value == "False" ||
           value == "0" || value == "1";
  }

  void read_condition(std::string_view text, const std::string& macro) {
    const bool compares = compares_texts(text);
    for (const auto& [name, value] : defaults_) {
      const bool named = text.find("$(arg " + name + ")") != text.npos ||
                         text.find("arg('" + name + "')") != text.npos ||
                         text.find("arg(\"" + name + "\")") != text.npos;
      if (named) add_compared(name, name, text, compares);
    }
    for (const auto& [key, arguments] : reaching_) {
      const bool is_visible =
          key.macro == macro || (key.macro.empty() && !reaching_.contains({macro, key.name}));
      if (!is_visible || !has_word(text, key.name)) continue;
      for (const std::string& argument : arguments) {
        // What a macro is given may be more than a truth value to others.
        if (compares || key.macro.empty() || is_truth_value(argument))
          add_compared(argument, key.name, text, compares);
      }
    }
  }

  void add_compared(const std::string& argument, const std::string& name, std::string_view text,
                    bool compares) {
    std::set<std::string> found;
    if (!compares) found = {"true", "false"};
    for (const std::string& quoted : quoted_texts(text)) {
      const bool is_name =
          quoted == argument || quoted == name || quoted.find('$') != std::string::npos;
      if (compares && !is_name) found.insert(quoted);
    }
    values[argument].merge(found);
  }

  void read_path(std::string_view text, const std::string& macro,
                 const std::vector<std::string>& paths, const Disk& disk) {
    const auto take = [&](const std::string& argument, const std::string& reference) {
      const std::string& value = defaults_.find(argument)->second;
      if (!value.empty() && value.find_first_of("$/") == value.npos &&
          is_part_of_path(text, reference) && in_paths_.insert(argument).second)
        add_entries(argument, value, paths, disk);
    };
    for (const auto& [name, value] : defaults_) take(name, "$(arg " + name + ")");
    for (const auto& [key, arguments] : reaching_) {
      if (!key.macro.empty() && key.macro != macro) continue;
      for (const std::string& argument : arguments) take(argument, "${" + key.name + "}");
    }
  }

  /// Directly behind a slash: all that is between it and the next one, or the dot of a file's extension.
  static bool is_part_of_path(std::string_view text, const std::string& reference) {
    const std::size_t at = text.find(reference);
    if (at == text.npos || at == 0 || text[at - 1] != '/') return false;
    const std::size_t end = at + reference.size();
    return end < text.size() && (text[end] == '/' || text[end] == '.');
  }

  void add_entries(const std::string& name, const std::string& value,
                   const std::vector<std::string>& paths, const Disk& disk) {
    for (const std::string& path : paths) {
      for (const char behind : {'/', '.'}) {
        const std::size_t at = path.find('/' + value + behind);
        if (at == path.npos) continue;
        const std::string rest = path.substr(at + 1 + value.size());
        if (behind == '.' && rest.find('/') != rest.npos) continue;
        for (const std::string& entry : disk.list(path.substr(0, at))) {
          const bool is_file = behind == '.';
          if (is_file && (!entry.ends_with(rest) || entry.size() == rest.size())) continue;
          const std::string other = is_file ? entry.substr(0, entry.size() - rest.size()) : entry;
          if (is_file || disk.kind(path.substr(0, at + 1) + entry + rest) == PathKind::kFile)
            values[name].insert(other);
        }
      }
    }
  }

  static bool has_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || (!is_word_byte(text[at - 1]) && text[at - 1] != '\'');
      if (begins && (end == text.size() || !is_word_byte(text[end]))) return true;
    }
    return false;
  }

  std::map<std::string, std::string, std::less<>> defaults_;
  std::vector<Assignment> assignments_;
  std::map<TemplateName, std::set<std::string>> reaching_;  ///< the arguments that a name may be
  std::set<std::string, std::less<>> in_paths_;  ///< arguments whose folders have been listed
};

/// The files that an expansion read, and those that it looked for in vain.
std::vector<std::string> paths_of(const xacro::Expansion& expansion) {
  std::vector<std::string> paths;
  for (const xacro::FileUse& file : expansion.files) paths.push_back(file.path);
  for (const xacro::Fact& fact : expansion.facts) {
    if (fact.kind == xacro::FactKind::kFileNotFound) paths.push_back(fact.name);
  }
  return paths;
}

}  // namespace

ArgumentPlan all_arguments(const xacro::Expansion& expansion, const Sources& sources,
                           const Disk& disk, ArgumentPlan plan) {
  std::vector<xml::Document> documents;
  for (const xacro::FileUse& file : expansion.files) {
    const std::string_view bytes = sources.bytes(file.source);
    if (bytes.find("<") == bytes.npos) continue;  // YAML
    documents.push_back(xml::parse(bytes, file.source));
  }
  ArgumentReader reader;
  for (const xml::Document& document : documents) reader.declare(document);
  reader.follow();
  for (const xml::Document& document : documents) reader.read_conditions(document);
  const std::vector<std::string> paths = paths_of(expansion);
  for (const xml::Document& document : documents) reader.read_paths(document, paths, disk);
  std::vector<TemplateArguments> single;
  std::vector<TemplateArguments> paired;
  for (const auto& [name, values] : reader.values) {
    std::size_t index = 0;
    for (const std::string& value : values) {
      if (value.empty() || value == reader.defaults().find(name)->second) continue;
      single.push_back({{name, value}});
      if (index == paired.size()) paired.emplace_back();
      paired[index++].emplace_back(name, value);
    }
  }
  const std::size_t room = kMaxArgumentSets - std::min(kMaxArgumentSets, plan.sets.size());
  std::vector<TemplateArguments>& chosen = single.size() <= room ? single : paired;
  if (chosen.size() > room) {
    std::size_t left_out = 0;
    for (std::size_t i = room; i < chosen.size(); ++i) left_out += chosen[i].size();
    plan.left_out = std::to_string(left_out) + " values of arguments are left out, as " +
                    std::to_string(kMaxArgumentSets) + " sets are expanded at most";
    chosen.resize(room);
  }
  std::move(chosen.begin(), chosen.end(), std::back_inserter(plan.sets));
  return plan;
}

std::string shown_arguments(const TemplateArguments& arguments) {
  std::string text;
  for (const auto& [name, value] : arguments) {
    if (!text.empty()) text += ' ';
    text += name + ":=" + value;
  }
  return text;
}

}  // namespace rigor::read
