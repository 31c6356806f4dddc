// The data sheet of a device of one's own, from the description that its node is laid out from:
// names of manufacturer objects included. CMake's canvoy_data_sheet() writes it beside the program
// (cmake/CanvoyDataSheet.cmake).
//
//     constexpr auto pump = describe(cia301::device_type(0), speed);
//     std::string text = own_sheet(pump, {.product_name = "Pump"});     // an EDS
//     int status = write_own_sheet(pump, {.product_name = "Pump"}, "pump.eds");
#pragma once

#include <span>
#include <string>

#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::formats {

namespace detail {

std::string own_sheet(std::span<const Part> parts, SheetIdentity identity);
int write_own_sheet(std::span<const Part> parts, SheetIdentity identity, const std::string& path);

}  // namespace detail

/// An EDS (CiA 306), or a DCF where the identity has a node-ID. The profile is that of the default
/// of 1000h, or CiA 301; numbers of 1018h are those of the description.
template <std::size_t capacity>
std::string own_sheet(const DeviceDescription<capacity>& device, SheetIdentity identity) {
  return detail::own_sheet({device.begin(), device.size()}, std::move(identity));
}

/// Writes it into a file, whose name the sheet tells. Answers an exit status: 1 where the file
/// cannot be written, with a line on stderr.
template <std::size_t capacity>
int write_own_sheet(const DeviceDescription<capacity>& device, SheetIdentity identity,
                    const std::string& path) {
  return detail::write_own_sheet({device.begin(), device.size()}, std::move(identity), path);
}

}  // namespace canvoy::formats
