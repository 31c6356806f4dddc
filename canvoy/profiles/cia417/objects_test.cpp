// Each entry of CiA 417-4 as its clause prints it, typed from the text.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "canvoy/profiles/cia417.hpp"

namespace canvoy::cia417_objects_test {
namespace {

constexpr DataType u8 = DataType::unsigned8;
constexpr DataType u16 = DataType::unsigned16;
constexpr DataType u32 = DataType::unsigned32;
constexpr DataType u48 = DataType::unsigned48;
constexpr DataType i8 = DataType::integer8;
constexpr DataType i16 = DataType::integer16;
constexpr DataType i32 = DataType::integer32;
constexpr DataType dom = DataType::domain;
constexpr Mapping no = Mapping::no;
constexpr Mapping may = Mapping::optional;
constexpr Mapping yes = Mapping::by_default;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t int32_min = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t int32_max = std::numeric_limits<std::int32_t>::max();

/// "ro/rw": who provides it has it ro, who consumes it rw (4.1.2). Category: mandatory, optional,
/// conditional.
struct ExpectedEntries {
  const char* clause;
  unsigned index;
  unsigned last_index;
  unsigned sub;
  unsigned last_sub;
  DataType type;
  const char* access;
  Mapping mapping;
  char category;
  std::int64_t initial;
};

constexpr ExpectedEntries entries[] = {
    // 4.2 to 4.8: inputs, outputs, doors.
    {"4.2.1", 0x6000, 0x6000, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.2.1", 0x6000, 0x6000, 0x01, 0x01, u16, "ro", no, 'M', none},
    {"4.2.1", 0x6000, 0x6000, 0x02, 0x02, u16, "ro", no, 'M', none},
    {"4.2.1", 0x6000, 0x6000, 0x03, 0xFE, u16, "ro", no, 'O', none},
    {"4.2.2", 0x6001, 0x6001, 0x00, 0x00, u8, "rw", no, 'M', 1},
    {"4.2.3", 0x6010, 0x6010, 0x00, 0x00, u48, "ro/rw", yes, 'M', 0},
    {"4.2.4", 0x6011, 0x6011, 0x00, 0x00, u48, "ro/rw", yes, 'M', 0},
    {"4.2.5", 0x6012, 0x6012, 0x00, 0x00, u48, "ro/rw", yes, 'M', 0},
    {"4.2.6", 0x6020, 0x6020, 0x00, 0x00, u32, "rw", no, 'M', none},
    {"4.3.1", 0x6100, 0x611F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.3.1", 0x6100, 0x611F, 0x01, 0x01, u48, "ro/rw", no, 'M', none},
    {"4.3.1", 0x6100, 0x611F, 0x02, 0xFE, u48, "ro/rw", no, 'O', none},
    {"4.3.2", 0x6120, 0x613F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.3.2", 0x6120, 0x613F, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.3.2", 0x6120, 0x613F, 0x02, 0xFE, u32, "rw", no, 'C', none},
    {"4.3.3", 0x6140, 0x615F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.3.3", 0x6140, 0x615F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.3.3", 0x6140, 0x615F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.3.4", 0x6160, 0x617F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.3.4", 0x6160, 0x617F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.3.4", 0x6160, 0x617F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.3.5", 0x6180, 0x619F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.3.5", 0x6180, 0x619F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.3.5", 0x6180, 0x619F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.4.1", 0x6200, 0x621F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.4.1", 0x6200, 0x621F, 0x01, 0x01, u48, "ro/rw", no, 'M', 0},
    {"4.4.1", 0x6200, 0x621F, 0x02, 0xFE, u48, "ro/rw", no, 'O', 0},
    {"4.5.1", 0x6220, 0x623F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.5.1", 0x6220, 0x623F, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.5.1", 0x6220, 0x623F, 0x02, 0xFE, u32, "rw", no, 'C', none},
    {"4.5.2", 0x6240, 0x625F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.5.2", 0x6240, 0x625F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.5.2", 0x6240, 0x625F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.5.3", 0x6260, 0x627F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.5.3", 0x6260, 0x627F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.5.3", 0x6260, 0x627F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.5.4", 0x6280, 0x629F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.5.4", 0x6280, 0x629F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.5.4", 0x6280, 0x629F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.6.1", 0x6300, 0x6300, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.6.1", 0x6300, 0x6300, 0x01, 0x01, u16, "ro/rw", yes, 'M', 0xFFFF},
    {"4.6.1", 0x6300, 0x6300, 0x02, 0x02, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.6.1", 0x6300, 0x6300, 0x03, 0x03, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.6.1", 0x6300, 0x6300, 0x04, 0x04, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.7.1", 0x6301, 0x6301, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.1", 0x6301, 0x6301, 0x01, 0x01, u16, "ro/rw", yes, 'M', 0xFFFF},
    {"4.7.1", 0x6301, 0x6301, 0x02, 0x02, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.7.1", 0x6301, 0x6301, 0x03, 0x03, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.7.1", 0x6301, 0x6301, 0x04, 0x04, u16, "ro/rw", yes, 'O', 0xFFFF},
    {"4.7.2", 0x6302, 0x6302, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.2", 0x6302, 0x6302, 0x01, 0x01, u16, "ro/rw", may, 'M', 0xFFFF},
    {"4.7.2", 0x6302, 0x6302, 0x02, 0x02, u16, "ro/rw", may, 'O', 0xFFFF},
    {"4.7.2", 0x6302, 0x6302, 0x03, 0x03, u16, "ro/rw", may, 'O', 0xFFFF},
    {"4.7.2", 0x6302, 0x6302, 0x04, 0x04, u16, "ro/rw", may, 'O', 0xFFFF},
    {"4.7.3", 0x6304, 0x6304, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.3", 0x6304, 0x6304, 0x01, 0x01, u8, "rw", no, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x02, 0x02, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x03, 0x03, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x04, 0x04, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x05, 0x05, u8, "rw", no, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x06, 0x06, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x07, 0x07, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x08, 0x08, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x09, 0x09, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x0A, 0x0A, u8, "rw", may, 'O', 0},
    {"4.7.3", 0x6304, 0x6304, 0x0B, 0x0B, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.4", 0x6305, 0x6305, 0x01, 0x01, u8, "rw", no, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x02, 0x02, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x03, 0x03, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x04, 0x04, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x05, 0x05, u8, "rw", no, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x06, 0x06, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x07, 0x07, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x08, 0x08, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x09, 0x09, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x0A, 0x0A, u8, "rw", may, 'O', 0},
    {"4.7.4", 0x6305, 0x6305, 0x0B, 0x0B, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.5", 0x6306, 0x6306, 0x01, 0x01, u8, "rw", no, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x02, 0x02, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x03, 0x03, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x04, 0x04, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x05, 0x05, u8, "rw", no, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x06, 0x06, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x07, 0x07, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x08, 0x08, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x09, 0x09, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x0A, 0x0A, u8, "rw", may, 'O', 0},
    {"4.7.5", 0x6306, 0x6306, 0x0B, 0x0B, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.7.6", 0x6307, 0x6307, 0x01, 0x01, u8, "rw", no, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x02, 0x02, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x03, 0x03, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x04, 0x04, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x05, 0x05, u8, "rw", no, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x06, 0x06, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x07, 0x07, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x08, 0x08, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x09, 0x09, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x0A, 0x0A, u8, "rw", may, 'O', 0},
    {"4.7.6", 0x6307, 0x6307, 0x0B, 0x0B, u8, "rw", may, 'O', 0},
    {"4.8.1", 0x6310, 0x6310, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.8.1", 0x6310, 0x6310, 0x01, 0x01, u8, "ro/rw", yes, 'M', 0xFF},
    {"4.8.1", 0x6310, 0x6310, 0x02, 0x02, u8, "ro/rw", yes, 'O', 0xFF},
    {"4.8.1", 0x6310, 0x6310, 0x03, 0x03, u8, "ro/rw", yes, 'O', 0xFF},
    {"4.8.1", 0x6310, 0x6310, 0x04, 0x04, u8, "ro/rw", yes, 'O', 0xFF},
    // 4.9 and 4.10: position.
    {"4.9.1", 0x6380, 0x6380, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.1", 0x6380, 0x6380, 0x01, 0x01, u16, "rw", no, 'M', none},
    {"4.9.1", 0x6380, 0x6380, 0x02, 0x02, u16, "rw", no, 'O', none},
    {"4.9.1", 0x6380, 0x6380, 0x03, 0x03, u16, "rw", no, 'O', none},
    {"4.9.1", 0x6380, 0x6380, 0x04, 0x04, u16, "rw", no, 'O', none},
    {"4.9.2", 0x6381, 0x6381, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.2", 0x6381, 0x6381, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.9.2", 0x6381, 0x6381, 0x02, 0x02, u32, "rw", no, 'O', none},
    {"4.9.2", 0x6381, 0x6381, 0x03, 0x03, u32, "rw", no, 'O', none},
    {"4.9.2", 0x6381, 0x6381, 0x04, 0x04, u32, "rw", no, 'O', none},
    {"4.9.3", 0x6382, 0x6382, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.3", 0x6382, 0x6382, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.9.3", 0x6382, 0x6382, 0x02, 0x02, u32, "rw", no, 'O', none},
    {"4.9.3", 0x6382, 0x6382, 0x03, 0x03, u32, "rw", no, 'O', none},
    {"4.9.3", 0x6382, 0x6382, 0x04, 0x04, u32, "rw", no, 'O', none},
    {"4.9.4", 0x6383, 0x6383, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.4", 0x6383, 0x6383, 0x01, 0x01, u32, "ro/rw", yes, 'M', none},
    {"4.9.4", 0x6383, 0x6383, 0x02, 0x02, u32, "ro/rw", may, 'O', none},
    {"4.9.4", 0x6383, 0x6383, 0x03, 0x03, u32, "ro/rw", may, 'O', none},
    {"4.9.4", 0x6383, 0x6383, 0x04, 0x04, u32, "ro/rw", may, 'O', none},
    {"4.9.5", 0x6384, 0x6384, 0x00, 0x00, u8, "ro", no, 'M', 3},
    {"4.9.5", 0x6384, 0x6384, 0x01, 0x01, u32, "rw", no, 'M', 10},
    {"4.9.5", 0x6384, 0x6384, 0x02, 0x02, u32, "rw", no, 'M', 10},
    {"4.9.5", 0x6384, 0x6384, 0x03, 0x03, u32, "rw", no, 'M', 1},
    {"4.9.6", 0x6385, 0x6385, 0x00, 0x00, u8, "ro", no, 'M', 3},
    {"4.9.6", 0x6385, 0x6385, 0x01, 0x01, u32, "rw", no, 'M', 10},
    {"4.9.6", 0x6385, 0x6385, 0x02, 0x02, u32, "rw", no, 'M', 10},
    {"4.9.6", 0x6385, 0x6385, 0x03, 0x03, u32, "rw", no, 'M', 1},
    {"4.9.7, A3", 0x6386, 0x6386, 0x00, 0x00, u8, "ro", no, 'M', 3},
    {"4.9.7, A3", 0x6386, 0x6386, 0x01, 0x01, u32, "rw", no, 'M', 10},
    {"4.9.7, A3", 0x6386, 0x6386, 0x02, 0x02, u32, "rw", no, 'M', 10},
    {"4.9.7, A3", 0x6386, 0x6386, 0x03, 0x03, u32, "rw", no, 'M', 1},
    {"4.9.8", 0x6387, 0x6387, 0x00, 0x00, u8, "ro", no, 'M', 3},
    {"4.9.8", 0x6387, 0x6387, 0x01, 0x01, u32, "rw", no, 'M', 10},
    {"4.9.8", 0x6387, 0x6387, 0x02, 0x02, u32, "rw", no, 'M', 10},
    {"4.9.8", 0x6387, 0x6387, 0x03, 0x03, u32, "rw", no, 'M', 1},
    {"4.9.9", 0x6390, 0x6390, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.9", 0x6390, 0x6390, 0x01, 0x01, i16, "ro/rw", yes, 'M', none},
    {"4.9.9", 0x6390, 0x6390, 0x02, 0x02, i16, "ro/rw", may, 'O', none},
    {"4.9.9", 0x6390, 0x6390, 0x03, 0x03, i16, "ro/rw", may, 'O', none},
    {"4.9.9", 0x6390, 0x6390, 0x04, 0x04, i16, "ro/rw", may, 'O', none},
    {"4.9.10", 0x6391, 0x6391, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.10", 0x6391, 0x6391, 0x01, 0x01, i16, "ro/rw", yes, 'M', none},
    {"4.9.10", 0x6391, 0x6391, 0x02, 0x02, i16, "ro/rw", may, 'O', none},
    {"4.9.10", 0x6391, 0x6391, 0x03, 0x03, i16, "ro/rw", may, 'O', none},
    {"4.9.10", 0x6391, 0x6391, 0x04, 0x04, i16, "ro/rw", may, 'O', none},
    {"4.9.11", 0x63B0, 0x63B0, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.11", 0x63B0, 0x63B0, 0x01, 0x01, u8, "ro", may, 'M', none},
    {"4.9.11", 0x63B0, 0x63B0, 0x02, 0xFE, u8, "ro", may, 'O', none},
    {"4.9.12", 0x63B1, 0x63B1, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.12", 0x63B1, 0x63B1, 0x01, 0x01, u8, "ro", may, 'M', none},
    {"4.9.12", 0x63B1, 0x63B1, 0x02, 0xFE, u8, "ro", may, 'O', none},
    {"4.9.13", 0x63B2, 0x63B2, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.13", 0x63B2, 0x63B2, 0x01, 0x01, u8, "ro", may, 'M', none},
    {"4.9.13", 0x63B2, 0x63B2, 0x02, 0xFE, u8, "ro", may, 'O', none},
    {"4.9.14", 0x63B3, 0x63B3, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.14", 0x63B3, 0x63B3, 0x01, 0x01, u8, "ro", may, 'M', none},
    {"4.9.14", 0x63B3, 0x63B3, 0x02, 0xFE, u8, "ro", may, 'O', none},
    {"4.9.15", 0x63B4, 0x63B4, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.15", 0x63B4, 0x63B4, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.15", 0x63B4, 0x63B4, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.16", 0x63B5, 0x63B5, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.16", 0x63B5, 0x63B5, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.16", 0x63B5, 0x63B5, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.17", 0x63B6, 0x63B6, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.17", 0x63B6, 0x63B6, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.17", 0x63B6, 0x63B6, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.18", 0x63B7, 0x63B7, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.18", 0x63B7, 0x63B7, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.18", 0x63B7, 0x63B7, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.19", 0x63B8, 0x63B8, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.19", 0x63B8, 0x63B8, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.19", 0x63B8, 0x63B8, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.20", 0x63B9, 0x63B9, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.20", 0x63B9, 0x63B9, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.20", 0x63B9, 0x63B9, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.21", 0x63BA, 0x63BA, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.21", 0x63BA, 0x63BA, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.21", 0x63BA, 0x63BA, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.22", 0x63BB, 0x63BB, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.22", 0x63BB, 0x63BB, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.9.22", 0x63BB, 0x63BB, 0x02, 0xFE, i32, "rw", no, 'O', none},
    {"4.9.23", 0x63C0, 0x63C0, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.23", 0x63C0, 0x63C0, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.23", 0x63C0, 0x63C0, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.23", 0x63C0, 0x63C0, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.23", 0x63C0, 0x63C0, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.24", 0x63C1, 0x63C1, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.24", 0x63C1, 0x63C1, 0x01, 0x01, u32, "ro/rw", no, 'M', none},
    {"4.9.24", 0x63C1, 0x63C1, 0x02, 0x02, u32, "ro/rw", no, 'O', none},
    {"4.9.24", 0x63C1, 0x63C1, 0x03, 0x03, u32, "ro/rw", no, 'O', none},
    {"4.9.24", 0x63C1, 0x63C1, 0x04, 0x04, u32, "ro/rw", no, 'O', none},
    {"4.9.25", 0x63C2, 0x63C2, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.25", 0x63C2, 0x63C2, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.25", 0x63C2, 0x63C2, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.25", 0x63C2, 0x63C2, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.25", 0x63C2, 0x63C2, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.26", 0x63C4, 0x63C4, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.26", 0x63C4, 0x63C4, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.26", 0x63C4, 0x63C4, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.26", 0x63C4, 0x63C4, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.26", 0x63C4, 0x63C4, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.27", 0x63C5, 0x63C5, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.27", 0x63C5, 0x63C5, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.27", 0x63C5, 0x63C5, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.27", 0x63C5, 0x63C5, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.27", 0x63C5, 0x63C5, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.28", 0x63C6, 0x63C6, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.28", 0x63C6, 0x63C6, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.28", 0x63C6, 0x63C6, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.28", 0x63C6, 0x63C6, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.28", 0x63C6, 0x63C6, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.29", 0x63C7, 0x63C7, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.29", 0x63C7, 0x63C7, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.9.29", 0x63C7, 0x63C7, 0x02, 0x02, u16, "ro/rw", no, 'O', none},
    {"4.9.29", 0x63C7, 0x63C7, 0x03, 0x03, u16, "ro/rw", no, 'O', none},
    {"4.9.29", 0x63C7, 0x63C7, 0x04, 0x04, u16, "ro/rw", no, 'O', none},
    {"4.9.30, A12", 0x63C8, 0x63C8, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.30, A12", 0x63C8, 0x63C8, 0x01, 0x01, u32, "ro/rw", no, 'M', none},
    {"4.9.30, A12", 0x63C8, 0x63C8, 0x02, 0x02, u32, "ro/rw", no, 'O', none},
    {"4.9.30, A12", 0x63C8, 0x63C8, 0x03, 0x03, u32, "ro/rw", no, 'O', none},
    {"4.9.30, A12", 0x63C8, 0x63C8, 0x04, 0x04, u32, "ro/rw", no, 'O', none},
    {"4.9.31, A12", 0x63C9, 0x63C9, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.31, A12", 0x63C9, 0x63C9, 0x01, 0x01, i16, "ro/rw", no, 'M', none},
    {"4.9.31, A12", 0x63C9, 0x63C9, 0x02, 0x02, i16, "ro/rw", no, 'O', none},
    {"4.9.31, A12", 0x63C9, 0x63C9, 0x03, 0x03, i16, "ro/rw", no, 'O', none},
    {"4.9.31, A12", 0x63C9, 0x63C9, 0x04, 0x04, i16, "ro/rw", no, 'O', none},
    {"4.9.32", 0x63D0, 0x63D0, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.32", 0x63D0, 0x63D0, 0x01, 0x01, u32, "ro", no, 'M', 0},
    {"4.9.32", 0x63D0, 0x63D0, 0x02, 0x02, u32, "ro", no, 'O', none},
    {"4.9.32", 0x63D0, 0x63D0, 0x03, 0x03, u32, "ro", no, 'O', none},
    {"4.9.33", 0x63D1, 0x63D1, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.33", 0x63D1, 0x63D1, 0x01, 0x01, u32, "ro", no, 'M', 0},
    {"4.9.33", 0x63D1, 0x63D1, 0x02, 0x02, u32, "ro", no, 'O', none},
    {"4.9.33", 0x63D1, 0x63D1, 0x03, 0x03, u32, "ro", no, 'O', none},
    {"4.9.34", 0x63D2, 0x63D2, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.34", 0x63D2, 0x63D2, 0x01, 0x01, u32, "ro", no, 'M', 0},
    {"4.9.34", 0x63D2, 0x63D2, 0x02, 0x02, u32, "ro", no, 'O', none},
    {"4.9.34", 0x63D2, 0x63D2, 0x03, 0x03, u32, "ro", no, 'O', none},
    {"4.9.35", 0x63D3, 0x63D3, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.9.35", 0x63D3, 0x63D3, 0x01, 0x01, u32, "ro", no, 'M', 0},
    {"4.9.35", 0x63D3, 0x63D3, 0x02, 0x02, u32, "ro", no, 'O', none},
    {"4.9.35", 0x63D3, 0x63D3, 0x03, 0x03, u32, "ro", no, 'O', none},
    {"4.10.1", 0x63A0, 0x63A0, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.10.1", 0x63A0, 0x63A0, 0x01, 0x01, u8, "ro", may, 'M', none},
    {"4.10.1", 0x63A0, 0x63A0, 0x02, 0xFE, u8, "ro", may, 'O', none},
    {"4.10.2", 0x63A1, 0x63A1, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.10.2", 0x63A1, 0x63A1, 0x01, 0x01, u8, "rw", may, 'M', 0},
    {"4.10.2", 0x63A1, 0x63A1, 0x02, 0xFE, u8, "rw", may, 'O', 0},
    {"4.10.3", 0x63A2, 0x63A2, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.10.3", 0x63A2, 0x63A2, 0x01, 0x01, u8, "rw", may, 'M', 0},
    {"4.10.3, A17", 0x63A2, 0x63A2, 0x02, 0xFE, u8, "rw", may, 'O', 0},
    // 4.11 to 4.13: drive, load, sensors.
    {"4.11.1.1", 0x6400, 0x6400, 0x00, 0x00, u16, "ro/rw", may, 'M', none},
    {"4.11.1.2", 0x6401, 0x6401, 0x00, 0x00, u16, "ro/rw", may, 'M', none},
    {"4.11.1.3", 0x6402, 0x6402, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.1.3", 0x6402, 0x6402, 0x01, 0x01, i16, "rw", no, 'O', 0},
    {"4.11.1.3", 0x6402, 0x6402, 0x02, 0x02, i16, "rw", no, 'O', 1},
    {"4.11.1.3", 0x6402, 0x6402, 0x03, 0x03, i16, "rw", no, 'O', 2},
    {"4.11.1.3", 0x6402, 0x6402, 0x04, 0x04, i16, "rw", no, 'O', 1},
    {"4.11.1.3", 0x6402, 0x6402, 0x05, 0x05, i16, "rw", no, 'O', 2},
    {"4.11.1.4", 0x6403, 0x6403, 0x00, 0x00, i8, "ro/rw", may, 'M', none},
    {"4.11.1.5", 0x6404, 0x6404, 0x00, 0x00, i8, "ro/rw", may, 'M', none},
    {"4.11.1.6", 0x6405, 0x6405, 0x00, 0x00, i16, "rw", may, 'M', none},
    {"4.11.1.7", 0x6406, 0x6406, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.1.8", 0x6408, 0x6408, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.1.8", 0x6408, 0x6408, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.11.1.8", 0x6408, 0x6408, 0x02, 0x02, u32, "ro", no, 'O', none},
    {"4.11.1.9", 0x6409, 0x6409, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.1.9", 0x6409, 0x6409, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.11.1.9", 0x6409, 0x6409, 0x02, 0x02, u32, "rw", no, 'O', none},
    {"4.11.1.10, A2", 0x640A, 0x640A, 0x00, 0x00, u32, "rw", may, 'M', none},
    {"4.11.1.11", 0x640B, 0x640B, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.1.11", 0x640B, 0x640B, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.11.1.11", 0x640B, 0x640B, 0x02, 0x02, u32, "rw", no, 'O', none},
    {"4.11.1.12", 0x640C, 0x640C, 0x00, 0x00, u8, "rw", no, 'M', none},
    {"4.11.1.13", 0x640D, 0x640D, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.1.13", 0x640D, 0x640D, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.11.1.13", 0x640D, 0x640D, 0x02, 0x06, u32, "rw", no, 'O', none},
    {"4.11.2", 0x640F, 0x640F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.2", 0x640F, 0x640F, 0x01, 0x01, dom, "rw", no, 'M', none},
    {"4.11.2", 0x640F, 0x640F, 0x02, 0xFE, dom, "rw", no, 'O', none},
    {"4.11.3.1", 0x6410, 0x6410, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.1", 0x6410, 0x6410, 0x01, 0x01, i8, "rw", no, 'M', 0},
    {"4.11.3.1", 0x6410, 0x6410, 0x02, 0x02, u8, "rw", no, 'M', none},
    {"4.11.3.2", 0x6411, 0x6411, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.2", 0x6411, 0x6411, 0x01, 0x01, i8, "rw", no, 'M', 0},
    {"4.11.3.2", 0x6411, 0x6411, 0x02, 0x02, u8, "rw", no, 'M', none},
    {"4.11.3.3", 0x6412, 0x6412, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.3", 0x6412, 0x6412, 0x01, 0x01, i8, "rw", no, 'M', 0},
    {"4.11.3.3", 0x6412, 0x6412, 0x02, 0x02, u8, "rw", no, 'M', none},
    {"4.11.3.4", 0x6413, 0x6413, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.4", 0x6413, 0x6413, 0x01, 0x01, i8, "rw", no, 'M', 0},
    {"4.11.3.4", 0x6413, 0x6413, 0x02, 0x02, u8, "rw", no, 'M', none},
    {"4.11.3.5", 0x6414, 0x6414, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.5", 0x6414, 0x6414, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.5", 0x6414, 0x6414, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.6", 0x6415, 0x6415, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.6", 0x6415, 0x6415, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.6", 0x6415, 0x6415, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.7", 0x6416, 0x6416, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.7", 0x6416, 0x6416, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.7", 0x6416, 0x6416, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.8", 0x6417, 0x6417, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.8", 0x6417, 0x6417, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.8", 0x6417, 0x6417, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.9", 0x6418, 0x6418, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.9", 0x6418, 0x6418, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.9", 0x6418, 0x6418, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.10", 0x6419, 0x6419, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.10", 0x6419, 0x6419, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.10", 0x6419, 0x6419, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.11", 0x641A, 0x641A, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.11", 0x641A, 0x641A, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.11", 0x641A, 0x641A, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.12", 0x641B, 0x641B, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.12", 0x641B, 0x641B, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.12", 0x641B, 0x641B, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.13", 0x641C, 0x641C, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.13", 0x641C, 0x641C, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.13", 0x641C, 0x641C, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.14", 0x641D, 0x641D, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.3.14", 0x641D, 0x641D, 0x01, 0x01, u32, "rw", no, 'M', 1},
    {"4.11.3.14", 0x641D, 0x641D, 0x02, 0x02, u32, "rw", no, 'M', 1},
    {"4.11.3.15", 0x641E, 0x641E, 0x00, 0x00, u8, "rw", no, 'M', 0},
    {"4.11.4.1", 0x6420, 0x6420, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.4.2", 0x6421, 0x6421, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.4.2", 0x6421, 0x6421, 0x01, 0x01, i32, "rw", no, 'M', int32_min},
    {"4.11.4.2", 0x6421, 0x6421, 0x02, 0x02, i32, "rw", no, 'M', int32_max},
    {"4.11.4.3", 0x6422, 0x6422, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.4.3, A14", 0x6422, 0x6422, 0x01, 0x01, i32, "rw", no, 'M', int32_min},
    {"4.11.4.3, A14", 0x6422, 0x6422, 0x02, 0x02, i32, "rw", no, 'M', int32_max},
    {"4.11.4.4", 0x6423, 0x6423, 0x00, 0x00, u32, "rw", no, 'M', 1},
    {"4.11.4.5", 0x6424, 0x6424, 0x00, 0x00, u32, "rw", no, 'M', 1},
    {"4.11.5.1", 0x6428, 0x6428, 0x00, 0x00, i32, "rw", may, 'M', 0},
    {"4.11.6.1", 0x6430, 0x6430, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.6.2", 0x6431, 0x6431, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.6.3", 0x6432, 0x6432, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.6.4", 0x6433, 0x6433, 0x00, 0x00, i32, "ro/rw", may, 'M', none},
    {"4.11.6.5", 0x6434, 0x6434, 0x00, 0x00, i16, "rw", no, 'M', none},
    {"4.11.6.6", 0x6435, 0x6435, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.6.6", 0x6435, 0x6435, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.11.6.6", 0x6435, 0x6435, 0x02, 0x02, i32, "rw", no, 'M', none},
    {"4.11.6.7", 0x6436, 0x6436, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.11.6.7", 0x6436, 0x6436, 0x01, 0x01, i32, "rw", no, 'M', none},
    {"4.11.6.7", 0x6436, 0x6436, 0x02, 0x02, i32, "rw", no, 'M', none},
    {"4.11.6.8", 0x6437, 0x6437, 0x00, 0x00, i32, "rw", no, 'M', none},
    {"4.11.6.9", 0x6438, 0x6438, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.11.6.9", 0x6438, 0x6438, 0x01, 0x01, u16, "rw", no, 'M', none},
    {"4.11.6.9", 0x6438, 0x6438, 0x02, 0x02, u16, "rw", no, 'M', none},
    {"4.11.6.9", 0x6438, 0x6438, 0x03, 0xFE, u16, "rw", no, 'O', none},
    {"4.12.1", 0x6480, 0x6480, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.12.1", 0x6480, 0x6480, 0x01, 0x01, u16, "ro/rw", yes, 'M', none},
    {"4.12.1", 0x6480, 0x6480, 0x02, 0x02, u16, "rw", no, 'O', 2},
    {"4.12.2", 0x6481, 0x6481, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.12.2", 0x6481, 0x6481, 0x01, 0x01, u16, "rw", no, 'M', none},
    {"4.12.2", 0x6481, 0x6481, 0x02, 0x02, u16, "rw", no, 'M', none},
    {"4.12.3", 0x6482, 0x6482, 0x00, 0x00, u8, "ro", no, 'M', 2},
    {"4.12.3", 0x6482, 0x6482, 0x01, 0x01, u8, "ro/rw", yes, 'M', none},
    {"4.12.3", 0x6482, 0x6482, 0x02, 0x02, u8, "rw", no, 'M', 0x0F},
    {"4.12.4", 0x6483, 0x6483, 0x00, 0x00, u8, "ro", no, 'M', 4},
    {"4.12.4", 0x6483, 0x6483, 0x01, 0x01, u16, "rw", no, 'M', none},
    {"4.12.4", 0x6483, 0x6483, 0x02, 0x02, u16, "rw", no, 'M', none},
    {"4.12.4", 0x6483, 0x6483, 0x03, 0x03, u16, "rw", no, 'M', none},
    {"4.12.4", 0x6483, 0x6483, 0x04, 0x04, u16, "rw", no, 'M', none},
    {"4.12.5", 0x6484, 0x6484, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.12.5", 0x6484, 0x6484, 0x01, 0x01, u16, "ro/rw", no, 'M', none},
    {"4.12.5", 0x6484, 0x6484, 0x02, 0xFE, u16, "ro/rw", no, 'O', none},
    {"4.12.6", 0x6485, 0x6485, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.12.6", 0x6485, 0x6485, 0x01, 0x01, u16, "rw", no, 'M', none},
    {"4.13.1", 0x6500, 0x651F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.13.1", 0x6500, 0x651F, 0x01, 0x01, u48, "ro/rw", no, 'M', none},
    {"4.13.1", 0x6500, 0x651F, 0x02, 0xFE, u48, "ro/rw", no, 'O', none},
    {"4.13.2", 0x6520, 0x653F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.13.2", 0x6520, 0x653F, 0x01, 0x01, u32, "rw", no, 'M', none},
    {"4.13.2", 0x6520, 0x653F, 0x02, 0xFE, u32, "rw", no, 'C', none},
    {"4.13.3", 0x6540, 0x655F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.13.3", 0x6540, 0x655F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.13.3", 0x6540, 0x655F, 0x02, 0xFE, u32, "rw", no, 'O', none},
    {"4.13.4, A18", 0x6560, 0x657F, 0x00, 0x00, u8, "ro", no, 'M', none},
    {"4.13.4", 0x6560, 0x657F, 0x01, 0x01, u32, "rw", no, 'O', none},
    {"4.13.4", 0x6560, 0x657F, 0x02, 0xFE, u32, "rw", no, 'O', none},
};

std::string text_of(Access access) {
  switch (access) {
    case Access::ro:
      return "ro";
    case Access::rw:
      return "rw";
    default:
      return "";
  }
}
std::string access_of(const EntryInfo& entry) {
  const std::string provider = text_of(entry.access);
  return entry.consumer_access == Access::none ? provider
                                               : provider + "/" + text_of(entry.consumer_access);
}
char letter_of(Category category) {
  return category == Category::mandatory ? 'M' : category == Category::optional ? 'O' : 'C';
}
std::int64_t initial_of(const EntryInfo& entry) {
  const Default& initial = entry.initial;
  const bool is_printed = initial.kind == Default::Kind::number ||
                          (initial.kind == Default::Kind::highest_sub && initial.number != 0);
  return is_printed ? initial.number : none;
}

void expect_entry(const ExpectedEntries& expected, unsigned index, unsigned sub) {
  SCOPED_TRACE(testing::Message() << expected.clause << ": " << std::hex << index << "h:" << sub);
  const ObjectInfo* object = find_object(cia417::profile, index);
  ASSERT_NE(object, nullptr);
  const EntryInfo* entry = find_entry(*object, sub);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->type, expected.type);
  EXPECT_EQ(access_of(*entry), expected.access);
  EXPECT_EQ(entry->mapping, expected.mapping);
  EXPECT_EQ(letter_of(entry->category), expected.category);
  EXPECT_EQ(initial_of(*entry), expected.initial);
}

TEST(Cia417, EntriesHaveTheTypeAccessMappingCategoryAndDefaultOfTheirClause) {
  for (const ExpectedEntries& expected : entries) {
    for (const unsigned index : {expected.index, expected.last_index}) {
      expect_entry(expected, index, expected.sub);
      expect_entry(expected, index, expected.last_sub);
    }
  }
}

TEST(Cia417, NothingButTheDescribedEntriesIsThere) {
  constexpr unsigned first = 0x6000;
  std::vector<bool> expected(0x800U * 0x100U);
  for (const ExpectedEntries& row : entries) {
    for (unsigned index = row.index; index <= row.last_index; ++index) {
      for (unsigned sub = row.sub; sub <= row.last_sub; ++sub) {
        expected[(index - first) * 0x100 + sub] = true;
      }
    }
  }
  for (unsigned i = 0; i < expected.size(); ++i) {
    const ObjectInfo* object = find_object(cia417::profile, first + i / 0x100);
    const bool is_there = object != nullptr && find_entry(*object, i % 0x100) != nullptr;
    ASSERT_EQ(is_there, expected[i]) << std::hex << first + i / 0x100 << ":" << i % 0x100;
  }
  EXPECT_EQ(find_object(cia417::profile, first - 1), nullptr);
}

/// 4.1.1, 4.2.2: eight lifts, each 0800h above the last one (errata B18).
TEST(Cia417, EachLiftHasTheObjectsOfTheFirstOne) {
  for (unsigned lift = 1; lift <= 8; ++lift) {
    const unsigned offset = (lift - 1) * 0x800;
    for (const ExpectedEntries& expected : entries) {
      // Of the device itself (errata B32).
      if (expected.index == 0x6000 || expected.index == 0x6001) continue;
      EXPECT_EQ(find_object(cia417::profile, expected.index + offset),
                find_object(cia417::profile, expected.index));
    }
  }
  EXPECT_EQ(find_object(cia417::profile, 0xA100), nullptr) << "there is no ninth lift";
  EXPECT_EQ(find_object(cia417::profile, 0x6C82)->name, "Load signaling");
}

TEST(Cia417, WhatThePhysicalDeviceSaysOfItselfIsThereOnce) {
  for (const unsigned index : {0x6000U, 0x6001U}) {
    EXPECT_NE(find_object(cia417::profile, index), nullptr);
    for (unsigned lift = 2; lift <= 8; ++lift) {
      EXPECT_EQ(find_object(cia417::profile, index + (lift - 1) * 0x800), nullptr);
    }
  }
}

}  // namespace
}  // namespace canvoy::cia417_objects_test
