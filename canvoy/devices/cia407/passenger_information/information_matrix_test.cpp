// The matrix of passenger information, cell by cell (CiA 407, 6.4): each class and subclass has the
// objects of its column and no other one, with the access of the last column; and what can be shown
// is shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/shown_texts_test.hpp"

namespace canvoy::cia407::information_matrix_test {
namespace {

template <InformationClass device_class>
constexpr const BusUnit* column_units[][1] = {
    {&bus_unit<PassengerInformationKind<device_class, InformationSubclass::simple>>},
    {&bus_unit<PassengerInformationKind<device_class, InformationSubclass::text>>},
    {&bus_unit<PassengerInformationKind<device_class, InformationSubclass::graphics>>},
    {&bus_unit<PassengerInformationKind<device_class, InformationSubclass::extended>>}};

constexpr std::size_t columns = 12;
std::span<const BusUnit* const> units_of(std::size_t column) {
  const std::size_t subclass = column % 4;
  if (column < 4) return column_units<InformationClass::destination>[subclass];
  if (column < 8) return column_units<InformationClass::next_stop>[subclass];
  return column_units<InformationClass::information>[subclass];
}

/// How its value is to be read on a display.
enum class Show { as_text, as_number, never, not_mapped, picture };

struct Row {
  std::uint16_t index;
  std::uint8_t sub;   ///< that is mapped
  const char* cells;  ///< as the clause prints them: M, O, or -
  Show show;
  std::vector<const char*> values = {};  ///< by sub-index, from `sub` on
  const char* read = "";
};

// Values are written as octets: numbers have their low byte first.
const Row rows[] = {
    {0x6101, 0, "-OOO-OOO-OOO", Show::as_number, {"\x05"}, "5"},
    {0x6109, 0, "---OMMMMMMMM", Show::as_number, {"\x05"}, "5"},
    {0x610B, 0, "-OMMMMMMMMMM", Show::as_text, {"", "U", "8"}, "U8"},
    {0x610C, 1, "OOOO----OMOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x610D, 1, "-MOO-OOO-MOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x610E,
     0,
     "---O---O---O",
     Show::as_text,
     {"", "\x29", "\x5C", "\x0B", "\x08", "\x05", "\x04"},
     "08:05"},
    {0x6110, 0, "MMMM----MMMM", Show::as_number, {"\x05"}, "5"},
    {0x6112, 1, "-MOO-MOO-MOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6119, 0, "---O---O-OOO", Show::as_number, {"\xD7"}, "22"},
    {0x611D, 0, "-OOO-OOO-OOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6120, 0, "---OMMMMMMMM", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6121, 0, "OOOOOOOOOOOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6123, 0, "---O---O-OOO", Show::as_number, {"\x1A\x24"}, "36"},
    {0x6191, 0, "MMMMMMMMMMMM", Show::as_number, {"\x05"}, "5"},
    {0x6192, 0, "OMMMOMMMMMMM", Show::as_number, {"\x05"}, "5"},
    {0x6193, 0, "MMMMMMMMMMMM", Show::as_number, {"\x05"}, "5"},
    {0x6196, 0, "OMMMOMMMMMMM", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6200, 1, "OOOOOOOOOOMO", Show::as_text, {"<text/>"}, "<text/>"},
    {0x6201, 1, "-OOOOOOOOOOO", Show::not_mapped},
    {0x6202, 1, "OOOOOOOOOOMO", Show::picture, {"GIF89a"}, "GIF89a"},
    {0x6203, 1, "MMMMMMMMMMMM", Show::not_mapped},
    {0x6204, 0, "-----OOOOOOO", Show::not_mapped},
    {0x6205, 1, "-----OOOOOOO", Show::not_mapped},
    {0x6481, 0, "---O---O-OOO", Show::as_number, {"\x1A\x24"}, "36"},
    {0x6488, 1, "---O---O-OOO", Show::never},
    {0x6489, 0, "---O---O-OOO", Show::as_number, {"\xE0\x24"}, "22"},
    {0x6520, 0, "---O---O-OOO", Show::as_number, {"\x1A\x24"}, "36"},
    {0x6662, 0, "---O---O-OOO", Show::as_number, {"\x64"}, "36"},
    {0x6740, 1, "--------OOOO", Show::never},
    {0x6741, 0, "--------OOOO", Show::never},
    {0x6742, 1, "--------OOOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6743, 1, "--------OOOO", Show::as_text, {"Zoo"}, "Zoo"},
    {0x6744, 1, "--------OOOO", Show::as_text, {"Zoo"}, "Zoo"},
};

/// 6205h is printed as wo, but its list of character sets can be read (errata 29).
bool is_read_write(std::uint16_t index) {
  return (index >= 0x6200 && index <= 0x6203) || index == 0x6205;
}

std::string place_of(const Row& row, std::size_t column) {
  char text[64];
  std::snprintf(text, sizeof text, "%04Xh, class %zu, subclass %zu", row.index, column / 4 + 1,
                column % 4 + 1);
  return text;
}

class InformationMatrix : public testing::TestWithParam<std::size_t> {
 protected:
  /// The value, as many octets as the entry has; texts as they are.
  void write(const Row& row) {
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      const auto sub = static_cast<std::uint8_t>(row.sub + i);
      std::string octets = row.values[i];
      if (octets.empty()) continue;
      const auto entry = bench.node().dictionary().find(row.index, sub);
      ASSERT_TRUE(entry);
      const bool is_number = !entry->row->is_text() && entry->row->type != DataType::domain;
      if (is_number) octets.resize(entry->bytes().size(), '\0');
      EXPECT_TRUE(bench.download(row.index, sub, octets)) << place_of(row, GetParam());
    }
  }
  void map(const Row& row) {
    char request[48];
    std::snprintf(request, sizeof request, "23 03 62 02 %02X %02X %02X 00", row.sub,
                  row.index >> 8U, row.index & 0xFFU);
    bench.ask(request);
    bench.ask("23 03 62 01 01 00 00 00");
  }
  bool is_refused() { return bench.cable.last(0x085) == "085#04 FF 01 01 00 00 00 00"; }

  ShownTexts shown;
  BusBench bench{units_of(GetParam()), [this](Environment& environment) {
                   environment.provide(callback<&ShownTexts::hardware>(shown));
                 }};
};

TEST_P(InformationMatrix, HasTheObjectsOfItsColumnAndNoOthers) {
  for (const Row& row : rows) {
    // All devices may read the number of entries of a record.
    const bool is_record = !row.values.empty() && std::string_view(row.values.front()).empty();
    char request[48];
    std::snprintf(request, sizeof request, "40 %02X %02X %02X 00 00 00 00", row.index & 0xFFU,
                  row.index >> 8U, is_record ? 1U : unsigned{row.sub});
    const std::string answer = bench.ask(request);
    const bool is_there = row.cells[GetParam()] != '-';
    if (!is_there) {
      EXPECT_EQ(answer.substr(0, 2) + answer.substr(11), "80 00 00 02 06")
          << place_of(row, GetParam());
    } else if (is_read_write(row.index)) {
      EXPECT_NE(answer.substr(0, 2), "80") << place_of(row, GetParam()) << ": rw";
    } else {
      // All other objects of passenger information are wo: they can be written, but not read back.
      EXPECT_EQ(answer.substr(0, 2) + answer.substr(11), "80 01 00 01 06")
          << place_of(row, GetParam());
    }
  }
}

TEST_P(InformationMatrix, ShowsWhatItsColumnHas) {
  const bool has_pictures = GetParam() % 4 >= 2;  // graphics, extended
  for (const Row& row : rows) {
    if (row.cells[GetParam()] == '-' || row.show == Show::not_mapped) continue;
    write(row);
    map(row);
    const bool can_show = row.show == Show::picture ? has_pictures : row.show != Show::never;
    EXPECT_EQ(is_refused(), !can_show) << place_of(row, GetParam()) << ": FF04h";
    const std::vector<std::string> expected =
        can_show ? std::vector<std::string>{row.read} : std::vector<std::string>{};
    EXPECT_EQ(shown.texts, expected) << place_of(row, GetParam());
    bench.ask("23 03 62 01 00 00 00 00");
  }
}

INSTANTIATE_TEST_SUITE_P(EachColumn, InformationMatrix, testing::Range<std::size_t>(0, columns));

}  // namespace
}  // namespace canvoy::cia407::information_matrix_test
