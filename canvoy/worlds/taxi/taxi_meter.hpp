// The taximeter of a taxi, as the driver uses it: its keys, its display, its memory without power,
// and its outputs to printer, tariff display and terminal. Where the meter is real, its state is
// that of its messages on the bus.
//
//     TaxiMeter meter(bus, options, sabotage, clock, events);
//     meter.provide(environment);
//     meter.keys().hire();
//     meter.display().trip.fare
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/storage/flash.hpp"
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/taxi/shift.hpp"
#include "canvoy/worlds/taxi/taxi_event.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"
#include "canvoy/worlds/taxi/town_clock.hpp"

namespace canvoy::taxi {

// Application of the taximeter of a taxi, beside its virtual device: it shows the fare on display 1
// of the terminal while there are passengers, and otherwise gives the display back.

/// Where the fare is shown, and how.
struct FareDisplaySettings {
  NodeId terminal = 0;             ///< node-ID of the terminal
  cia447::Currency currency = {};  ///< of the fare
};

/// The application of the taximeter of a taxi, beside its virtual device.
class FareDisplay {
 public:
  /// `network` must outlive this object; it acts once the node runs.
  FareDisplay(cia447::CarNetwork& network, const car::NoHardware& hardware,
              const FareDisplaySettings& settings);

  /// Shows what the meter has on its own display.
  void show(const cia447::TaximeterDisplay& display);

 private:
  FareDisplaySettings settings_;
  cia447::TerminalClient terminal_;
};

/// A CarUnit beside the virtual device of the taximeter; it is not in the catalogue.
struct FareDisplayKind : cia447::CarKind<FareDisplay, car::NoHardware, FareDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "fare-display", .title = "display of a fare"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// The keys of the terminal.
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

/// A flash memory of a simulated device, which keeps its contents while the device has no power.
///
///     KeptFlash flash(2, 512);
///     hardware.flash = &flash.flash();
class KeptFlash {
 public:
  /// An erased memory; `sector_size` in bytes.
  KeptFlash(std::size_t sectors, std::uint32_t sector_size) : bytes_(sectors * sector_size, 0xFF) {
    flash_.sector_size = sector_size;
    flash_.unit = 8;
    flash_.erase = decltype(Flash::erase)::to<&KeptFlash::erase>(*this);
    flash_.program = decltype(Flash::program)::to<&KeptFlash::program>(*this);
    flash_.read = decltype(Flash::read)::to<&KeptFlash::read>(*this);
  }
  KeptFlash(const KeptFlash&) = delete;
  KeptFlash& operator=(const KeptFlash&) = delete;

  /// Functions for the device; valid as long as this object.
  const Flash& flash() const { return flash_; }

 private:
  FlashState erase(std::uint32_t address) {
    std::fill_n(at(address), flash_.sector_size, std::uint8_t{0xFF});
    return FlashState::done;
  }
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    std::ranges::copy(bytes, at(address));
    return FlashState::done;
  }
  bool read(std::uint32_t address, std::span<std::uint8_t> bytes) {
    std::copy_n(at(address), bytes.size(), bytes.begin());
    return true;
  }
  std::vector<std::uint8_t>::iterator at(std::uint32_t address) {
    return bytes_.begin() + static_cast<std::ptrdiff_t>(address);
  }

  std::vector<std::uint8_t> bytes_;
  Flash flash_;
};

class TaxiMeter {
 public:
  /// Local time of the meter; empty: its clock has none.
  using Clock = Callback<std::optional<cia447::LocalTime>()>;

  /// All must outlive this object. `clock` is the meter's own.
  TaxiMeter(car::CarBus& bus, const TaxiOptions& options, const Sabotage& sabotage,
            const TownClock& town, const Clock& clock, EventLog<TaxiEvent>& events)
      : bus_(bus),
        options_(options),
        sabotage_(sabotage),
        town_(town),
        clock_(clock),
        events_(events) {}
  TaxiMeter(const TaxiMeter&) = delete;
  TaxiMeter& operator=(const TaxiMeter&) = delete;

  /// Adds the hardware of the device.
  void provide(Environment& environment);
  /// Adds its connections to the other devices, for those that are made after it.
  void provide_outputs(Environment& environment);
  /// Call it before the meter loses or gets its power.
  void power_changes(bool is_on);

  /// Keys for the driver: a key of a meter without power does nothing. Keys of a real meter are
  /// pressed outside of the world: the functions then do only the other actions of the driver.
  MeterKeys keys();
  /// What the meter shows; of a real one, what it sends.
  const cia447::TaximeterDisplay& display() const { return display_; }
  /// True from hiring until the trip is paid.
  bool has_passengers() const;
  /// Takes the state that a real meter reports. False: it is not new.
  bool heard(cia447::Taximeter state);
  /// Takes the data of a trip that a real meter sends.
  void heard(const cia447::TripData& trip) { display_.trip = trip; }
  /// Prints the receipt with this number for the trip on the display, with this payment.
  void print_receipt(std::uint32_t number, std::string_view payment);
  /// Prints the slip of the ended shift, after a receipt that is being printed.
  void print_slip();
  /// Prints what waits; call it often.
  void step();
  /// Opens or closes the seal, for which a tool is needed.
  void open_seal(bool is_open) { is_seal_open_ = is_open; }
  /// Sets the function that is called for all that the meter records.
  void on_recorded(Callback<void(const cia447::AuditEntry&)> recorded) { recorded_ = recorded; }
  /// The unit; made again when it gets power, so keep no reference.
  cia447::TaximeterUnit& unit() { return *unit_; }
  /// The unit; made again when it gets power, so keep no reference.
  const cia447::TaximeterUnit& unit() const { return *unit_; }

 private:
  cia447::TaximeterHardware hardware();
  cia447::TaximeterSettings settings();
  FareDisplaySettings fare_display_settings();
  void is_network(cia447::CarNetwork& network, Node& node);
  void show(const cia447::TaximeterDisplay& display);
  bool seal_is_open() { return is_seal_open_; }
  void note(const cia447::AuditEntry& entry);
  MeterKeys keys_of_others();
  bool begin_calibration();
  std::optional<std::uint32_t> end_calibration(std::uint32_t metres);
  const Business& printed_business() const;
  cia447::PaperHead paper_head() const;

  car::CarBus& bus_;
  const TaxiOptions& options_;
  const Sabotage& sabotage_;
  const TownClock& town_;
  Clock clock_;
  EventLog<TaxiEvent>& events_;
  static constexpr std::uint32_t sector_size = 1024;
  KeptFlash flash_{4, sector_size};
  bool is_seal_open_ = false;
  Callback<void(const cia447::AuditEntry&)> recorded_;
  cia447::TaximeterUnit* unit_ = nullptr;
  std::optional<cia447::MeterOutputs> outputs_;
  std::string slip_{};                   ///< slip that waits to be printed
  FareDisplay* fare_display_ = nullptr;  ///< null while it has no power
  cia447::TaximeterDisplay display_;
};

}  // namespace canvoy::taxi
