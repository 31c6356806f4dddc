// Application of the on-board computer of a bus, beside its virtual device: it starts the network,
// holds the timetable, follows the vehicle along its route, and has displays show the next stop and
// the destination. The application of a physical device (cia407::application).
//
// It senses what a real one does: pulses of the wheels and the contacts of the doors, which are
// wired to it; the journey, position and time by CAN, from identification, positioning and time
// fixing. It reports nothing that is unknown: then displays are dark, tickets are blocked, and the
// stop point is 0. After a sign of lost frames (GapWatch), the other devices send their data again,
// and the computer sends its own.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/display_server.hpp"
#include "canvoy/worlds/bus_line/journey_texts.hpp"
#include "canvoy/worlds/bus_line/line_clock.hpp"
#include "canvoy/worlds/bus_line/route_position.hpp"

namespace canvoy::bus_line {

/// What the computer senses of the vehicle.
struct LineControlHardware {
  cia407::MainOnBoardComputerUnit* computer = nullptr;  ///< of the same device
  Callback<double()> odometer = {};                     ///< m, by pulses of the wheels
  Callback<bool()> has_open_door = {};  ///< true while a contact of the doors is open
  Callback<std::optional<cia407::CivilTime>()> clock = {};  ///< own clock, which may be wrong
};

/// The network that it controls, and its timetable.
struct LineControlSettings {
  const BusLine* line = nullptr;                   ///< its timetable
  std::vector<NodeId> nodes{};                     ///< devices that it starts and watches
  std::vector<DisplayServer::Display> displays{};  ///< displays that it writes texts to
  NodeId identification = 0;                       ///< node-ID of the identification device
  Duration identification_time_out{};  ///< time after which it is lost without its heartbeat
  NodeId positioning = 0;              ///< node-ID of the device with satellites
  NodeId doors = 0;  ///< device that reports open doors, at which a request to stop ends
  /// CAN-ID of 6204h of the train bus gateway, TRUE where a passenger in another vehicle wants to
  /// get off. An on-board computer provides this object, and so has no entry to which it could be
  /// mapped.
  std::uint16_t train_stop_request_id = 0;
  NodeId train_gateway = 0;  ///< device that sends it
  NodeId diagnostics = 0;    ///< device to which the errors of the others are reported (6740h); 0:
                             ///< none
  /// Devices that send PDOs with the data of the computer.
  std::vector<NodeId> sources{};
};

class LineControl {
 public:
  static constexpr Duration node_time_out = 2500ms;  ///< of heartbeats, of all other devices
  /// Time-out of devices with a heartbeat twice as often: the identification device, and the
  /// computer itself.
  static constexpr Duration short_time_out = 1200ms;

  /// `device` must outlive this object; it acts once the node runs.
  LineControl(cia407::VirtualDevice& device, const LineControlHardware& hardware,
              LineControlSettings settings);
  ~LineControl();
  LineControl(const LineControl&) = delete;
  LineControl& operator=(const LineControl&) = delete;

  /// Local time for the virtual device: by satellites, or of its own clock where those are not
  /// heard.
  std::optional<cia407::CivilTime> local_time() const;
  /// Presses the stop button. False: the computer is not in service.
  bool press_stop_button();

 private:
  static const AccessHandlers hook_calls[];

  Node& node() { return device_.node(); }
  const BusRoute& route() const { return settings_.line->routes[journey_->route]; }
  const BusLine& line() const { return *settings_.line; }

  void reset(ResetScope scope);
  void begin();
  void look(Time now);
  void changed(NodeId id, RemoteState state);
  void start_waiting();
  void start(NodeId id);
  void refresh();
  void report_again(NodeId id);
  void heard(NodeId id, RemoteState state) { gaps_.heard(id, state); }
  void ask_anew(NodeId id);
  void forget_all();
  void watch_doors(Time now);
  void train_told(const Frame& frame, Time now);
  void hear_errors();
  void error_told(const Frame& frame, Time now);

  void take_journey();
  void interrupt_journey();
  void lose_journey();
  void take_fix();
  void take_time();
  void locate();

  bool knows_stop() const { return journey_ != nullptr && position_.knows_stop(); }
  JourneyTexts texts() const;
  void tell();
  void report_position();
  void sets_learnt() { told_.reset(); }
  void keep_texts();

  cia407::VirtualDevice& device_;
  LineControlHardware hardware_;
  LineControlSettings settings_;
  std::unique_ptr<std::array<NmtMaster::RemoteNode, node_id_max>> remotes_;
  NmtMaster master_;
  std::array<GapWatch::Rhythm, node_id_max> rhythms_;
  GapWatch gaps_;
  DisplayServer displays_;
  Timer timer_;
  bool has_begun_ = false;
  Time next_start_{};
  std::array<bool, node_id_max + 1> is_started_{};
  Time refresh_at_ = never;  ///< time at which all is sent again

  const Journey* journey_ = nullptr;  ///< null: none is known
  /// The journey of an identification device that is away: the computer follows its route, and
  /// reports nothing. Null: none.
  const Journey* interrupted_ = nullptr;
  bool has_journey_told_ = false;  ///< a message has reported the journey, or that there is none
  RoutePosition position_;
  std::array<bool, node_id_max + 1> was_operational_{};  ///< since the computer has booted
  bool has_returned_ = false;  ///< a device was operational, and left that state since all was sent
  bool had_open_door_ = false;
  Time opened_at_ = never;  ///< since then a door has opened, and no request was ended
  LineClock clock_;

  struct Told {
    const Journey* journey = nullptr;
    bool knows_stop = false;
    bool has_reached_stop = false;
    std::size_t place = 0;
    std::size_t reached = 0;

    friend bool operator==(const Told&, const Told&) = default;
  };
  std::optional<Told> told_;
  RouteStop told_stop_;  ///< the zone and segment of this stop were sent

  std::array<std::uint16_t, node_id_max + 1> errors_{};  ///< the last error of each; 0: none
  std::optional<bool> train_wants_stop_;  ///< empty: not received since its sender has booted
};

/// A BusUnit of the computer beside its virtual device; it is not in the catalogue.
struct LineControlKind : cia407::BusKind<LineControl, LineControlHardware, LineControlSettings> {
  static constexpr DeviceInfo info = {.name = "line-control", .title = "line logic of a bus"};
  static constexpr const VirtualDeviceInfo& provides = cia407::application;
  /// Error control and emergencies of all other nodes, and the request of the train.
  static constexpr std::size_t routes = 2 * std::size_t{node_id_max} + 1;
};

}  // namespace canvoy::bus_line
