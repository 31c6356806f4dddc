#include "canvoy/tools/device/store/device_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/formats/sheet/sheet_storage.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t store_sector_size = formats::storage_sector_size;

/// At least two sectors, which are some hundred parameters, so that files survive small changes of
/// a device.
std::uint32_t slot_size_of(const Node& node) {
  return std::max(formats::storage_slot_size(node.dictionary()), 2 * store_sector_size);
}

/// Two slots for the parameters, and two sectors for LSS.
host::FileFlash::Geometry geometry(std::uint32_t slot_size) {
  return {.sector_size = store_sector_size, .sectors = 2 * (slot_size / store_sector_size) + 2};
}

const char* state_text(RecordState state) {
  switch (state) {
    case RecordState::valid:
    case RecordState::empty:
      return "";
    case RecordState::damaged:
      return "is damaged";
    case RecordState::other_format:
      return "has the format of another version of canvoy";
    case RecordState::foreign:
      return "is of another kind of device";
    case RecordState::outdated:
      return "is of a device with other objects";
    case RecordState::too_long:
      return "is longer than its place";
    case RecordState::unreadable:
      return "cannot be read";
  }
  return "";
}

}  // namespace

DeviceStore::DeviceStore(const std::string& path, Node& node)
    : path_(path),
      slot_size_(slot_size_of(node)),
      file_(value_or_throw(host::FileFlash::open(path, geometry(slot_size_)))),
      storage_(node, file_->flash(), {.slot_size = slot_size_}) {}

LssStore::Place DeviceStore::lss_place() const {
  return {.address = 2 * slot_size_, .slot_size = store_sector_size};
}

std::string DeviceStore::complaint() const {
  std::string what = state_text(storage_.state());
  if (what.empty()) return what;
  return fmt::format("{}: what was stored {}; the device has its defaults, store anew or restore",
                     path_, what);
}

}  // namespace canvoy::tools
