// Serves the page of something live until somebody ends it: what `canvoy run --web` and `canvoy
// view` have in common.
#pragma once

#include <optional>
#include <string>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/live/live_source.hpp"

namespace canvoy::tools {

/// As given on the command line.
struct ServeOptions {
  std::string address{};       ///< a port, or an address with one; empty: a free port of loopback
  std::string allow_write{};   ///< as parse_write_permission() reads it
  std::string allow_record{};  ///< as Recorder::allow() takes it

  /// All but the address.
  void add_to(Verb& command);
};

/// `8080` and `192.168.1.5:8080` as an address to listen on. Throws UsageError.
std::string listening_address(const std::string& text);

/// Prints the address; returns what the source comes to when there was a signal. Throws Failure.
int serve(LiveSource& source, host::EventLoop& loop, const ServeOptions& options);

}  // namespace canvoy::tools
