// Handles of CiA 417-4 for inputs, outputs and sensors. `next_input` is the value that a PDO sends
// or receives; `input` are the inputs of the groups.
//
//     controller[cia417::next_input.function].is(BasicFunction::standard_hall_call)
//     controller[cia417::next_input.source_panel].value()          // the floor
//     panel[cia417::output.property(3, 17)] = Property::flashing;  // output 17 of group 3
//     panel[cia417::output.flash_frequency(3, 17)] = 1.5;          // Hz
//
// Write a value that consists of fields as a whole (`whole`): each write of a mapped object may
// send a PDO.
#pragma once

#include "canvoy/profiles/cia417/inputs.hpp"
#include "canvoy/profiles/cia417/outputs.hpp"
#include "canvoy/profiles/cia417/sensors.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia417 {

/// The fields of a virtual input.
template <const ObjectInfo& object, Name entry = "">
struct InputHandles {
  static constexpr Number<object, entry> whole{};  ///< all fields at once
  /// Decides what the sub-function is.
  static constexpr State<BasicFunction, object, entry, "Basic function"> function{};
  // The basic function decides which of these the sub-function is.
  static constexpr Flag<object, entry, "Hall call up"> hall_call_up{};      ///< of a hall call
  static constexpr Flag<object, entry, "Hall call down"> hall_call_down{};  ///< of a hall call
  /// Floor of a car call or destination call, 1 to 254.
  static constexpr Number<object, entry, "Target stop"> target_stop{};
  /// Of a special function.
  static constexpr State<SpecialFunction, object, entry, "Special function"> special_function{};
  /// As a number, whatever the function.
  static constexpr Number<object, entry, "Sub function"> sub_function{};
  /// A bit for each of lifts 1 to 8.
  template <unsigned lift>
  static constexpr Flag<object, entry, numbered("Source lift ", lift)> source_lift{};
  /// Floor of the panel; 0: the car.
  static constexpr Number<object, entry, "Source panel"> source_panel{};
  /// Doors 1 to 4 beside which it hangs.
  template <unsigned door>
  static constexpr Flag<object, entry, numbered("Source door ", door)> source_door{};
  /// Doors 1 to 4 at the destination.
  template <unsigned door>
  static constexpr Flag<object, entry, numbered("Dest. door ", door)> destination_door{};
  /// A request, or a defect.
  static constexpr State<CallRequest, object, entry, "Call request"> call_request{};
  static constexpr Flag<object, entry, "Lock"> lock{};  ///< with or without a locking function
};
inline constexpr InputHandles<virtual_input_mapping_object> next_input;  ///< as a PDO has it
/// Of a group: `(group, number)`.
inline constexpr InputHandles<input_group_object, "Virtual input #"> input;

/// The fields of a virtual output.
template <const ObjectInfo& object, Name entry = "">
struct OutputHandles {
  static constexpr Number<object, entry> whole{};  ///< all fields at once
  /// Decides what the sub-function is.
  static constexpr State<BasicFunction, object, entry, "Basic function"> function{};
  // The basic function decides which of these the sub-function is.
  static constexpr Flag<object, entry, "Hall call up"> hall_call_up{};      ///< of a hall call
  static constexpr Flag<object, entry, "Hall call down"> hall_call_down{};  ///< of a hall call
  /// Floor of an acknowledged call.
  static constexpr Number<object, entry, "Target stop acknowledgement"> target_stop{};
  /// Of an acknowledged special function.
  static constexpr State<SpecialFunction, object, entry, "Special function acknowledgement">
      special_function{};
  static constexpr Number<object, entry, "Floor data"> floor_data{};  ///< of a position indicator
  static constexpr Flag<object, entry, "Up"> up{};                    ///< of a direction indicator
  static constexpr Flag<object, entry, "Down"> down{};                ///< of a direction indicator
  static constexpr Flag<object, entry, "Right"> right{};              ///< of a direction indicator
  static constexpr Flag<object, entry, "Left"> left{};                ///< of a direction indicator
  /// Of a direction indicator: the car moves.
  static constexpr Flag<object, entry, "Moving"> moving{};
  /// Of a special indication.
  static constexpr State<SpecialIndication, object, entry, "Special indication">
      special_indication{};
  /// As a number, whatever the function.
  static constexpr Number<object, entry, "Sub-function"> sub_function{};
  /// A bit for each of lifts 1 to 8.
  template <unsigned lift>
  static constexpr Flag<object, entry, numbered("Destination lift ", lift)> destination_lift{};
  /// Floor of the panel; 0: the car.
  static constexpr Number<object, entry, "Destination panel"> destination_panel{};
  /// Buttons of doors 1 to 4.
  template <unsigned door>
  static constexpr Flag<object, entry, numbered("Dest. button ", door)> destination_button{};
  /// Doors 1 to 4.
  template <unsigned door>
  static constexpr Flag<object, entry, numbered("Dest. door ", door)> destination_door{};
  static constexpr Flag<object, entry, "Status"> status{};  ///< on or off
  /// How it is shown; decides its parameter.
  static constexpr State<Property, object, entry, "Property"> property{};
  // The property decides which of these its parameter is.
  static constexpr Quantity<object, entry, "Impulse"> impulse_time{};  ///< duration of an impulse
  static constexpr Quantity<object, entry, "Flashing"> flash_frequency{};  ///< of a flashing output
  static constexpr State<Color, object, entry, "Color"> color{};           ///< of a coloured output
  static constexpr Number<object, entry, "Volume"> volume{};              ///< of an acoustic output
  static constexpr Quantity<object, entry, "Scroll rate"> scroll_rate{};  ///< of a scrolling text
  static constexpr Flag<object, entry, "Predicate">
      predicate{};  ///< the acknowledgement is affirmed
};
inline constexpr OutputHandles<virtual_output_mapping_object> next_output;  ///< as a PDO has it
/// Of a group: `(group, number)`.
inline constexpr OutputHandles<output_group_object, "Virtual output #"> output;

/// The fields of a virtual sensor.
template <const ObjectInfo& object, Name entry = "">
struct SensorHandles {
  static constexpr Number<object, entry> whole{};  ///< all fields at once
  /// What it senses.
  static constexpr State<SensorFunction, object, entry, "Basic function"> function{};
  /// A bit for each of lifts 1 to 8.
  template <unsigned lift>
  static constexpr Flag<object, entry, numbered("Source lift ", lift)> source_lift{};
  /// Floor of the sensor; 0: the car.
  static constexpr Number<object, entry, "Source floor"> source_floor{};
  /// 80h and above are the maker's.
  static constexpr Number<object, entry, "Source position"> source_position{};
  /// State of a sensor with two of them.
  static constexpr State<SensorSignal, object, entry, "Sensor signal"> signal{};
  static constexpr Number<object, entry, "Sensor value"> value{};  ///< of a sensor with a number
};
inline constexpr SensorHandles<virtual_sensor_mapping_object> next_sensor;  ///< as a PDO has it
/// Of a group: `(group, number)`.
inline constexpr SensorHandles<sensor_group_object, "Virtual sensor #"> sensor;

// Parameters. Input 17 of group 3 is `input_enabled(3, 17)`.

inline constexpr Flag<input_parameter_1_object, "Parameter 1 input #", "Enable"> input_enabled;
inline constexpr Number<input_parameter_1_object, "Parameter 1 input #", "Error code">
    input_error_code;
inline constexpr Quantity<input_parameter_2_object, "Parameter 2 input #", "Limitation">
    input_limitation;
inline constexpr Quantity<input_parameter_2_object, "Parameter 2 input #", "Sending event">
    input_sending_event;
inline constexpr Quantity<input_parameter_3_object, "Parameter 3 input #", "Debounce time">
    input_debounce_time;
inline constexpr Flag<input_parameter_3_object, "Parameter 3 input #", "LH edge"> input_lh_edge;
inline constexpr Flag<input_parameter_3_object, "Parameter 3 input #", "HL edge"> input_hl_edge;
inline constexpr Flag<input_parameter_3_object, "Parameter 3 input #", "Polarity"> input_inverted;
inline constexpr Number<input_parameter_4_object, "Parameter 4 input #"> input_parameter_4_value;

inline constexpr Flag<output_parameter_1_object, "Parameter 1 output #", "Enable"> output_enabled;
inline constexpr Number<output_parameter_1_object, "Parameter 1 output #", "Error code">
    output_error_code;
inline constexpr Number<output_parameter_1_object, "Parameter 1 output #", "Default value">
    output_default_value;
inline constexpr Quantity<output_parameter_2_object, "Parameter 2 output #", "Limitation">
    output_limitation;
inline constexpr Number<output_parameter_2_object, "Parameter 2 output #", "Reception event">
    output_reception_event;
inline constexpr Quantity<output_parameter_2_object, "Parameter 2 output #", "Impulse time">
    output_impulse_time;
inline constexpr Flag<output_parameter_3_object, "Parameter 3 output #", "Polarity">
    output_inverted;
inline constexpr Quantity<output_parameter_4_object, "Parameter 4 output #", "Flash rate">
    output_flash_rate;
inline constexpr Quantity<output_parameter_4_object, "Parameter 4 output #", "Scroll rate">
    output_scroll_rate;
inline constexpr Number<output_parameter_4_object, "Parameter 4 output #", "Color"> output_color;
inline constexpr Number<output_parameter_4_object, "Parameter 4 output #", "Intensity/Volume">
    output_intensity;

inline constexpr Flag<sensor_parameter_1_object, "Parameter 1 sensor #", "Enable"> sensor_enabled;
inline constexpr Number<sensor_parameter_1_object, "Parameter 1 sensor #", "Error code">
    sensor_error_code;
inline constexpr Quantity<sensor_parameter_2_object, "Parameter 2 sensor #", "Limitation">
    sensor_limitation;
inline constexpr Quantity<sensor_parameter_2_object, "Parameter 2 sensor #", "Sending event">
    sensor_sending_event;
inline constexpr Quantity<sensor_parameter_3_object, "Parameter 3 sensor #", "Debounce time">
    sensor_debounce_time;
inline constexpr Flag<sensor_parameter_3_object, "Parameter 3 sensor #", "LH edge"> sensor_lh_edge;
inline constexpr Flag<sensor_parameter_3_object, "Parameter 3 sensor #", "HL edge"> sensor_hl_edge;
inline constexpr Flag<sensor_parameter_3_object, "Parameter 3 sensor #", "Polarity">
    sensor_inverted;
inline constexpr Number<sensor_parameter_3_object, "Parameter 3 sensor #", "SI unit">
    sensor_si_unit;
inline constexpr Number<sensor_parameter_3_object, "Parameter 3 sensor #", "Prefix"> sensor_prefix;

}  // namespace canvoy::cia417
