// Values just beyond the ranges of the clauses of CiA 419, and of CiA 401 as CiA 852 uses it,
// written by a foreign client. The ranges are typed from the clauses, not taken from the
// descriptions: each writable application object of these devices has a row, and one without fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "canvoy/devices/testing/foreign_client.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::ranges_test {
namespace {

using Bytes = ForeignClient::Bytes;

constexpr AbortCode low = AbortCode::value_too_low;    // 0609 0032h
constexpr AbortCode high = AbortCode::value_too_high;  // 0609 0031h
constexpr AbortCode range = AbortCode::value_range;    // 0609 0030h
constexpr std::int64_t u8 = std::numeric_limits<std::uint8_t>::max();

/// A value, and its answer.
struct Try {
  std::int64_t value = 0;
  AbortCode answer = AbortCode::none;
};

/// Objects from `first` to `last`, with values of `size` bytes.
struct RangeRow {
  unsigned profile = 0;
  const char* clause = "";
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  std::size_t size = 1;
  std::vector<Try> tries = {};  ///< empty where each value of the type is allowed
};

/// Bits for inputs or outputs, numbers without a range, and floating-point values.
RangeRow all_of_type(unsigned profile, const char* clause, unsigned first, unsigned last) {
  return {.profile = profile,
          .clause = clause,
          .first = static_cast<std::uint16_t>(first),
          .last = static_cast<std::uint16_t>(last)};
}

const std::vector<Try> booleans = {{0}, {1}, {2, high}, {5, high}, {u8, high}};
const std::vector<Try> error_modes = {{0}, {1}, {2, range}, {u8, range}};
const std::vector<Try> triggers = {{0}, {0x1F}, {0x20, high}, {0x80, high}, {u8, high}};

const RangeRow rows[] = {
    {419, "7.2.1", 0x6000, 0x6000, 1, {{0}, {1}, {2, high}, {0x80, high}, {u8, high}}},
    {419,
     "7.2.3",
     0x6010,
     0x6010,
     2,
     {{0xFEC0}, {0x02A8}, {0xFFFF}, {0xFEBF, low}, {0x8000, low}, {0x02A9, high}, {0x7000, high}}},
    all_of_type(419, "7.2.5", 0x6060, 0x6060),
    all_of_type(419, "7.2.6", 0x6070, 0x6070),
    {419, "7.2.8", 0x6081, 0x6081, 1, {{0}, {0x64}, {u8}, {0x65, high}, {0xFE, high}}},

    all_of_type(401, "a bit for each input", 0x6002, 0x6003),
    {401, "BOOLEAN", 0x6005, 0x6005, 1, booleans},
    all_of_type(401, "a bit for each input", 0x6006, 0x6008),
    all_of_type(401, "a bit for each input", 0x6102, 0x6108),
    all_of_type(401, "a bit for each input", 0x6122, 0x6128),
    all_of_type(401, "a bit for each output", 0x6200, 0x6328),
    all_of_type(401, "all of a converter", 0x6410, 0x6413),
    {401, "bits 0 to 4", 0x6421, 0x6421, 1, triggers},
    {401, "BOOLEAN", 0x6423, 0x6423, 1, booleans},
    all_of_type(401, "limits, deltas, offsets and scales", 0x6424, 0x6432),
    all_of_type(401, "offsets and scales", 0x6441, 0x6442),
    {401, "0 and 1", 0x6443, 0x6443, 1, error_modes},
    all_of_type(401, "error values, offsets, scales and units", 0x6444, 0x6450),
};

unsigned profile_of_rows(const DeviceKind& kind) {
  return kind.profile->number == 852 ? 401 : kind.profile->number;
}

const RangeRow* row_of(const DeviceKind& kind, std::uint16_t index) {
  const RangeRow* const found = std::ranges::find_if(rows, [&](const RangeRow& row) {
    return row.profile == profile_of_rows(kind) && index >= row.first && index <= row.last;
  });
  return found == std::end(rows) ? nullptr : found;
}

Bytes bytes_of(std::int64_t value, std::size_t size) {
  Bytes bytes(sizeof value);
  store(bytes.data(), static_cast<std::uint64_t>(value));
  bytes.resize(size);
  return bytes;
}

/// The rows on one device.
class Ranges {
 public:
  explicit Ranges(const DeviceKind& kind) : kind_(kind) {}

  void try_all() {
    for (const Part& part : kind_.forms.front().parts()) {
      if (part.index() < 0x6000) continue;
      for (unsigned place = 0; place < part.count(); ++place) try_object(part, place);
    }
  }
  unsigned refused = 0;

 private:
  void try_object(const Part& part, unsigned place) {
    const auto index = static_cast<std::uint16_t>(part.index() + place);
    for (const EntryInfo& entry : part.object().entries()) {
      const bool is_writable =
          part.has(entry) && allows(detail::access_of(part, entry), Access::sdo_write);
      if (!is_writable) continue;
      const RangeRow* const row = row_of(kind_, index);
      if (row == nullptr) {
        ADD_FAILURE() << kind_.info.name << ": no row for " << std::hex << index;
        continue;
      }
      for (const Try& tried : row->tries) try_value(*row, index, entry.sub_first, tried);
    }
  }

  /// A refused value leaves the one before.
  void try_value(const RangeRow& row, std::uint16_t index, std::uint8_t sub, const Try& tried) {
    const Bytes before = *desk_.read(index, sub);
    const Bytes value = bytes_of(tried.value, row.size);
    EXPECT_EQ(desk_.write(index, sub, value), tried.answer)
        << row.clause << ": " << std::hex << index << " sub " << unsigned{sub} << " = "
        << tried.value;
    if (tried.answer == AbortCode::none) return;
    refused += 1;
    EXPECT_EQ(*desk_.read(index, sub), before) << row.clause;
  }

  const DeviceKind& kind_;
  ForeignClient desk_{kind_};
};

class RangesOf : public testing::TestWithParam<const char*> {};

TEST_P(RangesOf, EndWhereTheirClauseSays) {
  const DeviceKind* const kind = find_device_kind(GetParam());
  ASSERT_NE(kind, nullptr);
  Ranges ranges(*kind);
  ranges.try_all();
  EXPECT_GT(ranges.refused, 5u);
}

INSTANTIATE_TEST_SUITE_P(Devices, RangesOf, testing::Values("charger", "io-401", "operator"),
                         [](const auto& tried) {
                           return std::string(tried.param) == "io-401" ? "io_401" : tried.param;
                         });

}  // namespace
}  // namespace canvoy::ranges_test
