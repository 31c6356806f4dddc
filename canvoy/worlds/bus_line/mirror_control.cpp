#include "canvoy/worlds/bus_line/mirror_control.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::bus_line {

namespace {

constexpr Duration mirror_period = 50ms;
constexpr Duration mirror_start_period = 1s;
constexpr Duration mirror_refresh = 200ms;
constexpr Duration mirror_time_out = 2500ms;
/// Longer than the time between two texts of the on-board computer.
constexpr Duration mirror_settle = 150ms;
constexpr std::uint16_t first_told = 0x6100;
constexpr std::uint16_t last_told = 0x67FF;
constexpr std::uint16_t iso_8859_1 = 1;

}  // namespace

constexpr AccessHandlers MirrorControl::hook_calls[] = {
    cia407::after_any_write<&MirrorControl::written>};

MirrorControl::MirrorControl(cia407::VirtualDevice& device, const MirrorControlHardware& hardware,
                             MirrorControlSettings settings)
    : device_(device),
      hardware_(hardware),
      settings_(std::move(settings)),
      remotes_(std::make_unique<std::array<NmtMaster::RemoteNode, node_id_max>>()),
      master_(device.node(), *remotes_),
      gaps_(device.node(), callback<&MirrorControl::ask_anew>(*this), rhythms_),
      texts_(device.node()),
      displays_(device.node(), master_, texts_),
      timer_(callback<&MirrorControl::look>(*this)) {
  for (const DisplayServer::Display& display : settings_.displays) displays_.add(display);
  device.on_reset = callback<&MirrorControl::reset>(*this);
  device.react(*this, hook_calls);
  master_.on_message(callback<&MirrorControl::heard>(*this));
  master_.on_change(callback<&MirrorControl::changed>(*this));
  for (const NodeId id : settings_.nodes) master_.set_time_out(id, mirror_time_out);
}

/// Destroys the timers of the watched nodes before other units of its device, which still remove
/// theirs from the queue.
MirrorControl::~MirrorControl() {
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    master_.set_time_out(id, Duration::zero());
  }
  node().timers().disarm(timer_);
}

void MirrorControl::reset(ResetScope) {
  has_begun_ = false;
  has_news_ = true;
  refresh_at_ = never;
  displays_.forget_all();
  node().timers().arm(timer_, node().now());
}

/// The state of the other devices is unknown: they go dark, and start from the beginning.
void MirrorControl::begin() {
  master_.command(NmtMaster::all_nodes, NmtCommand::enter_pre_operational);
  master_.command(NmtMaster::all_nodes, NmtCommand::start);
  is_started_.fill(true);
  displays_.forget_all();
  has_begun_ = true;
}

void MirrorControl::look(Time now) {
  node().timers().arm(timer_, now + mirror_period);
  if (!has_begun_ || node().state() != NmtState::operational) begin();
  const bool is_coupled = hardware_.is_coupled && hardware_.is_coupled();
  if (std::exchange(was_coupled_, is_coupled) && !is_coupled) forget_train();
  if (now >= next_start_) start_waiting(now);
  if (now >= refresh_at_) {
    refresh_at_ = never;
    report_again();
  }
  if (is_settling_ && now >= settled_at_) {
    is_settling_ = false;
    has_news_ = true;
  }
  if (std::exchange(has_news_, false)) {
    displays_.want([this](DisplayUse use, CharacterSets) { return view_of(use); });
  }
  displays_.serve();
}

void MirrorControl::written(const Entry& entry) {
  has_news_ = true;
  const std::uint32_t journey = device_[cia407::journey_number].raw();
  const bool is_other = std::exchange(journey_, journey) != journey;
  is_settling_ = is_settling_ || is_other;
  const bool is_text = entry.index == cia407::text_of_stop_point_object.index;
  if (is_other || (is_settling_ && is_text)) settled_at_ = node().now() + mirror_settle;
}

/// Earlier messages of the train may be wrong.
void MirrorControl::forget_train() {
  node().dictionary().restore_defaults(first_told, last_told, node().id());
  has_news_ = true;
  report_again();
}

/// A device that enters operational again sends all its data (8.1.4.3).
void MirrorControl::report_again() {
  master_.command(node().id(), NmtCommand::enter_pre_operational);
  master_.command(node().id(), NmtCommand::start);
}

void MirrorControl::start_waiting(Time now) {
  next_start_ = now + mirror_start_period;
  for (const NodeId id : settings_.nodes) {
    const RemoteState state = master_.remote(id).state();
    const bool waits = state == RemoteState::boot_up || state == RemoteState::pre_operational ||
                       state == RemoteState::stopped;
    if (waits) start(id);
  }
}

void MirrorControl::start(NodeId id) {
  is_started_.at(id) = master_.command(id, NmtCommand::start);
  refresh_at_ = node().now() + mirror_refresh;
}

/// A node that has left operational, or returns, has lost its data.
void MirrorControl::changed(NodeId id, RemoteState state) {
  const bool is_ours = std::ranges::find(settings_.nodes, id) != settings_.nodes.end();
  const bool begins_anew = state != RemoteState::operational || !is_started_.at(id);
  if (!is_ours || !has_begun_ || !begins_anew) return;
  displays_.forget(id);
  if (state == RemoteState::lost) {
    is_started_.at(id) = false;
    return;
  }
  if (state == RemoteState::operational) master_.command(id, NmtCommand::enter_pre_operational);
  start(id);
}

std::vector<std::uint8_t> MirrorControl::text(std::uint16_t index, std::uint8_t sub) {
  const Result<Entry> entry = node().dictionary().find(index, sub);
  if (!entry) return {};
  const std::span<const std::uint8_t> octets = entry->bytes();
  const bool is_blank = std::ranges::all_of(octets, [](std::uint8_t one) { return one == ' '; });
  return is_blank ? std::vector<std::uint8_t>()
                  : std::vector<std::uint8_t>(octets.begin(), octets.end());
}

DisplayView MirrorControl::view_of(DisplayUse use) {
  DisplayView view;
  const auto show = [&](std::uint16_t index, std::uint8_t from, std::uint8_t to) {
    std::vector<std::uint8_t> octets = text(index, from);
    if (!octets.empty()) view.shown.push_back({index, to, 0, std::move(octets)});
  };
  if (use == DisplayUse::destination) {
    show(cia407::text_line_route_description_object.index, 1, 1);
    show(cia407::text_of_destination_object.index, 1, 1);
    return view;
  }
  view.character_set = iso_8859_1;
  const std::uint32_t running = device_[cia407::number_of_running_in_route_representation].raw();
  if (is_settling_ || device_[cia407::stop_point_id].raw() == 0 || running == 0) return view;
  const std::uint8_t sub = stop_text_sub(running - 1);
  show(cia407::text_of_stop_point_object.index, sub, sub);
  return view;
}

}  // namespace canvoy::bus_line
