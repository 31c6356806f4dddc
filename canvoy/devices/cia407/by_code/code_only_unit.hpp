// Virtual devices of CiA 407 without objects (6.7, 6.14 to 6.16, 6.19, 6.25): they have a code in
// 1000h or 6000h, and the errors of clause 7.3 that apply to them.
//
//     const DeviceKind kind = bus_device_kind<VoiceRadioKind>();
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/error_watch.hpp"
#include "canvoy/devices/cia407/kit/errors.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// One type for each kind, so that an environment can offer hardware for each.
template <DeviceCode code>
struct CodeOnlyHardware {
  /// True if the error exists, of those that the kind may have.
  Callback<bool(std::uint16_t error_code)> has_error = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <DeviceCode code, class Plain>
constexpr void set_by_names(CodeOnlyHardware<code>& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::has_error; },
      "the class has no member function of CodeOnlyHardware: has_error");
  if constexpr (requires { &Plain::has_error; })
    hardware.has_error = callback<&Plain::has_error>(plain);
}

/// Of devices with a radio.
inline constexpr std::uint16_t radio_errors[] = {bus_error::no_radio_connection};
/// Errors of the supply and of its outputs.
inline constexpr std::uint16_t power_errors[] = {0x2110, 0x2310, 0x2320, 0x2330, 0x3110, 0x3120,
                                                 0x3210, 0x3220, 0x3310, 0x3320, 0x3330};

template <DeviceCode code>
class CodeOnlyUnit {
 public:
  /// Emergency error codes that the hardware may report.
  static constexpr std::span<const std::uint16_t> errors() {
    if (code == DeviceCode::power_supply) return power_errors;
    const bool is_radio = code == DeviceCode::data_radio || code == DeviceCode::voice_radio ||
                          code == DeviceCode::short_range_communication;
    return is_radio ? std::span<const std::uint16_t>(radio_errors)
                    : std::span<const std::uint16_t>();
  }
  /// Everything to which `hardware` refers must outlive this.
  CodeOnlyUnit(VirtualDevice& device, const CodeOnlyHardware<code>& hardware,
               const NoSettings& /*settings*/)
      : device_(device), errors_(device, errors(), hardware.has_error) {
    device.on_reset = callback<&CodeOnlyUnit::reset>(*this);
  }
  CodeOnlyUnit(const CodeOnlyUnit&) = delete;
  CodeOnlyUnit& operator=(const CodeOnlyUnit&) = delete;

 private:
  void reset(ResetScope /*scope*/) { errors_.look(device_.node().now()); }

  VirtualDevice& device_;
  ErrorWatch errors_;
};

/// Kind of a virtual device without objects.
template <DeviceCode code>
using CodeOnlyKind = BusKind<CodeOnlyUnit<code>, CodeOnlyHardware<code>>;

/// Ticket reader (6.7).
struct TicketReaderKind : CodeOnlyKind<DeviceCode::ticket_reader> {
  static constexpr DeviceInfo info = {.name = "ticket-reader",
                                      .title = "ticket or card reader, by its code alone",
                                      .product = "Canvoy CiA 407 ticket reader",
                                      .product_code = 40706,
                                      .node_id = 24};
  static constexpr const VirtualDeviceInfo& provides = ticket_reader;
};
/// Data radio (6.14).
struct DataRadioKind : CodeOnlyKind<DeviceCode::data_radio> {
  static constexpr DeviceInfo info = {.name = "data-radio",
                                      .title = "data radio (DRCC), by its code alone",
                                      .product = "Canvoy CiA 407 data radio",
                                      .product_code = 40713,
                                      .node_id = 25,
                                      .hardware = "a radio: connected or not"};
  static constexpr const VirtualDeviceInfo& provides = data_radio;
};
/// Voice radio (6.15).
struct VoiceRadioKind : CodeOnlyKind<DeviceCode::voice_radio> {
  static constexpr DeviceInfo info = {.name = "voice-radio",
                                      .title = "voice radio (VRCC), by its code alone",
                                      .product = "Canvoy CiA 407 voice radio",
                                      .product_code = 40714,
                                      .node_id = 26,
                                      .hardware = "a radio: connected or not"};
  static constexpr const VirtualDeviceInfo& provides = voice_radio;
};
/// Short-range communication (6.16).
struct ShortRangeKind : CodeOnlyKind<DeviceCode::short_range_communication> {
  static constexpr DeviceInfo info = {.name = "short-range-communication",
                                      .title = "short range radio (DSRC), by its code alone",
                                      .product = "Canvoy CiA 407 DSRC",
                                      .product_code = 40715,
                                      .node_id = 27,
                                      .hardware = "a radio: connected or not"};
  static constexpr const VirtualDeviceInfo& provides = short_range_communication;
};
/// Driver's console display (6.19).
struct ConsoleDisplayKind : CodeOnlyKind<DeviceCode::drivers_console_display> {
  static constexpr DeviceInfo info = {.name = "console-display",
                                      .title = "driver's console display, by its code alone",
                                      .product = "Canvoy CiA 407 console display",
                                      .product_code = 40718,
                                      .node_id = 28};
  static constexpr const VirtualDeviceInfo& provides = drivers_console_display;
};
/// Power supply (6.25).
struct BusPowerSupplyKind : CodeOnlyKind<DeviceCode::power_supply> {
  static constexpr DeviceInfo info = {.name = "bus-power-supply",
                                      .title = "power supply of a bus, by its code alone",
                                      .product = "Canvoy CiA 407 power supply",
                                      .product_code = 40724,
                                      .node_id = 29,
                                      .hardware = "voltages and currents: right or not"};
  static constexpr const VirtualDeviceInfo& provides = power_supply;
};

}  // namespace canvoy::cia407
