// Values that battery modules and chargers exchange, as CiA 419 describes them. CiA 418 has the
// same values (CiA 419, 7.2).
//
//     charger[cia419::battery_status].is(Readiness::ready)
#pragma once

#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// Readiness of a battery to accept a charge, or of a charger to deliver one (CiA 419, 7.2.1 and
/// 7.2.2).
enum class Readiness : std::uint8_t { not_ready = 0, ready = 1 };

namespace battery_values {

/// Of bit 0.
inline constexpr NamedValue readiness_names[] = {{Readiness::not_ready, "not ready"},
                                                 {Readiness::ready, "ready"}};
/// Of bits 1 to 7.
inline constexpr NamedValue reserved_names[] = {{0, "0", Meaning::padding},
                                                {1, 0x7F, "reserved", Meaning::reserved}};
/// Fields of a status of readiness: bit 0; the others are reserved.
inline constexpr FieldInfo readiness[] = {
    {.name = "readiness", .value = {.names = readiness_names}},
    {.first_bit = 1, .bits = 7, .name = "reserved", .value = {.names = reserved_names}}};

inline constexpr NamedValue invalid_8[] = {{0xFF, "invalid", Meaning::invalid}};  ///< of Unsigned8
/// Of Unsigned16 and Integer16.
inline constexpr NamedValue invalid_16[] = {{0xFFFF, "invalid", Meaning::invalid}};
/// Of Unsigned32.
inline constexpr NamedValue invalid_32[] = {{0xFFFF'FFFF, "invalid", Meaning::invalid}};

/// A battery measures -40.0 to 85.0 degrees at least (CiA 419, 7.2.3). FFFFh is -1 as Integer16:
/// -0.125 degrees cannot be sent (errata 1).
inline constexpr ValueInfo temperature = {.unit = Unit::degree_celsius,
                                          .scale = {.denominator = 8},
                                          .limits = at_least(-320, 680),
                                          .names = invalid_16};
/// CiA 419, 7.2.4.
inline constexpr ValueInfo ampere_hours = {
    .unit = Unit::ampere_hour, .scale = {.denominator = 8}, .names = invalid_16};
/// CiA 419, 7.2.5.
inline constexpr ValueInfo voltage = {
    .unit = Unit::volt, .scale = {.denominator = 1024}, .names = invalid_32};
/// CiA 419, 7.2.6.
inline constexpr ValueInfo current = {
    .unit = Unit::ampere, .scale = {.denominator = 16}, .names = invalid_16};
/// CiA 419, 7.2.7 and 7.2.8.
inline constexpr ValueInfo state_of_charge = {
    .unit = Unit::percent, .limits = within(0, 100), .names = invalid_8};

}  // namespace battery_values
}  // namespace canvoy
