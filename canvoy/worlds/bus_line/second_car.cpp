#include "canvoy/worlds/bus_line/second_car.hpp"

namespace canvoy::bus_line {

void SecondCar::add_nodes() {
  using namespace cia407;
  Environment& first = nodes_.add_site();
  first.provide(Callback<TrainBusGatewayHardware()>::to<&TrainLink::first_hardware>(train_));
  first.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainLink::is_first>(train_));
  nodes_.add(train_gateway_id, first);
  Environment& second = nodes_.add_site();
  second.provide(Callback<BusSegment()>::to<&SecondCar::segment>(*this));
  second.provide(Callback<TrainBusGatewayHardware()>::to<&TrainLink::second_hardware>(train_));
  second.provide(Callback<MirrorControlHardware()>::to<&SecondCar::mirror_hardware>(*this));
  second.provide(Callback<MirrorControlSettings()>::to<&SecondCar::mirror_settings>(*this));
  second.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainLink::is_second>(train_));
  nodes_.add(second_gateway_id, second);
  train_.join(nodes_.node(train_gateway_id), nodes_.node(second_gateway_id));
}

MirrorControlHardware SecondCar::mirror_hardware() {
  return {.is_coupled = Callback<bool()>::to<&TrainLink::is_coupled>(train_)};
}

MirrorControlSettings SecondCar::mirror_settings() {
  MirrorControlSettings settings{
      .nodes = {second_destination_id, second_next_stop_id, second_announcer_id},
      .displays = {{second_destination_id, DisplayUse::destination},
                   {second_next_stop_id, DisplayUse::next_stop}}};
  for (const AddedDevice& added : nodes_.design().added) {
    if (added.car == 2) settings.nodes.push_back(added.id);
  }
  return settings;
}

}  // namespace canvoy::bus_line
