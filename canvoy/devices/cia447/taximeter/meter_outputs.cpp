#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/printer.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

namespace {

/// All is sent again: a sign may have lost its power for too short a time to be detected, and its
/// boot-up message may have been lost as well.
constexpr Duration renewal = 10s;

/// Leaves the other lamps unchanged.
std::uint32_t with_lamp(std::uint32_t lamps, const FieldPlace& place, Lamp lamp) {
  const std::uint32_t mask = ((1U << place.bits) - 1) << place.first_bit;
  return (lamps & ~mask) | static_cast<std::uint32_t>(lamp) << place.first_bit;
}

}  // namespace

constexpr ServiceHandlers MeterOutputs::service_calls = {.reset = method<&MeterOutputs::reset>};

MeterOutputs::MeterOutputs(CarNetwork& network, const Settings& settings)
    : network_(network),
      settings_(settings),
      printer_(network.node(), mesh_channel_to(settings.printer)),
      sign_(network.node(), mesh_channel_to(settings.sign)),
      timer_(callback<&MeterOutputs::go_on>(*this)) {
  next_lost_ = network.on_lost(callback<&MeterOutputs::lost>(*this));
  network.node().attach(service_);
}

/// The state of the meter in other devices may be out of date.
void MeterOutputs::reset(ResetScope) {
  told_ = {};
  network_.node().timers().arm(timer_, network_.node().now() + settings_.repetition);
}

void MeterOutputs::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node != settings_.sign) return;
  told_ = {};
  network_.node().timers().arm(timer_, network_.node().now() + settings_.repetition);
}

void MeterOutputs::show(const TaximeterDisplay& display) {
  const bool is_on_duty =
      display.state != Taximeter::signed_off && display.state != Taximeter::standby_mode;
  const bool is_vacant = display.state == Taximeter::for_hire;
  wanted_.lamps = with_lamp(wanted_.lamps, place_of(tariff_display_lamps_command_1_taxi_light),
                            is_on_duty ? Lamp::on : Lamp::off);
  wanted_.lamps = with_lamp(wanted_.lamps, place_of(tariff_display_lamps_command_1_vacant_light),
                            is_vacant ? Lamp::on : Lamp::off);
  wanted_.level = display.trip.level;
  if (wanted_ != told_) go_on_soon();
}

void MeterOutputs::print(std::string_view text) {
  if (printer_.busy()) printer_.cancel();
  receipt_length_ = std::min(text.size(), receipt_.size());
  std::copy_n(text.begin(), receipt_length_, receipt_.begin());
  go_on_soon();
}

/// Nothing is sent from within a callback of a key.
void MeterOutputs::go_on_soon() {
  network_.node().timers().arm(timer_, network_.node().now());
}

void MeterOutputs::go_on(Time now) {
  const bool has_sign = settings_.sign != 0;
  const bool has_printer = settings_.printer != 0;
  if (now >= renewal_due_) {
    renewal_due_ = now + renewal;
    told_ = {};
  }
  if (has_sign) network_.watch(settings_.sign);
  if (has_sign && wanted_ != told_ && !sign_.busy()) write_sign();
  if (has_printer && receipt_length_ != 0 && !printer_.busy()) write_receipt();
  const bool is_done = (!has_sign || wanted_ == told_) && (!has_printer || receipt_length_ == 0);
  network_.node().timers().arm(timer_, is_done ? renewal_due_ : now + settings_.repetition);
}

void MeterOutputs::write_sign() {
  writing_ = wanted_;
  store(lamp_bytes_.data(), writing_.lamps);
  sign_.download(settings_.sign, tariff_display_lamps_command_1_object.index, 0, lamp_bytes_,
                 SdoClient::Done::to<&MeterOutputs::lamps_written>(*this));
}
void MeterOutputs::lamps_written(SdoClient::Outcome outcome) {
  if (!outcome) return;  // the timer continues
  sign_.download(settings_.sign, taxi_trip_tariff_level_object.index, 0, writing_.level,
                 SdoClient::Done::to<&MeterOutputs::level_written>(*this));
}
void MeterOutputs::level_written(SdoClient::Outcome outcome) {
  if (!outcome) return;
  told_ = writing_;
  renewal_due_ = network_.node().now() + renewal;
  const bool is_done = wanted_ == told_ && (settings_.printer == 0 || receipt_length_ == 0);
  if (is_done) network_.node().timers().arm(timer_, renewal_due_);
}

void MeterOutputs::write_receipt() {
  printer_.download(settings_.printer, printer_transport_object.index, 0,
                    std::span(receipt_).first(receipt_length_),
                    SdoClient::Done::to<&MeterOutputs::receipt_written>(*this));
}
void MeterOutputs::receipt_written(SdoClient::Outcome outcome) {
  if (!outcome) return;  // the timer continues
  receipt_length_ = 0;
  ++printed_;
}

}  // namespace canvoy::cia447
