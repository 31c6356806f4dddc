// The file of non-volatile values of a hosted device of a car: records and audit log of a
// taximeter, the node-ID from LSS of any device, the named devices of the gateway and the memories
// of its seats.
//
//     CarStore store("gateway.store");
//     store.join(environment);
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_master.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"
#include "canvoy/devices/kit/environment.hpp"

namespace canvoy::tools {

/// A few bytes in a flash, either the previous or the present ones.
class KeptBytes {
 public:
  /// `flash` must outlive this.
  KeptBytes(const Flash& flash, const RecordPair::Place& place);

  /// False: their number differs, or they cannot be read.
  bool load(std::span<std::uint8_t> bytes);
  void keep(std::span<const std::uint8_t> bytes);

 private:
  void rewind() { left_ = bytes_; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  RecordPair records_;
  std::span<const std::uint8_t> bytes_;  ///< to be written
  std::span<const std::uint8_t> left_;
};

class CarStore {
 public:
  /// Throws Failure if the file cannot be used.
  explicit CarStore(const std::string& path);
  CarStore(const CarStore&) = delete;
  CarStore& operator=(const CarStore&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);

  /// The flash; a taximeter uses its first two sectors.
  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// Place of the audit log of a taximeter that is no gateway: a gateway has the memories of its
  /// seats there.
  static cia447::AuditMemory::Place audit_place();
  /// Memory of the gateway. Unreadable content counts as no named device.
  cia447::CarMemory memory();
  /// Memories of the seats. Unreadable content counts as empty.
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
