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

#include "canvoy/devices/cia447/audio_switch/audio_matrix.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

/// The switch itself.
struct AudioSwitchHardware {
  /// Called for each pair of channels, 1 to 16, that changes its gain; 0: not connected, FDh:
  /// maximum.
  Callback<void(unsigned input, unsigned output, std::uint8_t gain)> connect = {};
};

class AudioSwitchUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  AudioSwitchUnit(CarNetwork& network, const AudioSwitchHardware& hardware,
                  const SwitchedSettings& settings);
  AudioSwitchUnit(const AudioSwitchUnit&) = delete;
  AudioSwitchUnit& operator=(const AudioSwitchUnit&) = delete;

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
