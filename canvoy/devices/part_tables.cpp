#include "canvoy/devices/part_tables.hpp"

#include "canvoy/profiles/layout.hpp"

namespace canvoy {

PartTables::PartTables(std::span<const Part> parts) {
  objects_.reserve(parts.size());
  for (const Part& part : parts) add(part);
}

void PartTables::add(const Part& part) {
  ObjectRow object = {.index = part.index(),
                      .count = part.count(),
                      .entry_first = static_cast<std::uint16_t>(entries_.size()),
                      .offset = value_bytes_};
  for (const EntryInfo& entry : part.object().entries()) {
    if (part.has(entry)) entries_.push_back(detail::row_of(part, entry));
  }
  object.entry_count = static_cast<std::uint16_t>(entries_.size() - object.entry_first);
  value_bytes_ += detail::lay_out_object(
      object, std::span(entries_).subspan(object.entry_first, object.entry_count));
  objects_.push_back(object);
}

}  // namespace canvoy
