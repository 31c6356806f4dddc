#include "canvoy/devices/kit/part_tables.hpp"

#include <vector>

#include "canvoy/profiles/model/layout.hpp"

namespace canvoy {

PartTables::PartTables(std::span<const Part> parts) {
  tables_.objects.reserve(parts.size());
  for (const Part& part : parts) add(part);
}

void PartTables::add(const Part& part) {
  std::vector<EntryRow> entries;
  detail::Reason reason;  // for the compiler, which has checked the description before
  for (const EntryInfo& entry : part.object().entries()) {
    if (part.has(entry)) entries.push_back(detail::row_of(part, entry, reason));
  }
  add_object(tables_, {.index = part.index(), .count = part.count()}, entries);
}

}  // namespace canvoy
