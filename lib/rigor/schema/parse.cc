// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the line language of schemas/*.schema, which is explained at the top of schemas/sdf.schema.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>

#include <rigor/schema/tables.h>

namespace rigor::schema {
namespace {

using Fault = Schema::Fault;

constexpr std::array<std::string_view, 10> kKeyWords = {"card",       "type",   "count", "default",
                                                        "min",        "max",    "enum",  "unit",
                                                        "deprecated", "instead"};  // as in Key
constexpr std::array<std::string_view, 5> kCardWords = {"0", "1", "*", "+",
                                                        "-1"};  // as in Cardinality

template <std::size_t Count>
std::optional<std::uint8_t> index_of(const std::array<std::string_view, Count>& words,
                                     std::string_view word) {
  for (std::size_t i = 0; i < Count; ++i) {
    if (words[i] == word) return static_cast<std::uint8_t>(i);
  }
  return std::nullopt;
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

VersionSet from_on(int minor) { return ~VersionSet{0} << minor; }
VersionSet up_to(int minor) { return ~VersionSet{0} >> (kVersionLimit - 1 - minor); }

// Takes the next word off the front of a line; a word ends at a space, except inside "...".
std::string_view take_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  bool inside = false;
  std::size_t end = 0;
  while (end < rest.size() && (inside || rest[end] != ' ')) {
    if (rest[end] == '"') inside = !inside;
    ++end;
  }
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return word;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {
    // a schema line has some 85 bytes and two or three facets
    tables_.lines.reserve(text.size() / 64);
    tables_.facets.reserve(text.size() / 32);
  }

  std::variant<Tables, Fault> run() {
    if (!read_lines() || !resolve_uses() || !check_blocks()) return std::move(*fault_);
    group_entries();
    find_keys();
    find_only_types();
    if (!check_names()) return std::move(*fault_);
    reach();
    return std::move(tables_);
  }

 private:
  bool fail(std::uint32_t number, std::string message) {
    fault_ = Fault{static_cast<int>(number), std::move(message)};
    return false;
  }

  std::optional<int> version_of(std::string_view word) {
    const std::optional<Version> version = parse_version(word);
    if (!version || version->minor >= kVersionLimit) return std::nullopt;
    return version->minor;
  }

  bool read_lines() {
    std::string_view rest = text_;
    while (!rest.empty()) {
      ++number_;
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      const std::size_t indent = line.find_first_not_of(' ');
      if (indent == std::string_view::npos || line[indent] == '#') continue;
      if (indent % 2 != 0 || indent / 2 > stack_.size()) {
        return fail(number_, "indented by " + std::to_string(indent) +
                                 " spaces, which does not fit the line above");
      }
      stack_.resize(indent / 2);
      line.remove_prefix(indent);
      if (!(stack_.empty() ? read_top(line) : read_member(line))) return false;
    }
    if (tables_.known == 0) return fail(number_, "there is no line 'versions'");
    return true;
  }

  bool read_top(std::string_view line) {
    const std::string_view word = take_word(line);
    if (word == "versions") return read_versions(line);
    if (word != "define") {
      return fail(number_, quoted(word) + " at the margin; 'define' or 'versions' would be right");
    }
    if (tables_.known == 0) return fail(number_, "'versions' must come before the first 'define'");
    const std::string_view name = take_word(line);
    if (name.empty()) return fail(number_, "'define' without the name of a block");
    if (!blocks_.emplace(name, size()).second) {
      return fail(number_, "block " + quoted(name) + " is defined twice");
    }
    Line& block = add(name, Kind::kBlock);
    block.parent = size() - 1;
    block.exists = tables_.known;
    if (name == "root") tables_.root = size() - 1;
    return true;
  }

  bool read_versions(std::string_view line) {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const std::optional<int> minor = version_of(word);
      if (!minor) return fail(number_, quoted(word) + " is not a version from 1.0 to 1.31");
      if (from_on(*minor) & tables_.known) {
        return fail(number_, "version " + std::string(word) + " is out of order");
      }
      tables_.known |= only(*minor);
      tables_.versions.push_back(Version{*minor});
    }
    return true;
  }

  bool read_member(std::string_view line) {
    const std::uint32_t parent = stack_.back();
    if (tables_.lines[parent].kind == Kind::kAttribute ||
        tables_.lines[parent].kind == Kind::kUse) {
      return fail(number_, "an attribute or a use has nothing inside");
    }
    const std::string_view word = take_word(line);
    const bool in_block = tables_.lines[parent].kind == Kind::kBlock;
    if (word == "any" && !in_block) {
      tables_.lines[parent].open = true;
      return true;
    }
    Kind kind = Kind::kElement;
    if (word == "attribute" && !in_block) {
      kind = Kind::kAttribute;
    } else if (word == "use" && !in_block) {
      kind = Kind::kUse;
    } else if (word != "element") {
      return fail(number_, quoted(word) + " cannot stand here");
    }
    const std::string_view name = take_word(line);
    if (name.empty()) return fail(number_, quoted(word) + " without a name");
    Line& added = add(name, kind);
    added.parent = parent;
    added.first_facet = static_cast<std::uint32_t>(tables_.facets.size());
    if (!read_facets(added, line)) return false;
    added.last_facet = static_cast<std::uint32_t>(tables_.facets.size());
    std::stable_sort(tables_.facets.begin() + added.first_facet, tables_.facets.end(),
                     [](const Facet& a, const Facet& b) { return a.key < b.key; });
    if (added.exists == 0) {
      return fail(number_, quoted(name) + " exists in none of the versions of the line around it");
    }
    return true;
  }

  bool read_facets(Line& line, std::string_view rest) {
    line.exists = tables_.lines[line.parent].exists;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (word == "|") {
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
        line.doc = rest;
        return true;
      }
      const std::size_t equals = word.find('=');
      if (equals == std::string_view::npos) {
        return fail(number_, quoted(word) + " is not of the form key=value");
      }
      std::string_view key = word.substr(0, equals);
      std::string_view value = word.substr(equals + 1);
      const bool present = !value.empty();
      if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
        value = value.substr(1, value.size() - 2);
      }
      if (!(key == "since" || key == "until" ? read_existence(line, key, value)
                                             : read_facet(line, key, value, present))) {
        return false;
      }
    }
    return true;
  }

  bool read_existence(Line& line, std::string_view key, std::string_view value) {
    const std::optional<int> minor = version_of(value);
    if (!minor || !(tables_.known & only(*minor))) {
      return fail(number_, std::string(key) + "=" + std::string(value) + " is not a known version");
    }
    line.exists &= key == "since" ? from_on(*minor) : up_to(*minor);
    return true;
  }

  bool read_facet(const Line& line, std::string_view key, std::string_view value, bool present) {
    int from = 0;
    if (const std::size_t at = key.find('@'); at != std::string_view::npos) {
      const std::optional<int> minor = version_of(key.substr(at + 1));
      if (!minor || !(tables_.known & only(*minor))) {
        return fail(number_, quoted(key) + " does not name a known version");
      }
      from = *minor;
      key = key.substr(0, at);
    }
    const std::optional<std::uint8_t> index = index_of(kKeyWords, key);
    if (!index) return fail(number_, "unknown key " + quoted(key));
    Facet facet{value, static_cast<Key>(*index), static_cast<std::uint8_t>(from), 0, present};
    for (std::size_t i = line.first_facet; i < tables_.facets.size(); ++i) {
      if (tables_.facets[i].key == facet.key && tables_.facets[i].from >= facet.from) {
        return fail(number_, "key " + quoted(key) + " is repeated, or its versions out of order");
      }
    }
    if (present && !read_number(facet)) {
      return fail(number_, quoted(value) + " is not a value for " + quoted(key));
    }
    tables_.facets.push_back(facet);
    return true;
  }

  // The values of three keys are kept as numbers.
  bool read_number(Facet& facet) {
    std::optional<std::uint8_t> number = 0;
    if (facet.key == Key::kCard) {
      number = index_of(kCardWords, facet.value);
    } else if (facet.key == Key::kType) {
      const std::optional<Type> type = parse_type(facet.value);
      number = type ? std::optional(static_cast<std::uint8_t>(*type)) : std::nullopt;
    } else if (facet.key == Key::kCount) {
      return parse_count(facet.value).has_value();
    } else if (facet.key == Key::kDeprecated) {
      const std::optional<int> minor = version_of(facet.value);
      number = minor ? std::optional(static_cast<std::uint8_t>(*minor)) : std::nullopt;
    }
    if (number) facet.number = *number;
    return number.has_value();
  }

  bool resolve_uses() {
    for (Line& line : tables_.lines) {
      if (line.kind != Kind::kUse) continue;
      const auto block = blocks_.find(line.name);
      if (block == blocks_.end() || block->second == tables_.root) {
        return fail(line.number, "there is no block " + quoted(line.name) + " to use");
      }
      // the root element of a block is the line after its `define`; check_blocks() sees that it is
      // there
      line.declaration = block->second + 1;
      if (line.declaration < size()) line.name = tables_.lines[line.declaration].name;
    }
    return true;
  }

  bool check_blocks() {
    const auto root = blocks_.find("root");
    if (root == blocks_.end()) return fail(number_, "there is no block 'root'");
    std::vector<std::uint32_t> elements(size(), 0);
    for (const Line& line : tables_.lines) {
      if (line.kind != Kind::kBlock) ++elements[line.parent];
    }
    for (const auto& [name, index] : blocks_) {
      if (elements[index] == 1 || (index == tables_.root && elements[index] > 0)) continue;
      return fail(tables_.lines[index].number, "block " + quoted(name) + " has " +
                                                   std::to_string(elements[index]) +
                                                   " elements at its top; one would be right");
    }
    return true;
  }

  // Lays the children of each line side by side, and so its attributes; both in the order of the
  // file.
  void group_entries() {
    std::vector<Line>& lines = tables_.lines;
    std::vector<std::uint32_t> next_child(lines.size(), 0), next_attribute(lines.size(), 0);
    for (const Line& line : lines) {
      if (line.kind == Kind::kBlock) continue;
      ++(line.kind == Kind::kAttribute ? next_attribute : next_child)[line.parent];
    }
    std::uint32_t total = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i].first_attribute = total;
      total += std::exchange(next_attribute[i], total);
      lines[i].last_attribute = lines[i].first_child = total;
      total += std::exchange(next_child[i], total);
      lines[i].last_child = total;
    }
    tables_.entries.resize(total);
    for (std::uint32_t i = 0; i < size(); ++i) {
      const Line& line = lines[i];
      if (line.kind == Kind::kBlock) continue;
      const std::uint32_t at =
          (line.kind == Kind::kAttribute ? next_attribute : next_child)[line.parent]++;
      const Entry entry{line.name.data(), static_cast<std::uint32_t>(line.name.size()), i,
                        line.exists, line.exists & required(line)};
      tables_.entries[at] = entry;
      Line& around = lines[line.parent];
      (line.kind == Kind::kAttribute ? around.requires_attribute : around.requires_child) |=
          entry.required;
    }
  }

  void find_keys() {
    for (Line& line : tables_.lines) {
      for (const Line* one : {&line, &tables_.lines[line.declaration]}) {
        for (std::uint32_t i = one->first_facet; i < one->last_facet; ++i) {
          line.keys |= only(tables_.facets[i].key);
        }
      }
    }
  }

  void find_only_types() {
    const int first = tables_.versions.front().minor;
    for (Line& line : tables_.lines) {
      const Facet* type = nullptr;
      int said = 0;
      for (const Line* one : {&line, &tables_.lines[line.declaration]}) {
        for (std::uint32_t i = one->first_facet; i < one->last_facet; ++i) {
          if (tables_.facets[i].key != Key::kType) continue;
          type = &tables_.facets[i];
          ++said;
        }
        if (said > 0) break;
      }
      if (said == 0) line.only_type = Type::kNone;
      const bool always = said == 1 && type->from <= first && type->present;
      if (always) line.only_type = static_cast<Type>(type->number);
    }
  }

  VersionSet required(const Line& line) const {
    const std::optional<VersionSet> own = required_by_facets(line);
    return own ? *own : required_by_facets(tables_.lines[line.declaration]).value_or(0);
  }

  std::optional<VersionSet> required_by_facets(const Line& line) const {
    std::optional<VersionSet> set;
    for (std::uint32_t i = line.first_facet; i < line.last_facet; ++i) {
      const Facet& facet = tables_.facets[i];
      if (facet.key != Key::kCard) continue;
      const auto cardinality = static_cast<Cardinality>(facet.number);
      const bool needed = facet.present && (cardinality == Cardinality::kOne ||
                                            cardinality == Cardinality::kOneOrMore);
      const VersionSet later = from_on(facet.from);
      set = (set.value_or(0) & ~later) | (needed ? later : 0);
    }
    return set;
  }

  bool check_names() {
    for (const Line& line : tables_.lines) {
      if (!check_names(line.first_attribute, line.last_attribute) ||
          !check_names(line.first_child, line.last_child)) {
        return false;
      }
    }
    return true;
  }

  bool check_names(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) {
      const Line& one = tables_.lines[tables_.entries[i].line];
      for (std::uint32_t j = i + 1; j < last; ++j) {
        const Line& other = tables_.lines[tables_.entries[j].line];
        if ((one.exists & other.exists) != 0 && one.name == other.name) {
          return fail(other.number, quoted(other.name) + " stands here twice in one version");
        }
      }
    }
    return true;
  }

  // Finds the versions in which each line can be reached from a root: blocks do not say it
  // themselves.
  void reach() {
    std::vector<Line>& lines = tables_.lines;
    std::vector<std::uint32_t> open = {tables_.root};
    lines[tables_.root].reachable = tables_.known;
    while (!open.empty()) {
      const Line& around = lines[open.back()];
      open.pop_back();
      for (std::uint32_t i = around.first_attribute; i < around.last_child; ++i) {
        Line& place = lines[tables_.entries[i].line];
        place.reachable |= around.reachable & place.exists;
        Line& inside = lines[place.declaration];
        const VersionSet before = &inside == &place ? 0 : inside.reachable;
        const VersionSet after = before | (place.reachable & inside.exists);
        if (&inside != &place) inside.reachable = after;
        if (after != before) open.push_back(place.declaration);
      }
    }
  }

  Line& add(std::string_view name, Kind kind) {
    stack_.push_back(size());
    Line line;
    line.name = name;
    line.kind = kind;
    line.number = number_;
    line.declaration = size();
    tables_.lines.push_back(line);
    return tables_.lines.back();
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(tables_.lines.size()); }

  std::string_view text_;
  Tables tables_;
  std::optional<Fault> fault_;
  std::uint32_t number_ = 0;
  std::vector<std::uint32_t> stack_;  // the lines around the one that is read, outermost first
  std::unordered_map<std::string_view, std::uint32_t> blocks_;
};

}  // namespace

std::variant<Tables, Schema::Fault> parse_tables(std::string_view text) {
  return Parser(text).run();
}

}  // namespace rigor::schema
