// The digital inputs of CiA 401: polarity, filter, and which changes are events (6000h to 6008h,
// 6020h to 6027h, 6100h to 6108h, 6120h to 6128h).
//
//     DigitalInputs inputs(node, memory, {.sense = Callback<std::uint8_t(unsigned)>::to<
//                                             &Board::inputs>(board)}, {});
//     inputs.look(now);    // when an input may have changed; filtered ones wake up by themselves
//
// The text of CiA 401 is not at hand. Our reading: the objects of each width have their own
// polarity and masks, and an input is filtered if one of them says so. A change that is no event is
// stored without a PDO. The next event is always sent, and the change with it, whatever the PDO
// carried last. The state at a reset is no event.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia401/widths.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

/// State of 8 inputs beside the dictionary.
struct DigitalInputGroup {
  std::uint8_t number = 0;    ///< its sub-index in 6000h
  bool has_changed = false;   ///< in this check
  std::uint8_t sensed = 0;    ///< at the last check
  std::uint8_t accepted = 0;  ///< behind the filter
  /// Time from which an input differs from its accepted state, in microseconds modulo 2^32.
  std::array<std::uint32_t, 8> since{};
};

/// What no object of CiA 401 sets.
struct DigitalInputSettings {
  /// Time for which a filtered input has to be stable before it counts.
  Duration filter_time = std::chrono::milliseconds(5);
};

class DigitalInputs {
 public:
  /// Returns 8 inputs as wired: the group is the sub-index in 6000h, the first input is bit 0.
  using Sense = Callback<std::uint8_t(unsigned group)>;

  /// All arguments must outlive this. `groups`: one for each element of 6000h, which may have gaps.
  DigitalInputs(Node& node, std::span<DigitalInputGroup> groups, Sense sense,
                const DigitalInputSettings& settings);
  DigitalInputs(const DigitalInputs&) = delete;
  DigitalInputs& operator=(const DigitalInputs&) = delete;

  /// Reads the inputs without an event: after a reset.
  void begin();
  /// Reads the inputs; a change that has passed its filter, and that a mask selects, is an event.
  void look(Time now);
  /// Applies written parameters at once, without an event.
  void show();

 private:
  enum class Telling : std::uint8_t { events, nothing };

  void expired(Time now) { look(now); }
  bool filter(DigitalInputGroup& inputs, Time now);
  std::uint8_t filtered(unsigned group) const;
  void tell_all(Telling telling);
  void tell(unsigned group, bool may_tell);
  void tell_element(const Width& width, unsigned sub, bool may_tell);
  void tell_bits(unsigned group, std::uint32_t value, std::uint32_t events);
  const DigitalInputGroup* find_group(unsigned number) const;
  std::uint32_t accepted(unsigned sub, unsigned bytes) const;

  Node& node_;
  std::span<DigitalInputGroup> groups_;
  Sense sense_;
  DigitalInputSettings settings_;
  Timer timer_;
};

}  // namespace canvoy::cia401
