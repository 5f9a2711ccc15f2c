// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a plugin says of the robot, as the result has to say it: links and joints by their new names, a
// link that became part of another by that one's name, and places and directions in the frame that
// the result has. Private to the room.
//
//   const PluginText text = plugin_text(plugin, {.links = renamed, .moved = moved}, {.link = "wing"});
//   block.xml += laid_out(document, plugin, text.layout);
//   for (const PluginRemark& remark : text.remarks) …

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/xml_layout.h>
#include <rigor/model/pose.h>
#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

struct PluginNames {
  std::string model;  ///< of the source: what comes before `::` in "arm::wing" for the link `wing`
  /// Names of the source → those of the result, where they differ.
  std::map<std::string, std::string, std::less<>> links, joints;
  /// Joints of the source that are none in the result, such as one that fixed a link which became a frame.
  std::set<std::string, std::less<>> lost_joints = {};
  /// A link's frame that is elsewhere in the result, or that another link holds.
  struct Moved {
    std::string link;  ///< of the result, in whose frame the plugin speaks then
    model::Pose X_NL;  ///< the frame of the source in the frame of that link
  };
  std::map<std::string, Moved, std::less<>> moved;
};

struct PluginRemark {
  enum class Kind : std::uint8_t {
    kRenamed,      ///< a reference names what the result has
    kRewritten,    ///< a place or direction is expressed in the frame that the result has
    kLeftInFrame,  ///< numbers that may be meant in the old frame stand as they were
    kNoJoint       ///< `written` are names of joints that the result lacks; they stand as they were
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

/// Where a plugin is, by the source's names inside the model that is converted.
struct PluginPlace {
  std::string_view link;   ///< empty for a plugin of a model
  std::string_view model;  ///< of a nested one, in which the plugin's names are: "arm::hand"
};

/// A link is named by a parameter for links or in any other way: as text or attribute, plain or with
/// its model's name before it. A joint is named by a parameter whose name holds "joint", or by text with a
/// model's name before it; such a parameter may name several, with spaces or commas between.
///
/// Rewritten in a frame that moved are what consumers are known to read in the link's frame: `cp`,
/// `forward` and `upward` of LiftDrag, `center_of_volume` of Buoyancy, `xyzOffset` and `rpyOffset`
/// beside a `bodyName`, as libsdformat does for links that it lumps. Other leaves and attributes of
/// three or more numbers are left, with a remark, unless a link whose frame stays is named beside them.
PluginText plugin_text(xml::Element plugin, const PluginNames& names, const PluginPlace& place);

/// `name` attributes outside plugins that hold `::`, which libsdformat takes for a scope and refuses.
LayoutChanges without_scopes(xml::Element element);

/// With `::` as `__`.
std::string without_scope(std::string_view name);

}  // namespace rigor::convert
