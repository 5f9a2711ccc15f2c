// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares schemas/sdf.schema with the published descriptions of every SDFormat version, row by row
// and both ways: an element too many is a difference as well as one too few. The rows are those of
// sdf-spec/elements.tsv beside the corpus ($RIGOR_CORPUS/../sdf-spec). Differences that are meant,
// with their reasons:
//
//   - `urdf` and `collision_engine` describe files of their own, which no other description
//     includes: no document can contain what is in them.
//   - A sensor's topic has the default "__default" in 1.0 and 1.2, a slip of the pen for
//     "__default__", which is the descriptions' way to say that there is none.
//   - auto_inertia_params is open: its description says in words, not in a row, that any element
//     may stand inside.
//
// Rows of kind `element` with a `ref` are described by the file they refer to; what the row itself
// lists is compared too.
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

struct Row {
  std::string version, file, parent, kind, name, type, required, default_value, minimum, maximum,
      ref;
};

std::vector<Row> read_rows(const std::filesystem::path& path) {
  std::vector<Row> rows;
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);  // the header
  while (std::getline(in, line)) {
    std::array<std::string, 11> cells;
    std::size_t at = 0;
    for (std::string& cell : cells) {
      const std::size_t end = std::min(line.find('\t', at), line.size());
      cell = line.substr(at, end - at);
      at = std::min(end + 1, line.size());
    }
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6], cells[7],
                    cells[8], cells[9], cells[10]});
  }
  return rows;
}

bool is_never_included(const Row& row) {
  return row.file == "urdf" || row.file == "collision_engine";
}

// The descriptions' words for types, as the schema writes them.
std::string type_word(const std::string& type) {
  if (type == "unsigned int") return "uint";
  if (type == "uint64_t") return "uint64";
  if (type == "vector2d") return "vector2";
  return type;
}

std::string shown(std::optional<std::string_view> value) {
  return value ? "\"" + std::string(*value) + "\"" : "none";
}

// The default a row states: none for a container and for the word that represents none.
std::string default_of(const Row& row) {
  const bool none =
      row.type.empty() || row.default_value == "__default__" ||
      (row.file == "sensor" && row.name == "topic" && row.default_value == "__default");
  return none ? "none" : "\"" + row.default_value + "\"";
}

// Walks the rows of one version and the schema side by side.
class Comparison {
 public:
  Comparison(const std::vector<Row>& rows, std::string version) : version_(std::move(version)) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows[i];
      if (row.version != version_) continue;
      if (row.kind == "root") {
        roots_[row.file] = &row;
      } else {
        inside_[{row.file, row.parent}].push_back(&row);
      }
    }
  }

  void compare_file(const std::string& file, const Node& node, const std::string& path) {
    const auto root = roots_.find(file);
    ASSERT_NE(root, roots_.end()) << version_ << " " << file;
    seen_.insert(root->second);
    compare_values(*root->second, node, path);
    compare_inside(file, root->second->name, node, path, {});
  }

  void compare_cardinality(const Row& row, const Node& node, const std::string& path) {
    expect_equal(path, "required", row.required, std::string(to_string(node.cardinality())));
  }

  const std::set<const Row*>& seen() const { return seen_; }
  const std::vector<std::string>& differences() const { return differences_; }
  const Row& root(const std::string& file) const { return *roots_.at(file); }

 private:
  void compare_values(const Row& row, const Node& node, const std::string& path) {
    expect_equal(path, "type", type_word(row.type), std::string(to_string(node.type())));
    expect_equal(path, "default", default_of(row), shown(node.default_value()));
    expect_equal(path, "min", row.minimum, std::string(node.minimum().value_or("")));
    expect_equal(path, "max", row.maximum, std::string(node.maximum().value_or("")));
  }

  // Children and attributes, both ways. `allowed` names those that another row accounts for.
  void compare_inside(const std::string& file, const std::string& parent, const Node& node,
                      const std::string& path, std::set<std::string> allowed) {
    // a recursive block need not be walked twice, but every row that describes a place must be
    if (!visited_.insert({file, parent, node.declaration()}).second) return;
    bool open = parent.ends_with("auto_inertia_params");
    for (const Row* row : inside_[{file, parent}]) {
      seen_.insert(row);
      if (row->kind == "any") {
        open = true;
      } else {
        allowed.insert(compare_row(*row, node, path));
      }
    }
    if (open != node.open()) differ(path, "open", open ? "yes" : "no", node.open() ? "yes" : "no");
    for (const Node child : node.children()) expect_allowed(child, "", path, allowed);
    for (const Node attribute : node.attributes()) expect_allowed(attribute, "@", path, allowed);
  }

  void expect_allowed(const Node& node, const std::string& mark, const std::string& path,
                      const std::set<std::string>& allowed) {
    const std::string name = mark + std::string(node.name());
    if (!allowed.contains(name)) differ(path + "/" + name, "existence", "no", "yes");
  }

  // The name of what the row describes, with @ for an attribute.
  std::string compare_row(const Row& row, const Node& node, const std::string& path) {
    const bool attribute = row.kind == "attribute";
    const bool include = row.kind == "include";
    const std::string name = include ? roots_.at(row.name)->name : row.name;
    const std::string shown_name = (attribute ? "@" : "") + name;
    const std::string here = path + "/" + shown_name;
    const std::optional<Node> found = attribute ? node.attribute(name) : node.child(name);
    if (!found) {
      differ(here, "existence", "yes", "no");
      return shown_name;
    }
    compare_cardinality(row, *found, here);
    if (include) {
      compare_file(row.name, *found, here);
    } else if (!row.ref.empty()) {
      for (const Row* inner : inside_[{row.file, row.parent + "/" + row.name}]) {
        seen_.insert(inner);
        compare_row(*inner, *found, here);
      }
      compare_file(row.ref, *found, here);
    } else {
      compare_values(row, *found, here);
      if (!attribute) compare_inside(row.file, row.parent + "/" + row.name, *found, here, {});
    }
    return shown_name;
  }

  void expect_equal(const std::string& path, const char* what, const std::string& fact,
                    const std::string& schema) {
    if (fact != schema) differ(path, what, fact, schema);
  }

  void differ(const std::string& path, const char* what, const std::string& fact,
              const std::string& schema) {
    differences_.push_back(version_ + " " + path + " " + what + ": the description says " + fact +
                           ", the schema " + schema);
  }

  std::string version_;
  std::map<std::string, const Row*> roots_;
  std::map<std::pair<std::string, std::string>, std::vector<const Row*>> inside_;
  std::set<std::tuple<std::string, std::string, std::uint32_t>> visited_;
  std::set<const Row*> seen_;
  std::vector<std::string> differences_;
};

TEST(Facts, EveryRowOfEveryVersionIsInTheSchema) {
  const char* const corpus = std::getenv("RIGOR_CORPUS");
  if (!corpus) GTEST_SKIP() << "RIGOR_CORPUS is not set: nothing to compare with";
  const std::filesystem::path path = std::filesystem::path(corpus) / ".." / "sdf-spec/elements.tsv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent: nothing to compare with";
  const std::vector<Row> rows = read_rows(path);
  ASSERT_GT(rows.size(), 1000u);

  auto parsed = Schema::parse(sdf_schema_text());
  ASSERT_TRUE(std::holds_alternative<Schema>(parsed));
  const Schema& schema = std::get<Schema>(parsed);
  std::set<std::string> versions;
  for (const Row& row : rows) versions.insert(row.version);
  EXPECT_EQ(versions.size(), schema.versions().size());

  std::size_t compared = 0, left_out = 0;
  for (const Version version : schema.versions()) {
    const std::string word = to_string(version);
    Comparison comparison(rows, word);
    for (const Node root : schema.roots(version)) {
      const std::string file = root.name() == "gazebo" ? "gazebo" : "root";
      comparison.compare_cardinality(comparison.root(file), root, std::string(root.name()));
      comparison.compare_file(file, root, std::string(root.name()));
    }
    for (const std::string& difference : comparison.differences()) ADD_FAILURE() << difference;
    for (const Row& row : rows) {
      if (row.version != word) continue;
      if (is_never_included(row)) {
        ++left_out;
      } else if (comparison.seen().contains(&row)) {
        ++compared;
      } else {
        ADD_FAILURE() << word << " " << row.file << " " << row.parent << "/" << row.name
                      << " was not compared";
      }
    }
  }
  EXPECT_EQ(compared + left_out, rows.size());
  std::cout << compared << " rows compared, " << left_out << " of files that nothing includes\n";
}

}  // namespace
}  // namespace rigor::schema
