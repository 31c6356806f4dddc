#include "canvoy/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/protocol/abort_reason.hpp"
#include "canvoy/profiles/cia301.hpp"

namespace canvoy::text {

std::string node_text(NodeId node) {
  return fmt::format("node {} ({:02X}h)", node, node);
}

std::string object_text(std::uint16_t index, std::uint8_t sub) {
  return fmt::format("{:04X}h:{:02X}h", index, sub);
}

std::string bytes_text(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::size_t width = 3;  // including the blank before the next one
  std::string text(bytes.size() * width, ' ');
  char* at = text.data();
  for (const std::uint8_t byte : bytes) {
    at[0] = digits[byte >> 4U];
    at[1] = digits[byte & 0xFU];
    at += width;
  }
  if (!text.empty()) text.pop_back();
  return text;
}

std::string abort_text(AbortCode code) {
  return fmt::format("{:08X}h: {}", static_cast<std::uint32_t>(code), abort_reason(code));
}

std::string end_text(const SdoEnd& end) {
  switch (end.kind()) {
    case SdoEnd::Kind::done:
      return "done";
    case SdoEnd::Kind::aborted_by_server:
      return abort_text(end.abort());
    case SdoEnd::Kind::aborted_by_client:
      return "aborted here, " + abort_text(end.abort());
    case SdoEnd::Kind::no_answer:
      return "no answer";
    case SdoEnd::Kind::cancelled:
      break;
  }
  return "cancelled, " + abort_text(end.abort());
}

std::string_view emergency_text(std::uint16_t code) {
  // The code itself, or its class: 4310h belongs to 4300h, and that to 4000h.
  for (const unsigned mask : {0xFFFFU, 0xFF00U, 0xF000U}) {
    const auto* found = std::ranges::find_if(
        cia301::error_codes,
        [wanted = code & mask](const ErrorCodeInfo& info) { return info.code == wanted; });
    if (found != std::end(cia301::error_codes)) return found->text;
  }
  return "unknown error code";
}

std::string_view nmt_state_text(NmtState state) {
  switch (state) {
    case NmtState::initialisation:
      return "initialisation";
    case NmtState::stopped:
      return "stopped";
    case NmtState::operational:
      return "operational";
    case NmtState::pre_operational:
      return "pre-operational";
  }
  return "unknown state";
}

std::string_view bus_state_text(BusState state) {
  switch (state) {
    case BusState::error_active:
      return "error-active";
    case BusState::error_warning:
      return "error-warning";
    case BusState::error_passive:
      return "error-passive";
    case BusState::bus_off:
      return "bus-off";
  }
  return "unknown state";
}

std::string_view stop_reason_text(cia419::StopReason reason) {
  using enum cia419::StopReason;
  switch (reason) {
    case none:
      return "charging";
    case no_pilot_signal:
      return "no pilot signal";
    case bus_off:
      return "the CAN controller is bus-off";
    case no_battery:
      return "no battery is linked yet";
    case heartbeat_lost:
      return "no heartbeat of the battery";
    case not_operational:
      return "the charger is not operational";
    case battery_data_missed:
      return "the battery's PDO is missed";
    case battery_not_ready:
      return "the battery is not ready";
    case battery_full:
      return "the battery is full";
    case invalid_temperature:
      return "the battery's temperature is invalid";
    case invalid_voltage:
      return "the battery's voltage is invalid";
    case too_hot:
      return "the battery is too hot";
    case too_cold:
      return "the battery is too cold";
    case voltage_too_high:
      return "the battery's voltage is too high";
    case voltage_too_low:
      return "the battery's voltage is too low";
    case no_request:
      return "the battery requests no current";
  }
  return "unknown reason";
}

std::string duration_text(Duration duration) {
  const auto us = duration.count();
  const auto hours = us / 3'600'000'000;
  const auto minutes = us / 60'000'000 % 60;
  const double seconds = static_cast<double>(us % 60'000'000) / 1e6;
  std::string text;
  if (hours > 0) text += fmt::format("{}h ", hours);
  if (minutes > 0 || (hours > 0 && seconds > 0)) {
    text += fmt::format(fmt::runtime(hours > 0 ? "{:02}min " : "{}min "), minutes);
  }
  if (text.empty()) return fmt::format("{:.3f}s", seconds);
  if (seconds > 0) return text + fmt::format("{:06.3f}s", seconds);
  text.pop_back();
  return text;
}

}  // namespace canvoy::text
