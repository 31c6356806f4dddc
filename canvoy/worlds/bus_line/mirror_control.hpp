// Application of the gateway of a second car, beside its virtual device: it starts the devices of
// its segment, and has the displays there show what the first car sends over the train bus: line,
// destination and next stop. The application of a physical device (cia407::application).
//
// It has no timetable: texts come from the first car (610Ch, 610Dh, 6112h), and the next stop by
// its number in the route (610Ah). While texts of another journey arrive, no stop is shown. Where
// the train bus is silent, or the first car has no data, all is dark and the stop point is 0. After
// a sign of lost frames (GapWatch), all is sent again.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/worlds/bus_line/display_server.hpp"

namespace canvoy::bus_line {

/// What the gateway knows of the train bus.
struct MirrorControlHardware {
  /// true while the first car is heard on the train bus
  Callback<bool()> is_coupled = {};
};

/// The segment that it controls.
struct MirrorControlSettings {
  std::vector<NodeId> nodes{};                     ///< devices that it starts and watches
  std::vector<DisplayServer::Display> displays{};  ///< displays that it writes texts to
};

class MirrorControl {
 public:
  /// `device` must outlive this object; it acts once the node runs.
  MirrorControl(cia407::VirtualDevice& device, const MirrorControlHardware& hardware,
                MirrorControlSettings settings);
  ~MirrorControl();
  MirrorControl(const MirrorControl&) = delete;
  MirrorControl& operator=(const MirrorControl&) = delete;

 private:
  static const AccessHandlers hook_calls[];

  Node& node() { return device_.node(); }
  void reset(ResetScope scope);
  void begin();
  void look(Time now);
  void changed(NodeId id, RemoteState state);
  void start_waiting(Time now);
  void start(NodeId id);
  void written(const Entry& entry);
  void report_again();
  void heard(NodeId id, RemoteState state) { gaps_.heard(id, state); }
  void ask_anew(NodeId /*id*/) {
    if (has_begun_) report_again();
  }
  void forget_train();
  std::vector<std::uint8_t> text(std::uint16_t index, std::uint8_t sub);
  DisplayView view_of(DisplayUse use);

  cia407::VirtualDevice& device_;
  MirrorControlHardware hardware_;
  MirrorControlSettings settings_;
  std::unique_ptr<std::array<NmtMaster::RemoteNode, node_id_max>> remotes_;
  NmtMaster master_;
  std::array<GapWatch::Rhythm, node_id_max> rhythms_;
  GapWatch gaps_;
  cia407::TextSender texts_;
  DisplayServer displays_;
  Timer timer_;
  bool has_begun_ = false;
  bool was_coupled_ = false;
  Time next_start_{};
  Time refresh_at_ = never;  ///< time at which all is sent again
  std::array<bool, node_id_max + 1> is_started_{};
  bool has_news_ = true;
  std::uint32_t journey_ = 0;
  bool is_settling_ = false;  ///< another journey has begun, and some of its texts are still to
                              ///< come
  Time settled_at_{};
};

/// A BusUnit of the gateway beside its virtual device; it is not in the catalogue.
struct MirrorControlKind
    : cia407::BusKind<MirrorControl, MirrorControlHardware, MirrorControlSettings> {
  static constexpr DeviceInfo info = {.name = "mirror-control", .title = "logic of a second car"};
  static constexpr const VirtualDeviceInfo& provides = cia407::application;
  /// Error control of all other nodes, and SDO clients for texts.
  static constexpr std::size_t routes = node_id_max + cia407::TextSender::servers_max;
};

}  // namespace canvoy::bus_line
