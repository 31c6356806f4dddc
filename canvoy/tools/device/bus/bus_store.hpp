// The file of non-volatile values of a hosted device of CiA 407: the node-ID from LSS for any
// device, the assignment for identification, and the counts of a tachograph and a counting manager.
//
//     BusStore store("identification.store");
//     KeptBusValues kept = store.load();
//     store.keep(kept);
#pragma once

#include <memory>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/tools/device/store/car_store.hpp"

namespace canvoy::tools {

struct KeptBusValues {
  cia407::Assignment assignment{};  ///< numbers only, no texts
  double metres = 0;                ///< total distance of the vehicle
  double trip_begin = 0;            ///< m
  cia407::CountingManagerUnit::Counts counts{};

  friend bool operator==(const KeptBusValues&, const KeptBusValues&) = default;
};

class BusStore {
 public:
  /// Throws Failure if the file cannot be used.
  explicit BusStore(const std::string& path);
  BusStore(const BusStore&) = delete;
  BusStore& operator=(const BusStore&) = delete;

  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// Reads the file; unreadable content counts as empty.
  KeptBusValues load();
  void keep(const KeptBusValues& values);

 private:
  std::unique_ptr<host::FileFlash> file_;
  KeptBytes values_;
};

}  // namespace canvoy::tools
