// The file in which a hosted device stores its parameters.
//
//     DeviceStore store("charger.store", device.node());
//     device.node().start(now);
//     std::string line = store.complaint();
#pragma once

#include <memory>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/storage/storage.hpp"

namespace canvoy::tools {

class DeviceStore {
 public:
  /// Throws Failure if the file cannot be used. `node` must outlive this.
  DeviceStore(const std::string& path, Node& node);

  /// After the start of the node: the error in the content of the file, in one line; empty: none.
  std::string complaint() const;

  /// The rest of the file, for the node-ID from LSS.
  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;

 private:
  std::string path_;
  std::uint32_t slot_size_;
  std::unique_ptr<host::FileFlash> file_;
  Storage storage_;
};

}  // namespace canvoy::tools
