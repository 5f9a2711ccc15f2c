// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/ledger.h>

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include <rigor/read/values.h>
#include <rigor/read/workspace.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

namespace rigor::convert {
namespace {

/// A file with an account of it.
struct Books {
  explicit Books(const std::string& text) { file = &workspace.put("a.sdf", text); }

  /// The only element of that name.
  xml::Element at(const std::string& name) const {
    const xml::Document& document = *file->document;
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      if (document.element(i).name() == name) return document.element(i);
    }
    throw std::out_of_range(name);
  }
  Ledger& ledger() {
    if (!documents) {
      documents.emplace(workspace);
      open_ledger.emplace(*documents);
    }
    return *open_ledger;
  }
  Account close(const std::string& implied = {}) {
    return std::move(ledger()).close(
        [&](const model::Site&, xml::Element element) { return element.name() == implied; },
        [&](xml::Element, xml::Attribute attribute) { return attribute.name() == implied; },
        [](xml::Element element) {
          return element.name() == "sensor" ? NoteKind::kSensor : NoteKind::kUnknown;
        });
  }

  MemoryDisk disk;
  Sources sources;
  read::Workspace workspace{disk, sources};
  const read::File* file = nullptr;
  std::optional<read::Documents> documents;
  std::optional<Ledger> open_ledger;
};

std::size_t count_of(const Account& account, Outcome outcome) {
  return account.counts[static_cast<std::size_t>(outcome)];
}

std::size_t sum_of(const Account& account) {
  return std::accumulate(account.counts.begin(), account.counts.end(), std::size_t{0});
}

TEST(Ledger, TellsWhatNobodyTookOncePerSubtree) {
  Books books(
      "<model name='arm'><link name='palm'><sensor name='eye' type='camera'><rate>5</rate>"
      "</sensor></link></model>");
  books.ledger().open(read::site_of(books.at("model")), "arm");
  books.ledger().take(books.at("model"));
  books.ledger().take_value(books.at("model").attribute("name")->value_span());
  books.ledger().take(books.at("link"));
  books.ledger().take_value(books.at("link").attribute("name")->value_span());
  const Account account = books.close();

  ASSERT_EQ(account.notes.size(), 1U);
  const Note& note = account.notes[0];
  EXPECT_EQ(note.kind, NoteKind::kSensor);
  EXPECT_EQ(note.outcome, Outcome::kLost);
  EXPECT_EQ(note.count, 4U);  // sensor, its name and type, rate
  EXPECT_EQ(note.written, "link/sensor");
  EXPECT_EQ(note.subject, "arm/link palm/sensor eye");
  EXPECT_EQ(books.sources.bytes(note.where), "sensor");
  EXPECT_EQ(count_of(account, Outcome::kConverted), 4U);
  EXPECT_EQ(count_of(account, Outcome::kLost), 4U);
}

TEST(Ledger, TellsAnAttributeByItself) {
  Books books("<model name='arm'><link name='palm' color='red'/></model>");
  books.ledger().open(read::site_of(books.at("model")), "arm");
  books.ledger().take(books.at("model"));
  books.ledger().take(books.at("link"));
  const Account account = books.close("name");
  ASSERT_EQ(account.notes.size(), 1U);
  EXPECT_EQ(account.notes[0].written, "link/@color");
  EXPECT_EQ(books.sources.bytes(account.notes[0].where), "color='red'");
  EXPECT_EQ(count_of(account, Outcome::kImplied), 2U);
}

TEST(Ledger, TakesTheNodeWhoseValueStandsThere) {
  Books books("<a x='1' y=''><b></b><c z='2'>text</c><d/><e/></a>");
  Ledger& ledger = books.ledger();
  ledger.open(read::site_of(books.at("a")));
  const auto value_of = [&](const char* element, const char* attribute) {
    return books.at(element).attribute(attribute)->value_span();
  };
  ledger.take_value(value_of("a", "y"), Outcome::kCarried);
  ledger.take_value(books.at("b").text_span(), Outcome::kRewritten);
  ledger.take_value(books.at("c").text_span(), Outcome::kConverted);
  ledger.take_value(books.at("d").text_span(), Outcome::kSubstituted);  // where <e/> begins
  ledger.take_value({});                                                // a default: nowhere
  const Account account = books.close();
  EXPECT_EQ(count_of(account, Outcome::kCarried), 1U);
  EXPECT_EQ(count_of(account, Outcome::kRewritten), 1U);
  EXPECT_EQ(count_of(account, Outcome::kSubstituted), 1U);
  std::string lost;
  for (const Note& note : account.notes) lost += note.written + ' ';
  EXPECT_EQ(lost, "a/@x c/@z e ");
}

TEST(Ledger, AnElementThatOnlyHoldsWhatWasTakenGoesAlong) {
  Books books("<a><limit><lower>1</lower><odd>2</odd></limit><dynamics><odd2/></dynamics></a>");
  books.ledger().open(read::site_of(books.at("a")));
  books.ledger().take(books.at("lower"), Outcome::kRewritten);
  const Account account = books.close("odd2");
  ASSERT_EQ(account.notes.size(), 1U);
  EXPECT_EQ(account.notes[0].written, "limit/odd");
  EXPECT_EQ(count_of(account, Outcome::kRewritten), 3U);  // lower, and so limit and a
  EXPECT_EQ(count_of(account, Outcome::kImplied), 2U);    // odd2, and so dynamics
}

TEST(Ledger, AnElementWithWordsOfItsOwnDoesNot) {
  Books books("<a><limit>tight<lower>1</lower></limit></a>");
  books.ledger().open(read::site_of(books.at("a")));
  books.ledger().take(books.at("lower"));
  const Account account = books.close();
  ASSERT_EQ(account.notes.size(), 1U);
  EXPECT_EQ(account.notes[0].written, "limit");
  EXPECT_EQ(account.notes[0].count, 1U);
}

TEST(Ledger, WhatIsTakenTwiceHasTheWorseOutcome) {
  Books books("<a><b/><c><d/></c></a>");
  Ledger& ledger = books.ledger();
  ledger.open(read::site_of(books.at("a")));
  ledger.take(books.at("a"));
  ledger.take(books.at("b"), Outcome::kLost);
  ledger.take(books.at("b"), Outcome::kConverted);
  ledger.take(books.at("d"), Outcome::kConverted);
  EXPECT_EQ(ledger.take_all(books.at("c"), Outcome::kCarried), 1U);  // not d, which was taken
  const Account account = books.close();
  EXPECT_TRUE(account.notes.empty());
  EXPECT_EQ(count_of(account, Outcome::kLost), 1U);
  EXPECT_EQ(count_of(account, Outcome::kCarried), 1U);
  EXPECT_EQ(count_of(account, Outcome::kConverted), 2U);
}

TEST(Ledger, LosesAWholeElementWithOneNote) {
  Books books("<a><b x='1'><c/></b></a>");
  books.ledger().open(read::site_of(books.at("a")));
  books.ledger().take(books.at("a"));
  books.ledger().lose(read::site_of(books.at("b")), {.kind = NoteKind::kLoop});
  const Account account = books.close();
  ASSERT_EQ(account.notes.size(), 1U);
  EXPECT_EQ(account.notes[0].count, 3U);
  EXPECT_EQ(books.sources.bytes(account.notes[0].where), "b");
}

TEST(Ledger, CountsNestedOpeningsOnceAndNothingOutside) {
  Books books("<z><a><b><c/></b></a><d/></z>");
  books.ledger().open(read::site_of(books.at("b")));
  books.ledger().open(read::site_of(books.at("a")));
  books.ledger().open(read::site_of(books.at("b")));
  const Account account = books.close();
  EXPECT_EQ(sum_of(account), 3U);
  ASSERT_EQ(account.notes.size(), 1U);
  EXPECT_EQ(account.notes[0].written, "a");
}

TEST(Ledger, OrdersNotesByFilesAndBytes) {
  Books books("<a><b/><c/></a>");
  const read::File& other = books.workspace.put("0.sdf", "<x><y/></x>");
  Ledger& ledger = books.ledger();
  ledger.open(read::site_of(books.at("a")));
  ledger.open(read::site_of(*other.document->root()));
  ledger.take(books.at("a"));
  ledger.note({.kind = NoteKind::kWorld});  // stands nowhere
  ledger.note({.kind = NoteKind::kLoop, .where = books.at("c").name_span()});
  ledger.take(books.at("c"));
  const Account account = books.close();
  std::string order;
  for (const Note& note : account.notes)
    order += std::string(books.sources.bytes(note.where)) + '.';
  EXPECT_EQ(order, "b.c.x..");
}

TEST(Ledger, WalksAnyDepthAndManyAttributes) {
  constexpr std::size_t kMany = 200;
  std::string wide = "<a";
  for (std::size_t i = 0; i < kMany; ++i) wide += " x" + std::to_string(i) + "='1'";
  Books flat(wide + "/>");
  flat.ledger().open(read::site_of(flat.at("a")));
  EXPECT_EQ(sum_of(flat.close()), kMany + 1);

  constexpr std::size_t kDeep = 90;  // the scanner's own bound is not far
  std::string deep;
  for (std::size_t i = 0; i < kDeep; ++i) deep += "<b>";
  Books tall("<a>" + deep);
  tall.ledger().open(read::site_of(tall.at("a")));
  const Account account = tall.close();
  EXPECT_EQ(sum_of(account), kDeep + 1);
  EXPECT_EQ(account.notes.size(), 1U);
}

}  // namespace
}  // namespace rigor::convert
