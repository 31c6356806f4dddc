// What a person did to a played network from outside, with its time: a visitor who came to a lift,
// an SDO request, an NMT command. Written as text of the form of faults, so that a run can be
// repeated with it.
//
//     visit:from=2:to=7@1min
//     write:bus=sim0:node=10:object=6081/00:bytes=5A@63.5s
//     std::vector<Act> acts = parse_acts(texts);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/tools/player/sdo_requests.hpp"

namespace canvoy::tools {

/// A frame or a request for a bus.
struct BusRequest {
  enum class Kind : std::uint8_t { read, write, nmt } kind = Kind::read;
  std::string bus;
  NodeId node = 0;  ///< for NMT, 0: all nodes
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  SdoRequests::Bytes bytes{};  ///< the value to write, or the NMT command specifier (CiA 301)
};

struct Act {
  Time at{};                               ///< time of the run
  std::optional<BusRequest> request = {};  ///< none: a visitor
  unsigned from = 0;                       ///< floors of the visitor
  unsigned to = 0;
  bool is_added = false;  ///< by a viewer; not part of the command or the file
};

/// What is written after `act` on the command line, for a help text.
inline constexpr std::string_view act_forms =
    "visit:from=2:to=7@1min, read:bus=sim0:node=10:object=1018/04@1min, "
    "write:bus=sim0:node=5:object=1017:bytes=F401@1s, "
    "nmt:bus=sim0:node=0:command=start@1min";

std::string act_text(const Act& act);
/// Reads what act_text() writes. Throws UsageError.
Act parse_act(std::string_view text);
/// In the order of their times; those of one time in the given order. Throws UsageError.
std::vector<Act> parse_acts(const std::vector<std::string>& texts);

}  // namespace canvoy::tools
