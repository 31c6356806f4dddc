// The announcers of a bus with their loudspeakers, one in each car: what passengers hear, and
// whether each stop is announced there, and no other one.
//
//     Announcements announcements(nodes, options, truth, referee, events);
//     announcements.stop_comes(now, truth.current().stop_point);
//     announcements.step(now);
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"

namespace canvoy::bus_line {

class Announcements {
 public:
  /// All must outlive this object.
  Announcements(BusNodes& nodes, const BusNetworkOptions& options, const TrueHistory& truth,
                BusReferee& referee, EventLog<NetworkEvent>& events)
      : nodes_(nodes), options_(options), truth_(truth), referee_(referee), events_(events) {}
  Announcements(const Announcements&) = delete;
  Announcements& operator=(const Announcements&) = delete;

  /// Puts the announcer of a car on the bus.
  void add_car(unsigned car);
  /// Call it when this stop becomes the next one.
  void stop_comes(Time now, std::uint32_t stop_point);
  /// Judges what was not announced in time.
  void step(Time now);
  /// Number of announcements heard in the first car.
  std::size_t heard() const { return heard_; }

 private:
  /// Loudspeakers of a car.
  class Speakers {
   public:
    /// `all` must outlive them.
    Speakers(Announcements& all, unsigned car) : all_(all), car_(car) {}
    cia407::AcousticAnnouncerHardware hardware();

   private:
    bool say(std::uint32_t stop_point, std::string_view /*text*/) {
      return all_.say(car_, stop_point);
    }

    Announcements& all_;
    unsigned car_;
  };

  bool say(unsigned car, std::uint32_t stop_point);

  BusNodes& nodes_;
  const BusNetworkOptions& options_;
  const TrueHistory& truth_;
  BusReferee& referee_;
  EventLog<NetworkEvent>& events_;
  std::deque<Speakers> speakers_;
  std::array<std::optional<std::uint32_t>, cars_max> expected_;  ///< in each car
  Time expected_since_{};
  std::size_t heard_ = 0;
};

}  // namespace canvoy::bus_line
