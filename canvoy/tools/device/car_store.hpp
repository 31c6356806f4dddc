// The file in which a hosted device of a car keeps what it has to know after it was without power:
// a taximeter its record, any device the node-ID that LSS gave it, the gateway whom it has named.
//
//     CarStore store("gateway.store");
//     site.offer(Callback<cia447::CarMemory()>::to<&CarStore::memory>(store));
#pragma once

#include <array>
#include <memory>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"
#include "canvoy/devices/cia447/car_master.hpp"

namespace canvoy::tools {

class CarStore {
 public:
  /// Throws Failure where the file cannot be used.
  explicit CarStore(const std::string& path);
  CarStore(const CarStore&) = delete;
  CarStore& operator=(const CarStore&) = delete;

  /// A taximeter has the first two of its sectors.
  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// Of the gateway. What cannot be read is as if nobody had been named yet.
  cia447::CarMemory memory();

 private:
  /// Of each node-ID, whether it was given, and the identity of who got it.
  static constexpr std::size_t device_size = 1 + 4 * sizeof(std::uint32_t);
  using Bytes = std::array<std::uint8_t, cia447::add_on_devices_max * device_size>;

  cia447::KnownDevices load();
  void keep(const cia447::KnownDevices& known);
  void rewind() { offset_ = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  std::unique_ptr<host::FileFlash> file_;
  RecordPair known_;
  Bytes bytes_{};
  std::size_t offset_ = 0;
};

}  // namespace canvoy::tools
