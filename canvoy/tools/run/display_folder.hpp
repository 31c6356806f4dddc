// The displays of a simulated bus as pictures in a folder, a new one whenever a display looks
// different, as it flashes and scrolls: next-stop-0001.png and so on.
//
//     DisplayFolder folder("displays");
//     folder.look(network);    // each DisplayFolder::period
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::tools {

class DisplayFolder {
 public:
  /// Of what flashes fast, and of what scrolls by a column (BusDisplay).
  static constexpr Duration period = 250ms;

  /// Makes the folder where there is none. Throws UsageError where it cannot be made, and where
  /// there are pictures in it.
  explicit DisplayFolder(std::string folder);

  /// Draws those that look different than at the last call, the dark ones too. Throws Failure.
  void look(const bus::BusNetwork& network);
  std::size_t written() const { return written_; }

 private:
  struct Drawn {
    std::vector<std::string> text;
    bool has_sign = false;
    std::size_t pictures = 0;
  };

  std::string folder_;
  std::array<Drawn, node_id_max + 1> drawn_;
  std::size_t written_ = 0;
};

}  // namespace canvoy::tools
