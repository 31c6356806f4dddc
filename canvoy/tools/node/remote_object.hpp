// An object of a node to be requested, and its value as text and JSON, for `read`, `write`,
// `expect` and others.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/text/json_line.hpp"
#include "canvoy/tools/session/node_profile.hpp"

namespace canvoy::tools {

/// An object of a node, and the description of its entry: from the profile and the node, or the
/// type that the user gives. Throws Failure if the node does not answer, UsageError if there is no
/// such object or type.
class RemoteObject {
 public:
  RemoteObject(Session& session, NodeId node, std::string_view text, const ProfileChoice& profile,
               std::string_view type = {});

  NodeId node() const { return node_; }
  const ObjectAddress& address() const { return address_; }
  /// Null: unknown.
  const EntryInfo* entry() const {
    if (typed_) return &*typed_;
    return known_ ? known_->get() : nullptr;
  }
  std::string name() const { return printed_name(address_); }

  std::vector<std::uint8_t> read(Session& session) const {
    return session.read(node_, address_.index, address_.sub);
  }
  /// Text of a value: `20.000 °C`. Throws Failure if the given type does not fit the bytes.
  std::string text(std::span<const std::uint8_t> bytes) const;
  /// Appends [`network`], `node`, `index`, `sub` and [`name`].
  void append_place(text::JsonLine& json) const;
  /// Appends `raw`, `value` and [`unit`].
  void append_value(text::JsonLine& json, std::string& line,
                    std::span<const std::uint8_t> bytes) const;

 private:
  void check(std::span<const std::uint8_t> bytes) const;

  std::uint16_t network_;
  NodeId node_;
  ObjectAddress address_;
  std::optional<EntryInfo> typed_;
  std::string type_name_;  ///< as given by the user
  std::optional<NodeEntry> known_;
};

}  // namespace canvoy::tools
