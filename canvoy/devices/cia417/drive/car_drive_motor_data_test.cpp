// Motor data of a car drive unit (640Fh; CiA 417-4, 4.11.2): a record of the maker's own, which
// ours does not have.
#include "canvoy/devices/cia417/drive/car_drive_unit_test.hpp"

namespace canvoy::cia417::car_drive_motor_data_test {
namespace {

TEST_F(CarDriveTest, HasNoMotorDataOfItsOwn) {
  EXPECT_EQ(bench.ask("40 0F 64 00 00 00 00 00"), 0x0602'0000U);
}

constexpr EntryInfo rated_speed{
    .name = "Rated speed", .type = DataType::unsigned16, .access = Access::rw, .initial = 1'500};
constexpr EntryInfo pole_pairs{
    .name = "Pole pairs", .type = DataType::unsigned8, .access = Access::rw, .initial = 10};
constexpr EntryInfo motor_entries[] = {motor_data_entries[0], at(1, rated_speed),
                                       at(2, pole_pairs)};
constexpr ObjectInfo motor_of_maker = [] {
  ObjectInfo object = motor_data_object;
  object.subs = motor_entries;
  return object;
}();
constexpr auto drive_with_motor = describe(CarDriveKind<>::description, motor_of_maker);
constexpr auto drive_with_motor_layout = in_any_lift(lay_out_device<drive_with_motor>());

TEST(CarDriveMotorData, ADriveHasThoseThatItsMakerDescribes) {
  DriveBench bench;
  CarDriveDevice<drive_with_motor_layout> device(bench.port(), 2, bench.hardware());
  bench.boot(device.node());
  const auto read = [&](std::uint8_t sub) {
    return device.node().dictionary().number(0x640F, sub);
  };
  EXPECT_EQ(read(0), 2U);
  EXPECT_EQ(read(1), 1'500U);
  EXPECT_EQ(bench.ask("2F 0F 64 02 04 00 00 00"), 0U);
  EXPECT_EQ(read(2), 4U);
  EXPECT_EQ(bench.ask("2F 0F 64 01 04 00 00 00"), 0x0607'0013U) << "it has 16 bits";
  EXPECT_EQ(bench.ask("40 0F 64 03 00 00 00 00"), 0x0609'0011U);
}

}  // namespace
}  // namespace canvoy::cia417::car_drive_motor_data_test
