// The kind of an operator environment, for the catalogue, and its objects for elements that are
// known at run time. One source makes them, with memory from the heap: boards link OperatorDevice,
// and none of this.
//
//     environment.provide(Callback<OperatorEnvironment()>::to<&Options::elements>(options));
//     CatalogueDevice seat(operator_kind, port, 10, environment);
#pragma once

#include <vector>

#include "canvoy/devices/kit/device_kind.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::cia852 {

/// The default, if the environment offers no others: a seat.
inline constexpr OperatorEnvironment usual_elements = {.joysticks = 2,
                                                       .foot_pedals = 2,
                                                       .encoders = 1,
                                                       .wheels = 2,
                                                       .push_button_clusters = 1,
                                                       .indicator_clusters = 1,
                                                       .displays = 1,
                                                       .configuration = true};

/// The objects of such a device, sorted. The elements fulfil check_elements().
std::vector<Part> operator_parts(const OperatorEnvironment& elements, bool keeps_parameters);

extern const DeviceKind operator_kind;

}  // namespace canvoy::cia852
