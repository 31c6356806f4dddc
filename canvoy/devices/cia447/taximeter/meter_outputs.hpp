// Controls other devices for a taximeter, as their SDO client: prints receipts (60EBh), and sets
// the tariff display on the roof: taxi light, vacant light, tariff level (6106h, 60D3h).
//
//     MeterOutputs outputs(network, {.printer = 3, .sign = 5});
//     outputs.show(display);          // TaximeterHardware::show
//     outputs.print(receipt.text());
//
// A command that another device does not take is repeated until it does. A device that was lost and
// returns gets all again, and the tariff display also periodically: its loss may not have been
// detected. A waiting receipt is printed when there is paper again; a newer one replaces it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/taximeter/receipt.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447 {

class MeterOutputs {
 public:
  /// The other devices.
  struct Settings {
    NodeId printer = 0;        ///< 0: none
    NodeId sign = 0;           ///< 0: none
    Duration repetition = 2s;  ///< of commands that are not taken
  };

  /// It sets on_lost() of the network, and calls the former callback.
  MeterOutputs(CarNetwork& network, const Settings& settings);

  /// Shows the state of the taximeter on the roof.
  void show(const TaximeterDisplay& display);
  /// Prints a text, cut to printed_text_max bytes.
  void print(std::string_view text);

  /// True while a receipt is on its way to the printer.
  bool is_printing() const { return receipt_length_ != 0; }
  /// Number of receipts that the printer has taken.
  unsigned printed() const { return printed_; }

 private:
  struct Sign {
    std::uint32_t lamps = 0xFFFF'FFFF;
    std::array<std::uint8_t, 2> level = {0xFF, 0xFF};

    bool operator==(const Sign&) const = default;
  };

  void reset(ResetScope scope);
  void lost(NodeId node);
  void go_on(Time now);
  void go_on_soon();
  void write_sign();
  void lamps_written(SdoClient::Outcome outcome);
  void level_written(SdoClient::Outcome outcome);
  void write_receipt();
  void receipt_written(SdoClient::Outcome outcome);

  CarNetwork& network_;
  Settings settings_;
  SdoClient printer_;
  SdoClient sign_;
  Callback<void(NodeId)> next_lost_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Sign wanted_;
  Sign writing_;
  Sign told_;
  Time renewal_due_{};
  std::array<std::uint8_t, 4> lamp_bytes_{};
  std::array<std::uint8_t, printed_text_max> receipt_{};
  std::size_t receipt_length_ = 0;
  unsigned printed_ = 0;
};

}  // namespace canvoy::cia447
