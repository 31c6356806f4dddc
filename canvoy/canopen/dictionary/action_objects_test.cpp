// Which objects of CiA 301 and 302 are commands or states, and which are parameters.
#include "canvoy/canopen/dictionary/action_objects.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/device/verify_configuration.hpp"
#include "canvoy/canopen/storage/parameter.hpp"

namespace canvoy::action_objects_test {
namespace {

constexpr EntryShape writable{.type = DataType::unsigned32, .access = Access::rw};

bool is_configuration(std::uint16_t index) {
  std::uint8_t value[4] = {};
  Entry entry;
  entry.row = &writable;
  entry.value = value;
  entry.index = index;
  return VerifyConfiguration::is_configuration(entry);
}

TEST(ActionObjects, areNeitherStoredNorConfiguration) {
  for (const unsigned index :
       {0x1001U, 0x1002U, 0x1003U, 0x1010U, 0x1011U, 0x1013U, 0x1023U, 0x1026U,
        0x1F00U, 0x1F01U, 0x1F03U, 0x1F06U, 0x1F10U, 0x1F11U, 0x1F25U, 0x1F50U,
        0x1F51U, 0x1F52U, 0x1F56U, 0x1F57U, 0x1F82U, 0x1F83U}) {
    const auto object = static_cast<std::uint16_t>(index);
    EXPECT_FALSE(is_parameter(object, writable)) << std::hex << index;
    EXPECT_FALSE(is_configuration(object)) << std::hex << index;
  }
}

TEST(ActionObjects, areNotTheParametersBesideThem) {
  for (const unsigned index : {0x1005U, 0x1012U, 0x1014U, 0x1F02U, 0x1F22U, 0x1F26U, 0x1F53U,
                               0x1F54U, 0x1F55U, 0x1F80U, 0x1F81U, 0x1F84U, 0x1F8AU, 0x2000U}) {
    const auto object = static_cast<std::uint16_t>(index);
    EXPECT_TRUE(is_parameter(object, writable)) << std::hex << index;
    EXPECT_TRUE(is_configuration(object)) << std::hex << index;
  }
}

TEST(ActionObjects, leaveOut1020hWhichIsStoredAndNoConfigurationByItself) {
  EXPECT_TRUE(is_parameter(0x1020, writable));
  EXPECT_FALSE(is_configuration(0x1020));
}

}  // namespace
}  // namespace canvoy::action_objects_test
