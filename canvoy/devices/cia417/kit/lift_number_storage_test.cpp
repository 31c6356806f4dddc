// The lift number of each kind of device that has one, kept without power (CiA 417-4, 4.2.2; CiA
// 301, 7.5.2.13): after power-on objects, PDOs and CAN-IDs are where they were after the write.
#include <gtest/gtest.h>

#include <optional>

#include "canvoy/canopen/storage/storage.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/devices/cia417/controller/lift_of_four_floors_test.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"

namespace canvoy::cia417::lift_number_storage_test {
namespace {

constexpr unsigned groups = 3;
constexpr LiftDeviceOptions lift_1{};

/// Values of a device in lift 1: an object, and one of its PDOs.
struct Places {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint16_t pdo = 0;  ///< the index of its parameter
  std::uint32_t cob_id = 0;
  std::uint16_t mapped = 0;
};

constexpr auto storing_load_unit = describe(LoadKind<lift_1>::description, cia301::storage(groups));
constexpr auto load_unit_layout = in_any_lift(lay_out_device<storing_load_unit>());
struct LoadUnit : LoadMeasuringDevice<lift_1, 1, load_unit_layout> {
  explicit LoadUnit(const Port& port) : Device(port, 13, {}) {}
  static constexpr Places places{0x6483, 1, 0x1902, 0x188, 0x6482};
};

constexpr LiftDeviceOptions door_1{.doors = 0b0001};
constexpr auto storing_barrier =
    describe(LightBarrierKind<door_1>::description, cia301::storage(groups));
constexpr auto barrier_layout = in_any_lift(lay_out_device<storing_barrier>());
struct LightBarrier : LightBarrierDevice<door_1, barrier_layout> {
  explicit LightBarrier(const Port& port) : Device(port, 9, {}) {}
  static constexpr Places places{0x6310, 1, 0x190B, 0x205, 0x6310};
};

constexpr auto storing_door =
    describe(CarDoorKind<first_door>::description, cia301::storage(groups));
constexpr auto door_layout = in_any_lift(lay_out_device<storing_door>());
struct Door : CarDoorDevice<first_door, door_layout> {
  explicit Door(const Port& port) : Device(port, 6, {}) {}
  static constexpr Places places{0x6304, 1, 0x190A, 0x201, 0x6301};
};

constexpr auto storing_position = describe(CarPositionKind<>::description, cia301::storage(groups));
constexpr auto position_layout = in_any_lift(lay_out_device<storing_position>());
struct Position : CarPositionDevice<position_layout> {
  explicit Position(const Port& port) : Device(port, 4, {}) {}
  static constexpr Places places{0x6384, 1, 0x1906, 0x18C, 0x6383};
};

constexpr auto storing_drive = describe(CarDriveKind<>::description, cia301::storage(groups));
constexpr auto drive_layout = in_any_lift(lay_out_device<storing_drive>());
struct Drive : CarDriveDevice<drive_layout> {
  explicit Drive(const Port& port) : Device(port, 2, {}) {}
  static constexpr Places places{0x6423, 0, 0x1905, 0x181, 0x6401};
};

constexpr auto storing_door_controller =
    describe(CarDoorControllerKind<lift_1>::description, cia301::storage(groups));
constexpr auto door_controller_layout = in_any_lift(lay_out_device<storing_door_controller>());
struct DoorController : CarDoorControllerDevice<lift_1, door_controller_layout> {
  explicit DoorController(const Port& port) : Device(port, 1) {}
  static constexpr Places places{0x6300, 1, 0x1908, 0x200, 0x6300};
};

constexpr auto storing_drive_controller =
    describe(CarDriveControllerKind<lift_1>::description, cia301::storage(groups));
constexpr auto drive_controller_layout = in_any_lift(lay_out_device<storing_drive_controller>());
struct DriveController : CarDriveControllerDevice<lift_1, drive_controller_layout> {
  explicit DriveController(const Port& port) : Device(port, 1) {}
  static constexpr Places places{0x6400, 0, 0x1505, 0x181, 0x6401};
};

constexpr auto storing_call_controller = describe(full_call_controller, cia301::storage(groups));
constexpr auto call_controller_layout = in_any_lift(lay_out_device<storing_call_controller>());
struct Calls : CallControllerDevice<call_controller_layout> {
  explicit Calls(const Port& port)
      : CallControllerDevice(port, 1, {.served = {FloorSet::between(1, 4)}}) {}
  static constexpr Places places{.index = 0x6200};
};

constexpr auto storing_lift_controller = describe(full_lift_controller<>, cia301::storage(groups));
constexpr auto lift_controller_layout = in_any_lift(lay_out_device<storing_lift_controller>());
struct Lift : LiftControllerDevice<LiftControllerOptions{}, lift_controller_layout> {
  explicit Lift(const Port& port) : LiftControllerDevice(port, 1, lift_of_four_floors()) {}
  static constexpr Places places{0x6300, 1, 0x1904, 0x180, 0x6400};
};

/// A device that has power, on a cable of its own.
template <class Device>
struct Powered : DeviceOnCable<Device> {
  explicit Powered(SimulatedFlash& memory)
      : storage(this->device.node(), memory.flash, {.slot_size = 0x8000}) {
    this->start();
  }
  /// Storing takes its time.
  std::string ask(std::string_view request) {
    DeviceOnCable<Device>::ask(request);
    this->cable.run_for(5s);
    const std::string answer = this->cable.last(0x580U + this->device.node().id());
    return answer.empty() ? answer : answer.substr(4);
  }
  /// Nothing where there is no such object.
  std::optional<std::uint32_t> read(unsigned index, unsigned sub) {
    char request[40];
    std::snprintf(request, sizeof request, "40 %02X %02X %02X 00 00 00 00", index & 0xFF,
                  index >> 8, sub);
    const std::string answer = ask(request);
    if (answer.substr(12) == "00 00 02 06") return std::nullopt;
    EXPECT_EQ(answer[0], '4') << std::hex << index << ": " << answer;
    return load<std::uint32_t>(wire_frame("000#" + answer).data.data() + 4);
  }
  void write_lift(unsigned lift) {
    char request[40];
    std::snprintf(request, sizeof request, "2F 01 60 00 %02X 00 00 00", 1U << (lift - 1));
    EXPECT_EQ(ask(request), "60 01 60 00 00 00 00 00");
  }
  void save(char group) {
    const std::string sub = std::string("0") + group;
    EXPECT_EQ(ask("23 10 10 " + sub + " 73 61 76 65"), "60 10 10 " + sub + " 00 00 00 00");
  }

  Storage storage;
};

template <class Device>
class StoredLiftNumber : public testing::Test {
 protected:
  static void expect_in_lift(Powered<Device>& sut, unsigned lift) {
    constexpr Places places = Device::places;
    EXPECT_EQ(sut.read(0x6001, 0).value_or(0) & 0xFF, 1U << (lift - 1));
    for (unsigned other = 1; other <= 8; ++other) {
      EXPECT_EQ(sut.read(places.index + (other - 1) * 0x800, places.sub).has_value(), other == lift)
          << other;
      if (places.pdo == 0) continue;
      const auto cob_id = sut.read(places.pdo + (other - 1) * 0x10U, 1);
      const auto mapped = sut.read(places.pdo + 0x200U + (other - 1) * 0x10U, 1);
      ASSERT_EQ(cob_id.has_value(), other == lift) << other;
      ASSERT_EQ(mapped.has_value(), other == lift) << other;
      if (other != lift) continue;
      EXPECT_EQ(cob_id.value_or(0), places.cob_id + (lift - 1) * 0x10);
      EXPECT_EQ(mapped.value_or(0) >> 16, places.mapped + (lift - 1) * 0x800);
    }
  }

  SimulatedFlash memory{{.sector_size = 0x8000, .sectors = 2, .unit = 8}};
};

using Devices = testing::Types<LoadUnit, LightBarrier, Door, Position, Drive, DoorController,
                               DriveController, Calls, Lift>;
TYPED_TEST_SUITE(StoredLiftNumber, Devices);

TYPED_TEST(StoredLiftNumber, WithAllParametersItHoldsAfterPowerOn) {
  {
    Powered<TypeParam> before(this->memory);
    this->expect_in_lift(before, 1);
    before.write_lift(3);
    before.save('1');
  }
  Powered<TypeParam> sut(this->memory);
  this->expect_in_lift(sut, 3);
  sut.write_lift(2);
  this->expect_in_lift(sut, 2);
}

TYPED_TEST(StoredLiftNumber, StoredWithoutCommunicationParametersItMovesThoseToo) {
  {
    Powered<TypeParam> before(this->memory);
    before.write_lift(8);
    before.save('3');
  }
  Powered<TypeParam> sut(this->memory);
  this->expect_in_lift(sut, 8);
}

TYPED_TEST(StoredLiftNumber, CommunicationParametersThatWereStoredInAnotherLiftMoveWithIt) {
  Powered<TypeParam> sut(this->memory);
  sut.write_lift(3);
  sut.save('1');
  sut.write_lift(5);
  sut.cable.send("000#82 00");
  sut.cable.run_for(10ms);
  this->expect_in_lift(sut, 5);
}

TYPED_TEST(StoredLiftNumber, DefaultsBringBackTheLiftThatItWasMadeFor) {
  Powered<TypeParam> sut(this->memory);
  sut.write_lift(3);
  sut.save('1');
  EXPECT_EQ(sut.ask("23 11 10 01 6C 6F 61 64"), "60 11 10 01 00 00 00 00");
  sut.cable.send("000#81 00");
  sut.cable.run_for(10ms);
  this->expect_in_lift(sut, 1);
}

// At the wire.

TEST(StoredLiftNumberAtTheWire, ACallControllerHearsItsPanelsWithAndWithoutAStoredSet) {
  SimulatedFlash memory({.sector_size = 0x8000, .sectors = 2, .unit = 8});
  {
    Powered<Calls> before(memory);
    before.cable.send("495#02 01 01 03 10 01");
    before.cable.run_for(10ms);
    EXPECT_EQ(before.cable.last(0x400), "400#02 01 01 03 10 81") << "nothing is stored yet";
    before.write_lift(3);
    before.save('1');
  }
  Powered<Calls> sut(memory);
  sut.cable.run_for(1s);
  sut.cable.send("495#02 01 04 03 10 01");
  sut.cable.run_for(10ms);
  EXPECT_EQ(sut.cable.last(0x400), "400#02 01 04 03 10 81");
}

TEST(StoredLiftNumberAtTheWire, ADoorObeysTheControllerOfItsStoredLift) {
  SimulatedFlash memory({.sector_size = 0x8000, .sectors = 2, .unit = 8});
  {
    Powered<Door> before(memory);
    before.write_lift(3);
    before.save('3');
  }
  Powered<Door> sut(memory);
  sut.cable.clear();
  sut.cable.send("000#80 00");
  sut.cable.send("000#01 00");
  EXPECT_EQ(sut.cable.count(0x221), 1u) << "its statusword, for lift 3";
  EXPECT_EQ(sut.cable.count(0x201), 0u);
}

TEST(StoredLiftNumberAtTheWire, ACobIdThatSomebodyChoseStays) {
  SimulatedFlash memory({.sector_size = 0x8000, .sectors = 2, .unit = 8});
  {
    Powered<LoadUnit> before(memory);
    before.write_lift(3);
    before.ask("23 22 19 01 A8 01 00 80");
    before.ask("23 22 19 01 98 01 00 00");  // which would be that of lift 2
    before.save('1');
  }
  Powered<LoadUnit> sut(memory);
  EXPECT_EQ(sut.ask("40 22 19 01 00 00 00 00"), "43 22 19 01 98 01 00 00");
}

}  // namespace
}  // namespace canvoy::cia417::lift_number_storage_test
