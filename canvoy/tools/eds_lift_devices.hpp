// Devices of a lift (CiA 417-4) of which `canvoy eds` writes data sheets, by the names that it
// takes for them.
//
//     const LiftDeviceKind* kind = find_lift_device("car-door");
//     kind->add(maker);   // its objects, to a data sheet
#pragma once

#include <string_view>

#include "canvoy/formats/sheet_export.hpp"

namespace canvoy::tools {

struct LiftDeviceKind {
  std::string_view name;     ///< "car-door"
  std::string_view product;  ///< as the device names itself
  void (*add)(formats::SheetMaker& maker);
};

/// Null where there is none of this name.
const LiftDeviceKind* find_lift_device(std::string_view name);

}  // namespace canvoy::tools
