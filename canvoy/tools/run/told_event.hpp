// What has happened in a world, as it is told: in words to a terminal, as JSON to programs.
#pragma once

#include <string>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

struct ToldEvent {
  Time at{};
  std::string text{};
  std::string json{};  ///< an object, with its `time`, as docs/json.md says

  /// A line of a terminal, with its end.
  std::string line() const;
};

/// What a network of `canvoy/sim` says, in words and as JSON (docs/json.md): event(), picture() for
/// a terminal, snapshot(), summary_text() and summary(). Each world has its own.
template <class Network>
struct WorldText;

}  // namespace canvoy::tools
