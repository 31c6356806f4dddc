// Inputs, outputs and sensors in groups beyond the first: their records, their
// parameters and their messages (CiA 417-4, 4.3.1, 4.4.1 and 4.13.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/output_panel_device.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"

namespace canvoy::cia417::panel_groups_test {
namespace {

constexpr std::uint16_t all_of_a_lift = 32 * 254;
constexpr std::uint32_t last = all_of_a_lift - 1;  ///< sub-index FEh of group 32

/// By SDO; whether it was confirmed.
bool write(Cable& cable, std::string_view request) {
  cable.send("615#" + std::string(request));
  return cable.last(0x595).starts_with("595#60");
}
/// PDO 1 of node 21 carries the 48 bits of an object; then the node is made operational.
void start(Cable& cable, std::string_view mapping, std::string_view object,
           std::string_view parameters) {
  cable.start_all();
  EXPECT_TRUE(write(cable, "23 " + std::string(parameters) + " 80")) << "invalid";
  EXPECT_TRUE(write(cable, "23 " + std::string(mapping) + " 01 30 00 " + std::string(object)));
  EXPECT_TRUE(write(cable, "2F " + std::string(mapping) + " 00 01 00 00 00"));
  EXPECT_TRUE(write(cable, "23 " + std::string(parameters) + " 00"));
  cable.send("000#01 15");
  cable.run_for(1s);
}
std::size_t told(const Cable& cable, std::uint32_t can_id, std::string_view record) {
  return static_cast<std::size_t>(std::ranges::count_if(cable.heard, [&](const auto& heard) {
    return heard.frame.id == can_id && wire_text(heard.frame).substr(4) == record;
  }));
}

/// A small panel, which has all groups of another virtual device besides.
template <class... Objects>
constexpr auto panel_with(const Objects&... objects) {
  DeviceDescription<40> parts;
  parts.add(panel<PanelOptions{.outputs = 1, .parameters = false}>());
  parts.add(cia301::identity({}));
  (parts.add(objects), ...);
  return parts;
}

constexpr auto all_inputs = panel_with(
    virtual_input_mapping_object, input_group_object, input_parameter_1_object,
    input_parameter_2_object, input_parameter_3_object, cia301::tpdo({.number = 1, .entries = 1}));
constexpr auto all_inputs_layout = partial(lay_out_device<all_inputs>());

TEST(PanelGroups, TheLastInputOfGroup32HasItsParameters) {
  std::vector<VirtualInput> inputs(all_of_a_lift);
  inputs.back() = {.function = BasicFunction::generic, .lifts = lift_bit(1), .floor = 254};
  Cable cable;
  const auto device = std::make_unique<InputPanelDevice<all_inputs_layout>>(
      cable.port(0), NodeId{21}, InputPanelSettings{.inputs = inputs});
  cable.connect(0, device->node());
  start(cable, "00 1A", "10 60", "00 18 01 95 04 00");
  const auto change = [&](bool high) {
    device->unit().set_level(last, high, cable.now);
    cable.run_for(20ms);
  };
  EXPECT_TRUE(write(cable, "23 7F 61 FE 14 83 FF FF")) << "20 ms, inverted";
  EXPECT_EQ(device->node().dictionary().number(0x611F, 254), 0x0100'FE01'0001u);
  cable.clear();
  change(true);
  EXPECT_EQ(told(cable, 0x495, "01 00 01 FE 00 00"), 1u);
  EXPECT_TRUE(write(cable, "23 5F 61 FE FF FF 02 FF")) << "two events";
  change(false);
  EXPECT_EQ(told(cable, 0x495, "01 00 01 FE 00 01"), 0u);
  change(true);
  EXPECT_EQ(told(cable, 0x495, "01 00 01 FE 00 00"), 2u);
  EXPECT_TRUE(write(cable, "23 3F 61 FE FE FF FF FF")) << "disabled";
  cable.clear();
  change(false);
  change(true);
  change(false);
  EXPECT_EQ(cable.count(0x495), 0u);
  EXPECT_FALSE(write(cable, "23 3F 61 FF FF FF FF FF")) << "there are 254";
}

/// As many as in one of our descriptions: four groups.
constexpr std::uint16_t four_groups = 4 * 254;
constexpr auto many_outputs =
    describe(panel<PanelOptions{.outputs = four_groups}>(), cia301::identity({}));
constexpr auto many_outputs_layout = partial(lay_out_device<many_outputs>());

TEST(PanelGroups, TheLastOutputOfGroup4HasItsParameters) {
  std::vector<VirtualOutput> outputs(four_groups);
  outputs.back() = {
      .function = BasicFunction::standard_car_call, .sub_function = 254, .lifts = lift_bit(1)};
  OutputView shown;
  auto show = [&](std::uint32_t output, const OutputView& view) {
    if (output == four_groups - 1) shown = view;
  };
  Cable cable;
  const auto device = std::make_unique<OutputPanelDevice<many_outputs_layout>>(
      cable.port(0), NodeId{21},
      OutputHardware{.show = Callback<void(std::uint32_t, const OutputView&)>::of(show)},
      OutputPanelSettings{.outputs = outputs});
  cable.connect(0, device->node());
  cable.start_all();
  cable.send("000#01 15");
  cable.send("400#05 FE 01 00 00 01");
  EXPECT_TRUE(shown.on);
  EXPECT_EQ(device->node().dictionary().number(0x6203, 254), 0x0100'0001'FE05u);
  EXPECT_TRUE(write(cable, "23 63 62 FE FF 80 FF FF")) << "inverted";
  EXPECT_FALSE(shown.level());
  EXPECT_TRUE(write(cable, "23 83 62 FE 14 FF FF FF"));
  EXPECT_EQ(shown.flash_millihertz, 2000);
  EXPECT_TRUE(write(cable, "23 43 62 FE FF FF FF 05")) << "half a second";
  cable.send("400#05 FE 01 00 00 01");
  cable.run_for(499ms);
  EXPECT_TRUE(shown.on);
  cable.run_for(1ms);
  EXPECT_FALSE(shown.on);
  EXPECT_TRUE(write(cable, "23 23 62 FE FE FF FF FF")) << "disabled";
  cable.send("400#05 FE 01 00 00 01");
  EXPECT_FALSE(shown.on);
}

constexpr auto all_sensors =
    panel_with(virtual_sensor_mapping_object, sensor_group_object, sensor_parameter_1_object,
               sensor_parameter_2_object, sensor_parameter_3_object,
               cia301::tpdo({.number = 1, .entries = 1}));
constexpr auto all_sensors_layout = partial(lay_out_device<all_sensors>());

TEST(PanelGroups, TheLastSensorOfGroup32HasItsParameters) {
  std::vector<VirtualSensor> sensors(all_of_a_lift);
  sensors.back() = {
      .function = SensorFunction::pressure, .lifts = lift_bit(1), .floor = 254, .position = 0x81};
  Cable cable;
  using Device = SensorUnitDevice<1, LiftDeviceOptions{}, all_sensors_layout>;
  const auto device =
      std::make_unique<Device>(cable.port(0), NodeId{21}, SensorSettings{.sensors = sensors});
  cable.connect(0, device->node());
  start(cable, "00 1A", "12 60", "00 18 01 95 03 00");
  cable.clear();
  device->unit().set_value(last, -2, cable.now);
  cable.run_for(0ms);
  EXPECT_EQ(told(cable, 0x395, "05 01 FE 81 F8 FF"), 1u) << "-2, of the unit";
  EXPECT_EQ(device->node().dictionary().number(0x651F, 254), 0xFFF8'81FE'0105u);
  EXPECT_TRUE(write(cable, "23 7F 65 FE 0A FF FF FF")) << "10 ms";
  device->unit().set_level(last, true, cable.now);
  cable.run_for(9ms);
  EXPECT_EQ(told(cable, 0x395, "05 01 FE 81 F9 FF"), 0u);
  cable.run_for(1ms);
  EXPECT_EQ(told(cable, 0x395, "05 01 FE 81 F9 FF"), 1u);
  EXPECT_TRUE(write(cable, "23 3F 65 FE FE FF FF FF")) << "disabled";
  cable.run_for(0ms);
  EXPECT_EQ(told(cable, 0x395, "05 01 FE 81 F8 FF"), 2u) << "no signal any longer";
  EXPECT_FALSE(write(cable, "23 5F 65 FE FF 00 FF FF")) << "no events are reserved";
}

}  // namespace
}  // namespace canvoy::cia417::panel_groups_test
