// Serves what a tool stores in a configuration manager over the bus (CiA 302-3): DCFs of slaves
// (1F20h, 1F21h), from which it makes their concise DCFs (1F22h), concise DCFs themselves, and EDS
// of slaves (1F23h, 1F24h).
//
//     ConfigurationManager manager(node, workers);
//     StoredConfigurations stored(node, manager);
//     stored.store(0x1F20, 5, dcf_of_node_5);    // as a tool does it, by SDO
//     stored.content(0x1F22, 5);                 // by which node 5 is configured
//
// Public sources define what these objects hold, not how a manager answers. What it refuses, and
// when, is a choice of this project (docs/decisions.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/canopen/manager/configuration_manager.hpp"

namespace canvoy::formats {

/// For a host: contents are in memory, and DCFs are read whole. A slave has at most one concise
/// DCF: that of its DCF, or one that was stored instead and replaces the DCF. An empty content
/// deletes the stored one.
///
/// Aborts of a store: value_range (not a DCF, or one with a value that does not fit its type; in
/// 1F21h and 1F24h a format other than ASCII), those of ConciseDcf, device_state (this slave is
/// being configured, or another client stores here), out_of_memory (beyond `bytes_max`). All
/// contents are then unchanged.
class StoredConfigurations {
 public:
  static constexpr std::size_t default_bytes_max = 16 * 1024 * 1024;  ///< 16 MiB

  /// Serves the entries that the dictionary has. `bytes_max` limits the size of all contents
  /// together, including those in transfer.
  explicit StoredConfigurations(Node& node, const ConfigurationManager& manager,
                                std::size_t bytes_max = default_bytes_max);
  StoredConfigurations(const StoredConfigurations&) = delete;
  StoredConfigurations& operator=(const StoredConfigurations&) = delete;

  /// Sets the function called after a tool has stored a content, for example to save it.
  void on_stored(std::function<void(std::uint16_t index, NodeId slave)> stored) {
    stored_ = std::move(stored);
  }

  /// Stores a content; `index` is 1F20h, 1F22h or 1F23h. Does not call the function of on_stored().
  AbortCode store(std::uint16_t index, NodeId slave, std::span<const std::uint8_t> bytes);
  /// The stored content; empty if there is none. Valid until the next store.
  std::span<const std::uint8_t> content(std::uint16_t index, NodeId slave) const;

 private:
  using Bytes = std::vector<std::uint8_t>;
  using Place = std::pair<std::uint16_t, NodeId>;
  using Contents = std::map<Place, Bytes>;

  static Place place_of(const Entry& entry) { return {entry.index, entry.sub}; }
  Result<std::uint32_t> open_read(const Entry& entry);
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset, std::span<std::uint8_t> bytes);
  AbortCode open_write(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close_write(const Entry& entry, bool complete);
  AbortCode check_format(const Entry& entry, std::span<const std::uint8_t> value);

  AbortCode take_dcf(NodeId slave, Bytes text);
  AbortCode take_concise_dcf(NodeId slave, Bytes bytes);
  bool may_change(const Place& place) const;
  void put(const Place& place, Bytes bytes);
  bool has_room_for(std::size_t more) const;

  const ConfigurationManager& manager_;
  std::size_t bytes_max_;
  std::function<void(std::uint16_t, NodeId)> stored_;
  Contents contents_;
  Contents arriving_;    ///< downloads in progress
  std::set<Place> new_;  ///< stored since an upload began
  Domain domain_;
  Hook texts_;          ///< 1F20h
  Hook concise_;        ///< 1F22h
  Hook sheets_;         ///< 1F23h
  Hook text_formats_;   ///< 1F21h
  Hook sheet_formats_;  ///< 1F24h
};

}  // namespace canvoy::formats
