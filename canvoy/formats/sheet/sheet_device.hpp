// A device built from a data sheet at run time: its dictionary, with the services of CiA 301 that
// it requires, as those of a compiled device (DeviceNode). It has no behaviour of its own, and can
// stand in for any CANopen device.
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

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/canopen/device/heap_tables.hpp"
#include "canvoy/canopen/dictionary/action_objects.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/sheet_storage.hpp"

namespace canvoy::formats {

/// The tables of a dictionary, and the data that they refer to.
class SheetTables {
 public:
  /// Omits entries that a dictionary cannot have: of unknown type, or with an invalid default.
  SheetTables(const DataSheet& sheet, Findings& left_out);

  /// Tables; they refer to this object.
  DictionaryTables tables() const { return tables_.tables(); }

 private:
  void add_object(std::uint16_t index, const SheetObject& object);
  /// Adds an entry to `rows`, unless a dictionary cannot have it.
  void add_entry(std::vector<EntryRow>& rows, std::uint16_t index, std::uint8_t sub,
                 const SheetEntry& entry);
  bool set_default(EntryRow& row, const SheetEntry& entry);
  static void set_limits(EntryRow& row, const SheetEntry& entry);

  const DataSheet& sheet_;
  Findings& left_out_;
  HeapTables tables_;
  std::deque<std::string> texts_;
};

/// Contents of the domains of a dictionary, at most 64 KiB each. One client at a time writes a
/// domain; meanwhile, others get device_state. A client that continues to read after the domain was
/// written also gets device_state.
class DomainContents {
 public:
  /// Attaches to all domains of a dictionary, which must outlive this.
  explicit DomainContents(Dictionary& dictionary);
  DomainContents(const DomainContents&) = delete;
  DomainContents& operator=(const DomainContents&) = delete;

  /// Content of one domain.
  using Bytes = std::vector<std::uint8_t>;
  /// Sets the content of a domain for its first upload.
  void fill(std::uint16_t index, std::uint8_t sub, Bytes bytes) {
    contents_[place(index, sub)].bytes = std::move(bytes);
  }

 private:
  struct Content {
    Bytes bytes;
    std::optional<Bytes> arriving = {};  ///< by a download in progress
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
  /// What the owner of the device adds or takes over.
  struct Options {
    std::size_t further_routes = 0;  ///< number of CAN-IDs for services of the application
    /// If the sheet has 1010h or 1011h, stored values outlive NMT resets. False: the owner has a
    /// Storage of its own.
    bool stores_in_memory = true;
  };

  /// Copies `port`; what it refers to must outlive this.
  SheetDevice(const DataSheet& sheet, const Port& port, NodeId node_id, const Options& options);
  /// Like the above, with default options.
  SheetDevice(const DataSheet& sheet, const Port& port, NodeId node_id)
      : SheetDevice(sheet, port, node_id, Options()) {}

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// Sends errors, for an application that adds behaviour.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Parts of the sheet that the device does not have.
  const Findings& left_out() const { return left_out_; }
  /// Communication objects (1000h to 1FFFh) that are plain values here, since their function is the
  /// work of an application (CiA 301, CiA 302): ranges of indices.
  using IndexRange = canvoy::detail::IndexRange;
  /// Ranges of objects that the device has as plain values only.
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
