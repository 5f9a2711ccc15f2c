// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Holds the readers and the frames against what libsdformat resolves: testdata/frames.

#include <rigor/model/frames.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/resolve.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>

namespace rigor {
namespace {

using model::Id;

const std::string kFolder = std::string(RIGOR_TESTDATA) + "frames/";

/// "link top::arm", and its numbers and names, as a row of facts.tsv has them.
struct Row {
  std::string entity;
  std::vector<std::string> values;
};

/// The rows of a case, sorted, and what libsdformat says of it as a whole.
struct Case {
  std::string verdict;
  std::vector<Row> rows;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

void sort(std::vector<Row>& rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.entity < b.entity; });
}

std::map<std::string, Case> read_facts() {
  std::map<std::string, Case> cases;
  std::ifstream stream(kFolder + "facts.tsv");
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string> columns = split(line, '\t');
    Case& of = cases[columns[0]];
    if (columns[1] == "verdict") {
      of.verdict = columns[2];
      continue;
    }
    Row row{columns[1] + ' ' + columns[2], {columns.begin() + 3, columns.begin() + 10}};
    if (columns.size() > 10) {
      for (std::string& value : split(columns[10], ' ')) row.values.push_back(std::move(value));
    }
    of.rows.push_back(std::move(row));
  }
  for (auto& [file, of] : cases) sort(of.rows);
  return cases;
}

std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.15g", value);
  return buffer.data();
}

/// libsdformat's numbers of the joint types.
int number_of(model::JointType type) {
  using model::JointType;
  switch (type) {
    case JointType::kBall: return 1;
    case JointType::kContinuous: return 2;
    case JointType::kFixed: return 3;
    case JointType::kGearbox: return 4;
    case JointType::kPrismatic: return 5;
    case JointType::kRevolute: return 6;
    case JointType::kRevolute2: return 7;
    case JointType::kScrew: return 8;
    case JointType::kUniversal: return 9;
    default: return 0;
  }
}

/// What rigor makes of a loaded root, in the shape of the facts.
class Rows {
 public:
  explicit Rows(const model::Root& root) : root_(root), frames_(root) {
    all(root.models, [](Id<model::Model>, Row&) {});
    all(root.links, [this](Id<model::Link> id, Row& row) { add_mass(id, row); });
    all(root.collisions, [](Id<model::Collision>, Row&) {});
    all(root.visuals, [](Id<model::Visual>, Row&) {});
    all(root.frames, [](Id<model::Frame>, Row&) {});
    all(root.joints, [this](Id<model::Joint> id, Row& row) { add_ends_and_axes(id, row); });
    sort(rows_);
  }

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<model::FrameProblem>& problems() const { return frames_.problems(); }

 private:
  static const char* kind(const model::Model& model) { return model.merged ? "frame " : "model "; }
  static const char* kind(const model::Link&) { return "link "; }
  static const char* kind(const model::Collision&) { return "collision "; }
  static const char* kind(const model::Visual&) { return "visual "; }
  static const char* kind(const model::Frame&) { return "frame "; }
  static const char* kind(const model::Joint&) { return "joint "; }

  static void add(Row& row, std::initializer_list<double> numbers) {
    for (const double number : numbers) row.values.push_back(text(number));
  }

  template <class Entity, class Extra>
  void all(const std::vector<Entity>& entities, Extra extra) {
    for (std::uint32_t i = 0; i < entities.size(); ++i) {
      const Id<Entity> id{i};
      const auto X = frames_.pose(id);
      if (!X) continue;
      Row row{kind(entities[i]) + scoped_name(root_, id), {}};
      add(row, {X->translation.x, X->translation.y, X->translation.z, X->rotation.w, X->rotation.x,
                X->rotation.y, X->rotation.z});
      extra(id, row);
      rows_.push_back(std::move(row));
    }
  }

  void add_mass(Id<model::Link> id, Row& row) const {
    const mass::MassProperties m = mass::resolve(root_, id);
    const mass::Inertia& I = m.about_com;
    add(row, {m.mass, m.com.x, m.com.y, m.com.z, I.ixx, I.ixy, I.ixz, I.iyy, I.iyz, I.izz});
  }

  void add_ends_and_axes(Id<model::Joint> id, Row& row) const {
    const model::Joint& joint = root_[id];
    const auto& ends = frames_.ends(id);
    const auto name = [&](Id<model::Link> link) {
      return link ? model::name_in(root_, joint.model, link) : std::string("?");
    };
    // A name with a space in it is two words, here as there.
    const std::string names = (ends.parent_is_world ? "world" : name(ends.parent)) + ' ' +
                              name(ends.child) + ' ' + std::to_string(number_of(joint.type));
    for (std::string& word : split(names, ' ')) row.values.push_back(std::move(word));
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      if (const auto axis = frames_.axis(id, k)) add(row, {axis->x, axis->y, axis->z});
    }
  }

  const model::Root& root_;
  const model::Frames frames_;
  std::vector<Row> rows_;
};

/// Cases in which libsdformat 12 is not to be followed, and why.
const std::map<std::string, std::string> kDifferent{
    {"quaternion_long", "it takes 0 0 3 4 for a rotation as it is; rigor normalizes it"},
    {"child_is_own_model", "it refuses a joint's end that is a model's frame"},
    {"parent_is_nested_model_frame", "it refuses a joint's end that is a model's frame"},
};

/// Of a world of SDF 1.7 or older libsdformat makes a nested model `arm` of a link "arm::base" and
/// its like; the names of links and where they are stay the same, and only those are compared.
constexpr std::string_view kUnflattened = "flattened_world";

/// "cases/012_topic.sdf" is about "topic".
std::string topic(const std::string& file) {
  const std::size_t begin = file.find('_') + 1;
  return file.substr(begin, file.rfind('.') - begin);
}

/// Twelve digits are written; chains of a dozen poses lose some of sixteen.
constexpr double kTolerance = 1e-9;

/// libsdformat 12 merges models as text: the pose of what is merged, turned into roll, pitch and
/// yaw, passes through six digits. A placement frame's pose has more, and so what is merged by one
/// is off by some 1e-6 of the lever arms, which are a few meters long.
constexpr double kRoundedTolerance = 5e-5;

double tolerance(const std::string& file) {
  return topic(file) == "merge_placement" ? kRoundedTolerance : kTolerance;
}

/// Within a static model everything is one body for libsdformat, and has no link's name but that of
/// the model's own frame; rigor names the model's canonical link.
bool is_static_body(const std::string& name) { return name.ends_with("__model__"); }

bool same(const std::string& a, const std::string& b, double sign, double tolerance) {
  char* end_a = nullptr;
  char* end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a);
  const double y = sign * std::strtod(b.c_str(), &end_b);
  if (a.empty() || b.empty() || *end_a != '\0' || *end_b != '\0') {
    return a == b || is_static_body(a);
  }
  return std::abs(x - y) <= tolerance * std::max(1.0, std::abs(x));
}

bool same(const Row& fact, const Row& row, double tolerance) {
  if (fact.values.size() != row.values.size()) return false;
  const auto rotation = [&](double sign) {
    for (std::size_t i = 3; i < 7; ++i) {
      if (!same(fact.values[i], row.values[i], sign, tolerance)) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < fact.values.size(); ++i) {
    const bool in_rotation = i >= 3 && i < 7;
    if (!in_rotation && !same(fact.values[i], row.values[i], 1, tolerance)) return false;
  }
  return rotation(1) || rotation(-1);
}

std::string print(const Row& row) {
  std::string line = row.entity;
  for (const std::string& value : row.values) line += ' ' + value;
  return line;
}

class FramesFacts : public testing::Test {
 protected:
  void compare(const std::string& file, const Case& of) {
    const read::Loaded loaded = load(file);
    const Rows all(loaded.root);
    EXPECT_TRUE(loaded.facts.empty());
    for (const auto& problem : all.problems()) {
      ADD_FAILURE() << "problem of " << problem.subject << ": " << problem.name;
    }
    const auto matters = [&](const Row& row) {
      return topic(file) != kUnflattened || row.entity.starts_with("link ");
    };
    const auto surplus = [&](const Row& row) {
      if (matters(row)) ADD_FAILURE() << "surplus: " << print(row);
    };
    auto row = all.rows().begin();
    const auto end = all.rows().end();
    for (const Row& fact : of.rows) {
      if (!matters(fact)) continue;
      for (; row != end && row->entity < fact.entity; ++row) surplus(*row);
      if (row == end || row->entity != fact.entity) {
        ADD_FAILURE() << "missing: " << print(fact);
        continue;
      }
      EXPECT_TRUE(same(fact, *row, tolerance(file)))
          << "fact: " << print(fact) << "\nrow:  " << print(*row);
      ++row;
    }
    for (; row != end; ++row) surplus(*row);
  }

  std::vector<model::FrameProblem> problems(const std::string& file) {
    return model::Frames(load(file).root).problems();
  }

 private:
  static read::SearchPaths models() {
    read::SearchPaths paths;
    paths.given.push_back({kFolder + "models", "--model-path"});
    return paths;
  }

  read::Loaded load(const std::string& file) {
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    return read::load(reader, workspace_.open(kFolder + file));
  }

  RealDisk disk_;
  Sources sources_;
  read::Workspace workspace_{disk_, sources_};
  Environment environment_{disk_, models()};
};

TEST_F(FramesFacts, EveryRowIsAsLibsdformatResolvesIt) {
  const std::map<std::string, Case> cases = read_facts();
  ASSERT_GE(cases.size(), 400U);
  std::size_t compared = 0;
  for (const auto& [file, of] : cases) {
    if (of.verdict != "valid" || kDifferent.contains(topic(file))) continue;
    SCOPED_TRACE(file);
    compare(file, of);
    compared += of.rows.size();
  }
  EXPECT_GE(compared, 5000U);
}

TEST_F(FramesFacts, WhatLibsdformatRefusesOfNamesIsAProblem) {
  // Its codes of joint ends (19 to 21), attached_to (22, 23) and relative_to (25, 26).
  std::size_t found = 0;
  for (const auto& [file, of] : read_facts()) {
    for (const int code : {19, 20, 21, 22, 23, 25, 26}) {
      if (of.verdict != "error " + std::to_string(code) || kDifferent.contains(topic(file)))
        continue;
      EXPECT_FALSE(problems(file).empty()) << file;
      ++found;
    }
  }
  EXPECT_GE(found, 8U);
}

}  // namespace
}  // namespace rigor
