// Arbitrary text as a data sheet: what is read is written, and reads back unchanged.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_check.hpp"
#include "canvoy/formats/sheet/sheet_diff.hpp"
#include "canvoy/formats/xdd/xdd.hpp"
#include "canvoy/formats/xdd/xdd_writer.hpp"
#include "canvoy/profiles/registry.hpp"

namespace {

using namespace canvoy::formats;

bool same_entry(const SheetEntry& a, const SheetEntry& b) {
  return a.name == b.name && a.data_type == b.data_type && a.access == b.access &&
         a.default_value == b.default_value && a.others == b.others;
}

bool same_object(const SheetObject& a, const SheetObject& b) {
  return same_entry(a.own, b.own) &&
         std::ranges::equal(a.subs, b.subs, [](const auto& one, const auto& other) {
           return one.first == other.first && same_entry(one.second, other.second);
         });
}

void check_eds(std::string_view text) {
  Findings findings;
  const DataSheet sheet = read_eds(text, findings);
  check_sheet(sheet, canvoy::find_profile("419"), findings);
  const DataSheet again = read_eds(write_eds(sheet), findings);
  static_cast<void>(compare_sheets(sheet, again));
  const bool same =
      std::ranges::equal(sheet.objects, again.objects, [](const auto& one, const auto& other) {
        return one.first == other.first && same_object(one.second, other.second);
      });
  if (!same) std::abort();
}

void check_xdd(std::string_view text) {
  Findings findings;
  const DataSheet sheet = read_xdd(text, findings);
  check_sheet(sheet, nullptr, findings);
  const DataSheet again = read_xdd(write_xdd(sheet), findings);
  if (sheet.objects.size() != again.objects.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (is_xml(text)) {
    check_xdd(text);
  } else {
    check_eds(text);
  }
  return 0;
}
