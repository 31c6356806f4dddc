// Provisions of CiA 407 beside its objects: index ranges (9.1), configurations (8.1.4), failures
// (7.2), and refused accesses (9.2.27).
#pragma once

#include "canvoy/profiles/cia407/values.hpp"
#include "canvoy/profiles/model/provisions.hpp"

namespace canvoy::cia407 {

inline constexpr IndexRangeProvision index_ranges[] = {
    {0x6000, 0x60FF, "Physical device", "9.1"},
    {0x6100, 0x618F, "Main on-board computer", "9.1"},
    {0x6190, 0x61FF, "Identification device", "9.1"},
    {0x6200, 0x62FF, "Passenger information", "9.1"},
    {0x6300, 0x631F, "Ticket canceller", "9.1"},
    {0x6320, 0x633F, "Ticket printer", "9.1"},
    {0x6340, 0x635F, "Ticket/card reader/validators", "9.1"},
    {0x6380, 0x63AF, "Acoustic announcer", "9.1"},
    {0x63B0, 0x63CF, "Acoustic control manager", "9.1"},
    {0x6400, 0x647F, "Train bus gateway", "9.1"},
    {0x6480, 0x64FF, "Vehicle gateway", "9.1"},
    {0x6500, 0x651F, "Vehicle driver indicator", "9.1"},
    {0x6520, 0x657F, "Tachograph", "9.1"},
    {0x6600, 0x661F, "DRCC", "9.1"},
    {0x6620, 0x663F, "VRCC", "9.1"},
    {0x6640, 0x665F, "DSRC", "9.1"},
    {0x6660, 0x667F, "Geographical positioning", "9.1"},
    {0x6680, 0x669F, "Time fixing", "9.1"},
    {0x66A0, 0x66BF, "Driver's console display", "9.1"},
    {0x66C0, 0x66DF, "Driver's console keyboard", "9.1"},
    {0x6700, 0x671F, "Passenger counting", "9.1"},
    {0x6720, 0x673F, "Passenger counting manager", "9.1"},
    {0x6740, 0x675F, "Diagnostics device", "9.1"},
    {0x6760, 0x677F, "Generic I/O device", "9.1"},
    {0x6780, 0x679F, "Power supply", "9.1"},
    {0x67FF, 0x67FF, "Device type object", "9.1"},
    {0x7000, 0x9FFF, "reserved", "9.1"},
};

// Class 1 is the destination indicator, class 2 the next stop indicator; subclass 2 shows text.
inline constexpr ConfiguredDevice minimum_devices[] = {{0x01}, {0x02}, {0x03, 1, 2}, {0x04}};
inline constexpr ConfiguredDevice typical_devices[] = {{0x01},       {0x02}, {0x03, 1, 2},
                                                       {0x03, 2, 2}, {0x04}, {0x05}};
inline constexpr ConfigurationProvision configurations[] = {
    {"minimum configuration", minimum_devices, "8.1.4.1"},
    {"typical configuration", typical_devices, "8.1.4.2"},
};

inline constexpr FailureProvision failures[] = {
    {bus_off_failure, "7.2"},
    {life_guarding_failure, "7.2"},
    {heartbeat_failure, "7.2"},
    {"an internal failure of the device", "7.2"},
};

inline constexpr AbortProvision aborts[] = {
    {0x6740, 0, AbortCode::value_range, "a number above 0 is written", "9.2.27.1"},
    {0x6741, 0, AbortCode::value_range, "anything but 0 is written", "9.2.27.2"},
    {0x6742, 0, AbortCode::value_range, "a number above 1 is written", "9.2.27.3"},
    {0x6743, 0, AbortCode::value_range, "a number above 1 is written", "9.2.27.4"},
    {0x6744, 0, AbortCode::value_range, "a number above 1 is written", "9.2.27.5"},
};

inline constexpr Provisions provisions = {.index_ranges = index_ranges,
                                          .configurations = configurations,
                                          .aborts = aborts,
                                          .failures = failures};

}  // namespace canvoy::cia407
