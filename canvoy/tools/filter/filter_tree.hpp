// A parsed filter: conditions, and their combination.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/decoder/mark.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/argument/filter_ranges.hpp"
#include "canvoy/tools/filter/filter_value.hpp"

namespace canvoy::tools {

/// A frame as input of a filter.
struct FilterFrame {
  Duration time{};         ///< since 1970, or since the start of the log
  Duration since_first{};  ///< since the first frame
  std::string_view bus = {};
  const Frame& frame;
  const text::FrameWords& words;
};

/// Offset of CAN-IDs in one order: those of 29 bits are above those of 11 bits.
inline constexpr std::int64_t filter_extended_id = std::int64_t{1} << 29;

struct FilterCondition {
  enum class By : std::uint8_t {
    bus,
    node,
    can_id,
    service,
    value,
    text,
    marks,
    time,
    since_first
  };
  By by = By::bus;
  std::string written = {};             ///< as written by the user
  std::vector<std::string> names = {};  ///< of buses; parts of services and of texts in plain form
  FilterRanges ranges = {};             ///< node-IDs, CAN-IDs, and microseconds
  std::vector<decoder::Mark> marks = {};  ///< empty: any
  FilterValue value{FilterObject{}};
  bool was_true = false;  ///< true for a frame, while none has passed the filter

  bool holds(const FilterFrame& frame);
};

using FilterBy = FilterCondition::By;

struct FilterExpression {
  enum class Kind : std::uint8_t { all, any, none, condition };
  Kind kind = Kind::all;
  std::vector<FilterExpression> parts = {};  ///< of a `none`: one part
  std::size_t condition = 0;                 ///< index of the condition in the filter
};

}  // namespace canvoy::tools
