#include "canvoy/sim/bus/display_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

/// As the display has it: without blanks at its end.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

DisplayWatch::DisplayWatch(BusNodes& nodes, const BusLine& line, const BusDisplays& displays,
                           const BusVehicle& vehicle, BusReferee& referee,
                           EventLog<NetworkEvent>& events)
    : nodes_(nodes),
      line_(line),
      displays_(displays),
      vehicle_(vehicle),
      referee_(referee),
      events_(events) {
  for (const BusRoute& route : line.routes) {
    whole_texts_.push_back(latin_1_as_utf_8(trimmed(to_latin_1(route_text(line, route)))));
  }
}

void DisplayWatch::displays_changed() {
  has_news_ = true;
  const Time now = nodes_.world().now();
  for (const NodeId id : display_ids) {
    const ShownDisplay* display = displays_.find(id);
    if (display == nullptr || display->text() == told_texts_.at(id)) continue;
    const std::string& text = display->text();
    told_texts_.at(id) = text;
    events_.note(now, DisplayShows{id, text});
    if (!text.empty()) ++texts_;
    if (id == information_id) {
      referee_.judge_one(InvariantKind::texts, now, is_whole_text(text));
    }
  }
}

void DisplayWatch::judge(Time now) {
  if (std::exchange(has_news_, false)) {
    has_lie_ = std::ranges::any_of(display_ids, [this](NodeId id) { return lies(id); });
  }
  referee_.judge(InvariantKind::next_stop, now, is_lit(next_stop_id));
  referee_.judge(InvariantKind::destination, now,
                 is_lit(front_display_id) && is_lit(side_display_id));
  referee_.judge(InvariantKind::information, now, is_lit(information_id));
  referee_.judge(InvariantKind::second_car, now,
                 is_lit(second_destination_id) && is_lit(second_next_stop_id));
  referee_.judge_honesty(now, !has_lie_);
}

bool DisplayWatch::is_lit(NodeId id) const {
  return !nodes_.is_played(id) || !displays_.at(id).text().empty();
}

/// What it shows comes from devices that are played.
bool DisplayWatch::is_led_by_us(NodeId id) const {
  return car_of(id) == 1 ||
         (nodes_.is_played(second_gateway_id) && nodes_.is_played(train_gateway_id));
}

bool DisplayWatch::lies(NodeId id) const {
  const std::string& text = displays_.at(id).text();
  const bool is_mangled = id == information_id && !is_whole_text(text);
  return is_led_by_us(id) && !text.empty() && !is_mangled && text != expected_text(id);
}

std::string DisplayWatch::expected_text(NodeId id) const {
  const BusTruth truth = vehicle_.truth();
  if (id == next_stop_id || id == second_next_stop_id) {
    return latin_1_as_utf_8(trimmed(to_latin_1(truth.stop->name)));
  }
  if (id == information_id) {
    return whole_texts_[static_cast<std::size_t>(truth.route - line_.routes.data())];
  }
  return trimmed(to_ascii(line_.name)) + "\n" + trimmed(to_ascii(truth.route->destination));
}

bool DisplayWatch::is_whole_text(const std::string& text) const {
  return text.empty() || std::ranges::find(whole_texts_, text) != whole_texts_.end();
}

}  // namespace canvoy::bus
