// The two indicators of a device, run (green) and error (red), as data (CiA 303-3).
//
//     Indicators indicators(node, &emergency_producer, &sync);
//     lss_hooks.state_entered =
//         Callback<void(LssState)>::to<&Indicators::lss_state_entered>(indicators);
//     board.green(is_lit(indicators.run(), Indicator::run, now));
//     board.red(is_lit(indicators.error(), Indicator::error, now));
#pragma once

#include <cstdint>

#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sync/sync.hpp"

namespace canvoy {

/// The two lights of a device: run is green, error is red. One bicolour LED can show both.
enum class Indicator : std::uint8_t { run, error };

/// State of an indicator. Flashes are followed by a second of darkness.
enum class Indication : std::uint8_t {
  off,
  on,
  flickering,  ///< 50 ms on, 50 ms off
  blinking,    ///< 200 ms on, 200 ms off
  single_flash,
  double_flash,
  triple_flash,
  quadruple_flash,
};

/// True if the indicator is on at `at`. The two indicators flicker and blink alternately, and a red
/// flash begins when a green one ends, so that they can share a bicolour LED. All patterns count
/// from Time zero: the indicators of a node stay in step, whenever their state changes.
bool is_lit(Indication indication, Indicator indicator, Time at);
/// Time of the next change of the indicator after `at`; never if there is none.
Time next_change(Indication indication, Indicator indicator, Time at);

/// Determines the present state of a node's indicators. Holds no time and sends nothing: query it
/// after each call of the node, and at next_change().
///
/// Run, the first that applies: flickering (LSS services or bit-rate detection), triple flash
/// (program download), then the NMT state: off, blinking (pre-operational), single flash (stopped),
/// on (operational).
///
/// Error, the first that applies: on (bus-off), flickering, quadruple flash (8250h), triple flash
/// (SYNC), double flash (8130h), single flash (warning limit or error-passive), blinking (invalid
/// configuration), off.
class Indicators {
 public:
  /// A condition that the application reports, since the node cannot detect it.
  enum class Condition : std::uint8_t {
    lss = 1,                    ///< LSS services are under way
    program_download = 2,       ///< a program download is under way
    invalid_configuration = 4,  ///< parameters are missing, or contradict each other
    error_control = 8,          ///< a guarded slave is lost; 8130h reports this for heartbeats
    bit_rate_detection = 16,    ///< bit-rate detection is under way
  };

  /// Makes the indicators. All arguments must outlive this object. Without an emergency producer no
  /// error is shown; without SYNC its loss is not shown.
  explicit Indicators(const Node& node, const EmergencyProducer* emergency = nullptr,
                      const Sync* sync = nullptr)
      : node_(node), emergency_(emergency), sync_(sync) {}

  /// Reports whether a condition holds. Conditions are independent of each other; none holds at
  /// first.
  void set(Condition condition, bool holds);

  // For the hooks of LssSlave, ProgramServer and BitRateDetection.

  /// Shows LSS (flickering) while the slave is in LSS state configuration.
  void lss_state_entered(LssState state) { set(Condition::lss, state == LssState::configuration); }
  /// Shows a program download (triple flash of the run indicator) while it is under way.
  void program_under_way(bool under_way) { set(Condition::program_download, under_way); }
  /// Shows bit-rate detection (flickering of both indicators) while it is under way.
  void bit_rate_detected(bool under_way) { set(Condition::bit_rate_detection, under_way); }

  /// What the green indicator shows now; see the class for the order of precedence.
  Indication run() const;
  /// What the red indicator shows now; see the class for the order of precedence.
  Indication error() const;

 private:
  bool holds(Condition condition) const;
  bool flickers() const { return holds(Condition::lss) || holds(Condition::bit_rate_detection); }
  bool is_present(std::uint16_t error_code) const;

  const Node& node_;
  const EmergencyProducer* emergency_;
  const Sync* sync_;
  std::uint8_t conditions_ = 0;
};

}  // namespace canvoy
