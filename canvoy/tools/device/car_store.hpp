// The file in which a hosted device of a car keeps what it has to know after it was without power:
// a taximeter its record and its audit log, any device the node-ID that LSS gave it, the gateway
// whom it has named and what is in the memories of the seats.
//
//     CarStore store("gateway.store");
//     store.join(site);
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"
#include "canvoy/devices/cia447/car_master.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"
#include "canvoy/devices/site.hpp"

namespace canvoy::tools {

/// A few bytes in a flash, as they were before or as they are now.
class KeptBytes {
 public:
  /// `flash` must outlive this.
  KeptBytes(const Flash& flash, const RecordPair::Place& place);

  /// False: there are not as many as these, or they cannot be read.
  bool load(std::span<std::uint8_t> bytes);
  void keep(std::span<const std::uint8_t> bytes);

 private:
  void rewind() { left_ = bytes_; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  RecordPair records_;
  std::span<const std::uint8_t> bytes_;  ///< that are written
  std::span<const std::uint8_t> left_;
};

class CarStore {
 public:
  /// Throws Failure where the file cannot be used.
  explicit CarStore(const std::string& path);
  CarStore(const CarStore&) = delete;
  CarStore& operator=(const CarStore&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);

  /// A taximeter has the first two of its sectors.
  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// Of a taximeter that is no gateway: where that one has the memories of its seats.
  static cia447::AuditMemory::Place audit_place();
  /// Of the gateway. What cannot be read is as if nobody had been named yet.
  cia447::CarMemory memory();
  /// Of its seats. What cannot be read is as if nothing had been stored yet.
  cia447::SeatStore seats();

 private:
  cia447::KnownDevices load_known();
  void keep_known(const cia447::KnownDevices& known);
  cia447::SeatMemories load_seats();
  void keep_seats(const cia447::SeatMemories& memories);

  std::unique_ptr<host::FileFlash> file_;
  KeptBytes known_;
  KeptBytes seats_;
};

}  // namespace canvoy::tools
