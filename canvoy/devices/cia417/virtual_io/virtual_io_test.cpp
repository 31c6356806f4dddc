// The bytes of virtual inputs, outputs and sensors, typed from CiA 417-4.
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::virtual_io_test {
namespace {

TEST(VirtualIo, AnInputHasTheBytesOf431FromTheLowestOn) {
  constexpr VirtualInput button = {.function = BasicFunction::standard_hall_call,
                                   .sub_function = hall_down,
                                   .lifts = lift_bit(1) | lift_bit(3),
                                   .floor = 254,
                                   .doors = source_door(2) | destination_door(1),
                                   .data = 0x81};
  EXPECT_EQ(encode(button), 0x8121'FE05'0202u);
  EXPECT_EQ(decode_input(0x8121'FE05'0202), button);
}

TEST(VirtualIo, AnOutputHasTheBytesOf441FromTheLowestOn) {
  constexpr VirtualOutput lamp = {.function = BasicFunction::special_indication,
                                  .sub_function = sub_function_of(SpecialIndication::overload),
                                  .lifts = lift_bit(8),
                                  .floor = floor_of_car,
                                  .doors = output_door(1),
                                  .data = output_data(true, Property::flashing, 5, true)};
  EXPECT_EQ(encode(lamp), 0xD710'0080'0343u);
  EXPECT_EQ(decode_output(0xD710'0080'0343), lamp);
}

TEST(VirtualIo, ASensorHasTheBytesOf4131FromTheLowestOn) {
  constexpr VirtualSensor sensor = {.function = SensorFunction::temperature,
                                    .lifts = lift_bit(2),
                                    .floor = 7,
                                    .position = 0x80,
                                    .data = sensor_data(SensorSignal::set, -2)};
  EXPECT_EQ(encode(sensor), 0xFFF9'8007'0206u);
  EXPECT_EQ(decode_sensor(0xFFF9'8007'0206), sensor);
}

TEST(VirtualIo, EveryByteOfARecordIsKeptAtItsPlace) {
  for (unsigned position = 0; position < 6; ++position) {
    for (std::uint64_t byte = 0; byte <= 0xFF; ++byte) {
      const std::uint64_t record = byte << (8 * position);
      EXPECT_EQ(encode(decode_input(record)), record);
      EXPECT_EQ(encode(decode_output(record)), record);
      EXPECT_EQ(encode(decode_sensor(record)), record);
    }
  }
}

TEST(VirtualIo, BitsAboveARecordAreIgnored) {
  EXPECT_EQ(encode(decode_input(0xFFFF'0102'0304'0506)), 0x0102'0304'0506u);
  EXPECT_EQ(encode(decode_sensor(0xFFFF'0102'0304'0506)), 0x0102'0304'0506u);
}

TEST(VirtualIo, TheCallRequestIsBits1And0AndTheLockBit7) {
  for (unsigned data = 0; data <= 0xFF; ++data) {
    VirtualInput input{.data = static_cast<std::uint8_t>(data)};
    EXPECT_EQ(input.request(), static_cast<CallRequest>(data % 4));
    EXPECT_EQ(input.locks(), data >= 0x80);
    input.set_request(CallRequest::defective);
    EXPECT_EQ(input.data, (data & 0xFC) | 2) << "all other bits stay";
  }
}

TEST(VirtualIo, FunctionDataOfOutputsIsStatusPropertyParameterAndPredicate) {
  for (unsigned raw = 0; raw <= 0xFF; ++raw) {
    const OutputData data{static_cast<std::uint8_t>(raw)};
    EXPECT_EQ(data.status(), raw % 2 == 1);
    EXPECT_EQ(static_cast<unsigned>(data.property()), raw / 2 % 8);
    EXPECT_EQ(data.parameter(), raw / 16 % 8);
    EXPECT_EQ(data.predicate(), raw >= 128);
    EXPECT_EQ(output_data(data.status(), data.property(), data.parameter(), data.predicate()), raw);
  }
}

TEST(VirtualIo, ASensorValueIsTheUpper14BitsWithASign) {
  EXPECT_EQ(VirtualSensor{.data = 0x8000}.value(), -8192);
  EXPECT_EQ(VirtualSensor{.data = 0x7FFF}.value(), 8191);
  EXPECT_EQ(VirtualSensor{.data = 0xFFFE}.value(), -1);
  EXPECT_EQ(VirtualSensor{.data = 0xFFFE}.signal(), SensorSignal::defective);
  for (int value = -8192; value <= 8191; ++value) {
    const auto sent = static_cast<std::int16_t>(value);
    EXPECT_EQ(VirtualSensor{.data = sensor_data(SensorSignal::set, sent)}.value(), value);
  }
}

TEST(VirtualIo, DoorsStandInTheUpperAndTheLowerHalfOfTheirByte) {
  EXPECT_EQ(source_door(1), 0x10);
  EXPECT_EQ(source_door(4), 0x80);
  EXPECT_EQ(destination_door(1), 0x01);
  EXPECT_EQ(destination_door(4), 0x08);
  EXPECT_EQ(source_doors(0xA5), 0x0A);
  EXPECT_EQ(destination_doors(0xA5), 0x05);
  EXPECT_EQ(lift_bit(1), 0x01);
  EXPECT_EQ(lift_bit(8), 0x80);
}

TEST(VirtualIo, TheBasicFunctionSaysWhatTheSubFunctionIs) {
  for (unsigned code = 0; code <= 0xFF; ++code) {
    const auto function = static_cast<BasicFunction>(code);
    EXPECT_EQ(is_hall_call(function), code >= 0x02 && code <= 0x04);
    EXPECT_EQ(has_target_stop(function), code >= 0x05 && code <= 0x0D);
    EXPECT_EQ(is_manufacturer_specific(function), code >= 0x80);
  }
}

}  // namespace
}  // namespace canvoy::cia417::virtual_io_test
