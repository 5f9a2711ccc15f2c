// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/argument_sets.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

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

/// Arguments, and properties that are nothing but one.
class ArgumentReader {
 public:
  void declare(const xml::Document& document) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      const auto name = element.attribute("name");
      if (!name) continue;
      if (element.name() == "xacro:arg") {
        const auto value = element.attribute("default");
        defaults_.try_emplace(std::string(name->value()), value ? value->value() : "");
      } else if (element.name() == "xacro:property") {
        const auto value = element.attribute("value");
        if (value && value->value().starts_with("$(arg ") && value->value().ends_with(")")) {
          const std::string_view inner = value->value().substr(6, value->value().size() - 7);
          property_of_.try_emplace(std::string(name->value()), inner);
        }
      }
    }
  }

  void read_conditions(const xml::Document& document) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const xml::Element element = document.element(i);
      if (element.name() != "xacro:if" && element.name() != "xacro:unless") continue;
      if (const auto value = element.attribute("value")) read_condition(value->value());
    }
  }

  /// What else a path may hold in the place of an argument's default: of `config/ur5/limits.yaml`, with the
  /// default `ur5`, the folders beside that have a `limits.yaml`.
  void read_paths(const xml::Document& document, const std::vector<std::string>& paths,
                  const Disk& disk) {
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      for (const xml::Attribute attribute : document.element(i).attributes())
        read_path(attribute.value(), paths, disk);
    }
  }

  ArgumentValues values;

  const std::map<std::string, std::string, std::less<>>& defaults() const { return defaults_; }

 private:
  void read_condition(std::string_view text) {
    for (const std::string& name : arguments_in(text)) {
      std::set<std::string> found;
      bool compares = text.find("==") != text.npos || text.find("!=") != text.npos ||
                      text.find(" in ") != text.npos;
      for (const std::string& quoted : quoted_texts(text)) {
        const bool is_name = quoted == name || quoted.find('$') != std::string::npos;
        if (compares && !is_name) found.insert(quoted);
      }
      if (!compares) found = {"true", "false"};
      values[name].merge(found);
    }
  }

  void read_path(std::string_view text, const std::vector<std::string>& paths, const Disk& disk) {
    if (text.find('/') == text.npos || text.find('$') == text.npos) return;
    for (const auto& [name, value] : defaults_) {
      if (!value.empty() && value.find_first_of("$/") == value.npos &&
          is_part_of_path(text, "$(arg " + name + ")") && in_paths_.insert(name).second) {
        add_entries(name, value, paths, disk);
      }
    }
    for (const auto& [property, argument] : property_of_) {
      const auto known = defaults_.find(argument);
      if (known == defaults_.end() || known->second.empty() ||
          known->second.find_first_of("$/") != known->second.npos)
        continue;
      if (is_part_of_path(text, "${" + property + "}") && in_paths_.insert(argument).second)
        add_entries(argument, known->second, paths, disk);
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

  std::set<std::string> arguments_in(std::string_view text) const {
    std::set<std::string> found;
    for (const auto& [name, value] : defaults_) {
      const bool named = text.find("$(arg " + name + ")") != text.npos ||
                         text.find("arg('" + name + "')") != text.npos ||
                         text.find("arg(\"" + name + "\")") != text.npos;
      if (named) found.insert(name);
    }
    for (const auto& [property, argument] : property_of_) {
      if (has_word(text, property) && defaults_.contains(argument)) found.insert(argument);
    }
    return found;
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
  std::map<std::string, std::string, std::less<>> property_of_;
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
