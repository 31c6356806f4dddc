// Concise DCFs as constants in flash, for the content of 1F22h: clients may read them, but not
// write them (CiA 302-3).
//
//     constexpr FixedConfigurations::Item items[] = {{.slave = 5, .concise_dcf = charger_dcf}};
//     FixedConfigurations configurations(node, items);
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Serves reads of 1F22h; a slave without an item has no content there.
class FixedConfigurations {
 public:
  /// The configuration of one slave.
  struct Item {
    NodeId slave = 0;                           ///< node-ID, the sub-index of 1F22h
    std::span<const std::uint8_t> concise_dcf;  ///< the whole domain
  };

  /// Makes the object; `items` and their data must outlive it.
  FixedConfigurations(Node& node, std::span<const Item> items) : items_(items) {
    domain_.open_read = decltype(Domain::open_read)::to<&FixedConfigurations::open>(*this);
    domain_.read = decltype(Domain::read)::to<&FixedConfigurations::read>(*this);
    hook_.first = hook_.last = object_index::concise_dcf;
    hook_.domain = &domain_;
    node.dictionary().attach(hook_);
  }
  FixedConfigurations(const FixedConfigurations&) = delete;
  FixedConfigurations& operator=(const FixedConfigurations&) = delete;

 private:
  std::span<const std::uint8_t> find(NodeId slave) const {
    const auto item = std::ranges::find(items_, slave, &Item::slave);
    return item == items_.end() ? std::span<const std::uint8_t>{} : item->concise_dcf;
  }
  Result<std::uint32_t> open(const Entry& entry) {
    const auto bytes = find(entry.sub);
    if (bytes.empty()) return AbortCode::no_data;
    return static_cast<std::uint32_t>(bytes.size());
  }
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset,
                           std::span<std::uint8_t> bytes) {
    const auto all = find(entry.sub);
    if (offset > all.size() || bytes.size() > all.size() - offset) return AbortCode::general;
    std::ranges::copy(all.subspan(offset, bytes.size()), bytes.begin());
    return bytes.size();
  }

  std::span<const Item> items_;
  Domain domain_;
  Hook hook_;
};

}  // namespace canvoy
