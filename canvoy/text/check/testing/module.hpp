// A module of CiA 401 of this project, with its data sheet: a device with nearly all of CiA 301 and
// with LSS.
//
//     expect_found_in_module({"it sends no heartbeat", {"heartbeat-01"}, lose_heartbeats});
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/text/check/testing/middle.hpp"

namespace canvoy::conformance {

inline const DeviceKind& module_kind() {
  return *find_device_kind("io-401");
}

inline formats::DataSheet sheet_of_module() {
  formats::SheetMaker maker(*module_kind().profile,
                            {.product_name = module_kind().info.product, .answers_lss = true});
  Environment environment;
  for (const Part& part : module_kind().form(environment).parts()) maker.add(part);
  return maker.take();
}

/// Expects that the cases that concern the defect fail, and no others of all classes.
inline void expect_found_in_module(const Way& way) {
  static const formats::DataSheet sheet = sheet_of_module();
  CheckedDevice device(module_kind());
  Middle middle(device);
  apply(device, middle, way);
  Check check(device.line(), device.node(), {.sheet = &sheet});
  const Report report = check.run();
  EXPECT_TRUE(report.is_whole) << way.name;
  EXPECT_THAT(failures(report), ::testing::UnorderedElementsAreArray(way.found_by)) << way.name;
}

}  // namespace canvoy::conformance
