// The passenger counting manager: adds up the results of the counters at all doors (6700h), reports
// the number of passengers and the occupancy of the vehicle, and keeps the counts of each stop with
// the line (6720h to 6723h; CiA 407, 6.22, 9.2.26).
//
//     CountingManagerUnit manager(device, {}, {.capacity = 80});
//
// Each write of 6700h is the result of one door. Counts outlive NMT resets, as passengers stay on
// board. 6720h is a record of 24 bytes for each of the last 128 stops, the oldest first: the six
// bytes of 610Eh; 6192h, 6193h, 6191h, 6109h; 6108h and a zero; in, out.
#pragma once

#include <array>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/file_shelf.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The vehicle's size.
struct CountingManagerSettings {
  unsigned capacity = 80;        ///< maximum number of passengers, at least 1
  unsigned close_percent = 90;   ///< from this share on, the car is nearly full
  unsigned limit_percent = 100;  ///< from this share on, the car is full
};

class CountingManagerUnit {
 public:
  static constexpr std::size_t record_size = 24;   ///< bytes of the record of one stop
  static constexpr std::size_t records_max = 128;  ///< the newest are kept

  /// Makes the unit; `device` must outlive it.
  CountingManagerUnit(VirtualDevice& device, const NoHardware& hardware,
                      const CountingManagerSettings& settings);

  /// Counts of the day.
  struct Counts {
    std::uint16_t in = 0;   ///< passengers
    std::uint16_t out = 0;  ///< passengers
    unsigned aboard = 0;    ///< passengers at present

    friend constexpr bool operator==(const Counts&, const Counts&) = default;
  };

  /// Passengers at present.
  unsigned aboard() const { return counts_.aboard; }
  /// Counts at present.
  Counts counts() const { return counts_; }
  /// Restores the counts that a memory has kept over a loss of power.
  void restore(const Counts& counts) {
    counts_ = counts;
    tell();
  }
  /// Sets all counts to 0 at the beginning of a day with an empty car. The records stay.
  void clear();

 private:
  static const AccessHandlers hook_calls[];

  using Record = std::array<std::uint8_t, record_size>;

  void reset(ResetScope scope);
  void counts_written();
  void stop_point_written();
  void take(std::uint8_t in, std::uint8_t out);
  void tell();
  void note(std::uint8_t in, std::uint8_t out);
  Record& last_record() { return records_[(records_made_ - 1) % records_max]; }
  Record& open_record();
  Result<std::uint32_t> open_read(const Entry& entry);
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset, std::span<std::uint8_t> bytes);

  VirtualDevice& device_;
  CountingManagerSettings settings_;
  Counts counts_;
  std::array<Record, records_max> records_{};
  std::size_t records_made_ = 0;
  bool is_stop_open_ = false;
  Domain domain_;
  Hook hook_;
};

/// Catalogue row of the passenger counting manager (6.22); bus_unit makes it a part of a device.
struct CountingManagerKind : BusKind<CountingManagerUnit, NoHardware, CountingManagerSettings> {
  static constexpr DeviceInfo info = {.name = "passenger-counting-manager",
                                      .title = "passenger counting manager of a car",
                                      .product = "Canvoy CiA 407 counting manager",
                                      .product_code = 40721,
                                      .node_id = 21};
  static constexpr const VirtualDeviceInfo& provides = passenger_counting_manager;
  static constexpr std::array pdos = {own_pdo<event_tpdo>,      own_pdo<aboard_tpdo>,
                                      own_pdo<command_rpdo>,    own_pdo<doors_rpdo>,
                                      own_pdo<door_count_rpdo>, own_pdo<door_count_rpdo>,
                                      own_pdo<door_count_rpdo>, own_pdo<door_count_rpdo>};
};

}  // namespace canvoy::cia407
