// The analogue inputs of CiA 401: offset and scaling, and which changes are events (6400h to 6403h,
// 6421h to 6432h).
//
//     AnalogueInputs inputs(node, memory, {.sense = Callback<std::int32_t(unsigned)>::to<
//                                              &Board::input>(board)}, {});
//     inputs.look();    // when an input may have changed
//
// The text of CiA 401 is not at hand. Our reading: an input causes an event when it changes, and is
// at or above its upper limit or below its lower one (where one of these triggers is selected), and
// differs from the value at its last event by more than one of its deltas (where one of those is).
// A change that is no event is stored without a PDO; the next event takes it along.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

/// What is known of an input beside the dictionary.
struct AnalogueInputState {
  std::uint8_t channel = 0;  ///< its sub-index
  std::int32_t raw = 0;      ///< at the last look
  // At the last event:
  std::int32_t integer = 0;  ///< that it is read by
  float real = 0;            ///< 6403h
};

struct AnalogueInputSettings {
  /// What 6424h to 6428h count in: the object that the device has of 6401h, 6402h, 6400h, in this
  /// order; or all 32 bits of the converter, left-adjusted. It is not known which one the
  /// specification means.
  bool limits_are_left_adjusted = false;
};

/// Whether a TPDO may be sent since it begins to work (Tpdos::ask_at_start): not, while it carries
/// analogue inputs alone and these cause no events (6423h).
bool tpdo_may_begin(const Dictionary& dictionary, std::uint16_t number);

struct AnalogueReals;

class AnalogueInputs {
 public:
  /// An input, by its sub-index, as its converter has it: full scale is that of 32 bits, a narrower
  /// value is adjusted to the left.
  using Sense = Callback<std::int32_t(unsigned channel)>;

  /// All must outlive this. `states`: one for each element of 6401h, which may have gaps. `reals`:
  /// null where there is no 6403h.
  AnalogueInputs(Node& node, std::span<AnalogueInputState> states, Sense sense,
                 const AnalogueInputSettings& settings, const AnalogueReals* reals = nullptr);
  AnalogueInputs(const AnalogueInputs&) = delete;
  AnalogueInputs& operator=(const AnalogueInputs&) = delete;

  /// Takes the inputs as they are, without an event: after a reset.
  void begin();
  /// Offset or scaling of an input was written: what it was at the last look is read by them,
  /// without an event.
  void rescale(unsigned channel);
  /// An input that has not moved costs no more than to be sensed.
  void look();
  bool are_enabled() const;
  /// An element of 6422h is about to be read from the bus: it says what has come since it was read
  /// last.
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
  std::array<std::uint32_t, 8> sources_{};  ///< since they were read, 32 inputs each
};

}  // namespace canvoy::cia401
