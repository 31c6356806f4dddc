// The data sheet of a custom device, from the description that defines its node, including names of
// manufacturer objects. CMake's canvoy_data_sheet() writes it beside the program
// (cmake/CanvoyDataSheet.cmake).
//
//     constexpr auto pump = describe(cia301::device_type(0), speed);
//     std::string text = own_sheet(pump, {.product_name = "Pump"});     // an EDS
//     int status = write_own_sheet(pump, {.product_name = "Pump"}, "pump.eds");
#pragma once

#include <span>
#include <string>

#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy::formats {

namespace detail {

std::string own_sheet(std::span<const Part> parts, SheetIdentity identity);
int write_own_sheet(std::span<const Part> parts, SheetIdentity identity, const std::string& path);

}  // namespace detail

/// Makes an EDS, or a DCF if the identity has a node-ID (CiA 306). The profile is that of the
/// default of 1000h, or CiA 301; the numbers of 1018h are those of the description.
template <std::size_t capacity>
std::string own_sheet(const DeviceDescription<capacity>& device, SheetIdentity identity) {
  return detail::own_sheet({device.begin(), device.size()}, std::move(identity));
}

/// Writes the sheet into the file that it names. Returns an exit status: 1 if the file cannot be
/// written, with a line on stderr.
template <std::size_t capacity>
int write_own_sheet(const DeviceDescription<capacity>& device, SheetIdentity identity,
                    const std::string& path) {
  return detail::write_own_sheet({device.begin(), device.size()}, std::move(identity), path);
}

}  // namespace canvoy::formats
