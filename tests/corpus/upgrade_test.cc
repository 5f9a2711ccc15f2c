// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `upgrade` over every SDF file of the corpus, to every version from 1.4 on: what inspect prints of the
// result is what it prints of the file, a second upgrade changes nothing, and by two steps one comes to the
// same model as by one.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/author/upgrade/downgrade.h>
#include <rigor/author/upgrade/upgrade.h>
#include <rigor/read/load.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/rules/environment.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor {
namespace {

/// A file that holds `bytes`, or those on the disk.
struct UpgradeLooked {
  UpgradeLooked(const Environment& environment, const std::string& path, const std::string* bytes)
      : workspace(environment.disk, sources) {
    const read::File& file = bytes == nullptr ? workspace.open(path) : workspace.put(path, *bytes);
    loaded = load({workspace, environment.resolver, environment.sdf, environment.urdf}, file);
  }

  std::string rows() const {
    const model::Frames frames(loaded.root);
    return report::inspect_tsv({"", loaded.root, frames});
  }

  Sources sources;
  read::Workspace workspace;
  read::Loaded loaded;
};

/// Words are the same, and numbers to 1e-12 of themselves or of 1.
bool same_rows(const std::string& a, const std::string& b) {
  if (a == b) return true;
  std::istringstream words_a(a), words_b(b);
  std::string p, q;
  while (words_a >> p) {
    if (!(words_b >> q)) return false;
    char* end_p = nullptr;
    char* end_q = nullptr;
    const double x = std::strtod(p.c_str(), &end_p);
    const double y = std::strtod(q.c_str(), &end_q);
    const bool numbers = *end_p == '\0' && *end_q == '\0';
    if (p != q && !(numbers && std::abs(x - y) <= 1e-12 * std::max(1.0, std::abs(x)))) return false;
  }
  return !(words_b >> q);
}

int minor_of(const read::Loaded& loaded) {
  const auto version = schema::parse_version(loaded.root.version_text.value);
  return version ? version->minor : -1;
}

bool is_whole_sdf(const read::Loaded& loaded) {
  return loaded.file->document && loaded.file->document->complete() &&
         loaded.root.format == model::Format::kSdf && minor_of(loaded) >= 0;
}

TEST(CorpusUpgrade, TheModelStaysTheSame) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  // Where the models of the corpus include each other from.
  const std::string top = test::corpus() + "/";
  read::SearchPaths search;
  search.given.push_back({top + "gazebo_models", "the corpus"});
  const Environment environment(disk, search);
  std::map<int, int> upgraded;  // by the version they had
  for (const std::string& path : test::corpus_part()) {
    if (path.ends_with(".urdf") || path.ends_with(".config")) continue;
    SCOPED_TRACE(path);
    const UpgradeLooked before(environment, path, nullptr);
    if (!is_whole_sdf(before.loaded) || minor_of(before.loaded) >= 9) continue;
    const author::Upgrade result = author::upgrade(environment, before.loaded, schema::Version{9});
    for (const author::UpgradeNote& note : result.notes) {
      EXPECT_NE(note.severity, Severity::kError) << note.message;
    }
    if (result.refused()) continue;
    const UpgradeLooked after(environment, path, &result.text);
    EXPECT_EQ(minor_of(after.loaded), 9);
    EXPECT_TRUE(same_rows(before.rows(), after.rows()));
    const author::Upgrade again = author::upgrade(environment, after.loaded, schema::Version{9});
    EXPECT_TRUE(again.edits.empty());
    EXPECT_EQ(again.text, result.text);
    ++upgraded[minor_of(before.loaded)];
  }
  int all = 0;
  for (const auto& [version, count] : upgraded) {
    std::printf("%d of 1.%d  ", count, version);
    all += count;
  }
  std::printf("upgraded to 1.9: %d files\n", all);
  EXPECT_GT(all, static_cast<int>(test::part_of(1200)));
}

TEST(CorpusUpgrade, TwoStepsComeToTheSameAsOne) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int compared = 0;
  std::size_t turn = 0;
  for (const std::string& path : test::corpus_part()) {
    if (path.ends_with(".urdf") || path.ends_with(".config")) continue;
    const UpgradeLooked before(environment, path, nullptr);
    if (!is_whole_sdf(before.loaded) || minor_of(before.loaded) > 7) continue;
    const int between = 4 + static_cast<int>(turn++ % 8);  // 1.4 to 1.11
    if (minor_of(before.loaded) >= between) continue;
    SCOPED_TRACE(path + " by way of 1." + std::to_string(between));
    const author::Upgrade half =
        author::upgrade(environment, before.loaded, schema::Version{between});
    ASSERT_FALSE(half.refused());
    const UpgradeLooked middle(environment, path, &half.text);
    EXPECT_TRUE(same_rows(before.rows(), middle.rows()));
    const author::Upgrade rest = author::upgrade(environment, middle.loaded, schema::Version{12});
    const author::Upgrade whole = author::upgrade(environment, before.loaded, schema::Version{12});
    EXPECT_EQ(rest.text, whole.text);
    ++compared;
  }
  std::printf("%d files upgraded in two steps\n", compared);
  EXPECT_GT(compared, static_cast<int>(test::part_of(600)));
}

/// To 1.9 and back to what the file was: the same model by another text.
TEST(CorpusDowngrade, BackToTheOldVersionIsTheSameModel) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  std::map<std::string, int> refused;
  int back = 0, same_bytes = 0;
  for (const std::string& path : test::corpus_part()) {
    if (path.ends_with(".urdf") || path.ends_with(".config")) continue;
    const UpgradeLooked before(environment, path, nullptr);
    const int version = is_whole_sdf(before.loaded) ? minor_of(before.loaded) : 0;
    if (version < author::kOldestDowngrade || version >= 9) continue;
    SCOPED_TRACE(path);
    const author::Upgrade up = author::upgrade(environment, before.loaded, schema::Version{9});
    if (up.refused()) continue;
    const UpgradeLooked newer(environment, path, &up.text);
    const author::Upgrade down = author::downgrade(
        environment, newer.loaded, schema::Version{version}, author::VersionLosses::kAllowed);
    if (down.refused()) {
      for (const author::UpgradeNote& note : down.notes) {
        if (note.severity != Severity::kError) continue;
        ++refused[std::string(to_string(note.kind)) + ' ' + note.message.substr(0, 60)];
        break;
      }
      continue;
    }
    const UpgradeLooked after(environment, path, &down.text);
    EXPECT_EQ(minor_of(after.loaded), version);
    EXPECT_TRUE(same_rows(before.rows(), after.rows()));
    ++back;
    if (down.text == before.loaded.file->document->bytes()) ++same_bytes;
  }
  std::printf("%d files brought to 1.9 and back, %d with the same bytes\n", back, same_bytes);
  for (const auto& [why, count] : refused) std::printf("  refused %d: %s\n", count, why.c_str());
  EXPECT_GT(back, static_cast<int>(test::part_of(600)));
}

}  // namespace
}  // namespace rigor
