// The audio switch: connects audio inputs to outputs, each pair with a separate gain (6120h to
// 6122h; CiA 447-3, 4.2.19).
//
//     AudioSwitchUnit audio(network, {.connect = ...}, {});
//     audio.matrix().gain(7, 3);
//
// A command with a "don't care" in any field has no effect. Each client gets the answer to its own
// request, regardless of requests by others in between, with the present gain. For a request with
// all channels of a side and different gains, the answer is "signal not available" (errata Z32).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

/// The gains of an audio switch, for each pair of an input and an output (CiA 447-3, 4.2.19).
/// Channel n is the device with node-ID n; 0 stands for all channels.
///
///     AudioMatrix matrix;
///     matrix.connect(0, 3, 80);   // all inputs to output 3
///     matrix.gain(7, 3);          // 80
class AudioMatrix {
 public:
  static constexpr unsigned channels = 16;        ///< node-IDs 1 to 16
  static constexpr std::uint8_t gain_max = 0xFD;  ///< the greatest that is a gain

  /// Calls `changed` with each pair of channels that gets another gain. Channels are 0 to 16.
  template <class Changed>
  void connect(unsigned input, unsigned output, std::uint8_t gain, Changed changed) {
    each(input, output, [&](unsigned from, unsigned to) {
      std::uint8_t& at = gains_[from - 1][to - 1];
      if (at == gain) return;
      at = gain;
      changed(from, to);
    });
  }
  /// The same without a call.
  void connect(unsigned input, unsigned output, std::uint8_t gain) {
    connect(input, output, gain, [](unsigned, unsigned) {});
  }
  /// 0: not connected. For several pairs: the gain of all, or nothing if they differ.
  std::optional<std::uint8_t> gain(unsigned input, unsigned output) const {
    const std::uint8_t first = gains_[input == 0 ? 0 : input - 1][output == 0 ? 0 : output - 1];
    bool are_alike = true;
    each(input, output, [&](unsigned from, unsigned to) {
      are_alike = are_alike && gains_[from - 1][to - 1] == first;
    });
    return are_alike ? std::optional(first) : std::nullopt;
  }

 private:
  template <class Each>
  static void each(unsigned input, unsigned output, Each call) {
    for (unsigned from = 1; from <= channels; ++from) {
      for (unsigned to = 1; to <= channels; ++to) {
        if ((input == 0 || input == from) && (output == 0 || output == to)) call(from, to);
      }
    }
  }

  std::array<std::array<std::uint8_t, channels>, channels> gains_{};
};

/// The switch itself.
struct AudioSwitchHardware {
  /// Called for each pair of channels, 1 to 16, that changes its gain; 0: not connected, FDh:
  /// maximum.
  Callback<void(unsigned input, unsigned output, std::uint8_t gain)> connect = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(AudioSwitchHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::connect; },
      "the class has no member function of AudioSwitchHardware: connect");
  if constexpr (requires { &Plain::connect; }) hardware.connect = callback<&Plain::connect>(plain);
}

class AudioSwitchUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  AudioSwitchUnit(CarNetwork& network, const AudioSwitchHardware& hardware,
                  const SwitchedSettings& settings);

  /// Gains at present.
  const AudioMatrix& matrix() const { return matrix_; }
  /// Reports that the amplifier does not work: clients get that as answer.
  void report_failure(bool has_failed);

 private:
  static constexpr unsigned do_not_care = 0xFF;
  struct Pair {
    unsigned input = do_not_care;
    unsigned output = do_not_care;
    bool is_whole() const { return input != do_not_care && output != do_not_care; }
  };

  void reset(ResetScope scope);
  void command_written();
  void request_written();
  void answer_request();
  void respond(NodeId client);

  CarNetwork& network_;
  AudioSwitchHardware hardware_;
  AudioMatrix matrix_;
  std::array<Pair, node_id_max + 1> asked_{};  ///< by client
  bool has_failed_ = false;
  Commands commands_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the audio switch (4.2.19); car_unit makes it a part of a device.
struct AudioSwitchKind : CarKind<AudioSwitchUnit, AudioSwitchHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "audio-switch",
                                      .title = "audio switch",
                                      .product = "Canvoy CiA 447 audio switch",
                                      .product_code = 44716,
                                      .node_id = 12,
                                      .hardware = "amplifiers: 16 inputs to 16 outputs"};
  static constexpr const VirtualDeviceInfo& provides = audio_switch_device;
};

}  // namespace canvoy::cia447
