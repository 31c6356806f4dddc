// Provisions of CiA 417-4 beside its objects: index ranges (4.1.1), and the abort codes that refuse
// the creation of objects (4.2.6).
#pragma once

#include "canvoy/profiles/cia417/values.hpp"
#include "canvoy/profiles/model/provisions.hpp"

namespace canvoy::cia417 {

inline constexpr std::array<std::string_view, lift_count> range_owners = {
    "lift-control application 1", "lift-control application 2", "lift-control application 3",
    "lift-control application 4", "lift-control application 5", "lift-control application 6",
    "lift-control application 7", "lift-control application 8"};
inline constexpr auto index_ranges = ranges_of(0x6000, block_pitch, range_owners, "4.1.1");

inline constexpr std::string_view not_supported = "the device does not support the object";
inline constexpr std::string_view lacks_resources = "no resources are left for the object";
inline constexpr AbortProvision aborts[] = {
    {0x6020, 0, AbortCode::value_range, not_supported, "4.2.6"},
    {0x6020, 0, AbortCode::general, not_supported, "4.2.6"},
    {0x6020, 0, AbortCode::out_of_memory, lacks_resources, "4.2.6"},
    {0x6020, 0, AbortCode::general, lacks_resources, "4.2.6"},
};

inline constexpr Provisions provisions = {.index_ranges = index_ranges, .aborts = aborts};

}  // namespace canvoy::cia417
