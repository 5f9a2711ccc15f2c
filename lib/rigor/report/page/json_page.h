// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a page's data. Private to the room.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/page/bytes.h>
#include <rigor/report/page/model_page.h>
#include <rigor/report/places.h>

namespace rigor::report {

/// The files that something on the page stands in, each once.
class PageFiles {
 public:
  explicit PageFiles(const Sources& sources) : places_(sources) {}

  void add(SourceId source);

  /// Adds `line` and `file` (-1 for what stands nowhere).
  void place(Json& json, Span where);
  int index_of(const Diagnostic& diagnostic);
  Places& places() { return places_; }

  Json json() const { return files_; }

 private:
  int index_of(std::string_view path, std::string_view text);

  Places places_;
  Json files_ = Json::array();
  std::map<std::string, int, std::less<>> known_;
  std::size_t text_ = 0;
};

/// [x, y, z, qw, qx, qy, qz]
inline Json pose_array(const model::Pose& X) {
  const model::Quaternion q = positive_w(X.rotation);
  return Json::array({finite(X.translation.x), finite(X.translation.y), finite(X.translation.z),
                      finite(q.w), finite(q.x), finite(q.y), finite(q.z)});
}
inline Json pose_array(const std::optional<model::Pose>& X) {
  return X ? pose_array(*X) : Json(nullptr);
}

template <class T>
int index_or_none(model::Id<T> id) {
  return id ? static_cast<int>(id.value) : -1;
}

// Adds to the data of a page: models, links and joints;
void add_entities(Json& data, const ModelPage& page, PageFiles& files);
/// bodies, meshes, textures, pictures and what is not drawn; meshes go into `bytes`;
void add_scene(Json& data, const ModelPage& page, PageFiles& files, PageBytes& bytes);
/// findings.
void add_findings(Json& data, const ModelPage& page, PageFiles& files);

}  // namespace rigor::report
