#include "canvoy/worlds/bus_line/following_cars.hpp"

namespace canvoy::bus_line {

void FollowingCars::add_nodes() {
  using namespace cia407;
  Environment& first = nodes_.add_site();
  first.provide(Callback<TrainBusGatewayHardware()>::to<&TrainLink::first_hardware>(train_));
  first.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainLink::is_first>(train_));
  nodes_.add(train_gateway_id, first);
  train_.join(1, nodes_.node(train_gateway_id));
  for (unsigned number = 2; number <= nodes_.cars(); ++number) {
    Environment& environment = nodes_.add_site();
    cars_.emplace_back(nodes_, train_, number).add_to(environment);
    nodes_.add(gateway_of(number), environment);
    train_.join(number, nodes_.node(gateway_of(number)));
  }
}

void FollowingCars::Car::add_to(Environment& environment) {
  using namespace cia407;
  environment.provide(Callback<BusSegment()>::to<&Car::segment>(*this));
  environment.provide(
      Callback<TrainBusGatewayHardware()>::to<&TrainLink::following_hardware>(train_));
  environment.provide(Callback<MirrorControlHardware()>::to<&Car::mirror_hardware>(*this));
  environment.provide(Callback<MirrorControlSettings()>::to<&Car::mirror_settings>(*this));
  environment.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&Car::is_made>(*this));
}

MirrorControlHardware FollowingCars::Car::mirror_hardware() {
  return {.is_coupled = Callback<bool()>::to<&TrainLink::is_coupled>(train_)};
}

MirrorControlSettings FollowingCars::Car::mirror_settings() {
  const NodeId destination = nodes_.id(destination_of(number_));
  const NodeId next_stop = nodes_.id(next_stop_of(number_));
  MirrorControlSettings settings{
      .nodes = {destination, next_stop, nodes_.id(announcer_of(number_))},
      .displays = {{destination, DisplayUse::destination}, {next_stop, DisplayUse::next_stop}}};
  for (const AddedDevice& added : nodes_.design().added) {
    if (added.car == number_) settings.nodes.push_back(added.id);
  }
  return settings;
}

}  // namespace canvoy::bus_line
