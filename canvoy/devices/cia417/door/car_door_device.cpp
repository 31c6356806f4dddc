#include "canvoy/devices/cia417/door/car_door_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/kit/lift_forms.hpp"

namespace canvoy::cia417 {

/// A fourth door has no recommended node-ID.
static constexpr NodeId ids_of_doors[] = {6, 7, 8, 12};

const DeviceKind car_door_kind = {.info = CarDoorKind<>::info,
                                  .profile = &profile,
                                  .forms = forms_of_doors<CarDoorKind>,
                                  .node_ids_of_doors = ids_of_doors};

}  // namespace canvoy::cia417
