// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the database without SQLite (RIGOR_WITH_SQLITE=OFF).

#include <rigor/results/reader.h>
#include <rigor/results/temporary_file.h>
#include <rigor/results/writer.h>

namespace rigor::results {
namespace {

[[noreturn]] void database_is_absent() { throw DatabaseError("rigor was built without SQLite"); }

}  // namespace

class Writer::Tables {};

Writer::Writer(const std::string&) { database_is_absent(); }
Writer::~Writer() = default;

// There is no writer to call them on.
void Writer::add(const Record&) {}
void Writer::finish() {}

class Reader::Queries {};

Reader::Reader(const std::string&) { database_is_absent(); }
Reader::~Reader() = default;

// There is no reader to call them on.
Totals Reader::totals() const { return {}; }
std::vector<RuleTotal> Reader::rules() const { return {}; }
void Reader::each_model(const std::function<void(const ModelRow&)>&) const {}
ModelDetails Reader::details(std::int64_t, const DetailLimits&) const { return {}; }
void Reader::models_of(const RuleTotal&, std::size_t,
                       const std::function<void(const ModelRow&, std::uint64_t)>&) const {}

std::string sqlite_version() { return {}; }

}  // namespace rigor::results
