// A device that a data sheet describes, built while the program runs: its dictionary, with the
// services of CiA 301 that it asks for, as a compiled device (DeviceNode) has them. It has no
// behaviour of its own; any CANopen device can be stood in for.
//
//     SheetDevice device(sheet, port, 5);
//     device.node().start(now);
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/action_objects.hpp"
#include "canvoy/canopen/heap_node.hpp"
#include "canvoy/canopen/heap_tables.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"
#include "canvoy/formats/sheet/sheet_storage.hpp"

namespace canvoy::formats {

/// The tables of a dictionary, and what they refer to.
class SheetTables {
 public:
  /// Entries that no dictionary can have (no known type, a default that is none) are left out.
  SheetTables(const DataSheet& sheet, Findings& left_out);

  DictionaryTables tables() const { return tables_.tables(); }

 private:
  void add_object(std::uint16_t index, const SheetObject& object);
  /// To `rows`, unless no dictionary can have it.
  void add_entry(std::vector<EntryRow>& rows, std::uint16_t index, std::uint8_t sub,
                 const SheetEntry& entry);
  bool set_default(EntryRow& row, const SheetEntry& entry);
  static void set_limits(EntryRow& row, const SheetEntry& entry);

  Findings& left_out_;
  HeapTables tables_;
  std::deque<std::string> texts_;
};

/// The content of the domains of a dictionary: 64 KiB each at most. One client at a time writes a
/// domain, others are told device_state meanwhile; so is who reads on after it has been written.
class DomainContents {
 public:
  explicit DomainContents(Dictionary& dictionary);
  DomainContents(const DomainContents&) = delete;
  DomainContents& operator=(const DomainContents&) = delete;

  using Bytes = std::vector<std::uint8_t>;
  /// What the first upload of a domain gives.
  void fill(std::uint16_t index, std::uint8_t sub, Bytes bytes) {
    contents_[place(index, sub)].bytes = std::move(bytes);
  }

 private:
  struct Content {
    Bytes bytes;
    std::optional<Bytes> arriving = {};  ///< by a download that has not ended
    bool is_new = false;                 ///< written since an upload began
  };

  static std::uint32_t place(std::uint16_t index, std::uint8_t sub) {
    return static_cast<std::uint32_t>(index) << 8 | sub;
  }
  Content& content(const Entry& entry) { return contents_[place(entry.index, entry.sub)]; }
  Result<std::uint32_t> open_read(const Entry& entry);
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset, std::span<std::uint8_t> bytes);
  AbortCode open_write(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close_write(const Entry& entry, bool complete);

  Domain domain_;
  std::deque<Hook> hooks_;
  std::map<std::uint32_t, Content> contents_;
};

class SheetDevice {
 public:
  struct Options {
    std::size_t further_routes = 0;  ///< CAN-IDs that services of the application want
    /// Where the sheet has 1010h or 1011h: what is stored outlives NMT resets. False: the owner has
    /// a Storage of his own.
    bool stores_in_memory = true;
  };

  /// `port` is copied, what it refers to must outlive this.
  SheetDevice(const DataSheet& sheet, const Port& port, NodeId node_id, const Options& options);
  SheetDevice(const DataSheet& sheet, const Port& port, NodeId node_id)
      : SheetDevice(sheet, port, node_id, Options()) {}
  SheetDevice(const SheetDevice&) = delete;
  SheetDevice& operator=(const SheetDevice&) = delete;

  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// What of the sheet is not in the device.
  const Findings& left_out() const { return left_out_; }
  /// Communication objects (1000h to 1FFFh) that are here values only, since what CiA 301 and 302
  /// say that they do is the work of an application: from a first to a last index.
  using IndexRange = canvoy::detail::IndexRange;
  std::vector<IndexRange> without_behaviour() const;

 private:
  void add_storage(const Options& options);
  void add_own_sheet(const DataSheet& sheet);

  Findings left_out_;
  SheetTables sheet_;
  HeapNode device_;
  DomainContents domains_{device_.node().dictionary()};
  std::optional<MemoryStorage> storage_;
};

}  // namespace canvoy::formats
