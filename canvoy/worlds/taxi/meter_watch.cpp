#include "canvoy/worlds/taxi/meter_watch.hpp"

namespace canvoy::taxi {

namespace {

/// A display that has power and is dark for longer is defective.
constexpr Duration shown_within = 3s;

bool has_passengers(const cia447::TaximeterDisplay& display) {
  return display.state == cia447::Taximeter::hired || display.state == cia447::Taximeter::stopped;
}
bool is_lit(const cia447::TaximeterDisplay& display) {
  return display.state != cia447::Taximeter::not_available;
}

}  // namespace

/// After two losses without a display between them, the result of the first one is unknown.
void MeterWatch::power_changes(Time now, bool is_on) {
  if (is_on) {
    back_at_ = now;
    is_dark_ = false;
    return;
  }
  is_awaited_ = has_passengers(last_) && !is_awaited_;
  before_ = last_;
  lost_at_ = now;
  is_dark_ = true;
}

std::optional<double> MeterWatch::look(Time now, const cia447::TaximeterDisplay& display) {
  if (is_dark_) return std::nullopt;
  if (is_awaited_) judge_return(now, display);
  if (!is_lit(display)) return std::nullopt;
  last_ = display;
  const bool had_trip = has_trip_;
  has_trip_ = has_passengers(display);
  if (!had_trip || has_trip_) return std::nullopt;
  return display.trip.total;
}

void MeterWatch::judge_return(Time now, const cia447::TaximeterDisplay& display) {
  const bool is_late = now - back_at_ > shown_within;
  if (!is_lit(display) && !is_late) return;
  is_awaited_ = false;
  ++cuts_;
  if (!is_lit(display) || !is_defined(display)) ++wrong_ends_;
}

bool MeterWatch::is_defined(const cia447::TaximeterDisplay& display) const {
  const Duration cut = back_at_ - lost_at_;
  const bool goes_on = display.state == before_.state;
  const bool has_ended = display.state == cia447::Taximeter::for_hire;
  const bool is_long = cut > longest_cut_ + clock_step;
  if (is_long ? !has_ended : !(goes_on || (has_ended && may_end_trip(cut)))) return false;
  const cia447::TripData& had = before_.trip;
  const cia447::TripData& has = display.trip;
  return has.total != cia447::TripData::unknown && has.total >= had.total &&
         has.supplements == had.supplements && has.distance >= had.distance &&
         has.start == had.start;
}

}  // namespace canvoy::taxi
