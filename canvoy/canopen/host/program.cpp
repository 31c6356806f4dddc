#include "canvoy/canopen/host/program.hpp"

#include <charconv>
#include <cstdio>
#include <string_view>

namespace canvoy {

int OpenBus::wait() {
  const host::Result<void> stops = loop_->stop_on_signals();
  if (!stops) return fail(stops.error());
  loop_->run();
  return 0;
}

host::Result<OpenBus> open(const char* name) {
  if (name == nullptr) {
    return host::Error{"bus", "none is named", "name one: can0, or udp:239.74.163.2:43113"};
  }
  auto loop = host::EventLoop::create();
  if (!loop) return loop.error();
  auto bus = host::open_bus(**loop, std::string_view(name));
  if (!bus) return bus.error();
  return OpenBus(std::move(*loop), std::move(*bus));
}

host::Result<NodeId> read_node_id(const char* text) {
  const std::string_view written = text == nullptr ? "" : text;
  const bool is_hexadecimal = written.starts_with("0x") || written.starts_with("0X");
  const std::string_view digits = written.substr(is_hexadecimal ? 2 : 0);
  unsigned id = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, failure] = std::from_chars(digits.data(), end, id, is_hexadecimal ? 16 : 10);
  const bool is_number = failure == std::errc() && rest == end;
  if (is_number && is_node_id(id)) return static_cast<NodeId>(id);
  return host::Error{written.empty() ? "node-ID" : std::string(written), "is no node-ID",
                     "give one from 1 to 127"};
}

int fail(const host::Error& error) {
  std::fprintf(stderr, "%s\n", error.line().c_str());
  return 1;
}

}  // namespace canvoy
