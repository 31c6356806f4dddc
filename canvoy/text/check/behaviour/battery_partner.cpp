#include "canvoy/text/check/behaviour/battery_partner.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia418/kinds.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"

namespace canvoy::conformance {

namespace {

/// Time after which a charger has checked all nodes (CiA 419, 6.1 gives no time).
constexpr Duration link_max = 30s;
constexpr Duration look_again = 200ms;
constexpr Duration reset_max = 5s;
constexpr std::uint16_t pdos_of_battery = 3;

}  // namespace

BatteryPartner::BatteryPartner(Bench& bench)
    : bench_(bench),
      player_{.hears = [this](const Heard& heard) { hear(heard); },
              .due = [this] { return is_silent_ ? Time::max() : device_->node().deadline(); },
              .act = [this](Time now) { device_->node().advance(now); }} {
  environment_.provide(Callback<cia418::BatteryHardware()>::to<&BatteryPartner::hardware>(*this));
  device_.emplace(cia418::battery_kind, Port{this, &BatteryPartner::send_from, nullptr},
                  played_node(bench), environment_);
  device_->node().start(bench_.now());
  bench_.join(player_);
  bench_.listen(1ms);
  device_->node().command(NmtCommand::start);
}

BatteryPartner::~BatteryPartner() {
  bench_.leave(player_);
  bench_.command(NmtCommand::reset_node);
  bench_.await(can_id::error_control + bench_.node(), reset_max);
}

cia418::BatteryHardware BatteryPartner::hardware() {
  return {.sense = Callback<cia418::BatteryReadings()>::to<&BatteryPartner::sense>(*this)};
}

bool BatteryPartner::send_from(void* context, const Frame& frame) {
  auto& self = *static_cast<BatteryPartner*>(context);
  if (!self.is_silent_) self.bench_.send(frame);
  return true;
}

void BatteryPartner::hear(const Heard& heard) {
  if (is_silent_) return;
  const Frame& frame = heard.frame;
  const std::uint32_t requests = can_id::sdo_request + device_->node().id();
  if (frame.id == requests && frame.length == 8) {
    const unsigned command = frame.data[0] >> 5;
    const bool is_write = command == 1;
    if (is_write || command == 2) {
      requests_.push_back({is_write, load<std::uint16_t>(&frame.data[1]), frame.data[3]});
    }
  }
  device_->node().receive(frame, bench_.now());
}

bool BatteryPartner::was_asked(const Request& request) const {
  return std::ranges::find(requests_, request) != requests_.end();
}

std::uint32_t BatteryPartner::own(std::uint16_t index, std::uint8_t sub) {
  const Dictionary& dictionary = device_->node().dictionary();
  return dictionary.find(index, sub) ? static_cast<std::uint32_t>(dictionary.number(index, sub))
                                     : CobId::bit31;
}

bool BatteryPartner::has_rpdo_of_battery() {
  for (std::uint16_t i = 0; i < pdos_of_battery; ++i) {
    const auto cob_id =
        bench_.number(static_cast<std::uint16_t>(object_index::rpdo_parameter + i), 1);
    const std::uint32_t of_battery =
        own(static_cast<std::uint16_t>(object_index::tpdo_parameter + i), 1);
    if (cob_id && CobId{*cob_id}.valid() &&
        (*cob_id & Frame::id_max) == (of_battery & Frame::id_max)) {
      return true;
    }
  }
  return false;
}

std::optional<Verdict> BatteryPartner::wait_until_linked() {
  const auto& hand = bench_.options().hand;
  if (hand && hand({.words = "close the pilot contact of the charger"}) != HandAnswer::done) {
    return not_applicable("nobody could close the pilot contact");
  }
  bench_.command(NmtCommand::start);
  const Time until = bench_.now() + link_max;
  while (!bench_.is_broken() && bench_.now() < until) {
    if (has_rpdo_of_battery()) {
      bench_.command(NmtCommand::start);
      bench_.listen(look_again);
      return std::nullopt;
    }
    bench_.listen(look_again);
  }
  if (!hand) {
    return not_applicable("it links itself to no battery: its pilot contact may be open (--hands)");
  }
  return failed("30 s after the pilot contact was closed no RPDO of it is the battery's");
}

}  // namespace canvoy::conformance
