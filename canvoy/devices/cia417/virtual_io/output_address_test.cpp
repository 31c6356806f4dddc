// Every basic function with every sub-function, lift, floor and door: which outputs a record
// addresses (CiA 417-4, 4.4.1).
#include "canvoy/devices/cia417/virtual_io/output_address.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace canvoy::cia417::output_address_test {
namespace {

VirtualOutput of(unsigned function, unsigned sub_function) {
  return {.function = static_cast<BasicFunction>(function),
          .sub_function = static_cast<std::uint8_t>(sub_function),
          .lifts = lift_bit(1),
          .floor = 3,
          .doors = output_door(1)};
}

/// For one basic function: whether record and output with these sub-functions belong together.
template <class Expected>
void expect(unsigned function, unsigned wanted, unsigned assigned, Expected expected) {
  if (is_addressed(of(function, wanted), of(function, assigned)) == expected(wanted, assigned)) {
    return;
  }
  ADD_FAILURE() << function << " " << wanted << " " << assigned;
}
template <class Expected>
void expect_all(unsigned function, Expected expected) {
  for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
    for (unsigned assigned = 0; assigned <= 0xFF; ++assigned) {
      expect(function, wanted, assigned, expected);
    }
  }
}

TEST(OutputAddress, HallCallsAddressTheLampsOfTheirDirections) {
  for (unsigned function = 0x02; function <= 0x04; ++function) {
    expect_all(function, [](unsigned wanted, unsigned assigned) {
      return (wanted % 2 == 1 && assigned % 2 == 1) ||
             (wanted / 2 % 2 == 1 && assigned / 2 % 2 == 1);
    });
  }
}

TEST(OutputAddress, TargetStopsAddressTheirButtonOr255AllButtons) {
  for (unsigned function = 0x05; function <= 0x0D; ++function) {
    expect_all(function, [](unsigned wanted, unsigned assigned) {
      if (wanted == 0 || assigned == 0) return false;
      return wanted == 255 || wanted == assigned;
    });
  }
}

TEST(OutputAddress, SpecialFunctionsAddressTheirOwnAcknowledgement) {
  expect_all(0x0E,
             [](unsigned wanted, unsigned assigned) { return wanted == assigned && wanted != 0; });
}

TEST(OutputAddress, APositionIndicatorShowsWhateverFloorButTheReservedOne) {
  expect_all(0x40, [](unsigned wanted, unsigned) { return wanted != 255; });
}

TEST(OutputAddress, LanternsAndDirectionsShowWhateverArrows) {
  expect_all(0x41, [](unsigned, unsigned) { return true; });
  expect_all(0x42, [](unsigned, unsigned) { return true; });
}

TEST(OutputAddress, ASpecialIndicationHasALampOfItsOwnOrADisplayForAll) {
  expect_all(0x43, [](unsigned wanted, unsigned assigned) {
    return wanted == 0 || assigned == 0 || wanted == assigned;
  });
}

TEST(OutputAddress, AnArrivalIsNotUpAndDownAtTheSameTime) {
  expect_all(0x44, [](unsigned wanted, unsigned) { return wanted % 4 != 3; });
}

TEST(OutputAddress, OperationDataAndPublicityAreOfTheirFunctionAlone) {
  expect_all(0x45, [](unsigned, unsigned) { return true; });
  expect_all(0x46, [](unsigned, unsigned) { return true; });
}

TEST(OutputAddress, WhatIsReservedOrManufacturerSpecificAddressesTheVerySame) {
  for (unsigned function = 1; function <= 0xFF; ++function) {
    const bool is_defined =
        (function >= 0x02 && function <= 0x0E) || (function >= 0x40 && function <= 0x46);
    if (is_defined) continue;
    for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
      for (const unsigned assigned : {wanted, wanted ^ 1, 0U, 0xFFU}) {
        expect(function, wanted, assigned, std::equal_to<>());
      }
    }
  }
}

TEST(OutputAddress, FunctionZeroAddressesNobody) {
  expect_all(0x00, [](unsigned, unsigned) { return false; });
}

TEST(OutputAddress, AnotherFunctionIsAnotherOutput) {
  for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
    for (unsigned assigned = 0; assigned <= 0xFF; ++assigned) {
      if (wanted == assigned) continue;
      ASSERT_FALSE(is_addressed(of(wanted, 1), of(assigned, 1)));
    }
  }
}

TEST(OutputAddress, OneOfTheLiftsIsEnough) {
  for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
    for (unsigned assigned = 0; assigned <= 0xFF; ++assigned) {
      VirtualOutput record = of(0x40, 1);
      VirtualOutput output = of(0x40, 1);
      record.lifts = static_cast<std::uint8_t>(wanted);
      output.lifts = static_cast<std::uint8_t>(assigned);
      bool expected = false;
      for (unsigned lift = 0; lift < 8; ++lift) {
        expected = expected || (wanted >> lift % 8 & assigned >> lift & 1) != 0;
      }
      ASSERT_EQ(is_addressed(record, output), expected);
    }
  }
}

TEST(OutputAddress, AFloorOrTheCarOrFFhAllFloors) {
  for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
    for (unsigned assigned = 0; assigned <= 0xFF; ++assigned) {
      VirtualOutput record = of(0x40, 1);
      VirtualOutput output = of(0x40, 1);
      record.floor = static_cast<std::uint8_t>(wanted);
      output.floor = static_cast<std::uint8_t>(assigned);
      const bool expected = wanted == assigned || (wanted == 255 && assigned != 0);
      ASSERT_EQ(is_addressed(record, output), expected) << wanted << " " << assigned;
    }
  }
}

TEST(OutputAddress, DoorsAndColumnsOfButtonsAreLookedAtWhereBothUseThem) {
  for (unsigned wanted = 0; wanted <= 0xFF; ++wanted) {
    for (unsigned assigned = 0; assigned <= 0xFF; ++assigned) {
      VirtualOutput record = of(0x40, 1);
      VirtualOutput output = of(0x40, 1);
      record.doors = static_cast<std::uint8_t>(wanted);
      output.doors = static_cast<std::uint8_t>(assigned);
      const auto agree = [](unsigned a, unsigned b) { return a == 0 || b == 0 || (a & b) != 0; };
      const bool expected = agree(wanted / 16, assigned / 16) && agree(wanted % 16, assigned % 16);
      ASSERT_EQ(is_addressed(record, output), expected) << wanted << " " << assigned;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417::output_address_test
