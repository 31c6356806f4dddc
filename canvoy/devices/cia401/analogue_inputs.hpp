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
#include "canvoy/profiles/cia401_handles.hpp"

namespace canvoy::cia401 {

/// What was told of an input last: of the integer that it is read by, and of 6403h.
struct AnalogueInputState {
  std::int64_t integer = 0;
  double real = 0;
};

struct AnalogueInputSettings {
  /// What 6424h to 6428h count in: the object that the device has of 6401h, 6402h, 6400h, in this
  /// order; or all 32 bits of the converter, left-adjusted. It is not known which one the
  /// specification means.
  bool limits_are_left_adjusted = false;
};

class AnalogueInputs {
 public:
  /// An input from 1 on, as its converter has it: full scale is that of 32 bits, a narrower value
  /// is adjusted to the left.
  using Sense = Callback<std::int32_t(unsigned channel)>;

  /// All must outlive this. `states`: one for each input.
  AnalogueInputs(Node& node, std::span<AnalogueInputState> states, Sense sense,
                 const AnalogueInputSettings& settings)
      : node_(node), states_(states), sense_(sense), settings_(settings) {}
  AnalogueInputs(const AnalogueInputs&) = delete;
  AnalogueInputs& operator=(const AnalogueInputs&) = delete;

  /// Takes the inputs as they are, without an event: after a reset, and when a parameter was
  /// written.
  void begin();
  void look();
  bool are_enabled() const;
  /// An element of 6422h is about to be read from the bus: it says what has come since it was read
  /// last.
  void source_is_read(const Entry& entry);

 private:
  /// A value, and what decides whether its change is an event.
  template <class Number>
  struct Change {
    Number before = 0;  ///< in the object
    Number now = 0;
    Number told = 0;  ///< at the last event
  };
  struct Limits {
    std::uint16_t upper =
        0;  ///< the object; lower limit, delta, negative and positive delta follow
  };

  template <class Number>
  bool is_event(unsigned channel, const Change<Number>& change, Number factor, Limits limits) const;
  template <class Number>
  Number limit(std::uint16_t index, unsigned channel, bool is_signed) const;
  void read(unsigned channel, bool may_tell);
  bool read_integers(unsigned channel, std::int32_t raw, bool may_tell);
  bool read_real(unsigned channel, std::int32_t raw, bool may_tell);
  void add_source(unsigned channel);

  Node& node_;
  std::span<AnalogueInputState> states_;
  Sense sense_;
  AnalogueInputSettings settings_;
  std::array<std::uint32_t, 8> sources_{};  ///< since they were read, 32 inputs each
};

}  // namespace canvoy::cia401
