// Lamps and displays for tests: the outputs of a landing on a cable, and their states.
//
//     OutputBench bench;
//     bench.start();
//     bench.tell("02 01 01 03 10 01");
//     EXPECT_TRUE(bench.view(0).on);
#pragma once

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/output_panel_device.hpp"

namespace canvoy::cia417 {

/// At landing 3 of lift 1: call lamps up and down; position, lantern, all special indications, the
/// one of overload, and a gong.
inline constexpr VirtualOutput bench_outputs[] = {
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_up,
     .lifts = lift_bit(1),
     .floor = 3,
     .doors = output_door(1)},
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_down,
     .lifts = lift_bit(1),
     .floor = 3,
     .doors = output_door(1)},
    {.function = BasicFunction::position_indicator, .lifts = lift_bit(1), .floor = 3},
    {.function = BasicFunction::hall_lantern, .lifts = lift_bit(1), .floor = 3},
    {.function = BasicFunction::special_indication, .lifts = lift_bit(1), .floor = 3},
    {.function = BasicFunction::special_indication,
     .sub_function = sub_function_of(SpecialIndication::overload),
     .lifts = lift_bit(1),
     .floor = 3},
    {.function = BasicFunction::arrival_indication, .lifts = lift_bit(1), .floor = 3}};

inline constexpr auto bench_lamps =
    describe(panel<PanelOptions{.outputs = 7}>(), cia301::identity({}));
inline constexpr auto bench_lamps_layout = partial(lay_out_device<bench_lamps>());

class OutputBench {
 public:
  OutputBench() { cable.connect(0, panel.node()); }

  /// Runs up to NMT state operational.
  void start() {
    cable.start_all();
    cable.send("000#01 15");
    shown.clear();
  }
  /// Sends a record in the PDO.
  void tell(std::string_view record) { cable.send("400#" + std::string(record)); }
  /// Writes by SDO; returns true if it was confirmed.
  bool write(std::string_view request) {
    cable.send("615#" + std::string(request));
    return cable.last(0x595).starts_with("595#60");
  }
  /// Three segments: 48 bits do not fit into one frame.
  bool write_record(std::string_view object, std::string_view record) {
    cable.send("615#21 " + std::string(object) + " 06 00 00 00");
    cable.send("615#03 " + std::string(record) + " 00");
    return cable.last(0x595).starts_with("595#20");
  }
  void run_for(Duration time) { cable.run_for(time); }

  /// The last state shown by the hardware.
  const OutputView& view(std::uint32_t output) const { return views[output]; }
  bool is_on(std::uint32_t output) const { return views[output].on; }
  /// The outputs that are on: bit 0 is the first.
  unsigned on() const {
    unsigned mask = 0;
    for (unsigned i = 0; i < views.size(); ++i) mask |= views[i].on ? 1U << i : 0U;
    return mask;
  }
  std::uint64_t stored(unsigned index, unsigned sub) const {
    return panel.node().dictionary().number(static_cast<std::uint16_t>(index),
                                            static_cast<std::uint8_t>(sub));
  }

  Cable cable;
  std::array<OutputView, 7> views{};
  std::vector<std::uint32_t> shown;  ///< outputs shown by the hardware, in their order
  OutputPanelDevice<bench_lamps_layout> panel{
      cable.port(0), 21, {.show = callback<&OutputBench::show>(*this)}, {.outputs = bench_outputs}};

 private:
  void show(std::uint32_t output, const OutputView& view) {
    views[output] = view;
    shown.push_back(output);
  }
};

}  // namespace canvoy::cia417
