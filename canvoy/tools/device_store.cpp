#include "canvoy/tools/device_store.hpp"

#include <fmt/format.h>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

// Two slots of two sectors for the parameters: 8 KiB are some hundred of them. Two sectors for LSS.
constexpr std::uint32_t sector_size = 4096;
constexpr host::FileFlash::Geometry geometry{.sector_size = sector_size, .sectors = 6};
constexpr std::uint32_t slot_size = 2 * sector_size;

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
      file_(value_or_throw(host::FileFlash::open(path, geometry))),
      storage_(node, file_->flash(), {.slot_size = slot_size}) {}

std::string DeviceStore::complaint() const {
  std::string what = state_text(storage_.state());
  if (what.empty()) return what;
  return fmt::format("{}: what was stored {}; the device has its defaults, store anew or restore",
                     path_, what);
}

}  // namespace canvoy::tools
