// A viewer by WebSocket: what was sent to it, and its requests.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/web/web_server.hpp"

namespace canvoy::tools {

/// What is shown at one time, the same for all viewers.
struct LiveLook {
  std::shared_ptr<const nlohmann::ordered_json> state{};   ///< without counts
  std::shared_ptr<const nlohmann::ordered_json> counts{};  ///< its members `counts` and `counted`
};

class LiveViewer : public web::LiveClient {
 public:
  using Json = nlohmann::ordered_json;

  /// `look` is the latest one, and must outlive this. `wants_values`: the default until the viewer
  /// changes it.
  LiveViewer(LiveSource& source, const LiveLook& look, bool wants_values = true);

  std::string next() override;
  bool is_behind() const override;
  void said(std::string_view message) override;

 private:
  /// Answers to be sent. Shared with the answering code, so that they may outlive the viewer.
  using Answers = std::vector<std::string>;

  void begin_anew();
  void add_state();
  void add_events();
  void add_values();
  void add_frames();
  void add(std::string_view name, std::string_view json);
  void do_request(const Json& request, const LiveSource::Done& done);
  void watch_frames(const Json& request);

  LiveSource& source_;
  const LiveLook& newest_;
  LiveLook told_;  ///< what was sent last
  std::optional<std::uint64_t> run_;
  std::uint64_t event_ = 0;
  std::uint64_t change_ = 0;
  bool wants_values_;
  std::string filter_;
  std::unique_ptr<FrameStream> frames_;
  double told_searched_ = 1;  ///< last frames_searched sent
  std::shared_ptr<Answers> answers_ = std::make_shared<Answers>();
  std::string message_;
};

}  // namespace canvoy::tools
