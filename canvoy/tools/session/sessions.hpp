// The buses of verbs: each is opened by the first verb that uses it, and stays open for later
// verbs, as in a script.
//
//     Session& session = sessions.open("can0", {});
#pragma once

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

class Sessions {
 public:
  /// Throws like the Session. The time-out is that of this verb.
  Session& open(const std::string& bus, AnswerTime time_out) {
    if (bus.find(',') != std::string::npos) {
      throw UsageError(
          fmt::format("{}: one bus at a time; only monitor, wait and script take several", bus));
    }
    std::unique_ptr<Session>& session = sessions_[bus];
    if (session == nullptr) session = std::make_unique<Session>(bus, time_out);
    session->set_time_out(time_out);
    session->choose(SdoTransfer::segmented);
    return *session;
  }

 private:
  std::map<std::string, std::unique_ptr<Session>> sessions_;
};

}  // namespace canvoy::tools
