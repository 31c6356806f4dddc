// Simulated persons at the devices of a car, of a bus and of the panels of a lift: a driver, a
// passenger who buys a ticket, a person who presses a button; and what they see.
//
//     TransportHands transport(environment, hands);
#pragma once

#include <map>

#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/text/check/testing/hands.hpp"

namespace canvoy::conformance {

class TransportHands {
 public:
  /// Both arguments must outlive this.
  TransportHands(Environment& environment, Hands& hands) {
    provide(environment);
    watch(environment);
    learn_cars(hands);
    learn_buses(hands);
    learn_lifts(hands);
  }
  TransportHands(const TransportHands&) = delete;
  TransportHands& operator=(const TransportHands&) = delete;

 private:
  using Self = TransportHands;
  static constexpr std::uint64_t strange_card = 13;

  void provide(Environment& environment) {
    environment.provide(Callback<cia447::GpsHardware()>::to<&Self::gps_hardware>(*this));
    environment.provide(
        Callback<cia447::DriverIdentificationHardware()>::to<&Self::card_hardware>(*this));
    environment.provide(
        Callback<cia407::TicketCancellerHardware()>::to<&Self::canceller_hardware>(*this));
    environment.provide(
        Callback<cia407::TicketPrinterHardware()>::to<&Self::printer_hardware>(*this));
    environment.provide(Callback<cia417::OutputHardware()>::to<&Self::lamp_hardware>(*this));
  }
  void watch(Environment& environment) {
    environment.watch(
        Callback<void(cia447::NavigationUnit&, Node&)>::to<&Self::has_navigation>(*this));
    environment.watch(
        Callback<void(cia447::DriverIdentificationUnit&, Node&)>::to<&Self::has_cards>(*this));
    environment.watch(
        Callback<void(cia407::TicketCancellerUnit&, Node&)>::to<&Self::has_canceller>(*this));
    environment.watch(
        Callback<void(cia407::TicketPrinterUnit&, Node&)>::to<&Self::has_printer>(*this));
    environment.watch(
        Callback<void(cia407::PassengerCounterUnit&, Node&)>::to<&Self::has_counter>(*this));
    environment.watch(
        Callback<void(cia417::InputPanelUnit&, Node&)>::to<&Self::has_buttons>(*this));
    environment.watch(
        Callback<void(cia417::LoneDoorController&, Node&)>::to<&Self::has_doors>(*this));
  }

  // Cars.

  cia447::GpsReading read_gps() {
    if (!sees_sky_) return {.fix = cia447::GpsFix::none};
    return {.fix = cia447::GpsFix::fix_3d, .latitude = 48.137, .longitude = 11.575};
  }
  cia447::GpsHardware gps_hardware() {
    return {.read = Callback<cia447::GpsReading()>::to<&Self::read_gps>(*this)};
  }
  bool knows(std::uint64_t id) { return id != strange_card; }
  cia447::DriverIdentificationHardware card_hardware() {
    return {.knows = Callback<bool(std::uint64_t)>::to<&Self::knows>(*this)};
  }
  void has_navigation(cia447::NavigationUnit& unit, Node&) { navigation_ = &unit; }
  void has_cards(cia447::DriverIdentificationUnit& unit, Node&) { cards_ = &unit; }
  void learn_cars(Hands& hands) {
    hands.learn("cover the antenna of the GPS receiver", [this] { sees_sky_ = false; });
    hands.learn("give the GPS receiver a view of the whole sky", [this] { sees_sky_ = true; });
    hands.learn_at(navigation_, "select no destination at the navigation system",
                   [this] { navigation_->cancel(); });
    hands.learn_at(cards_, "log a driver in",
                   [this] { cards_->log_in({.id = 4711, .name = "A. Driver"}); });
    hands.learn_at(cards_, "log the driver out", [this] { cards_->log_out(); });
    hands.learn_at(cards_, "show a card that is not known to the reader",
                   [this] { cards_->log_in({.id = strange_card}); });
  }

  // Buses.

  void stamp(const cia407::TicketData&) { is_stamped_ = true; }
  cia407::TicketCancellerHardware canceller_hardware() {
    return {.stamp = Callback<void(const cia407::TicketData&)>::to<&Self::stamp>(*this)};
  }
  bool print(const cia407::TicketData&) {
    is_printed_ = has_paper_;
    return has_paper_;
  }
  bool has_paper() { return has_paper_; }
  cia407::TicketPrinterHardware printer_hardware() {
    return {.print = Callback<bool(const cia407::TicketData&)>::to<&Self::print>(*this),
            .has_paper = Callback<bool()>::to<&Self::has_paper>(*this)};
  }
  void has_canceller(cia407::TicketCancellerUnit& unit, Node&) { canceller_ = &unit; }
  void has_printer(cia407::TicketPrinterUnit& unit, Node&) { printer_ = &unit; }
  void has_counter(cia407::PassengerCounterUnit& unit, Node&) { counter_ = &unit; }
  void learn_buses(Hands& hands) {
    hands.learn_at(canceller_, "put a ticket into the canceller", [this] {
      is_stamped_ = false;
      canceller_->insert_ticket();
    });
    hands.sees["the ticket is cancelled"] = [this] { return is_stamped_; };
    hands.sees["the ticket is not cancelled"] = [this] { return !is_stamped_; };
    hands.learn_at(printer_, "have a ticket printed", [this] {
      is_printed_ = false;
      printer_->sell_ticket();
    });
    hands.sees["a ticket is printed"] = [this] { return is_printed_; };
    hands.learn_at(printer_, "take the paper out of the ticket printer",
                   [this] { has_paper_ = false; });
    hands.learn_at(printer_, "put paper into the ticket printer", [this] { has_paper_ = true; });
    hands.learn_at(counter_, "let two people in at the door", [this] { counter_->count_in(2); });
    hands.learn_at(counter_, "let one person out at the door", [this] { counter_->count_out(1); });
  }

  // Lifts.

  void show_lamp(std::uint32_t output, const cia417::OutputView& view) { lit_[output] = view.on; }
  cia417::OutputHardware lamp_hardware() {
    return {.show = Callback<void(std::uint32_t, const cia417::OutputView&)>::to<&Self::show_lamp>(
                *this)};
  }
  void has_buttons(cia417::InputPanelUnit& unit, Node& node) {
    buttons_ = &unit;
    panel_ = &node;
  }
  void has_doors(cia417::LoneDoorController& unit, Node&) { doors_ = &unit; }
  void learn_lifts(Hands& hands) {
    hands.learn_at(buttons_, "press button 1 of the panel",
                   [this] { buttons_->set_level(0, true, panel_->now()); });
    hands.learn_at(buttons_, "let button 1 of the panel go",
                   [this] { buttons_->set_level(0, false, panel_->now()); });
    hands.sees["lamp 1 of the panel is lit"] = [this] { return lit_[0]; };
    hands.sees["lamp 1 of the panel is dark"] = [this] { return !lit_[0]; };
    hands.learn_at(doors_, "have the controller open door 1", [this] { doors_->open(1); });
    hands.learn_at(doors_, "have the controller close door 1", [this] { doors_->close(1); });
    hands.learn_at(doors_, "have the controller stop door 1", [this] { doors_->stop(1); });
  }

  bool sees_sky_ = true;
  cia447::NavigationUnit* navigation_ = nullptr;
  cia447::DriverIdentificationUnit* cards_ = nullptr;
  cia407::TicketCancellerUnit* canceller_ = nullptr;
  cia407::TicketPrinterUnit* printer_ = nullptr;
  cia407::PassengerCounterUnit* counter_ = nullptr;
  cia417::InputPanelUnit* buttons_ = nullptr;
  cia417::LoneDoorController* doors_ = nullptr;
  Node* panel_ = nullptr;
  bool is_stamped_ = false;
  bool is_printed_ = false;
  bool has_paper_ = true;
  std::map<std::uint32_t, bool> lit_;
};

}  // namespace canvoy::conformance
