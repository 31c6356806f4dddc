// The kind of an operator environment, for the catalogue, and its objects with elements that are
// known when the program runs. They are made in one source, which takes memory from the heap:
// boards link OperatorDevice, and none of this.
//
//     site.offer(Callback<OperatorEnvironment()>::to<&Options::elements>(options));
//     CatalogueDevice seat(operator_kind, port, 10, site);
#pragma once

#include <vector>

#include "canvoy/devices/device_kind.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::cia852 {

/// Where the site offers no others: a seat.
inline constexpr OperatorEnvironment usual_elements = {.joysticks = 2,
                                                       .foot_pedals = 2,
                                                       .encoders = 1,
                                                       .wheels = 2,
                                                       .push_button_clusters = 1,
                                                       .indicator_clusters = 1,
                                                       .displays = 1,
                                                       .configuration = true};

/// The objects of such a device, sorted. Elements are as check_elements() wants them.
std::vector<Part> operator_parts(const OperatorEnvironment& elements, bool keeps_parameters);

extern const DeviceKind operator_kind;

}  // namespace canvoy::cia852
