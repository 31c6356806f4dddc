// The analogue inputs of CiA 401: offset and scaling, and which changes are events (6400h to 6403h,
// 6421h to 6432h).
//
//     AnalogueInputs inputs(node, memory, {.sense = Callback<std::int32_t(unsigned)>::to<
//                                              &Board::input>(board)}, {});
//     inputs.look();    // when an input may have changed
//
// The text of CiA 401 is not at hand. Our reading: an input causes an event when it changes, and is
// at or above its upper limit or below its lower one (where one of these triggers is selected), and
// differs from the value at its last event by more than one of its deltas (where one of those is
// selected). A change that is no event is stored without a PDO; the next event sends it, too.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

/// State of an input beside the dictionary.
struct AnalogueInputState {
  std::uint8_t channel = 0;  ///< its sub-index
  std::int32_t raw = 0;      ///< at the last check
  // At the last event:
  std::int32_t integer = 0;  ///< from which it is read
  float real = 0;            ///< 6403h
};

/// What the known text of CiA 401 leaves open.
struct AnalogueInputSettings {
  /// Unit of 6424h to 6428h: that of the first existing object of 6401h, 6402h, 6400h, in this
  /// order; or all 32 bits of the converter, left-adjusted. It is not known which one the
  /// specification means.
  bool limits_are_left_adjusted = false;
};

/// True if a TPDO may be sent when it starts to work (Tpdos::ask_at_start): not if it carries only
/// analogue inputs and these cause no events (6423h).
bool tpdo_may_begin(const Dictionary& dictionary, std::uint16_t number);

struct AnalogueReals;

class AnalogueInputs {
 public:
  /// Returns an input, by its sub-index, in the scale of its converter: full scale is that of 32
  /// bits, a narrower value is left-adjusted.
  using Sense = Callback<std::int32_t(unsigned channel)>;

  /// All arguments must outlive this. `states`: one for each element of 6401h, which may have gaps.
  /// `reals`: null without 6403h.
  AnalogueInputs(Node& node, std::span<AnalogueInputState> states, Sense sense,
                 const AnalogueInputSettings& settings, const AnalogueReals* reals = nullptr);
  AnalogueInputs(const AnalogueInputs&) = delete;
  AnalogueInputs& operator=(const AnalogueInputs&) = delete;

  /// Reads the inputs without an event: after a reset.
  void begin();
  /// Applies a written offset or scaling to the last value of an input, without an event.
  void rescale(unsigned channel);
  /// Checks the inputs. An input that has not changed costs only its sensing.
  void look();
  /// True if 6423h allows events of analogue inputs, or does not exist.
  bool are_enabled() const;
  /// Updates an element of 6422h before it is read from the bus: it shows the events since it was
  /// last read.
  void source_is_read(const Entry& entry);

 private:
  friend struct AnalogueReals;

  void read(AnalogueInputState& state, bool may_tell);
  bool read_integers(AnalogueInputState& state, bool may_tell);
  bool is_event_of_width(const AnalogueInputState& state, const Width& width, std::int64_t before,
                         std::int64_t now) const;
  void add_source(unsigned channel);

  Node& node_;
  std::span<AnalogueInputState> states_;
  Sense sense_;
  AnalogueInputSettings settings_;
  const AnalogueReals* reals_;
  std::array<std::uint32_t, 8> sources_{};  ///< since the last read, 32 inputs each
};

}  // namespace canvoy::cia401
