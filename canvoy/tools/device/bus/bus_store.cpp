#include "canvoy/tools/device/bus/bus_store.hpp"

#include <array>
#include <bit>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t bus_sector_size = 4096;
/// Two each for the node-ID and for the values.
constexpr std::uint32_t bus_sectors = 4;
constexpr RecordPair::Place bus_values_place = {
    .address = 2 * bus_sector_size, .slot_size = bus_sector_size, .kind = 0x5653'5542};  // "BUSV"

/// The numbers of KeptBusValues, eight bytes each.
using BusNumbers = std::array<std::uint64_t, 11>;
using BusNumberBytes = std::array<std::uint8_t, sizeof(BusNumbers)>;

}  // namespace

BusStore::BusStore(const std::string& path)
    : file_(value_or_throw(
          host::FileFlash::open(path, {.sector_size = bus_sector_size, .sectors = bus_sectors}))),
      values_(file_->flash(), bus_values_place) {}

LssStore::Place BusStore::lss_place() const {
  return {.address = 0, .slot_size = bus_sector_size};
}

KeptBusValues BusStore::load() {
  BusNumberBytes bytes;
  if (!values_.load(bytes)) return {};
  BusNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers.at(i) = canvoy::load<std::uint64_t>(&bytes.at(i * sizeof(std::uint64_t)));
  }
  KeptBusValues values{.assignment = {.driver_id = static_cast<std::uint32_t>(numbers[0]),
                                      .destination_number = static_cast<std::uint32_t>(numbers[1]),
                                      .line_id = static_cast<std::uint16_t>(numbers[2]),
                                      .route_number = static_cast<std::uint16_t>(numbers[3]),
                                      .block_id = static_cast<std::uint32_t>(numbers[4]),
                                      .journey_number = static_cast<std::uint16_t>(numbers[5])},
                       .metres = std::bit_cast<double>(numbers[6]),
                       .trip_begin = std::bit_cast<double>(numbers[7]),
                       .counts = {.in = static_cast<std::uint16_t>(numbers[8]),
                                  .out = static_cast<std::uint16_t>(numbers[9]),
                                  .aboard = static_cast<unsigned>(numbers[10])}};
  return values;
}

void BusStore::keep(const KeptBusValues& values) {
  const cia407::Assignment& drives = values.assignment;
  const BusNumbers numbers = {drives.driver_id,
                              drives.destination_number,
                              drives.line_id,
                              drives.route_number,
                              drives.block_id,
                              drives.journey_number,
                              std::bit_cast<std::uint64_t>(values.metres),
                              std::bit_cast<std::uint64_t>(values.trip_begin),
                              values.counts.in,
                              values.counts.out,
                              values.counts.aboard};
  BusNumberBytes bytes;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    store(&bytes.at(i * sizeof(std::uint64_t)), numbers.at(i));
  }
  values_.keep(bytes);
}

}  // namespace canvoy::tools
