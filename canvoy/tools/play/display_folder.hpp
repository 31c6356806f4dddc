// Displays of a simulated bus as images in a folder, a new one whenever a display changes,
// including flashing and scrolling: next-stop-0001.png and so on.
//
//     DisplayFolder folder("displays");
//     folder.look(network);    // each DisplayFolder::period
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::tools {

class DisplayFolder {
 public:
  /// Period of fast flashing, and of scrolling by a column (BusDisplay).
  static constexpr Duration period = 250ms;

  /// Creates the folder if needed. Throws UsageError if this fails, or if it contains such images.
  explicit DisplayFolder(std::string folder);

  /// Draws displays that have changed since the last call, including dark ones. Throws Failure.
  void look(const bus_line::BusNetwork& network);
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
