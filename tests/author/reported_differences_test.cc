// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/reported_differences.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace rigor::author {
namespace {

using convert::Note;
using convert::NoteKind;
using convert::Outcome;
using robot::Difference;
using robot::DifferenceKind;

/// Spans that nest or are apart, as those of elements are.
void nest(std::mt19937& generator, std::uint32_t begin, std::uint32_t end,
          std::vector<Span>& spans) {
  if (end - begin < 2) return;
  spans.push_back({SourceId{0}, begin, end});
  const std::uint32_t middle =
      begin + 1 + static_cast<std::uint32_t>(generator() % (end - begin - 1));
  nest(generator, begin + 1, middle, spans);
  nest(generator, middle, end - 1, spans);
}

bool hold(const Span& outer, const Span& inner) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Against a look at each note.
TEST(ReportedDifferences, AreThoseInsideOrAroundALoss) {
  std::mt19937 generator(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<Span> spans;
    nest(generator, 0, 200, spans);
    convert::Notes notes;
    for (const Span& span : spans) {
      const auto chance = generator() % 8;
      if (chance > 1) continue;
      notes.push_back({.kind = NoteKind::kUnknown,
                       .outcome = chance == 0 ? Outcome::kLost : Outcome::kRewritten,
                       .where = span});
    }
    const ReportedDifferences reported(model::Root{}, notes);
    for (const Span& span : spans) {
      const bool expected = std::any_of(notes.begin(), notes.end(), [&](const Note& note) {
        return note.outcome == Outcome::kLost && (hold(note.where, span) || hold(span, note.where));
      });
      Difference difference{.kind = DifferenceKind::kMass};
      difference.span_a = span;
      EXPECT_EQ(reported.include(difference), expected) << span.begin << ' ' << span.end;
      difference.span_a.source = SourceId{1};
      EXPECT_FALSE(reported.include(difference)) << "another file";
    }
  }
}

TEST(ReportedDifferences, ALinkWithoutMassHandsItsJointsOn) {
  const ReportedDifferences reported(
      model::Root{},
      {{.kind = NoteKind::kMassless, .outcome = Outcome::kRewritten, .subject = "robot/link tip"}});
  Difference difference{.kind = DifferenceKind::kJointParent};
  difference.from.text = "tip";
  EXPECT_TRUE(reported.include(difference));
  difference.from.text = "p";
  EXPECT_FALSE(reported.include(difference));
}

}  // namespace
}  // namespace rigor::author
