#include "canvoy/worlds/charger/connection_watch.hpp"

namespace canvoy::charger {

namespace {

bool is_given(const SdoConnection& connection) {
  return connection.state == SdoConnection::State::given;
}

}  // namespace

void ConnectionWatch::look(Time now, std::span<const SdoConnection> present) {
  for (std::size_t i = 0; i < present.size(); ++i) {
    const SdoConnection& is = present[i];
    SdoConnection& was = told_.at(i);
    const bool same = is.client == was.client && is.server == was.server;
    if (is_given(was) && !(is_given(is) && same)) {
      events_->push_back({now, SdoConnectionChanged{was.client, was.server, false}});
    }
    if (is_given(is) && !(is_given(was) && same)) {
      events_->push_back({now, SdoConnectionChanged{is.client, is.server, true}});
    }
    was = is;
  }
}

}  // namespace canvoy::charger
