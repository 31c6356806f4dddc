// A node of one's own: a charger of CiA 419 with an object of its maker.
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace my_charger {

inline constexpr canvoy::ObjectInfo fan_speed{
    .index = 0x2000,
    .name = "fan_speed",
    .entry = {.type = canvoy::DataType::unsigned16, .access = canvoy::Access::rw}};
inline constexpr auto description =
    canvoy::describe(canvoy::cia419::charger({}), canvoy::cia301::identity({.vendor_id = 0x123}),
                     canvoy::cia301::heartbeat_producer(1000), fan_speed);
inline constexpr auto layout = canvoy::lay_out_device<description>();

}  // namespace my_charger
