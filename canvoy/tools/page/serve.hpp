// Serves the page of a live source until it is ended: common part of `canvoy run --web` and `canvoy
// view`.
#pragma once

#include <optional>
#include <string>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/page/live_source.hpp"

namespace canvoy::tools {

/// Options of the command line.
struct ServeOptions {
  std::string address{};       ///< a port, or an address with one; empty: a free port of loopback
  std::string allow_write{};   ///< read by parse_write_permission()
  std::string allow_record{};  ///< read by Recorder::allow()

  /// Adds all options except the address.
  void add_to(Verb& command);
};

/// Reads `8080` and `192.168.1.5:8080` as an address to listen on. Throws UsageError.
std::string listening_address(const std::string& text);

/// Prints the address and serves until a signal; returns the result of the source. Throws Failure.
int serve(LiveSource& source, host::EventLoop& loop, const ServeOptions& options);

}  // namespace canvoy::tools
