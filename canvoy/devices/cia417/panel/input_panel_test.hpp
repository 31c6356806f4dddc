// Panels for tests: a landing with call buttons on a cable.
//
//     PanelBench bench;
//     bench.start();
//     bench.press(0);
//     EXPECT_EQ(bench.told(), (Records{"02 01 01 03 10 01"}));
#pragma once

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"

namespace canvoy::cia417 {

using Records = std::vector<std::string>;

/// Up and down at landing 3 of lift 1, a key for fire service, a car call for floor 7.
inline constexpr VirtualInput bench_inputs[] = {
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_up,
     .lifts = lift_bit(1),
     .floor = 3,
     .doors = source_door(1)},
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_down,
     .lifts = lift_bit(1),
     .floor = 3,
     .doors = source_door(1)},
    {.function = BasicFunction::special_function,
     .sub_function = sub_function_of(SpecialFunction::fire_service),
     .lifts = lift_bit(1),
     .floor = 3,
     .data = VirtualInput::lock_bit},
    {.function = BasicFunction::standard_car_call,
     .sub_function = 7,
     .lifts = lift_bit(1),
     .floor = floor_of_car,
     .doors = destination_door(1)}};

inline constexpr auto bench_panel = describe(panel<PanelOptions{.inputs = 4}>(),
                                             cia301::identity({}), cia301::heartbeat_producer(0));
inline constexpr auto bench_panel_layout = lay_out_device<bench_panel>();

/// Node 21 (15h): its records come with CAN-ID 495h.
template <const auto& layout = bench_panel_layout, std::size_t queue_max = 16>
class PanelBench {
 public:
  explicit PanelBench(std::span<const VirtualInput> inputs = bench_inputs)
      : panel(cable.port(0), 21, {.inputs = inputs}) {
    cable.connect(0, panel.node());
  }

  /// Runs up to NMT state operational, and discards the frames sent until then.
  void start() {
    cable.start_all();
    cable.send("000#01 15");
    cable.run_for(10ms);
    cable.clear();
  }
  void level(std::uint32_t input, bool high) {
    panel.unit().set_level(input, high, cable.now);
    cable.run_for(0ms);
  }
  void press(std::uint32_t input) { level(input, true); }
  void release(std::uint32_t input) { level(input, false); }
  void report(std::uint32_t input, CallRequest condition, std::uint8_t error_code = 0xFF) {
    panel.unit().report(input, condition, cable.now, error_code);
    cable.run_for(0ms);
  }
  /// Writes by SDO; returns true if it was confirmed.
  bool write(std::string_view request) {
    cable.send("615#" + std::string(request));
    return cable.last(0x595).starts_with("595#60");
  }

  /// From here on, the bus takes a record every 100 ms, the first one in 100 ms.
  void hold_up() {
    write("23 81 18 01 95 04 00 80");
    write("2B 81 18 03 E8 03 00 00");
    write("23 81 18 01 95 04 00 00");
    cable.clear();
  }

  /// The records since the last call, as transferred.
  Records told() {
    Records records;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == 0x495) records.push_back(wire_text(heard.frame).substr(4));
    }
    cable.clear();
    return records;
  }
  /// The records since the last call, with their times in microseconds.
  Records reported_at() {
    Records records;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id != 0x495) continue;
      records.push_back(std::to_string(heard.at.time_since_epoch().count()) + " " +
                        wire_text(heard.frame).substr(4));
    }
    cable.clear();
    return records;
  }
  std::uint64_t stored(unsigned index, unsigned sub) const {
    return panel.node().dictionary().number(static_cast<std::uint16_t>(index),
                                            static_cast<std::uint8_t>(sub));
  }

  Cable cable;
  InputPanelDevice<layout, queue_max> panel;
};

}  // namespace canvoy::cia417
