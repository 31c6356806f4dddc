#include "canvoy/tools/device/device_options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

namespace {

/// For reports on the bus of the host: a CAN-ID allowed for a communication object.
std::uint32_t emergency_can_id(const std::string& text) {
  if (text.empty()) return RemoteSettings::invalid_cob_id;
  const bool is_hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  const char* const begin = text.data() + (is_hexadecimal ? 2 : 0);
  const char* const end = text.data() + text.size();
  std::uint32_t id = 0;
  const auto [stop, error] = std::from_chars(begin, end, id, is_hexadecimal ? 16 : 10);
  if (error == std::errc{} && stop == end && has_free_id({id})) return id;
  throw UsageError(fmt::format(
      "--embedded-emergency: '{}' is no CAN-ID for emergencies: give one as 0x6C0", text));
}

RemoteSettings settings_of(const EmbeddedOptions& options) {
  RemoteSettings settings;
  settings.network = options.network;
  settings.indication = static_cast<std::uint8_t>(options.indication);
  settings.emergency_cob_id = emergency_can_id(options.emergency);
  return settings;
}

}  // namespace

void add_embedded_options(Verb& command, EmbeddedOptions& options) {
  command.add({
      {"--embedded", options.bus,
       "a bus behind an operator environment, as can1: devices there are reached "
       "through it, as can0/2:7"},
      {"--embedded-network", options.network, "its number, 1 to 65535 (default 2)",
       between(1U, 0xFFFFU)},
      {"--embedded-indication", options.indication,
       "the SDO command by which a host says the network (default 0xE0)", between(0xE0U, 0xFFU)},
      {"--embedded-emergency", options.emergency,
       "the CAN-ID by which emergencies from there are told, as 0x6C0 (default: they "
       "are not)"},
  });
}

void check_embedded(const EmbeddedOptions& options, const std::string& host_bus) {
  if (options.bus.empty()) return;
  emergency_can_id(options.emergency);
  if (to_string(real_bus(options.bus)) == to_string(real_bus(host_bus))) {
    throw UsageError(fmt::format("--embedded: {} is the bus of the device itself", options.bus));
  }
}

EmbeddedNetwork::EmbeddedNetwork(host::EventLoop& loop, Node& module,
                                 const EmbeddedOptions& options)
    : bus_(value_or_throw(host::open_bus(loop, real_bus(options.bus)))),
      attachment_(loop, *bus_),
      access_(module, attachment_.port(), channels_, settings_of(options)) {
  attachment_.attach(ear_);
}

}  // namespace canvoy::tools
