// Permission of viewers of the page to write and to command: `--allow-write`.
//
//     WritePermission permission = parse_write_permission("nmt,10:6010,1017,6000-67FF");
//     if (!permission.allows(10, 0x6010)) return refuse();
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::tools {

class WritePermission {
 public:
  /// True if an object of a node may be written.
  bool allows(NodeId node, std::uint16_t index) const;
  bool allows_nmt() const { return nmt_; }
  bool is_empty() const { return !nmt_ && ranges_.empty(); }
  /// The text as given; empty: nothing is allowed.
  const std::string& text() const { return text_; }

 private:
  friend WritePermission parse_write_permission(std::string_view text);

  struct Range {
    NodeId node = 0;  ///< 0: all nodes
    std::uint16_t first = 0;
    std::uint16_t last = 0;
  };

  std::vector<Range> ranges_;
  bool nmt_ = false;
  std::string text_;
};

/// Reads `all`, or a list, separated by commas, of `nmt`, indices (`1017`), ranges of them
/// (`6000-67FF`), and each of these for one node (`10:6010`); indices are hexadecimal. Empty:
/// nothing. Throws UsageError.
WritePermission parse_write_permission(std::string_view text);

}  // namespace canvoy::tools
