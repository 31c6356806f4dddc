// An event of a world, as text for a terminal and as JSON for programs.
#pragma once

#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

struct ReportedEvent {
  Time at{};
  std::string text{};
  std::string json{};  ///< an object with its `time` (docs/json.md)

  /// A line for a terminal, with its line end.
  std::string line() const;
};

/// Text and JSON of a network of `canvoy/sim` (docs/json.md): event(), picture() for a terminal,
/// snapshot(), summary_text() and summary(). Each world has its own.
template <class Network>
struct WorldText;

}  // namespace canvoy::tools
