// The file in which a hosted device of CiA 407 keeps what it has to know after it was without
// power: any device the node-ID that LSS gave it, identification who drives what, a tachograph and
// a counting manager what they have counted.
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
#include "canvoy/tools/device/car_store.hpp"

namespace canvoy::tools {

struct KeptBusValues {
  cia407::Assignment assignment{};  ///< its numbers, no texts
  double metres = 0;                ///< that the vehicle was driven, in all of its life
  double trip_begin = 0;            ///< m
  cia407::CountingManagerUnit::Counts counts{};

  friend bool operator==(const KeptBusValues&, const KeptBusValues&) = default;
};

class BusStore {
 public:
  /// Throws Failure where the file cannot be used.
  explicit BusStore(const std::string& path);
  BusStore(const BusStore&) = delete;
  BusStore& operator=(const BusStore&) = delete;

  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// What cannot be read is as if nothing had been kept yet.
  KeptBusValues load();
  void keep(const KeptBusValues& values);

 private:
  std::unique_ptr<host::FileFlash> file_;
  KeptBytes values_;
};

}  // namespace canvoy::tools
