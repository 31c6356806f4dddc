// The device of all samples: a node with one application object, 2000h.
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace pump {

inline constexpr canvoy::ObjectInfo speed{
    .index = 0x2000,
    .name = "speed",
    .entry = {.type = canvoy::DataType::unsigned16, .access = canvoy::Access::rw, .initial = 100}};
inline constexpr auto description =
    canvoy::describe(canvoy::cia301::device_type(0), canvoy::cia301::error_register_object,
                     canvoy::cia301::identity({.vendor_id = 0x123}),
                     canvoy::cia301::heartbeat_producer(1000), speed);
inline constexpr auto layout = canvoy::lay_out_device<description>();
using Device = canvoy::DeviceNode<layout>;

}  // namespace pump
