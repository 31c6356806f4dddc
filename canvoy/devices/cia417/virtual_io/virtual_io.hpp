// Virtual inputs, outputs and sensors of a lift as values: records of 48 bits in the mapping
// objects 6010h, 6011h and 6012h and in the groups (CiA 417-4, 4.3.1, 4.4.1 and 4.13.1). They own
// nothing and cost as much as six bytes.
//
//     const VirtualInput button = {.function = BasicFunction::standard_hall_call,
//                                  .sub_function = hall_up, .lifts = lift_bit(1),
//                                  .floor = 3, .doors = source_door(1)};
//     dictionary.set_number(0x6100, 1, encode(button));
//     const VirtualInput came = decode_input(dictionary.number(0x6010, 0));
#pragma once

#include <cstdint>

#include "canvoy/profiles/cia417/outputs.hpp"
#include "canvoy/profiles/cia417/sensors.hpp"

namespace canvoy::cia417 {

/// The bit of a lift in lift masks and in 6001h; `lift` is 1 to 8.
constexpr std::uint8_t lift_bit(unsigned lift) {
  return static_cast<std::uint8_t>(1U << (lift - 1));
}
inline constexpr std::uint8_t all_lifts = 0xFF;  ///< a bit each

// Floors of records: 1 to 254, and two special values.

inline constexpr std::uint8_t floor_of_car = 0x00;  ///< a panel inside the car
inline constexpr std::uint8_t all_floors = 0xFF;    ///< for outputs: those of all landings

// Doors of records, from 1 to 4. The upper half is the door of the panel, the lower half the door
// of the exit: for inputs the destination door, for outputs the column of buttons that refers to
// it.

/// Bit of door 1 to 4 as the place of a panel.
constexpr std::uint8_t source_door(unsigned door) {
  return static_cast<std::uint8_t>(1U << (door + 3));
}
/// Bit of door 1 to 4 as the door that is wanted.
constexpr std::uint8_t destination_door(unsigned door) {
  return static_cast<std::uint8_t>(1U << (door - 1));
}
/// For an output: the door of the panel, and the column of its buttons.
constexpr std::uint8_t output_door(unsigned door) {
  return source_door(door);
}
/// The mask of doors, door 1 in bit 0, from the upper and from the lower half.
constexpr std::uint8_t source_doors(std::uint8_t doors) {
  return static_cast<std::uint8_t>(doors >> 4);
}
/// Doors that are wanted, as a mask of doors.
constexpr std::uint8_t destination_doors(std::uint8_t doors) {
  return doors & 0x0F;
}
/// The inverse, into the upper half.
constexpr std::uint8_t at_doors(std::uint8_t doors) {
  return static_cast<std::uint8_t>(doors << 4);
}

// Sub-functions of hall calls, one bit each.

inline constexpr std::uint8_t hall_up = 0x01;                         ///< the call goes up
inline constexpr std::uint8_t hall_down = 0x02;                       ///< the call goes down
inline constexpr std::uint8_t hall_undirected = hall_up | hall_down;  ///< a button for both

// Sub-functions of hall lanterns, direction and arrival indications, one bit each. An arrival has
// only up or down.

inline constexpr std::uint8_t arrow_up = 0x01;      ///< sub-function of the direction indicators
inline constexpr std::uint8_t arrow_down = 0x02;    ///< sub-function of the direction indicators
inline constexpr std::uint8_t arrow_right = 0x04;   ///< sub-function of the direction indicators
inline constexpr std::uint8_t arrow_left = 0x08;    ///< sub-function of the direction indicators
inline constexpr std::uint8_t arrow_moving = 0x10;  ///< added to the direction

/// Sub-function of basic function 0Eh.
constexpr std::uint8_t sub_function_of(SpecialFunction function) {
  return static_cast<std::uint8_t>(function);
}
/// Sub-function of the special indications.
constexpr std::uint8_t sub_function_of(SpecialIndication indication) {
  return static_cast<std::uint8_t>(indication);
}

// Meaning of the sub-function for a basic function, the same for inputs and outputs.

/// True from `first` to `last`, both included.
constexpr bool is_between(BasicFunction function, BasicFunction first, BasicFunction last) {
  return function >= first && function <= last;
}
/// True for basic functions 02h to 04h.
constexpr bool is_hall_call(BasicFunction function) {
  return is_between(function, BasicFunction::standard_hall_call,
                    BasicFunction::high_priority_hall_call);
}
/// True if the sub-function is a target stop.
constexpr bool has_target_stop(BasicFunction function) {
  return is_between(function, BasicFunction::standard_car_call,
                    BasicFunction::high_priority_call_to_destination_floor);
}
/// True for functions of the maker.
constexpr bool is_manufacturer_specific(BasicFunction function) {
  return function >= BasicFunction::manufacturer_first;
}

/// A button, key or contact (4.3.1).
struct VirtualInput {
  BasicFunction function = BasicFunction::none;  ///< basic function
  std::uint8_t sub_function = 0;                 ///< depends on the function
  std::uint8_t lifts = 0;                        ///< see lift_bit()
  std::uint8_t floor = floor_of_car;             ///< 0: in the car
  std::uint8_t doors = 0;                        ///< see source_door() and destination_door()
  std::uint8_t data = 0;  ///< bits 1 and 0: see request(); bit 7: see locks()

  static constexpr std::uint8_t lock_bit = 0x80;  ///< of the last byte: a locking button

  /// Whether it is requested, not requested, defective or not installed.
  constexpr CallRequest request() const { return static_cast<CallRequest>(data & 0x03); }
  /// Sets the request, and keeps the other bits.
  constexpr void set_request(CallRequest request) {
    data = static_cast<std::uint8_t>((data & ~0x03U) | static_cast<unsigned>(request));
  }
  /// True if the button or key has a locking function.
  constexpr bool locks() const { return (data & lock_bit) != 0; }
  constexpr bool operator==(const VirtualInput&) const = default;
};

/// Contents and form of a virtual output: the last byte of its record (4.4.1).
struct OutputData {
  std::uint8_t raw = 0;  ///< as in the record

  /// On or off.
  constexpr bool status() const { return (raw & 0x01) != 0; }
  /// How it is shown: steady, blinking and so on.
  constexpr Property property() const { return static_cast<Property>(raw >> 1 & 0x07); }
  /// The property defines its meaning: a frequency for flashing, a Color for color.
  constexpr std::uint8_t parameter() const { return raw >> 4 & 0x07; }
  /// Bit 7: whether the form counts.
  constexpr bool predicate() const { return (raw & 0x80) != 0; }
  constexpr bool operator==(const OutputData&) const = default;
};
/// `parameter` is 0 to 7.
constexpr std::uint8_t output_data(bool status, Property property = Property::standard,
                                   unsigned parameter = 0, bool predicate = false) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(status) |
                                   static_cast<unsigned>(property) << 1 | (parameter & 7U) << 4 |
                                   static_cast<unsigned>(predicate) << 7);
}

/// A lamp, display or loudspeaker (4.4.1).
struct VirtualOutput {
  BasicFunction function = BasicFunction::none;  ///< basic function
  std::uint8_t sub_function = 0;                 ///< depends on the function
  std::uint8_t lifts = 0;                        ///< see lift_bit()
  std::uint8_t floor = floor_of_car;             ///< 0: in the car
  std::uint8_t doors = 0;                        ///< see output_door(); low bits: buttons
  std::uint8_t data = 0;                         ///< see OutputData

  constexpr bool operator==(const VirtualOutput&) const = default;
};

/// A sensor (4.13.1).
struct VirtualSensor {
  SensorFunction function = SensorFunction::none;  ///< kind of sensor
  std::uint8_t lifts = 0;                          ///< see lift_bit()
  std::uint8_t floor = floor_of_car;               ///< 0: in the car
  std::uint8_t position = first_maker_position;    ///< 80h to FFh; those below are reserved
  std::uint16_t data = 0;  ///< bits 1 and 0: see signal(); the others: see value()

  /// Signal of the sensor: bits 0 and 1.
  constexpr SensorSignal signal() const { return static_cast<SensorSignal>(data & 0x03); }
  /// For pressure and temperature: -8192 to 8191 units of sensor parameter 3 (errata A21).
  constexpr std::int16_t value() const {
    return static_cast<std::int16_t>(static_cast<std::int16_t>(data) >> 2);
  }
  constexpr bool operator==(const VirtualSensor&) const = default;
};
/// Data of a sensor: a signal, and a value above it.
constexpr std::uint16_t sensor_data(SensorSignal signal, std::int16_t value) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(value) << 2 |
                                    static_cast<unsigned>(signal));
}

// The record as the number in the dictionary, transferred in little-endian order: the basic
// function is its lowest byte. Any 48 bits are a record; higher bits are ignored.

/// A byte of a record, counted from the first that is sent.
constexpr std::uint8_t record_byte(std::uint64_t record, unsigned position) {
  return static_cast<std::uint8_t>(record >> (8 * position));
}
/// A value in its place in a record.
constexpr std::uint64_t at_record_byte(unsigned position, std::uint64_t value) {
  return value << (8 * position);
}

/// For VirtualInput and VirtualOutput, which have the same bytes.
template <class Record>
constexpr std::uint64_t encode(const Record& record) {
  return at_record_byte(0, static_cast<std::uint8_t>(record.function)) |
         at_record_byte(1, record.sub_function) | at_record_byte(2, record.lifts) |
         at_record_byte(3, record.floor) | at_record_byte(4, record.doors) |
         at_record_byte(5, record.data);
}
/// Record as it is mapped: the first byte is the least significant.
constexpr std::uint64_t encode(const VirtualSensor& record) {
  return at_record_byte(0, static_cast<std::uint8_t>(record.function)) |
         at_record_byte(1, record.lifts) | at_record_byte(2, record.floor) |
         at_record_byte(3, record.position) | at_record_byte(4, record.data);
}

/// Takes a record of any kind apart.
template <class Record>
constexpr Record decode_record(std::uint64_t record) {
  return {.function = static_cast<BasicFunction>(record_byte(record, 0)),
          .sub_function = record_byte(record, 1),
          .lifts = record_byte(record, 2),
          .floor = record_byte(record, 3),
          .doors = record_byte(record, 4),
          .data = record_byte(record, 5)};
}
/// Takes a record of 6010h apart.
constexpr VirtualInput decode_input(std::uint64_t record) {
  return decode_record<VirtualInput>(record);
}
/// Takes a record of 6011h apart.
constexpr VirtualOutput decode_output(std::uint64_t record) {
  return decode_record<VirtualOutput>(record);
}
/// Takes a record of 6012h apart.
constexpr VirtualSensor decode_sensor(std::uint64_t record) {
  return {.function = static_cast<SensorFunction>(record_byte(record, 0)),
          .lifts = record_byte(record, 1),
          .floor = record_byte(record, 2),
          .position = record_byte(record, 3),
          .data = static_cast<std::uint16_t>(record >> 32)};
}

}  // namespace canvoy::cia417
