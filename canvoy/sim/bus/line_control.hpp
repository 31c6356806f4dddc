// What the on-board computer of a bus does beside its virtual device: it starts the network, knows
// the timetable, follows the vehicle along its route, and has displays show the next stop and the
// destination. The application of a physical device (cia407::application).
//
// It senses what a real one does: pulses of the wheels and the contacts of the doors, which are
// wired to it; the journey, position and time by CAN, from identification, positioning and time
// fixing. What it does not know it does not say: then displays are dark, tickets are blocked, and
// the stop point is 0. After a sign of lost frames (GapWatch) those who know something tell it
// again, and the computer tells its own.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/bus_kind.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/gap_watch.hpp"
#include "canvoy/sim/bus/bus_line.hpp"
#include "canvoy/sim/bus/display_server.hpp"
#include "canvoy/sim/bus/journey_texts.hpp"
#include "canvoy/sim/bus/line_clock.hpp"
#include "canvoy/sim/bus/route_position.hpp"

namespace canvoy::bus {

struct LineControlHardware {
  cia407::MainOnBoardComputerUnit* computer = nullptr;      ///< of the same device
  Callback<double()> odometer = {};                         ///< m, by pulses of the wheels
  Callback<bool()> has_open_door = {};                      ///< the contacts of the doors
  Callback<std::optional<cia407::CivilTime>()> clock = {};  ///< its own, local time
};

struct LineControlSettings {
  const BusLine* line = nullptr;  ///< its timetable
  std::vector<NodeId> nodes{};    ///< that it starts and watches
  std::vector<DisplayServer::Display> displays{};
  NodeId identification = 0;
  Duration identification_time_out{};  ///< without its heartbeat
  NodeId positioning = 0;
  NodeId doors = 0;  ///< who tells that a door opens: a request to stop ends with that
  /// Of 6204h of the train bus gateway, TRUE where somebody in another vehicle wants to get off: an
  /// on-board computer provides this object, and so has no entry to which it could be mapped.
  std::uint16_t train_stop_request_id = 0;
  NodeId train_gateway = 0;  ///< who tells it
  /// Who tells by PDOs what the computer has to know.
  std::vector<NodeId> sources{};
};

class LineControl {
 public:
  static constexpr Duration node_time_out = 2500ms;
  /// Of who has a heartbeat twice as often: the identification device, and the computer itself.
  static constexpr Duration short_time_out = 1200ms;

  LineControl(cia407::VirtualDevice& device, const LineControlHardware& hardware,
              LineControlSettings settings);
  ~LineControl();
  LineControl(const LineControl&) = delete;
  LineControl& operator=(const LineControl&) = delete;

  /// Local time, for the virtual device: by satellites, or of its own clock where that is not
  /// heard.
  std::optional<cia407::CivilTime> local_time() const;
  /// A passenger has pressed a button. False: it is not in service.
  bool press_stop_button();

 private:
  static const HookCalls hook_calls[];

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
  void tell_again(NodeId id);
  void heard(NodeId id, RemoteState state) { gaps_.heard(id, state); }
  void ask_anew(NodeId id);
  void forget_all();
  void watch_doors(Time now);
  void train_told(const Frame& frame, Time now);

  void take_journey();
  void lose_journey();
  void take_fix();
  void take_time();
  void locate();

  JourneyTexts texts() const;
  void tell();
  void tell_position();
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
  Time refresh_at_ = never;  ///< when all is told again

  const Journey* journey_ = nullptr;  ///< null: none is told
  bool has_journey_told_ = false;     ///< were it that none is driven
  RoutePosition position_;
  std::array<bool, node_id_max + 1> was_operational_{};  ///< since it began
  bool has_returned_ = false;  ///< one that was, and left operational since all was told
  bool had_open_door_ = false;
  Time opened_at_ = never;  ///< a door, and a request was not ended since
  LineClock clock_;

  struct Told {
    const Journey* journey = nullptr;
    bool knows_stop = false;
    bool is_located = false;
    std::size_t place = 0;
    std::size_t reached = 0;

    friend bool operator==(const Told&, const Told&) = default;
  };
  std::optional<Told> told_;
  RouteStop told_stop_;  ///< of which zone and segment are told

  std::optional<bool> train_wants_stop_;  ///< nothing: not told since the begin of who tells it
};

struct LineControlKind : cia407::BusKind<LineControl, LineControlHardware, LineControlSettings> {
  static constexpr DeviceInfo info = {.name = "line-control", .title = "line logic of a bus"};
  static constexpr const VirtualDeviceInfo& provides = cia407::application;
  /// Error control of all others, and the request of the train.
  static constexpr std::size_t routes = node_id_max + 1;
};

}  // namespace canvoy::bus
