// Finds the object of a node that the user means when its profile must be requested first, and the
// unit that the node uses for it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "canvoy/decoder/unit_source.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

/// Number of the profile in the device type (1000h) of the node; 0 if the node does not give it, or
/// it is unknown.
unsigned profile_of_node(Session& session, NodeId node);

/// The object in the data sheet or the profile with this number; if neither is known: in that of
/// the device type (1000h) of the node. If the node refuses to give it, an index is accepted,
/// without its type; a name throws Failure. Throws UsageError if there is no such object.
ObjectAddress find_object_of(Session& session, NodeId node, std::string_view object,
                             const ProfileChoice& profile);

/// Name as printed by the profile, with its numbers: `Identity object, Vendor-ID`; `6010h:00h` if
/// unknown.
std::string printed_name(const ObjectAddress& object);

/// The description of an entry of an object, with the unit that the node gives in another entry,
/// which is requested. As in the profile if the node does not give it; null if no profile has it.
class NodeEntry {
 public:
  NodeEntry(Session& session, NodeId node, const ObjectAddress& object,
            const ProfileChoice& profile);
  const EntryInfo* get() const { return told_ == nullptr ? entry_ : &told_->entry(); }

 private:
  const EntryInfo* entry_;
  std::unique_ptr<decoder::EntryWithUnit> told_;
};

}  // namespace canvoy::tools
