// The gains of an audio switch, for each pair of an input and an output (CiA 447-3, 4.2.19).
// Channel n is the device with node-ID n; 0 stands for all channels.
//
//     AudioMatrix matrix;
//     matrix.connect(0, 3, 80);   // all inputs to output 3
//     matrix.gain(7, 3);          // 80
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace canvoy::cia447 {

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

}  // namespace canvoy::cia447
