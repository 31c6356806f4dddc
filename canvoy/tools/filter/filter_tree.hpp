// A filter as it was understood: conditions, and how they are joined.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/decoder/mark.hpp"
#include "canvoy/tools/filter/filter_ranges.hpp"
#include "canvoy/tools/filter/filter_value.hpp"
#include "canvoy/words/frame_decoder.hpp"

namespace canvoy::tools {

/// What a filter looks at.
struct FilterFrame {
  Duration time{};         ///< since 1970, or since the log began
  Duration since_first{};  ///< since the first frame
  std::string_view bus = {};
  const Frame& frame;
  const words::FrameWords& words;
};

/// CAN-IDs in one order: those of 29 bits are above those of 11 bits.
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
  std::string written = {};               ///< as the user wrote it
  std::vector<std::string> names = {};    ///< of buses; plain parts of services and of texts
  FilterRanges ranges = {};               ///< of node-IDs, CAN-IDs, and microseconds
  std::vector<decoder::Mark> marks = {};  ///< empty: any
  FilterValue value{FilterObject{}};
  bool was_true = false;  ///< of a frame, as long as none has passed the filter

  bool holds(const FilterFrame& frame);
};

using FilterBy = FilterCondition::By;

struct FilterExpression {
  enum class Kind : std::uint8_t { all, any, none, condition };
  Kind kind = Kind::all;
  std::vector<FilterExpression> parts = {};  ///< of `none` one
  std::size_t condition = 0;                 ///< its place in the filter's conditions
};

}  // namespace canvoy::tools
