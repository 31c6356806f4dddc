// Complaints of a customer of a lift, and the invariant that each breaks: alone, and together with
// a harmless fault of the other lift, which excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <ostream>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_sabotage_table_test {
namespace {

// CAN-IDs of the first lift (CiA 417-4, pre-defined PDOs).
constexpr std::uint32_t drive_control = 0x180;
constexpr std::uint32_t drive_velocity = 0x184;
constexpr std::uint32_t load_signals = 0x188;
constexpr std::uint32_t car_position = 0x18C;
constexpr std::uint32_t door_control = 0x200;
constexpr std::uint32_t virtual_output = 0x400;
constexpr std::uint32_t virtual_input = 0x480;  // + node-ID
constexpr std::uint32_t heartbeat = 0x700;      // + node-ID

/// Two lifts of a group, with a foreign device on the bus of the first one.
class Scene {
 public:
  explicit Scene(const LiftNetworkDescription& description)
      : network(description), stranger_(network.world().bus(0).attach({})) {
    network.observe(0, {.context = this, .on_frame = note});
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void send(const Frame& frame) { network.world().bus(0).send(stranger_, frame); }
  void send(std::uint32_t id, std::uint64_t record, unsigned length = 6) {
    Frame frame = Frame::data_frame(id, {});
    frame.length = static_cast<std::uint8_t>(length);
    for (std::size_t i = 0; i < length; ++i) {
      frame.data.at(i) = static_cast<std::uint8_t>(record >> (8 * i));
    }
    send(frame);
  }
  LiftSnapshot car() const { return network.snapshot().lifts.at(0); }
  bool is_fast() const { return std::abs(car().speed_m_s) > 1; }
  bool is_inspected() { return network.shaft(1).facts(network.now()).is_inspected; }
  bool is_broken(InvariantKind kind, LiftNumber part) const {
    return std::ranges::any_of(network.invariants(), [=](const Invariant& one) {
      return one.kind == kind && one.part == part && !one.held;
    });
  }

  LiftNetwork network;
  Frame opening{};  ///< the controller's command to open its doors; empty: none yet
  bool holds_drive = false;

 private:
  static void note(void* self, Time, ControllerId sender, const Frame& frame) {
    auto& scene = *static_cast<Scene*>(self);
    if (sender == scene.stranger_) return;
    if (frame.id == drive_control) scene.note_drive(frame);
    if (frame.id != door_control || frame.length < 2) return;
    const unsigned command = frame.data[1] >> 4U;  // of door 1 (6300h, 4.6.1)
    const bool opens = command == 3 || command == 4;
    if (scene.opening.length == 0 && opens) scene.opening = frame;
  }
  /// A device that holds the drive stops it as soon as it is to move with an open door.
  void note_drive(const Frame& frame) {
    constexpr unsigned new_set_point = 0x10;
    if (!holds_drive || (frame.data[0] & new_set_point) == 0) return;
    if (car().doors.at(0).open_share == 0) return;
    network.world().at(network.now() + 1ms, [this](Time) {
      send(Frame::data_frame(drive_control, {0x02, 0, 0, 0, 0, 0}));
    });
  }

  ControllerId stranger_;
};

/// Called each 100 ms.
using Trick = std::function<void(Scene&)>;
/// Does the trick once, as soon as the condition holds.
Trick once_when(std::function<bool(const Scene&)> when, Trick trick) {
  return [when = std::move(when), trick = std::move(trick), is_done = false](Scene& it) mutable {
    if (is_done || !when(it)) return;
    is_done = true;
    trick(it);
  };
}
Trick always_from(Time from, Trick trick) {
  return [from, trick = std::move(trick)](Scene& it) {
    if (it.network.now() >= from) trick(it);
  };
}
bool is_fast_with_people(const Scene& it) {
  return it.opening.length != 0 && it.car().persons != 0 && it.is_fast();
}
bool is_far_from_a_call(const Scene& it) {
  const LiftSnapshot car = it.car();
  return it.is_fast() && car.persons != 0 && !car.car_calls.empty() &&
         std::abs(car.nearest_floor - car.car_calls.front()) > 1;
}
bool stands_empty(const Scene& it) {
  const LiftSnapshot car = it.car();
  return it.network.now() > Time(1min) && car.persons == 0 && car.speed_m_s == 0;
}

NodeDescription& node(LiftNetworkDescription& description, DeviceKind kind) {
  return *std::ranges::find(description.nodes, kind, &NodeDescription::kind);
}
NodeDescription& landing_panel(LiftNetworkDescription& description, FloorNumber floor) {
  return *std::ranges::find_if(description.nodes, [floor](const NodeDescription& each) {
    return each.kind == DeviceKind::landing_panel && each.floors.front() == floor;
  });
}
NodeValue no_pdo(std::uint16_t index, std::uint32_t can_id) {
  return {index,
          1,
          {static_cast<std::uint8_t>(can_id), static_cast<std::uint8_t>(can_id >> 8U), 0, 0x80}};
}
/// No node sends a SYNC: a PDO of transmission type 240 is never sent.
NodeValue on_sync(std::uint16_t index) {
  return {index, 2, {240}};
}
/// A PDO with an inhibit time of 6 s, which is written while it is off (CiA 301, 7.5.2.37).
std::vector<NodeValue> inhibited(std::uint16_t index, std::uint32_t can_id) {
  NodeValue back_on = no_pdo(index, can_id);
  back_on.bytes.back() = 0;
  return {no_pdo(index, can_id), {index, 3, {0x60, 0xEA}}, back_on};
}
/// Presses there are not reported.
void mute(NodeDescription& panel) {
  panel.values.push_back(no_pdo(0x1881, virtual_input + panel.id));
}
void add_fault(LiftNetworkDescription& description, const ScheduledFault& fault) {
  description.faults.faults.push_back(fault);
}
/// Mass of each of 13 people: 460 kg more than 1100 fill a car.
constexpr double heavy_kg = 120;
/// 13 people of 75 kg make the car sink by 58 mm.
constexpr double soft_ropes = 60;
/// More people come than there is room for.
void crowd_the_hall(LiftNetworkDescription& description, double mass_kg) {
  description.people.fill_share = 1;
  description.traffic.pattern = TrafficPattern::up_peak;
  description.traffic.percent_in_5_minutes = 30;
  description.traffic.mass_kg_mean = mass_kg;
  description.traffic.mass_kg_deviation = 0;
}
std::uint64_t turned_key(cia417::SpecialFunction key) {
  return cia417::encode(cia417::VirtualInput{.function = cia417::BasicFunction::special_function,
                                             .sub_function = cia417::sub_function_of(key),
                                             .lifts = cia417::lift_bit(1),
                                             .doors = cia417::source_door(1),
                                             .data = cia417::VirtualInput::lock_bit | 1U});
}

std::uint64_t lit_car_call(FloorNumber floor) {
  return cia417::encode(cia417::VirtualOutput{
      .function = cia417::BasicFunction::standard_car_call,
      .sub_function = floor,
      .lifts = cia417::lift_bit(1),
      .doors = cia417::source_door(1),
      .data = cia417::output_data(true, cia417::Property::standard, 0, true)});
}
/// A hand turns the switch on the roof of the empty car, and holds a button.
Trick inspection(Direction way) {
  return once_when(stands_empty, [way](Scene& it) {
    it.network.shaft(1).turn_inspection(Station::roof, true);
    it.network.shaft(1).hold_inspection(Station::roof, way);
  });
}
/// Controlword 000Fh, and 1 m/s up (1903h).
constexpr std::uint64_t velocity_up = 0x03E8'000F;

struct Sabotage {
  const char* name;
  InvariantKind breaks;
  LiftNumber part;  ///< 0: of all lifts
  std::function<void(LiftNetworkDescription&)> set = [](LiftNetworkDescription&) {};
  std::function<Trick()> trick = [] { return Trick([](Scene&) {}); };
};
std::ostream& operator<<(std::ostream& out, const Sabotage& it) {
  return out << it.name;
}

using Description = LiftNetworkDescription;

const Sabotage of_files[] = {
    {"ADriveThatHearsNoCommands", InvariantKind::lift_serves, 1,
     [](Description& it) {
       node(it, DeviceKind::drive).values = {no_pdo(0x1504, 0x180), no_pdo(0x1503, 0x184)};
     }},
    {"ADriveThatSaysNothing", InvariantKind::lift_serves, 1,
     [](Description& it) {
       node(it, DeviceKind::drive).values = {no_pdo(0x1905, 0x181), no_pdo(0x1907, 0x185)};
     }},
    {"ADoorThatSaysNothing", InvariantKind::lift_serves, 1,
     [](Description& it) { node(it, DeviceKind::door).values = {no_pdo(0x190A, 0x201)}; }},
    {"ADoorThatHearsNoCommands", InvariantKind::no_call_lost, 0,
     [](Description& it) { node(it, DeviceKind::door).values = {no_pdo(0x1508, 0x200)}; }},
    {"APositionThatIsToldEach6Seconds", InvariantKind::lift_serves, 1,
     [](Description& it) {
       node(it, DeviceKind::position).values = inhibited(0x1906, car_position);
     }},
    {"ADoorWhosePositionAwaitsASync", InvariantKind::lift_serves, 1,
     [](Description& it) { node(it, DeviceKind::door).values = {on_sync(0x190A)}; }},
    {"ADriveWhoseVelocityAwaitsASync", InvariantKind::lift_serves, 1,
     [](Description& it) { node(it, DeviceKind::drive).values = {on_sync(0x1907)}; }},
    {"APositionThatAwaitsASync", InvariantKind::lift_serves, 1,
     [](Description& it) { node(it, DeviceKind::position).values = {on_sync(0x1906)}; }},
    {"APositionThatIsNotTold", InvariantKind::lift_serves, 1,
     [](Description& it) { node(it, DeviceKind::position).values = {no_pdo(0x1906, 0x18C)}; }},
    {"ADriveThatIsLeftOut", InvariantKind::lift_serves, 1,
     [](Description& it) {
       std::erase_if(it.nodes, [](const NodeDescription& each) {
         return each.lift == 1 && each.kind == DeviceKind::drive;
       });
     }},
    {"AScaleThatIsLeftOut", InvariantKind::no_overload, 1,
     [](Description& it) {
       std::erase_if(it.nodes, [](const NodeDescription& each) {
         return each.lift == 1 && each.kind == DeviceKind::load;
       });
       crowd_the_hall(it, heavy_kg);
     }},
    {"ALandingThatNobodyHears", InvariantKind::call_acknowledged, 0,
     [](Description& it) { mute(landing_panel(it, 3)); }},
    {"ALandingWithoutAPanel", InvariantKind::call_acknowledged, 0,
     [](Description& it) {
       std::erase_if(it.nodes, [](const NodeDescription& each) {
         return each.kind == DeviceKind::landing_panel &&
                each.floors == std::vector<FloorNumber>{3};
       });
     }},
    {"AnEntranceWhosePanelHangsElsewhere", InvariantKind::call_acknowledged, 0,
     [](Description& it) {
       for (NodeDescription& each : it.nodes) {
         if (each.kind != DeviceKind::landing_panel) continue;
         std::ranges::replace(each.floors, FloorNumber{4}, FloorNumber{5});
       }
     }},
    {"ACarThatNobodyHears", InvariantKind::call_acknowledged, 0,
     [](Description& it) { mute(node(it, DeviceKind::car_panel)); }},
    {"ACarInWhichNobodyCanSayWhereTo", InvariantKind::nobody_trapped, 1,
     [](Description& it) { mute(node(it, DeviceKind::car_panel)); }},
    {"LampsThatStayDark", InvariantKind::call_acknowledged, 0,
     [](Description& it) {
       node(it, DeviceKind::car_panel).values = {no_pdo(0x1500, virtual_output)};
     }},
    {"AFireKeyThatNobodyHears", InvariantKind::fire_recall, 1,
     [](Description& it) {
       mute(landing_panel(it, it.service.fire_floor));
       add_fault(it, {.kind = FaultKind::fire_alarm, .start = Time(1min), .duration = 6min});
     }},
    {"AnEncoderThatDiesSilently", InvariantKind::emergency_told, 1,
     [](Description& it) {
       node(it, DeviceKind::position).values = {{0x1014, 0, {0x84, 0x00, 0x00, 0x80}}};
       add_fault(it, {.kind = FaultKind::dead_encoder, .start = Time(1min), .duration = 40s});
     }},
    {"AGroupThatDoesNotComeBack", InvariantKind::service_resumed, 0,
     [](Description& it) {
       node(it, DeviceKind::group_controller).values = {{0x1017, 0, {0, 0}}};
       add_fault(it,
                 {.kind = FaultKind::lost_node, .start = Time(1min), .duration = 10s, .part = 0});
     }},
};

const Sabotage of_strangers[] = {
    {"ADoorThatIsOpenedInAMovingCar", InvariantKind::closed_while_moving, 1,
     [](Description& it) { it.building.lifts[0].has_safety_chain = false; },
     [] { return once_when(is_fast_with_people, [](Scene& it) { it.send(it.opening); }); }},
    {"ADoorThatIsUnlockedInAMovingCar", InvariantKind::chain_stops, 1, [](Description&) {},
     [] { return once_when(is_fast_with_people, [](Scene& it) { it.send(it.opening); }); }},
    {"ADriveThatIsStoppedOnItsWay", InvariantKind::acceleration, 1, [](Description&) {},
     [] {
       return once_when(is_fast_with_people, [](Scene& it) {
         it.send(Frame::data_frame(0, {0x02, node_id::drive}));
       });
     }},
    {"ADriveThatIsStoppedWithPeopleInTheCar", InvariantKind::nobody_trapped, 1, [](Description&) {},
     [] {
       return once_when(is_fast_with_people, [](Scene& it) {
         it.send(Frame::data_frame(0, {0x02, node_id::drive}));
       });
     }},
    {"ADriveThatIsStoppedForGood", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return once_when(stands_empty, [](Scene& it) {
         it.send(Frame::data_frame(0, {0x02, node_id::drive}));
       });
     }},
    {"ADoorThatIsOpenedBetweenFloors", InvariantKind::opens_at_floor, 1, [](Description&) {},
     [] {
       return [is_stopped = false, is_done = false](Scene& it) mutable {
         if (!is_stopped && is_fast_with_people(it)) {
           it.send(Frame::data_frame(0, {0x02, node_id::drive}));
           is_stopped = true;
         } else if (is_stopped && !is_done && it.car().speed_m_s == 0) {
           it.send(it.opening);
           is_done = true;
         }
       };
     }},
    {"ADriveThatDoesNotLevel", InvariantKind::levelled, 1,
     [](Description& it) {
       it.building.lifts[0].car.rope_stretch_um_per_kg = soft_ropes;
       it.service.door_dwell = 30s;
       crowd_the_hall(it, 75);
     },
     [] { return Trick([](Scene& it) { it.holds_drive = true; }); }},
    {"ALampThatGoesOutWithoutACar", InvariantKind::no_call_lost, 0, [](Description&) {},
     [] {
       return once_when(is_far_from_a_call, [](Scene& it) {
         it.send(virtual_output, cia417::encode(cia417::VirtualOutput{
                                     .function = cia417::BasicFunction::standard_car_call,
                                     .sub_function = it.car().car_calls.front(),
                                     .lifts = cia417::lift_bit(1),
                                     .doors = cia417::source_door(1)}));
       });
     }},
    {"ADoorThatOpensByItselfUnderTheFireBrigade", InvariantKind::fire_buttons, 1,
     [](Description& it) {
       add_fault(it, {.kind = FaultKind::fire_brigade, .start = Time(1min), .duration = 8min});
     },
     [] {
       return once_when(
           [](const Scene& it) { return it.network.now() > Time(90s) && it.is_fast(); },
           [](Scene& it) { it.send(it.opening); });
     }},
    {"AScaleWhoseHeartbeatSomebodyElseSends", InvariantKind::safe_stand, 1,
     [](Description& it) {
       add_fault(it, {.kind = FaultKind::lost_node,
                      .start = Time(1min),
                      .duration = 3min,
                      .node = node_id::load});
     },
     [] {
       return always_from(Time(59s), [](Scene& it) {
         it.send(Frame::data_frame(heartbeat + node_id::load, {5}));
       });
     }},
    {"AKeyThatPutsItOutOfOrder", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return once_when(stands_empty, [](Scene& it) {
         it.send(virtual_input + node_id::first_car_panel,
                 turned_key(cia417::SpecialFunction::out_of_order));
       });
     }},
    {"AFireKeyThatNobodyHasTurned", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return once_when(stands_empty, [](Scene& it) {
         it.send(virtual_input + node_id::first_landing_panel,
                 turned_key(cia417::SpecialFunction::fire_service_enable));
       });
     }},
    {"ADriveThatIsResetAgainAndAgain", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         it.send(Frame::data_frame(0, {0x81, node_id::drive}));
       });
     }},
    {"ADoorThatIsToldToOpenAgainAndAgain", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         if (it.opening.length != 0 && it.car().speed_m_s == 0) it.send(it.opening);
       });
     }},
    {"AnOverloadThatIsNone", InvariantKind::lift_serves, 1, [](Description&) {},
     [] { return always_from(Time(1min), [](Scene& it) { it.send(load_signals, 14, 1); }); }},
    {"AnInspectionThatIsFasterThanItMay", InvariantKind::inspection_speed, 1, [](Description&) {},
     [] {
       return Trick([inspects = inspection(Direction::up)](Scene& it) mutable {
         inspects(it);
         if (it.is_inspected()) it.send(drive_velocity, velocity_up, 6);
       });
     }},
    {"AnInspectionThatMovesWithoutAButton", InvariantKind::inspection_buttons, 1,
     [](Description&) {},
     [] {
       return Trick([inspects = inspection(Direction::up), is_off = false](Scene& it) mutable {
         inspects(it);
         is_off = is_off || (it.is_inspected() && it.car().speed_m_s > 0.5);
         if (!is_off) return;
         it.network.shaft(1).hold_inspection(Station::roof, Direction::none);
         it.send(drive_velocity, velocity_up, 6);
       });
     }},
    {"ACallThatIsLitInAnInspection", InvariantKind::inspection_calls, 1, [](Description&) {},
     [] {
       return Trick([inspects = inspection(Direction::none)](Scene& it) mutable {
         inspects(it);
         if (it.is_inspected()) it.send(virtual_output, lit_car_call(4));
       });
     }},
    {"ABrakeThatNobodyTests", InvariantKind::weak_brake, 1,
     [](Description& it) {
       it.building.lifts[0].has_brake_test = false;
       add_fault(it, {.kind = FaultKind::weak_brake, .start = Time(1min), .duration = 8min});
     }},
    {"ABrigadeWhoseCarDoesNotObey", InvariantKind::fire_ride, 1,
     [](Description& it) {
       add_fault(it, {.kind = FaultKind::fire_brigade, .start = Time(1min), .duration = 8min});
     },
     [] {
       return always_from(Time(2min), [](Scene& it) {
         if (it.opening.length != 0 && it.car().speed_m_s == 0) it.send(it.opening);
       });
     }},
    {"AFireServiceThatDoesNotEnd", InvariantKind::service_resumed, 1,
     [](Description& it) {
       // The only lift: no other one carries people meanwhile.
       it = standard_lift_network({.floors = 6});
       it.traffic.percent_in_5_minutes = 12;
       add_fault(it, {.kind = FaultKind::fire_brigade, .start = Time(1min), .duration = 3min});
     },
     [] {
       return always_from(Time(2min), [](Scene& it) {
         it.send(virtual_input + node_id::first_landing_panel + 1,
                 turned_key(cia417::SpecialFunction::fire_service_enable));
       });
     }},
    {"ADisplayThatNamesAnotherFloor", InvariantKind::shown_floor, 1, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         it.send(virtual_output, cia417::encode(cia417::VirtualOutput{
                                     .function = cia417::BasicFunction::position_indicator,
                                     .sub_function = 6,
                                     .lifts = cia417::lift_bit(1),
                                     .floor = cia417::all_floors,
                                     .doors = 0xF0,
                                     .data = cia417::output_data(true)}));
       });
     }},
    {"ACarPanelThatIsStopped", InvariantKind::call_acknowledged, 0, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         it.send(Frame::data_frame(0, {0x02, node_id::first_car_panel}));
       });
     }},
    {"AnErrorThatTheDriveHasNotReported", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         it.send(Frame::data_frame(0x080 + node_id::drive, {0x00, 0x54, 0x01, 0, 0, 0, 0, 0}));
       });
     }},
    {"ADoorThatIsStoppedAgainAndAgain", InvariantKind::lift_serves, 1, [](Description&) {},
     [] {
       return always_from(Time(1min), [](Scene& it) {
         it.send(Frame::data_frame(door_control, {0xFF, 0x80, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}));
       });
     }},
    {"APositionThatSomebodyElseTells", InvariantKind::lift_serves, 1,
     [](Description& it) { it.service.technician = false; },
     [] { return always_from(Time(1min), [](Scene& it) { it.send(car_position, 300'000, 4); }); }},
};

/// Of the other lift, each two minutes; the first is in all runs, the others before a release.
constexpr FaultKind faults_beside[] = {FaultKind::light_barrier, FaultKind::finger_protector,
                                       FaultKind::motion_detector};

LiftNetworkDescription busy_building(std::optional<FaultKind> beside) {
  LiftNetworkDescription made = standard_lift_network({.lifts = 2, .floors = 6});
  made.people.holds_door = 0;
  made.traffic.percent_in_5_minutes = 12;
  for (Time at(45s); beside && at < Time(20min); at += 2min) {
    made.faults.faults.push_back({.kind = *beside, .start = at, .duration = 5s, .part = 2});
  }
  return made;
}

void expect_found(const Sabotage& sabotage, std::optional<FaultKind> beside) {
  SCOPED_TRACE(beside ? fault_name(*beside) : "alone");
  LiftNetworkDescription description = busy_building(beside);
  sabotage.set(description);
  ASSERT_EQ(check(description), "");
  Scene scene(description);
  ASSERT_FALSE(scene.network.refused());
  const Trick trick = sabotage.trick();
  const auto is_found = [&] { return scene.is_broken(sabotage.breaks, sabotage.part); };
  while (scene.network.now() < Time(20min)) {
    trick(scene);
    scene.network.run_until(scene.network.now() + 100ms);
    if (scene.network.now().time_since_epoch() % 5s == 0s && is_found()) break;
  }
  EXPECT_TRUE(is_found()) << broken(scene.network);
}

class EachLiftSabotage : public testing::TestWithParam<Sabotage> {};

/// Alone in a full run only: what is found beside a fault is found without it.
TEST_P(EachLiftSabotage, IsFoundAloneAndBesideAHarmlessFault) {
  if (tries_all()) expect_found(GetParam(), std::nullopt);
  for (const FaultKind kind : faults_beside) {
    expect_found(GetParam(), kind);
    if (!tries_all()) break;
  }
}

std::string name_of(const testing::TestParamInfo<Sabotage>& it) {
  return it.param.name;
}
INSTANTIATE_TEST_SUITE_P(OfFiles, EachLiftSabotage, testing::ValuesIn(of_files), name_of);
INSTANTIATE_TEST_SUITE_P(OfStrangers, EachLiftSabotage, testing::ValuesIn(of_strangers), name_of);

/// Without a sabotage all invariants hold, and both lifts serve.
TEST(LiftSabotages, TheFaultBesideThemBreaksAndExcusesNothing) {
  LiftNetwork network(busy_building(FaultKind::light_barrier));
  network.run_until(Time(20min));
  EXPECT_EQ(broken(network), "");
  for (const Invariant& invariant : network.invariants()) {
    const bool is_of_service = invariant.kind == InvariantKind::lift_serves ||
                               invariant.kind == InvariantKind::nobody_trapped;
    if (is_of_service) {
      EXPECT_TRUE(invariant.is_decided()) << unsigned{invariant.part};
    }
  }
}

TEST(LiftSabotages, ACrowdByItselfLeavesNoCarOverloadedOrBesideItsFloor) {
  LiftNetworkDescription description = busy_building(std::nullopt);
  description.building.lifts[0].car.rope_stretch_um_per_kg = soft_ropes;
  crowd_the_hall(description, heavy_kg);
  Scene scene(description);
  scene.network.run_until(Time(10min));
  for (const LiftNumber lift : {LiftNumber{1}, LiftNumber{2}}) {
    EXPECT_FALSE(scene.is_broken(InvariantKind::no_overload, lift));
    EXPECT_FALSE(scene.is_broken(InvariantKind::levelled, lift)) << broken(scene.network);
  }
}

}  // namespace
}  // namespace canvoy::lift::lift_sabotage_table_test
