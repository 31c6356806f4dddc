// Which object of which node a user means, when its profile has to be asked for first; and which
// unit the node has for it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "canvoy/decoder/told_unit.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/bus/session.hpp"

namespace canvoy::tools {

/// The number of the profile that the node's device type (1000h) names; 0 where the node does not
/// say, or nobody here knows it.
unsigned profile_of_node(Session& session, NodeId node);

/// The object in the profile with this number; where that is 0, in the one that the node's device
/// type (1000h) names. Where the node refuses to tell it, an index will do, without its type; a
/// name is refused with a Failure. Throws UsageError where there is no such object.
ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             unsigned profile);

/// As the profile prints it, with its numbers: `Identity object, Vendor-ID`; `6010h:00h` where
/// nobody knows it.
std::string printed_name(const ObjectAddress& object);

/// The description of an object's entry, with the unit that the node says where another entry tells
/// it: asks the node for that one. As the profile has it where the node does not tell; null where
/// no profile knows it.
class NodeEntry {
 public:
  NodeEntry(Session& session, NodeId node, const ObjectAddress& object);
  const EntryInfo* get() const { return told_ == nullptr ? entry_ : &told_->entry(); }

 private:
  const EntryInfo* entry_;
  std::unique_ptr<decoder::ToldEntry> told_;
};

}  // namespace canvoy::tools
