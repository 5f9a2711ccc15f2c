// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a plugin says of the robot, as the result has to say it: links and joints by their new names, a
// link that became part of another by that one's name, and places and directions in the frame that
// the result has. Private to the room.
//
//   const PluginText text = plugin_text(plugin, {.links = renamed, .moved = moved}, "wing");
//   block.xml += laid_out(document, plugin, text.layout);
//   for (const PluginRemark& remark : text.remarks) …

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/xml_layout.h>
#include <rigor/model/pose.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

struct PluginNames {
  /// Names of the source → those of the result, where they differ.
  std::map<std::string, std::string, std::less<>> links, joints;
  /// A link's frame that is elsewhere in the result, or that another link holds.
  struct Moved {
    std::string link;  ///< of the result, in whose frame the plugin speaks then
    model::Pose X_NL;  ///< the frame of the source in the frame of that link
  };
  std::map<std::string, Moved, std::less<>> moved;
};

struct PluginRemark {
  enum class Kind : std::uint8_t {
    kRenamed,     ///< a reference names what the result has
    kRewritten,   ///< a place or direction is expressed in the frame that the result has
    kLeftInFrame  ///< numbers that may be meant in the old frame stand as they were
  };
  Kind kind = Kind::kRenamed;
  Span where;
  std::string written;  ///< "link_name wing"
  std::string instead;
};

struct PluginText {
  LayoutChanges layout;
  std::vector<PluginRemark> remarks;
};

/// `own_link`: the source's name of the link that the plugin is in; empty for one of the model.
///
/// Rewritten in a frame that moved are what consumers are known to read in the link's frame: `cp`,
/// `forward` and `upward` of LiftDrag, `xyzOffset` and `rpyOffset` beside a `bodyName`, as libsdformat
/// does for links that it lumps. Other leaves of three or more numbers are left, with a remark.
PluginText plugin_text(xml::Element plugin, const PluginNames& names, std::string_view own_link);

/// `name` attributes outside plugins that hold `::`, which libsdformat takes for a scope and refuses.
LayoutChanges without_scopes(xml::Element element);

/// With `::` as `__`.
std::string without_scope(std::string_view name);

}  // namespace rigor::convert
