// A device of CiA 407 alone on a cable, for wire tests. Its node-ID is 5, unless the test sets
// another one.
#pragma once

#include <concepts>
#include <optional>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia407/kit/bus_kind.hpp"

namespace canvoy::cia407 {

class BusBench {
 public:
  /// The units find what `prepare` offers at the environment.
  template <std::invocable<Environment&> Prepare>
  BusBench(std::span<const BusUnit* const> units, Prepare prepare, NodeId node_id = 5)
      : node_id_(node_id) {
    prepare(environment);
    device_.emplace(units, cable.port(0), node_id, environment);
    cable.connect(0, device_->node());
    cable.start_all();
    cable.send("000#01 00");
  }
  explicit BusBench(std::span<const BusUnit* const> units, NodeId node_id = 5)
      : BusBench(
            units, [](Environment&) {}, node_id) {}

  BusDevice& device() { return *device_; }
  Node& node() { return device_->node(); }

  /// The answer to an SDO request: the frame's data.
  std::string ask(const std::string& request) {
    cable.send(id(0x600U + node_id_) + "#" + request);
    const std::string answer = cable.last(0x580U + node_id_);
    return answer.substr(answer.find('#') + 1);
  }
  /// Writes a value of 1, 2 or 4 bytes expedited: "02 61 00" is 6102h:00h. The command byte has the
  /// number of bytes.
  std::string write(const std::string& request) { return ask(request); }
  /// Writes up to 889 bytes in segments. True if the server accepted them.
  bool download(std::uint16_t index, std::uint8_t sub, std::string_view bytes);
  /// Reads in segments.
  std::string upload(std::uint16_t index, std::uint8_t sub);

  Cable cable;
  Environment environment;

 private:
  static std::string id(unsigned can_id) {
    char text[8];
    std::snprintf(text, sizeof text, "%03X", can_id);
    return text;
  }
  static std::string hex(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) {
      char pair[4];
      std::snprintf(pair, sizeof pair, "%02X ", static_cast<unsigned char>(byte));
      text += pair;
    }
    return text;
  }
  static std::string multiplexer(std::uint16_t index, std::uint8_t sub) {
    const char bytes[] = {static_cast<char>(index & 0xFF), static_cast<char>(index >> 8),
                          static_cast<char>(sub)};
    return hex({bytes, 3});
  }

  NodeId node_id_;
  std::optional<BusDevice> device_;
};

inline bool BusBench::download(std::uint16_t index, std::uint8_t sub, std::string_view bytes) {
  char size[] = {static_cast<char>(bytes.size() & 0xFF), static_cast<char>(bytes.size() >> 8), 0,
                 0};
  if (ask("21 " + multiplexer(index, sub) + hex({size, 4})).substr(0, 2) != "60") return false;
  unsigned toggle = 0;
  do {
    const std::string_view part = bytes.substr(0, 7);
    bytes.remove_prefix(part.size());
    std::string padded(part);
    padded.resize(7);
    const char command =
        static_cast<char>(toggle << 4 | (7 - part.size()) << 1 | (bytes.empty() ? 1U : 0U));
    const std::string answer = ask(hex({&command, 1}) + hex(padded));
    if (answer.substr(0, 2) != (toggle == 0 ? "20" : "30")) return false;
    toggle ^= 1;
  } while (!bytes.empty());
  return true;
}

inline std::string BusBench::upload(std::uint16_t index, std::uint8_t sub) {
  const auto byte_of = [](const std::string& answer, std::size_t position) {
    return static_cast<unsigned>(std::stoul(answer.substr(position * 3, 2), nullptr, 16));
  };
  const std::string first = ask("40 " + multiplexer(index, sub) + "00 00 00 00");
  const unsigned command = byte_of(first, 0);
  std::string text;
  if (command == 0x80) return "abort " + first.substr(12);
  if ((command & 2) != 0) {
    for (std::size_t i = 0; i < 4 - (command >> 2 & 3); ++i) {
      text += static_cast<char>(byte_of(first, 4 + i));
    }
    return text;
  }
  for (unsigned toggle = 0;; toggle ^= 1) {
    const char request = static_cast<char>(0x60 | toggle << 4);
    const std::string answer = ask(hex({&request, 1}) + "00 00 00 00 00 00 00");
    const unsigned segment = byte_of(answer, 0);
    if (segment == 0x80) return "abort " + answer.substr(12);
    for (std::size_t i = 0; i < 7 - (segment >> 1 & 7); ++i) {
      text += static_cast<char>(byte_of(answer, 1 + i));
    }
    if ((segment & 1) != 0) return text;
  }
}

}  // namespace canvoy::cia407
