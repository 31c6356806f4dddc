// Runs a played network, and does at their times what people did to it: from nodes of its own,
// which have no node-ID and no entries. The same acts at the same times give the same frames.
//
//     Actor actor(network, parse_acts(texts));
//     actor.run_until(now);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "canvoy/tools/player/act.hpp"
#include "canvoy/tools/player/player.hpp"

namespace canvoy::tools {

class Actor {
 public:
  /// `acts`: in the order of their times. The network must outlive this. Throws UsageError if an
  /// act names a bus that is not there, or a way that a visitor cannot take.
  Actor(PlayedNetwork& network, std::vector<Act> acts);
  ~Actor();
  Actor(const Actor&) = delete;
  Actor& operator=(const Actor&) = delete;

  void run_until(Time until);
  /// Does it now, and keeps it. Acts that viewers added for later are dropped. Throws UsageError
  /// like the constructor.
  void act(Act act, const SdoRequests::Done& done);

  const std::vector<Act>& acts() const { return acts_; }
  /// How many of them were done.
  std::size_t done() const { return done_; }
  /// Texts of those that viewers added.
  std::vector<std::string> added() const;

 private:
  struct Desk;
  Desk& desk_of(const std::string& bus);
  BusIndex bus_of(const std::string& name) const;
  void check(const Act& act) const;
  void perform(const Act& act, const SdoRequests::Done& done);

  PlayedNetwork& network_;
  std::vector<std::string> buses_;
  std::vector<std::unique_ptr<Desk>> desks_;
  std::vector<Act> acts_;
  std::size_t done_ = 0;
};

}  // namespace canvoy::tools
