// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Files in memory, or real ones with other bytes, for the verbs of `rigor edit`.
//
//   VerbBench bench({{"arm.urdf", text}});
//   const ProvenChange proven = bench.prove(scaled(bench.open("arm.urdf"), 2));
//   EXPECT_EQ(bench.text(proven), expected);

#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/verbs/change.h>
#include <rigor/robot/compare.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>

namespace rigor::author {

class VerbBench {
 public:
  explicit VerbBench(std::initializer_list<std::pair<const std::string, std::string>> files)
      : memory_(std::make_unique<MemoryDisk>(std::map<std::string, std::string>(files))),
        environment_(std::make_unique<Environment>(*memory_, read::SearchPaths{})),
        reader_(*environment_, sources_) {}
  explicit VerbBench(const Disk& disk)
      : environment_(std::make_unique<Environment>(disk, read::SearchPaths{})),
        reader_(*environment_, sources_) {}

  const EditedModel& open(const std::string& path) {
    OpenedModel opened = reader_.open(path);
    EXPECT_TRUE(opened.model) << opened.problem;
    return keep(std::move(opened));
  }
  /// Null when it cannot be edited.
  const EditedModel* try_open(const std::string& path) {
    OpenedModel opened = reader_.open(path);
    return opened.model ? &keep(std::move(opened)) : nullptr;
  }
  const EditedModel& open_text(const std::string& path, const std::string& text) {
    OpenedModel opened = reader_.open_changed(path, {}, {{path, text}});
    EXPECT_TRUE(opened.model) << opened.problem;
    return keep(std::move(opened));
  }

  ProvenChange prove(const EditedModel& edited, const Change& change) {
    return author::prove(reader_, edited, change);
  }

  /// The text of the only file, of a change that holds.
  std::string text(const EditedModel& edited, const Change& change) {
    const ProvenChange proven = prove(edited, change);
    EXPECT_EQ(proven.refused, "");
    EXPECT_EQ(words(proven.unasked), "");
    EXPECT_EQ(proven.files.size(), 1U);
    return proven.files.empty() ? std::string() : proven.files.front().text;
  }

  static std::string words(const std::vector<robot::Difference>& differences) {
    std::string text;
    for (const robot::Difference& d : differences) {
      text += std::string(robot::to_string(d.kind)) + ' ' + d.a + " → " + d.b + ' ' + d.what + ' ' +
              d.from.text + ' ' + d.to.text + '\n';
    }
    return text;
  }

  ModelReader& reader() { return reader_; }
  const Environment& environment() const { return *environment_; }

 private:
  const EditedModel& keep(OpenedModel opened) {
    kept_.push_back(std::move(opened.model));
    return *kept_.back();
  }

  std::unique_ptr<MemoryDisk> memory_;
  std::unique_ptr<Environment> environment_;
  Sources sources_;
  ModelReader reader_;
  std::deque<std::unique_ptr<EditedModel>> kept_;
};

/// In what two robots differ by more than rounding.
inline std::vector<robot::Difference> differences_at_rounding(const robot::Robot& a,
                                                              const robot::Robot& b) {
  constexpr double kRounding = 1e-12;
  std::vector<robot::Difference> found = robot::compare(
      a, b, {.helpers = robot::Helpers::kReported, .placement = robot::Placement::kReported},
      {.distance = kRounding, .angle = kRounding, .relative = kRounding, .configurations = 5});
  // Sums that are zero but for rounding.
  std::erase_if(found, [](const robot::Difference& d) {
    return (d.kind == robot::DifferenceKind::kTotalFirst ||
            d.kind == robot::DifferenceKind::kTotalSecond) &&
           d.distance <= kRounding;
  });
  return found;
}

}  // namespace rigor::author
