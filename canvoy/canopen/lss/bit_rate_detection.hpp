// Automatic bit-rate detection: listens at each bit rate in turn until a frame arrives (CiA 801).
//
// Like a node, it owns no clock: its owner passes what the controller receives, and time. Start the
// node after its end.
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

/// The controller only listens: it acknowledges nothing and destroys nothing. Other nodes must
/// therefore communicate, or one sends until it is error-passive, after which a listener receives
/// its frames. The order and times of CiA 801 itself are unknown: they are options.
class BitRateDetection {
 public:
  /// The most common bit rates come first.
  static constexpr std::array<std::uint32_t, 8> usual_bit_rates = {
      125'000, 250'000, 500'000, 1'000'000, 50'000, 20'000, 800'000, 10'000};

  /// Restarts the CAN controller with this bit rate in bit/s; false if it cannot: then the next bit
  /// rate follows, also after a frame was received.
  using Restart = Callback<bool(std::uint32_t bit_rate, bool listen_only)>;

  /// Order of the bit rates, and times.
  struct Options {
    std::span<const std::uint32_t> bit_rates = usual_bit_rates;  ///< must outlive the detection
    /// Time of silence until the next bit rate: longer than the longest silence between two frames.
    Duration dwell = 1500ms;
    std::uint8_t errors_max = 1;   ///< limit of one visit; the last one leads to the next bit rate
    std::uint16_t rounds_max = 0;  ///< limit over all bit rates; 0: none
  };

  /// Not started or stopped; under way; the result is bit_rate(); all rounds are over.
  enum class State : std::uint8_t { idle, listening, found, failed };

  /// Makes a detection with default options. It does nothing until start().
  explicit BitRateDetection(Restart restart);
  /// Makes a detection. An empty list of bit rates finds nothing.
  BitRateDetection(Restart restart, const Options& options);

  /// Sets the callback for the result: the controller runs with this bit rate, and takes part; 0:
  /// not found in rounds_max rounds.
  void on_found(Callback<void(std::uint32_t bit_rate)> found) { found_ = found; }
  /// Sets the callback for indicators: the detection begins, or has ended in any way.
  void on_under_way(Callback<void(bool under_way)> told) { under_way_ = told; }

  /// Begins, or begins again, with the first bit rate.
  void start(Time now);
  /// Ends the detection without a result; the controller keeps its bit rate.
  void stop() { enter(State::idle); }

  /// Takes a frame of the controller, or an error frame in the format of SocketCAN.
  void receive(const Frame& frame, Time now);
  /// Notes that the controller saw an error instead of a frame.
  void bus_error(Time now);
  /// Goes to the next bit rate if the dwell time is over. Call it at deadline().
  void advance(Time now);
  /// Time of the next bit rate; never unless it is listening.
  Time deadline() const { return state_ == State::listening ? until_ : never; }

  /// State of the detection; `found` and `failed` stay until the next start().
  State state() const { return state_; }
  /// Bit rate in use, or found, in bit/s.
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
