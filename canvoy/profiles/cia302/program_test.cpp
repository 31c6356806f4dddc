#include "canvoy/profiles/cia302/program.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia302_program_test {
namespace {

using namespace entry_rows;

constexpr auto device =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia302::programs(2), cia302::expected_programs());
constexpr auto device_layout = lay_out_device<device>();

constexpr Expected entries[] = {
    {0x1F50, 0, u8, "const", 2},   {0x1F50, 2, domain, "wo", 0},  {0x1F51, 0, u8, "const", 2},
    {0x1F51, 2, u8, "rw", 0},      {0x1F52, 0, u8, "const", 2},   {0x1F52, 1, u32, "rw", 0},
    {0x1F52, 2, u32, "rw", 0},     {0x1F53, 0, u8, "const", 127}, {0x1F53, 127, u32, "rw", 0},
    {0x1F54, 0, u8, "const", 127}, {0x1F54, 127, u32, "rw", 0},   {0x1F55, 0, u8, "const", 127},
    {0x1F55, 127, u32, "rw", 0},   {0x1F56, 0, u8, "const", 2},   {0x1F56, 2, u32, "ro", 0},
    {0x1F57, 0, u8, "const", 2},   {0x1F57, 2, u32, "ro", 0},
};

TEST(Cia302Program, ObjectsHaveTheirTypesAccessAndDefaults) {
  const DeviceMemory memory(device_layout.tables());
  expect_entries(memory.dictionary, entries);
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x1F50, 0x1F51, 0x1F57})) {
    EXPECT_EQ(memory.dictionary.find(index, 3).abort(), AbortCode::no_sub_index);
  }
}

}  // namespace
}  // namespace canvoy::cia302_program_test
