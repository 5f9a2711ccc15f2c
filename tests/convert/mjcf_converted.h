// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model in memory converted to MJCF, and the elements of the result, for tests.
//
//   MjcfConverted arm("<link name='base'/>…");
//   EXPECT_EQ(arm.attribute("joint", "elbow", "range"), "-1 1");

#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/drawing/looks.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::test {

class MjcfConverted {
 public:
  /// What stands in the one model of an SDF file, or a whole file.
  explicit MjcfConverted(const std::string& text, convert::MjcfOptions how = {},
                         author::Losses losses = author::Losses::kRefused,
                         std::map<std::string, std::string> files = {})
      : disk_(with_file(std::move(files), path_of(text), whole(text))),
        environment_(disk_, {}),
        workspace_(environment_.resolver, sources_),
        loaded_(read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                           workspace_.open(path_of(text)))),
        reads_(disk_, environment_.workers),
        result(author::to_mjcf(environment_, sources_, workspace_, loaded_, looking(how),
                               {.losses = losses, .out = "out/robot.xml"})) {
    if (result.text) document_ = xml::parse(*result.text, {});
  }

  /// The elements of that name, in the order of the file.
  std::vector<xml::Element> all(std::string_view name) const {
    std::vector<xml::Element> found;
    for (std::uint32_t i = 0; i < document_.element_count(); ++i) {
      if (document_.element(i).name() == name) found.push_back(document_.element(i));
    }
    return found;
  }
  xml::Element named(std::string_view element, std::string_view name) const {
    for (const xml::Element each : all(element)) {
      if (each.attribute("name") && each.attribute("name")->value() == name) return each;
    }
    throw std::out_of_range("no " + std::string(element) + " " + std::string(name));
  }
  static std::string attribute(xml::Element element, std::string_view attribute) {
    const auto found = element.attribute(attribute);
    return found ? std::string(found->value()) : "(none)";
  }
  std::string attribute(std::string_view element, std::string_view name,
                        std::string_view attribute) const {
    return MjcfConverted::attribute(named(element, name), attribute);
  }
  std::vector<double> numbers(xml::Element element, std::string_view attribute) const {
    return write::numbers_in(MjcfConverted::attribute(element, attribute)).value();
  }

  std::vector<convert::Note> notes(convert::NoteKind kind) const {
    std::vector<convert::Note> found;
    for (const convert::Note& note : result.account.notes) {
      if (note.kind == kind) found.push_back(note);
    }
    return found;
  }
  std::vector<std::string> errors() const {
    std::vector<std::string> found;
    for (const Diagnostic& each : result.diagnostics.list()) {
      if (each.severity == Severity::kError) {
        found.push_back(std::string(each.rule) + ": " + each.message);
      }
    }
    return found;
  }

 private:
  static std::map<std::string, std::string> with_file(std::map<std::string, std::string> files,
                                                      const std::string& path, std::string bytes) {
    files[path] = std::move(bytes);
    return files;
  }
  convert::MjcfOptions looking(convert::MjcfOptions how) {
    how.looks = view::looks_of(loaded_.root, sources_,
                               view::files_of(environment_.resolver, sources_, reads_));
    return how;
  }
  static bool is_urdf(const std::string& text) { return text.find("<robot") != std::string::npos; }
  static std::string path_of(const std::string& text) {
    return is_urdf(text) ? "robot.urdf" : "model.sdf";
  }
  static std::string whole(const std::string& text) {
    if (is_urdf(text) || text.starts_with("<sdf")) return text;
    return "<sdf version='1.9'><model name='m'>" + text + "</model></sdf>";
  }

  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
  mass::MeshReads reads_;
  xml::Document document_;

 public:
  author::Conversion result;
};

inline std::string mjcf_link(const std::string& name, const std::string& inside = {}) {
  return "<link name='" + name +
         "'><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>"
         "</inertial>" +
         inside + "</link>";
}

}  // namespace rigor::test
