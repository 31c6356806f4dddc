// Real hands on the seat of `canvoy device operator`: Linux input devices move its sticks and press
// its buttons, and their lights show its indicators.
//
//     Hands hands({"/dev/input/event5", "pedals.toml"}, elements, seat, output);
//     hands.on_change(...);           // after each report of a device
//     hands.serve(now);               // when descriptor() is readable, and now and then
//     hands.show(1, 3, true);         // indicator 3 of cluster 1 is on
//
// An unplugged device leaves its controls at rest, and is an error of the module until it is back;
// then it is read again. Encoders keep their position.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/seat/hand_mapping.hpp"
#include "canvoy/tools/device/seat/input_device.hpp"

namespace canvoy::tools {

class Hands {
 public:
  /// Each of `inputs` is a device, which is used as the next joystick, or a file with a mapping.
  /// The other arguments must outlive this. Throws UsageError and Failure for inputs that cannot be
  /// used.
  Hands(const std::vector<std::string>& inputs, const cia852::OperatorEnvironment& elements,
        SeatState& seat, const DeviceOutput& output);
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  /// Sets the function called after each report of a device, so that a press followed at once by a
  /// release is not missed.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Sets the function called when a device, counted from 1, is lost or back.
  void on_loss(Callback<void(unsigned device, bool is_lost)> lost) { lost_ = lost; }

  /// Readable when an event is available.
  int descriptor() const { return poll_.get(); }
  /// Processes all events, and looks for lost devices.
  void serve(Time now);
  void show(unsigned cluster, unsigned indicator, bool is_on);

 private:
  struct Hand {
    HandMapping wanted;     ///< as given by the user
    HandMapping mapping{};  ///< completed from the device
    std::unique_ptr<InputDevice> device{};
    Time next_look{};  ///< while the device is lost
    bool is_announced = false;
  };

  static constexpr Duration look_time = std::chrono::seconds(1);

  void take_device(Hand& hand, InputDevice device);
  void learn(Hand& hand);
  void read(Hand& hand, Time now);
  void lose(Hand& hand, Time now);
  void look_for(Hand& hand, Time now);
  unsigned number(const Hand& hand) const {
    return static_cast<unsigned>(&hand - hands_.data()) + 1;
  }
  bool is_lit(const HandLight& light) const;

  SeatState& seat_;
  const DeviceOutput& output_;
  host::Descriptor poll_;
  std::vector<Hand> hands_;
  std::array<std::uint64_t, cia852::indicator_clusters_max> lit_{};  ///< bit 0 is indicator 1
  Callback<void()> changed_;
  Callback<void(unsigned, bool)> lost_;
};

/// Applies an event to the seat: axes and buttons of the mapping. Calibrations must be complete.
void move_seat(SeatState& seat, const HandMapping& mapping, const InputEvent& event);
/// Sets all controls of the mapping except encoders to rest.
void rest_seat(SeatState& seat, const HandMapping& mapping);

}  // namespace canvoy::tools
