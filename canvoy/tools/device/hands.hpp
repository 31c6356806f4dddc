// Real hands on the seat of `canvoy device operator`: input devices of Linux move its sticks and
// press its buttons, and their lights show its indicators.
//
//     Hands hands({"/dev/input/event5", "pedals.toml"}, elements, seat, output);
//     hands.on_change(...);           // after each report of a device
//     hands.serve(now);               // when descriptor() is readable, and now and then
//     hands.show(1, 3, true);         // indicator 3 of cluster 1 is on
//
// A device that is unplugged leaves all that it moves at rest, and is an error of the module, until
// it is back: then it is read anew. Encoders stay where they are.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/tools/device/device_output.hpp"
#include "canvoy/tools/device/hand_mapping.hpp"
#include "canvoy/tools/device/input_device.hpp"

namespace canvoy::tools {

class Hands {
 public:
  /// Of `inputs` each is a device, which is the next joystick then, or a file with a mapping. The
  /// others must outlive this. Throws UsageError and Failure for what cannot be used.
  Hands(const std::vector<std::string>& inputs, const cia852::OperatorEnvironment& elements,
        SeatState& seat, const DeviceOutput& output);
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  /// Called after each report of a device, so that nothing that is pressed and released at once is
  /// missed.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Called when one of the devices, from 1 on, is lost or back.
  void on_loss(Callback<void(unsigned device, bool is_lost)> lost) { lost_ = lost; }

  /// Readable when something has happened.
  int descriptor() const { return poll_.get(); }
  /// Takes all that has happened, and looks for what is lost.
  void serve(Time now);
  void show(unsigned cluster, unsigned indicator, bool is_on);

 private:
  struct Hand {
    HandMapping wanted;     ///< as the user says
    HandMapping mapping{};  ///< completed by what the device says
    std::unique_ptr<InputDevice> device{};
    Time next_look{};  ///< while it is lost
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

/// What an event means for the seat: axes and buttons that the mapping names. Calibrations are
/// complete.
void move_seat(SeatState& seat, const HandMapping& mapping, const InputEvent& event);
/// All that it moves comes to rest, but encoders.
void rest_seat(SeatState& seat, const HandMapping& mapping);

}  // namespace canvoy::tools
