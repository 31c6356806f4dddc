// An object of a node that is asked for, and its value in words and in JSON, as `read`, `write`,
// `expect` and others tell it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/bus/node_profile.hpp"
#include "canvoy/words/json_line.hpp"

namespace canvoy::tools {

/// An object of a node, and what is known of its entry: by the profile and the node, or by the type
/// that the user says. Throws Failure where a node does not answer, UsageError where there is no
/// such object or type.
class AskedObject {
 public:
  AskedObject(Session& session, NodeId node, std::string_view text, unsigned profile,
              std::string_view type = {});

  NodeId node() const { return node_; }
  const ObjectAddress& address() const { return address_; }
  /// Null: nobody knows it.
  const EntryInfo* entry() const {
    if (typed_) return &*typed_;
    return known_ ? known_->get() : nullptr;
  }
  std::string name() const { return printed_name(address_); }

  std::vector<std::uint8_t> read(Session& session) const {
    return session.read(node_, address_.index, address_.sub);
  }
  /// `20.000 °C`. Throws Failure where the type that was said does not fit the bytes.
  std::string text(std::span<const std::uint8_t> bytes) const;
  /// [`network`], `node`, `index`, `sub` and [`name`].
  void append_place(words::JsonLine& json) const;
  /// `raw`, `value` and [`unit`].
  void append_value(words::JsonLine& json, std::string& line,
                    std::span<const std::uint8_t> bytes) const;

 private:
  void check(std::span<const std::uint8_t> bytes) const;

  std::uint16_t network_;
  NodeId node_;
  ObjectAddress address_;
  std::optional<EntryInfo> typed_;
  std::string type_name_;  ///< as the user said it
  std::optional<NodeEntry> known_;
};

}  // namespace canvoy::tools
