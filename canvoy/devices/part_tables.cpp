#include "canvoy/devices/part_tables.hpp"

#include <vector>

#include "canvoy/profiles/layout.hpp"

namespace canvoy {

PartTables::PartTables(std::span<const Part> parts) {
  tables_.objects.reserve(parts.size());
  for (const Part& part : parts) add(part);
}

void PartTables::add(const Part& part) {
  std::vector<EntryRow> entries;
  for (const EntryInfo& entry : part.object().entries()) {
    if (part.has(entry)) entries.push_back(detail::row_of(part, entry));
  }
  add_object(tables_, {.index = part.index(), .count = part.count()}, entries);
}

}  // namespace canvoy
