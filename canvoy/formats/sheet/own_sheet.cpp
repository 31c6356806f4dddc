#include "canvoy/formats/sheet/own_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats::detail {

namespace {

/// Default of 1000h in the device; 0 if none is given.
std::uint32_t device_type_of(std::span<const Part> parts) {
  const auto type = std::ranges::find(parts, object_index::device_type, &Part::index);
  if (type == parts.end()) return 0;
  const Default initial = canvoy::detail::initial_of(*type, type->object().entry);
  return static_cast<std::uint32_t>(initial.number);
}

}  // namespace

std::string own_sheet(std::span<const Part> parts, SheetIdentity identity) {
  const std::uint32_t device_type = device_type_of(parts);
  const Profile* profile = find_profile(device_type);
  SheetMaker maker(profile != nullptr ? *profile : base_profile(), std::move(identity));
  for (const Part& part : parts) maker.add(part);
  maker.add_basics(device_type);
  return write_eds(maker.take());
}

int write_own_sheet(std::span<const Part> parts, SheetIdentity identity, const std::string& path) {
  identity.file_name = path.substr(path.find_last_of('/') + 1);
  std::ofstream file(path, std::ios::binary);
  file << own_sheet(parts, std::move(identity)) << std::flush;
  if (file) return 0;
  fmt::print(stderr, "{}: cannot be written\n", path);
  return 1;
}

}  // namespace canvoy::formats::detail
