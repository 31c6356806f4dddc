// What CiA 417-4 says beside its objects: which indices are whose (4.1.1), and with which abort
// codes the creation of objects is refused (4.2.6).
#pragma once

#include "canvoy/profiles/cia417/values.hpp"
#include "canvoy/profiles/provisions.hpp"

namespace canvoy::cia417 {

inline constexpr IndexRangeProvision index_ranges[] = {
    {0x6000, 0x67FF, "lift-control application 1", "4.1.1"},
    {0x6800, 0x6FFF, "lift-control application 2", "4.1.1"},
    {0x7000, 0x77FF, "lift-control application 3", "4.1.1"},
    {0x7800, 0x7FFF, "lift-control application 4", "4.1.1"},
    {0x8000, 0x87FF, "lift-control application 5", "4.1.1"},
    {0x8800, 0x8FFF, "lift-control application 6", "4.1.1"},
    {0x9000, 0x97FF, "lift-control application 7", "4.1.1"},
    {0x9800, 0x9FFF, "lift-control application 8", "4.1.1"},
};

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
