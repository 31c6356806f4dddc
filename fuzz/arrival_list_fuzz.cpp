// Arbitrary text as a list of arriving people: it is refused, or all of them can be carried.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/arrival_list.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  static const lift::Building building = lift::uniform_building({.floors = 20});
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<lift::Arrival> people;
  try {
    people = tools::parse_arrivals("people.csv", text, building);
  } catch (const tools::Failure&) {
    return 0;
  }
  for (const lift::Arrival& each : people) {
    const bool is_here = each.from >= 1 && each.from <= 20 && each.to >= 1 && each.to <= 20;
    const bool is_person = each.mass_kg >= 1 && each.mass_kg <= 1000;
    if (!is_here || each.from == each.to || !is_person || each.at < Time{}) std::abort();
  }
  // In the form that a building takes.
  lift::Traffic traffic(people);
  Time last{};
  while (const auto next = traffic.next()) {
    if (next->at < last) std::abort();
    last = next->at;
  }
  return 0;
}
