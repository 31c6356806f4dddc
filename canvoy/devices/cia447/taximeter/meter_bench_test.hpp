// A taximeter alone on a cable, with a car that turns its wheels, a clock, a seal and a driver: for
// wire tests of taximeter_unit.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447 {

class MeterBench {
 public:
  static constexpr SimulatedFlash::Geometry geometry = {
      .sector_size = 512, .sectors = 2, .unit = 8};
  /// Monday 2026-11-23 12:00:00.
  static constexpr std::int64_t noon = 1'795'435'200;
  /// PDO 80 is the 26th of the list: 380h + 25 of node 5.
  static constexpr std::uint32_t status_pdo = 0x399;

  explicit MeterBench(const TaximeterSettings& wanted = {}, SimulatedFlash* flash = nullptr,
                      std::optional<std::int64_t> local = noon)
      : settings(wanted), memory(flash), local_at_start(local) {
    bench.emplace(only_unit<TaximeterKind>, [this](Environment& environment) {
      environment.provide(callback<&MeterBench::offered_settings>(*this));
      environment.provide(callback<&MeterBench::hardware>(*this));
      environment.watch(callback<&MeterBench::made>(*this));
    });
  }
  MeterBench(const MeterBench&) = delete;
  MeterBench& operator=(const MeterBench&) = delete;

  Cable& cable() { return bench->cable; }
  std::string ask(const std::string& request) { return bench->ask(request); }
  /// The answer to an SDO request of a client on its mesh channel.
  std::string ask_as(unsigned client, const std::string& request) {
    return bench->ask_as(client, request);
  }
  /// The number in an entry, read by SDO.
  std::uint64_t get(std::uint16_t index, unsigned sub = 0) {
    char request[32];
    std::snprintf(request, sizeof request, "40 %02X %02X %02X 00 00 00 00", index & 0xFF,
                  index >> 8, sub);
    const std::string answer = ask(request);
    if (answer.size() != 23 || answer[0] != '4') return 0xDEAD'DEAD'DEAD;
    const unsigned unused =
        static_cast<unsigned>(std::stoul(answer.substr(0, 2), nullptr, 16)) >> 2 & 3;
    std::uint64_t number = 0;
    for (unsigned byte = 0; byte < 4 - unused; ++byte) {
      number |= std::uint64_t{std::stoul(answer.substr(12 + 3 * byte, 2), nullptr, 16)} << 8 * byte;
    }
    return number;
  }

  /// A frame with 6050h, 6053h and 6055h; from node 1, the gateway, by default.
  void send_count(unsigned count, unsigned valid = 1, unsigned rpm = 0xFFFF,
                  const char* id = "187") {
    char frame[48];
    std::snprintf(frame, sizeof frame, "%s#00 00 %02X %02X %02X %02X %02X", id, rpm & 0xFF,
                  rpm >> 8, count & 0xFF, count >> 8 & 0xFF, 0xFC | valid);
    cable().send(frame);
  }
  /// Sends a tenth of the pulses every 100 ms, with a counter that overruns at `highest`.
  void drive(unsigned seconds_to_drive, unsigned pulses_a_second) {
    for (unsigned cycle = 0; cycle < seconds_to_drive * 10; ++cycle) {
      cable().run_for(100ms);
      turned += pulses_a_second / 10;
      send_count(turned % (highest + 1));
    }
  }
  /// The first value only sets the start of counting.
  void begin_shift() {
    send_count(turned % (highest + 1));
    EXPECT_TRUE(meter->sign_on());
  }
  void set_clock(const CivilTime& local) {
    local_at_start =
        seconds_since_1970(local) -
        std::chrono::floor<std::chrono::seconds>(cable().now.time_since_epoch()).count();
  }

  TaximeterSettings settings;
  SimulatedFlash* memory;
  std::optional<std::int64_t> local_at_start;
  std::int32_t utc_offset = 3600;
  bool seal_is_open = false;
  bool is_off = false;
  TaximeterDisplay display;
  unsigned turned = 65'000;
  unsigned highest = 0xFFFF;
  TaximeterUnit* meter = nullptr;
  std::optional<CarBench> bench;

 private:
  TaximeterSettings offered_settings() { return settings; }
  TaximeterHardware hardware() {
    return {.clock = callback<&MeterBench::clock>(*this),
            .seal_is_open = callback<&MeterBench::seal>(*this),
            .show = callback<&MeterBench::show>(*this),
            .turned_off = callback<&MeterBench::turned_off>(*this),
            .flash = memory == nullptr ? nullptr : &memory->flash};
  }
  void made(TaximeterUnit& unit, Node& node) {
    meter = &unit;
    node_ = &node;
  }
  std::optional<LocalTime> clock() {
    if (!local_at_start) return std::nullopt;
    const auto since_start =
        std::chrono::floor<std::chrono::seconds>(node_->now().time_since_epoch()).count();
    return LocalTime{*local_at_start + since_start, utc_offset};
  }
  bool seal() { return seal_is_open; }
  void show(const TaximeterDisplay& shown) { display = shown; }
  void turned_off() { is_off = true; }

  Node* node_ = nullptr;
};

}  // namespace canvoy::cia447
