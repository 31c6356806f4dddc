// The entries of clause 9.2 as they are printed, with the corrections of the errata in place.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/profiles/cia407.hpp"

namespace canvoy::cia407_entries_test {
namespace {

constexpr unsigned boolean = 1, i8 = 2, i16 = 3, u8 = 5, u16 = 6,
                   u32 = 7;  // as CiA 301 numbers them
constexpr unsigned text = 9, octets = 10, domain = 15;

struct Range {
  std::int64_t low = 0;
  std::int64_t high = -1;  ///< all that the type has, or typed in the tests of values
};
constexpr std::int64_t none = -1;

struct Expected {
  unsigned index;
  unsigned sub;
  const char* name;  ///< empty: that of the object
  unsigned type;
  char category;       ///< M or O
  const char* access;  ///< vd: see virtual device profiles
  char pdo;            ///< -: no, o: optional, d: default
  Range range;
  std::int64_t initial;
};
// clang-format off
constexpr Expected entries[] = {
    {0x6000, 0x00, "number_of_supported_virtual_devices", u8, 'M', "ro", '-', {2, 254}, none},
    {0x6000, 0x01, "virtual_device_type_1", u16, 'M', "ro", '-', {}, none},
    {0x6000, 0x02, "virtual_device_type_2", u16, 'M', "ro", '-', {}, none},
    {0x6000, 0x03, "virtual_device_type_3", u16, 'O', "ro", '-', {}, none},
    {0x6000, 0xFE, "virtual_device_type_254", u16, 'O', "ro", '-', {}, none},
    {0x6001, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 33}, none},
    {0x6001, 0x01, "event_at_sub", u32, 'M', "vd", 'd', {}, 0},
    {0x6001, 0x02, "events_from_1st_virtual_device", u32, 'O', "vd", 'o', {}, 0},
    {0x6001, 0x21, "events_from_32nd_virtual_device", u32, 'O', "vd", 'o', {}, 0},
    {0x6002, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 32}, none},
    {0x6002, 0x01, "events_for_1st_virtual_device", u32, 'O', "vd", 'o', {}, none},
    {0x6002, 0x20, "events_for_32nd_virtual_device", u32, 'O', "vd", 'o', {}, none},
    {0x6100, 0x00, "", u32, 'M', "vd", '-', {}, 0},
    {0x6101, 0x00, "", u16, 'M', "vd", '-', {}, 0},
    {0x6102, 0x00, "", u16, 'M', "vd", '-', {}, 0},
    {0x6103, 0x00, "", u32, 'M', "vd", '-', {}, 0},
    {0x6104, 0x00, "", u8, 'M', "vd", '-', {}, none},
    {0x6105, 0x00, "", u8, 'M', "vd", '-', {}, 1},
    {0x6106, 0x00, "", u32, 'M', "vd", '-', {}, 0},
    {0x6107, 0x00, "", u32, 'M', "vd", '-', {}, 0},
    {0x6108, 0x00, "", u8, 'M', "vd", 'd', {}, 1},
    {0x6109, 0x00, "", u32, 'M', "vd", 'd', {}, 0},
    {0x610A, 0x00, "", u8, 'M', "vd", 'd', {1, 255}, 1},
    {0x610B, 0x00, "number_of_characters", u8, 'M', "ro", '-', {1, 8}, none},
    {0x610B, 0x01, "character_1", u8, 'M', "vd", 'd', {}, 0},
    {0x610B, 0x02, "character_2", u8, 'O', "vd", 'd', {}, 0},
    {0x610B, 0x08, "character_8", u8, 'O', "vd", 'd', {}, 0},
    {0x610C, 0x00, "number_of_entries", u8, 'M', "vd", '-', {1, 254}, none},
    {0x610C, 0x01, "text_line/route_description_1", octets, 'M', "vd", '-', {}, none},
    {0x610C, 0x02, "text_line/route_description_2", octets, 'O', "vd", '-', {}, none},
    {0x610C, 0xFE, "text_line/route_description_254", octets, 'O', "vd", '-', {}, none},
    {0x610D, 0x00, "number_of_entries", u8, 'M', "vd", '-', {1, 254}, none},
    {0x610D, 0x01, "text_of_destination_1", octets, 'M', "vd", '-', {}, none},
    {0x610D, 0x02, "text_of_destination_2", octets, 'O', "vd", '-', {}, none},
    {0x610D, 0xFE, "text_of_destination_254", octets, 'O', "vd", '-', {}, none},
    {0x610E, 0x00, "number_of_entries", u8, 'M', "ro", '-', {6, 6}, 6},
    {0x610E, 0x01, "year", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610E, 0x02, "day", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610E, 0x03, "month", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610E, 0x04, "hour", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610E, 0x05, "minute", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610E, 0x06, "second", u8, 'M', "vd", 'd', {}, 0xFF},
    {0x610F, 0x00, "", u8, 'M', "vd", 'o', {0, 15}, 10},
    {0x6110, 0x00, "", u16, 'M', "vd", 'd', {}, 0},
    {0x6111, 0x00, "", u8, 'M', "vd", 'd', {}, 0},
    {0x6112, 0x00, "number_of_entries", u8, 'M', "vd", '-', {1, 254}, none},
    {0x6112, 0x01, "text_of_stop_point_1", octets, 'M', "vd", '-', {}, none},
    {0x6112, 0x02, "text_of_stop_point_2", octets, 'O', "vd", '-', {}, none},
    {0x6112, 0xFE, "text_of_stop_point_254", octets, 'O', "vd", '-', {}, none},
    {0x6113, 0x00, "", u16, 'M', "vd", '-', {}, none},
    {0x6114, 0x00, "", u8, 'M', "vd", '-', {}, 0},
    {0x6115, 0x00, "number_of_entries", u8, 'M', "ro", '-', {6, 6}, 6},
    {0x6115, 0x01, "year", u8, 'M', "vd", 'o', {}, none},
    {0x6115, 0x02, "day", u8, 'M', "vd", 'o', {}, none},
    {0x6115, 0x03, "month", u8, 'M', "vd", 'o', {}, none},
    {0x6115, 0x04, "hour", u8, 'M', "vd", 'o', {}, none},
    {0x6115, 0x05, "minute", u8, 'M', "vd", 'o', {}, none},
    {0x6115, 0x06, "second", u8, 'M', "vd", 'o', {}, none},
    {0x6116, 0x00, "", u8, 'M', "vd", 'd', {}, 0},
    {0x6117, 0x00, "", u8, 'M', "vd", 'o', {}, 0xFF},
    {0x6118, 0x00, "number_of_characters", u8, 'M', "ro", '-', {1, 8}, none},
    {0x6118, 0x01, "character_1", u8, 'M', "vd", 'd', {}, 0},
    {0x6118, 0x02, "character_2", u8, 'O', "vd", 'd', {}, 0},
    {0x6118, 0x08, "character_8", u8, 'O', "vd", 'd', {}, 0},
    {0x6119, 0x00, "", i16, 'M', "vd", 'o', {-1000, 1000}, none},
    {0x611A, 0x00, "", u32, 'M', "vd", 'o', {}, 0},
    {0x611B, 0x00, "", u16, 'M', "vd", '-', {}, 0xFFFF},
    {0x611C, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x611D, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x611E, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x611F, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6120, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6121, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6122, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6123, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x6190, 0x00, "", u32, 'M', "vd", 'd', {}, 0},
    {0x6191, 0x00, "", u32, 'M', "vd", 'd', {}, 0},
    {0x6192, 0x00, "", u16, 'M', "vd", 'd', {}, 0},
    {0x6193, 0x00, "", u16, 'M', "vd", 'd', {}, 0},
    {0x6194, 0x00, "", u32, 'M', "vd", 'd', {}, 0},
    {0x6195, 0x00, "", u16, 'M', "vd", 'd', {}, 0},
    {0x6196, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6197, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6198, 0x00, "", text, 'M', "vd", '-', {}, none},
    {0x6200, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 254}, none},
    {0x6200, 0x01, "XML_file_1", text, 'M', "vd", '-', {}, none},
    {0x6200, 0x02, "XML_file_2", text, 'O', "vd", '-', {}, none},
    {0x6200, 0xFE, "XML_file_254", text, 'O', "vd", '-', {}, none},
    {0x6201, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 254}, none},
    {0x6201, 0x01, "special_character_file_1", domain, 'M', "vd", '-', {}, none},
    {0x6201, 0x02, "special_character_file_2", domain, 'O', "vd", '-', {}, none},
    {0x6201, 0xFE, "special_character_file_254", domain, 'O', "vd", '-', {}, none},
    {0x6202, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 254}, none},
    {0x6202, 0x01, "reference_file_1", domain, 'M', "vd", '-', {}, none},
    {0x6202, 0x02, "reference_file_2", domain, 'O', "vd", '-', {}, none},
    {0x6202, 0xFE, "reference_file_254", domain, 'O', "vd", '-', {}, none},
    {0x6203, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 254}, none},
    {0x6203, 0x01, "display_update", u32, 'M', "vd", 'o', {}, 2},
    {0x6203, 0x02, "mapped_object_1", u32, 'M', "vd", 'o', {}, 0xC6101},
    {0x6203, 0x03, "mapped_object_2", u32, 'O', "vd", 'o', {}, 0x126101},
    {0x6203, 0xFE, "mapped_object_253", u32, 'O', "vd", 'o', {}, none},
    {0x6204, 0x00, "", boolean, 'M', "vd", 'o', {}, 0},
    {0x6205, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 254}, none},
    {0x6205, 0x01, "selected_character_set", u16, 'M', "rw", '-', {}, 0},
    {0x6205, 0x02, "1st additional available character set", u16, 'O', "ro", '-', {}, none},
    {0x6205, 0xFE, "253rd additional available character set", u16, 'O', "ro", '-', {}, none},
    {0x6481, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x6482, 0x00, "", u32, 'M', "vd", 'o', {}, 0},
    {0x6483, 0x00, "", u16, 'M', "vd", 'o', {}, 0xFFFF},
    {0x6484, 0x00, "", u8, 'M', "vd", 'o', {}, none},
    {0x6486, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x6487, 0x00, "", u16, 'M', "vd", 'o', {}, 0xFFFF},
    {0x6488, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 254}, none},
    {0x6488, 0x01, "general_state", u8, 'M', "vd", 'o', {}, none},
    {0x6488, 0x02, "specific_state_1_to_4", u8, 'M', "vd", 'o', {}, none},
    {0x6488, 0x03, "specific_state_5_to_8", u8, 'O', "vd", 'o', {}, none},
    {0x6488, 0xFE, "specific_state_1009_to_1012", u8, 'O', "vd", 'o', {}, none},
    {0x6489, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x648A, 0x00, "number_of_entries", u8, 'M', "ro", '-', {6, 6}, 6},
    {0x648A, 0x01, "fuel_rate", u16, 'M', "vd", 'o', {}, none},
    {0x648A, 0x02, "instantaneous_fuel_economy", u16, 'M', "vd", 'o', {}, none},
    {0x648A, 0x03, "average_fuel_economy", u16, 'M', "vd", 'o', {}, none},
    {0x648A, 0x04, "total_fuel_used", u32, 'M', "vd", 'o', {}, none},
    {0x648A, 0x05, "trip_fuel", u32, 'M', "vd", 'o', {}, none},
    {0x648A, 0x06, "total_idle_fuel_used", u32, 'M', "vd", 'o', {}, none},
    {0x648B, 0x00, "", u8, 'M', "vd", 'o', {}, none},
    {0x648C, 0x00, "", u8, 'M', "vd", 'o', {}, none},
    {0x648D, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 4}, none},
    {0x648D, 0x01, "total_idle_hours", u32, 'O', "vd", 'o', {}, none},
    {0x648D, 0x02, "total_vehicle_hours", u32, 'O', "vd", 'o', {}, none},
    {0x648D, 0x03, "total_engine_hours", u32, 'O', "vd", 'o', {}, none},
    {0x648D, 0x04, "total_power_takeoff_hours", u32, 'O', "vd", 'o', {}, none},
    {0x6520, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x6521, 0x00, "", u8, 'M', "vd", 'o', {}, none},
    {0x6522, 0x00, "number_of_entries", u8, 'M', "ro", '-', {1, 2}, none},
    {0x6522, 0x01, "total_vehicle_distance", u32, 'M', "vd", 'o', {}, none},
    {0x6522, 0x02, "trip_distance", u32, 'M', "vd", 'o', {}, none},
    {0x6523, 0x00, "number_of_entries", u8, 'M', "ro", '-', {8, 8}, 8},
    {0x6523, 0x01, "local_hour", i8, 'M', "vd", 'o', {}, 0},
    {0x6523, 0x02, "local_minute", i8, 'M', "vd", 'o', {}, 0},
    {0x6523, 0x03, "year", u8, 'M', "vd", 'o', {}, none},
    {0x6523, 0x04, "day", u8, 'M', "vd", 'o', {}, none},
    {0x6523, 0x05, "month", u8, 'M', "vd", 'o', {}, none},
    {0x6523, 0x06, "hour", u8, 'M', "vd", 'o', {}, none},
    {0x6523, 0x07, "minute", u8, 'M', "vd", 'o', {}, none},
    {0x6523, 0x08, "second", u8, 'M', "vd", 'o', {}, none},
    {0x6524, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 2}, 2},
    {0x6524, 0x01, "driver_1", text, 'M', "vd", '-', {}, none},
    {0x6524, 0x02, "driver_2", text, 'M', "vd", '-', {}, none},
    {0x6525, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 2}, 2},
    {0x6525, 0x01, "driver_1", u16, 'M', "vd", 'o', {}, none},
    {0x6525, 0x02, "driver_2", u16, 'M', "vd", 'o', {}, none},
    {0x6660, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 2}, 2},
    {0x6660, 0x01, "latitude", u32, 'M', "vd", 'o', {}, none},
    {0x6660, 0x02, "longitude", u32, 'M', "vd", 'o', {}, none},
    {0x6661, 0x00, "", u8, 'M', "vd", '-', {}, 0xFF},
    {0x6662, 0x00, "", u16, 'M', "vd", 'o', {}, none},
    {0x6663, 0x00, "", u16, 'M', "vd", '-', {}, none},
    {0x6664, 0x00, "", u32, 'M', "vd", 'o', {}, 0},
    {0x6665, 0x00, "", u16, 'M', "vd", '-', {}, 0xFFFF},
    {0x6680, 0x00, "number_of_entries", u8, 'M', "ro", '-', {8, 8}, 8},
    {0x6680, 0x01, "local_hour", i8, 'M', "vd", 'o', {}, 0},
    {0x6680, 0x02, "local_minute", i8, 'M', "vd", 'o', {}, 0},
    {0x6680, 0x03, "year", u8, 'M', "vd", 'o', {}, none},
    {0x6680, 0x04, "day", u8, 'M', "vd", 'o', {}, none},
    {0x6680, 0x05, "month", u8, 'M', "vd", 'o', {}, none},
    {0x6680, 0x06, "hour", u8, 'M', "vd", 'o', {}, none},
    {0x6680, 0x07, "minute", u8, 'M', "vd", 'o', {}, none},
    {0x6680, 0x08, "second", u8, 'M', "vd", 'o', {}, none},
    {0x66C0, 0x00, "", boolean, 'M', "vd", 'o', {}, 1},
    {0x6700, 0x00, "", u16, 'M', "vd", 'o', {}, 0},
    {0x6720, 0x00, "", domain, 'M', "vd", '-', {}, none},
    {0x6721, 0x00, "number_of_entries", u8, 'M', "ro", '-', {2, 2}, 2},
    {0x6721, 0x01, "number_incoming_passengers", u16, 'M', "vd", '-', {}, 0},
    {0x6721, 0x02, "number_outgoing_passengers", u16, 'M', "vd", '-', {}, 0},
    {0x6722, 0x00, "", u16, 'M', "vd", 'o', {}, 0},
    {0x6723, 0x00, "", u8, 'M', "vd", 'o', {}, 0},
    {0x6740, 0x00, "number_of_errors", u8, 'M', "rw", 'o', {0, 254}, none},
    {0x6740, 0x01, "short_error_field_1", u32, 'M', "rw", '-', {}, none},
    {0x6740, 0x02, "short_error_field_2", u32, 'O', "ro", '-', {}, none},
    {0x6740, 0xFE, "short_error_field_254", u32, 'O', "ro", '-', {}, none},
    {0x6741, 0x00, "", domain, 'M', "vd", '-', {}, none},
    {0x6742, 0x00, "number_of_messages", u8, 'M', "rw", '-', {0, 254}, none},
    {0x6742, 0x01, "message_1", octets, 'M', "rw", '-', {}, none},
    {0x6742, 0x02, "message_2", octets, 'O', "vd", '-', {}, none},
    {0x6742, 0xFE, "message_254", octets, 'O', "vd", '-', {}, none},
    {0x6743, 0x00, "number_of_messages", u8, 'M', "rw", '-', {0, 254}, none},
    {0x6743, 0x01, "message_1", octets, 'M', "rw", '-', {}, none},
    {0x6743, 0x02, "message_2", octets, 'O', "vd", '-', {}, none},
    {0x6743, 0xFE, "message_254", octets, 'O', "vd", '-', {}, none},
    {0x6744, 0x00, "number_of_messages", u8, 'M', "rw", '-', {0, 254}, none},
    {0x6744, 0x01, "message_1", octets, 'M', "rw", '-', {}, none},
    {0x6744, 0x02, "message_2", octets, 'O', "vd", '-', {}, none},
    {0x6744, 0xFE, "message_254", octets, 'O', "vd", '-', {}, none},
    {0x6760, 0x00, "", u32, 'M', "ro", 'o', {}, none},
    {0x6761, 0x00, "", u32, 'M', "rw", 'o', {}, 0},
    {0x6762, 0x00, "number_of_input_groups", u8, 'M', "ro", '-', {1, 4}, none},
    {0x6762, 0x01, "input_group_1", u32, 'M', "ro", 'o', {}, none},
    {0x6762, 0x02, "input_group_2", u32, 'O', "ro", 'o', {}, none},
    {0x6762, 0x04, "input_group_4", u32, 'O', "ro", 'o', {}, none},
    {0x6763, 0x00, "number_of_output_groups", u8, 'M', "ro", '-', {1, 4}, none},
    {0x6763, 0x01, "output_group_1", u32, 'M', "vd", 'o', {}, 0},
    {0x6763, 0x02, "output_group_2", u32, 'O', "vd", 'o', {}, 0},
    {0x6763, 0x04, "output_group_4", u32, 'O', "vd", 'o', {}, 0},
};
// clang-format on

/// The name with the number that stands for `#` at this sub-index.
std::string name_at(const EntryInfo& entry, unsigned sub) {
  std::string name(entry.name);
  const std::size_t at = name.find('#');
  if (at == std::string::npos) return name;
  return name.replace(at, 1, std::to_string(entry.first_number + sub - entry.sub_first));
}
std::string_view access_of(const EntryInfo& entry) {
  if (entry.access_by_device) return "vd";
  return entry.access == Access::rw ? "rw" : entry.access == Access::ro ? "ro" : "?";
}
char mapping_of(const EntryInfo& entry) {
  return "-od"[static_cast<unsigned>(entry.mapping)];
}
std::int64_t initial_of(const EntryInfo& entry) {
  const bool is_printed =
      entry.initial.kind == Default::Kind::number ||
      (entry.initial.kind == Default::Kind::highest_sub && entry.initial.number != 0);
  return is_printed ? entry.initial.number : none;
}

TEST(Cia407, EntriesAreThoseOfClause9) {
  for (const Expected& expected : entries) {
    SCOPED_TRACE(testing::Message() << std::hex << expected.index << "h " << expected.sub);
    const ObjectInfo* object = find_object(cia407::profile, expected.index);
    ASSERT_NE(object, nullptr);
    const EntryInfo* entry = find_entry(*object, expected.sub);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(name_at(*entry, expected.sub), expected.name);
    EXPECT_EQ(static_cast<unsigned>(entry->type), expected.type);
    EXPECT_EQ(entry->category == Category::optional ? 'O' : 'M', expected.category);
    EXPECT_EQ(access_of(*entry), expected.access);
    EXPECT_EQ(mapping_of(*entry), expected.pdo);
    EXPECT_EQ(initial_of(*entry), expected.initial);
    if (expected.range.low > expected.range.high) continue;
    EXPECT_EQ(entry->value.limits.kind, Limits::Kind::absolute);
    EXPECT_EQ(entry->value.limits.low, expected.range.low);
    EXPECT_EQ(entry->value.limits.high, expected.range.high);
  }
}

TEST(Cia407, NoEntryIsThereThatClause9DoesNotPrint) {
  for (const ObjectInfo* object : cia407::profile.objects) {
    if (object->index < 0x6000 || object->index == 0x67FF) continue;
    unsigned first = 0;
    unsigned last = 0;
    for (const Expected& expected : entries) {
      if (expected.index != object->index) continue;
      last = expected.sub;
    }
    for (const EntryInfo& entry : object->entries()) {
      EXPECT_EQ(entry.sub_first, first) << object->name;
      first = entry.last_sub() + 1U;
    }
    EXPECT_EQ(first - 1, last) << object->name;
  }
}

TEST(Cia407, WhoConsumesAnObjectIsWrittenTo) {  // 9.2.1, clause 6
  for (const ObjectInfo* object : cia407::profile.objects) {
    // What stands in the display itself, and outputs, are consumed by nobody else.
    const bool is_own =
        (object->index >= 0x6200 && object->index <= 0x6203) || object->index == 0x6763;
    for (const EntryInfo& entry : object->entries()) {
      if (!entry.access_by_device) continue;
      EXPECT_EQ(entry.access, is_own || object->index == 0x6741 ? Access::rw : Access::ro);
      EXPECT_EQ(entry.consumer_access, is_own ? Access::none : Access::wo) << object->name;
    }
  }
}

struct ExpectedObject {
  unsigned index;
  const char* clause;
  const char* name;
  unsigned code;
};
constexpr ExpectedObject expected_objects[] = {
    {0x6000, "9.2.3.1", "supported_virtual_device_types", 8},
    {0x6001, "9.2.4", "events_from_virtual_devices", 8},
    {0x6002, "9.2.5", "events_for_virtual_devices", 8},
    {0x6100, "9.2.6.1", "vehicle_ID", 7},
    {0x6101, "9.2.6.2", "body_ID", 7},
    {0x6102, "9.2.6.3", "garage_ID", 7},
    {0x6103, "9.2.6.4", "radio_ID", 7},
    {0x6104, "9.2.6.5", "vehicle_class", 7},
    {0x6105, "9.2.6.6", "number_of_vehicle_units", 7},
    {0x6106, "9.2.6.7", "driver_schedule_number", 7},
    {0x6107, "9.2.6.8", "route_destination_ID", 7},
    {0x6108, "9.2.6.9", "journey_direction", 7},
    {0x6109, "9.2.6.10", "stop_point_ID", 7},
    {0x610A, "9.2.6.11", "number_of_running_in_route_representation", 7},
    {0x610B, "9.2.6.12", "line_short_representation", 8},
    {0x610C, "9.2.6.13", "text_line/route_description", 8},
    {0x610D, "9.2.6.14", "text_of_destination", 8},
    {0x610E, "9.2.6.15", "local_time_and_date", 8},
    {0x610F, "9.2.6.16", "time_standby", 7},
    {0x6110, "9.2.6.17", "route_segment_number", 7},
    {0x6111, "9.2.6.18", "fare_zone", 7},
    {0x6112, "9.2.6.19", "text_of_stop_point", 8},
    {0x6113, "9.2.6.20", "previous_route_segment", 7},
    {0x6114, "9.2.6.21", "previous_fare_zone", 7},
    {0x6115, "9.2.6.22", "scheduled_time_and_date", 8},
    {0x6116, "9.2.6.23", "blocking_of_ticket_canceller", 7},
    {0x6117, "9.2.6.24", "traffic_light_priority_request", 7},
    {0x6118, "9.2.6.25", "stop_point_short_representation", 8},
    {0x6119, "9.2.6.26", "inside_temperature", 7},
    {0x611A, "9.2.6.27", "car_mileage", 7},
    {0x611B, "9.2.6.28", "car_mileage_calibration_information", 7},
    {0x611C, "9.2.6.29", "vehicle_ID_text", 7},
    {0x611D, "9.2.6.30", "body_ID_text", 7},
    {0x611E, "9.2.6.31", "garage_ID_text", 7},
    {0x611F, "9.2.6.32", "radio_ID_text", 7},
    {0x6120, "9.2.6.33", "stop_point_ID_text", 7},
    {0x6121, "9.2.6.34", "route_destination_ID_text", 7},
    {0x6122, "9.2.6.35", "driver_schedule_number_text", 7},
    {0x6123, "9.2.6.36", "vehicle_speed", 7},
    {0x6190, "9.2.7.1", "driver_ID", 7},
    {0x6191, "9.2.7.2", "destination_number", 7},
    {0x6192, "9.2.7.3", "line_ID", 7},
    {0x6193, "9.2.7.4", "route_number", 7},
    {0x6194, "9.2.7.5", "block_ID", 7},
    {0x6195, "9.2.7.6", "journey_number", 7},
    {0x6196, "9.2.7.7", "line_ID_text", 7},
    {0x6197, "9.2.7.8", "block_ID_text", 7},
    {0x6198, "9.2.7.9", "driver_ID_text", 7},
    {0x6200, "9.2.8.1", "XML_text", 8},
    {0x6201, "9.2.8.2", "special_character_files", 8},
    {0x6202, "9.2.8.3", "referenced_files_for_XML_files", 8},
    {0x6203, "9.2.8.4", "display_mapping", 8},
    {0x6204, "9.2.8.5", "bus_stop_request", 7},
    {0x6205, "9.2.8.6", "character_set", 8},
    {0x6481, "9.2.15.1", "wheel_based_vehicle_speed", 7},
    {0x6482, "9.2.15.2", "vehicle_mileage", 7},
    {0x6483, "9.2.15.3", "vehicle_mileage_precision", 7},
    {0x6484, "9.2.15.4", "drive_flag_and_direction_flag", 7},
    {0x6486, "9.2.15.5", "compass_bearing", 7},
    {0x6487, "9.2.15.6", "compass_bearing_precision", 7},
    {0x6488, "9.2.15.7", "state_of_doors", 8},
    {0x6489, "9.2.15.8", "ambient_air_temperature", 7},
    {0x648A, "9.2.15.9", "fuel_economy", 9},
    {0x648B, "9.2.15.10", "brake_switch", 7},
    {0x648C, "9.2.15.11", "engine_coolant_temperature", 7},
    {0x648D, "9.2.15.12", "operation_times", 8},
    {0x6520, "9.2.17.1", "tachograph_speed", 7},
    {0x6521, "9.2.17.2", "drive_recognition_and_direction_indication", 7},
    {0x6522, "9.2.17.3", "high_resolution_vehicle_distance", 8},
    {0x6523, "9.2.17.4", "tachograph_time_and_date", 9},
    {0x6524, "9.2.17.5", "tachograph_driver_ID", 8},
    {0x6525, "9.2.17.6", "continuous_driving_time", 8},
    {0x6660, "9.2.21.1", "position", 8},
    {0x6661, "9.2.21.2", "position_precision", 7},
    {0x6662, "9.2.21.3", "GPS_based_speed", 7},
    {0x6663, "9.2.21.4", "GPS_based_heading", 7},
    {0x6664, "9.2.21.5", "GPS_mileage", 7},
    {0x6665, "9.2.21.6", "GPS_mileage_precision", 7},
    {0x6680, "9.2.22.1", "time_universal_reference", 9},
    {0x66C0, "9.2.24.1", "flag_direction_forward_selection", 7},
    {0x6700, "9.2.25.1", "passenger_counting_in_and_out_per_door", 7},
    {0x6720, "9.2.26.1", "passenger_counting_manager_data", 7},
    {0x6721, "9.2.26.2", "total_in_out_passenger_counting_value", 8},
    {0x6722, "9.2.26.3", "counter_passenger_sum", 7},
    {0x6723, "9.2.26.4", "passenger_capacity_usage", 7},
    {0x6740, "9.2.27.1", "short_diagnostic_error_field", 8},
    {0x6741, "9.2.27.2", "extended_diagnostic_message_file", 7},
    {0x6742, "9.2.27.3", "error_class_1_messages", 8},
    {0x6743, "9.2.27.4", "error_class_2_messages", 8},
    {0x6744, "9.2.27.5", "error_class_3_messages", 8},
    {0x6760, "9.2.28.1", "digital_input", 7},
    {0x6761, "9.2.28.2", "digital_output", 7},
    {0x6762, "9.2.28.3", "analogue_input", 8},
    {0x6763, "9.2.28.4", "analogue_output", 8},
};

TEST(Cia407, ObjectsAreThoseOfClause9) {
  for (const ExpectedObject& expected : expected_objects) {
    SCOPED_TRACE(expected.name);
    const ObjectInfo* object = find_object(cia407::profile, expected.index);
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->clause, expected.clause);
    EXPECT_EQ(object->name, expected.name);
    EXPECT_EQ(static_cast<unsigned>(object->code), expected.code);
    EXPECT_EQ(object->category, Category::conditional) << "6000h, precisions, and clause 6";
    EXPECT_FALSE(object->condition.empty());
    EXPECT_FALSE(object->description.empty());
  }
  // 67FFh has no object description; 1001h and 1029h stand in clause 8.
  EXPECT_EQ(cia407::profile.objects.size(), std::size(expected_objects) + 3);
}

TEST(Cia407, PrecisionsAreThereWhereTheirValuesAre) {  // errata 2, 104
  constexpr struct {
    unsigned index;
    const char* condition;
  } precisions[] = {{0x611B, "if object 611Ah is implemented"},
                    {0x6483, "if object 6482h is implemented"},
                    {0x6487, "if object 6486h is implemented"},
                    {0x6661, "if object 6660h is implemented"},
                    {0x6665, "if object 6664h is implemented"}};
  for (const auto& [index, condition] : precisions) {
    EXPECT_EQ(find_object(cia407::profile, index)->condition, condition);
  }
}

TEST(Cia407, TextsHaveTheLengthsOfClause9) {
  constexpr struct {
    unsigned index;
    unsigned octets;
  } texts[] = {{0x610C, 128}, {0x610D, 128}, {0x6112, 128}, {0x6524, 19},
               {0x6742, 64},  {0x6743, 64},  {0x6744, 64}};
  for (const auto& [index, length] : texts) {
    EXPECT_EQ(find_entry(*find_object(cia407::profile, index), 1)->capacity, length);
  }
}

TEST(Cia407, Object1029SaysWhatAnErrorWithinTheDeviceDoes) {  // 8.1.3
  const EntryInfo& entry = *find_entry(*find_object(cia407::profile, 0x1029), 2);
  EXPECT_EQ(entry.name, "Internal_Device_Error");
  EXPECT_EQ(entry.access, Access::rw);
  EXPECT_EQ(entry.category, Category::optional);
  EXPECT_EQ(entry.initial.number, 0);
  EXPECT_EQ(entry.value.limits.low, 0);
  EXPECT_EQ(entry.value.limits.high, 2);
  ASSERT_EQ(entry.value.names.size(), 3U);
  EXPECT_EQ(entry.value.names[1].name, "no change of state");
}

TEST(Cia407, Object67FFIsADeviceType) {  // 9.2.30.1
  const ObjectInfo& object = *find_object(cia407::profile, 0x67FF);
  EXPECT_EQ(object.entry.type, DataType::unsigned32);
  EXPECT_EQ(object.entry.fields.size(), cia407::profile.device_type.size());
}

TEST(Cia407, RecordTypesHaveTheMembersOfClause9) {  // 9.2.2; errata 48, 66
  constexpr struct {
    const char* name;
    unsigned type;
  } fuel[] = {{"number_of_entries", u8},
              {"fuel_rate", u16},
              {"instantaneous_fuel_economy", u16},
              {"average_fuel_economy", u16},
              {"total_fuel_used", u32},
              {"trip_fuel", u32},
              {"total_idle_fuel_used", u32}},
    time[] = {{"number_of_entries", u8},
              {"local_hour", i8},
              {"local_minute", i8},
              {"year", u8},
              {"day", u8},
              {"month", u8},
              {"hour", u8},
              {"minute", u8},
              {"second", u8}};
  const auto expect = [](const RecordTypeInfo& type, unsigned index, const auto& members) {
    EXPECT_EQ(type.index, index);
    ASSERT_EQ(type.members.size(), std::size(members));
    for (std::size_t sub = 0; sub < std::size(members); ++sub) {
      EXPECT_EQ(type.members[sub].sub_first, sub);
      EXPECT_EQ(type.members[sub].name, members[sub].name);
      EXPECT_EQ(static_cast<unsigned>(type.members[sub].type), members[sub].type);
    }
  };
  ASSERT_EQ(cia407::profile.record_types.size(), 2U);
  expect(cia407::profile.record_types[0], 0x80, fuel);
  expect(cia407::profile.record_types[1], 0x81, time);
}

}  // namespace
}  // namespace canvoy::cia407_entries_test
