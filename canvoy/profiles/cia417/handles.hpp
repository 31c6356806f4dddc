// All handles of CiA 417-4 for the application code of a lift. A device that is one virtual device
// includes only what it needs: panel_handles.hpp, car_handles.hpp or drive_handles.hpp.
//
//     gateway[cia417::in_lift(3, cia417::absolute_load_value)].value()  // kilograms
#pragma once

#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"
#include "canvoy/profiles/cia417/manufacturer_handles.hpp"
#include "canvoy/profiles/cia417/panel_handles.hpp"
