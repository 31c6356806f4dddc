// Automatic bit-rate detection: listens at each bit rate in turn until a frame is heard (CiA 801).
//
// Like a node, it owns no clock: it is handed what the controller hears, and time. Start the node
// when it is done.
//
//     BitRateDetection detection({.restart = ...});
//     detection.on_found(Callback<void(std::uint32_t)>::to<&Board::bit_rate_found>(board));
//     detection.start(now);
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// The controller listens only: it acknowledges nothing and destroys nothing, so others must talk
/// to each other, or one sends until it is error-passive, which is when a listener has its frames.
/// What CiA 801 itself says of order and times is not known here: they are options.
class BitRateDetection {
 public:
  /// What most networks use comes first.
  static constexpr std::array<std::uint32_t, 8> usual_bit_rates = {
      125'000, 250'000, 500'000, 1'000'000, 50'000, 20'000, 800'000, 10'000};

  /// Restarts the CAN controller with this bit rate in bit/s; false where it cannot have it: then
  /// it is the next one's turn, also where a frame was heard.
  using Restart = Callback<bool(std::uint32_t bit_rate, bool listen_only)>;

  struct Options {
    std::span<const std::uint32_t> bit_rates = usual_bit_rates;  ///< must outlive the detection
    /// Of silence, until the next bit rate: longer than the longest silence between two frames.
    Duration dwell = 1500ms;
    std::uint8_t errors_max = 1;   ///< of one visit; with the last of them it is another bit rate
    std::uint16_t rounds_max = 0;  ///< over all bit rates, until it gives up; 0: never
  };

  enum class State : std::uint8_t { idle, listening, found, failed };

  explicit BitRateDetection(Restart restart);
  BitRateDetection(Restart restart, const Options& options);

  /// The controller runs with this bit rate, and takes part; a call with 0 says that it was not
  /// found in rounds_max rounds.
  void on_found(Callback<void(std::uint32_t bit_rate)> found) { found_ = found; }
  /// For indicators: it begins, or has ended in whatever way.
  void on_under_way(Callback<void(bool under_way)> told) { under_way_ = told; }

  void start(Time now);
  void stop() { enter(State::idle); }

  /// The controller received a frame, or an error frame as SocketCAN has them.
  void receive(const Frame& frame, Time now);
  /// The controller saw something that is no frame.
  void bus_error(Time now);
  void advance(Time now);
  Time deadline() const { return state_ == State::listening ? until_ : never; }

  State state() const { return state_; }
  /// That is listened at, or was found, in bit/s.
  std::uint32_t bit_rate() const { return options_.bit_rates[position_]; }

 private:
  void enter(State state);
  void listen(Time now);
  void next(Time now);

  Restart restart_;
  Options options_;
  Callback<void(std::uint32_t)> found_;
  Callback<void(bool)> under_way_;
  Time until_{};
  std::size_t position_ = 0;
  std::uint16_t rounds_ = 0;
  std::uint8_t errors_ = 0;
  State state_ = State::idle;
};

}  // namespace canvoy
