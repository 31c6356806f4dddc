// The page of a live source: what viewers get and may request by WebSocket and by HTTP. docs/web.md
// describes both.
//
//     LivePage page(source);
//     auto server = WebServer::create(loop, options, page);
//     page.look();  // whenever the source has gone on
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "canvoy/tools/page/api_routes.hpp"
#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/tools/page/live_viewer.hpp"
#include "canvoy/web/web_server.hpp"

namespace canvoy::tools {

class LivePage : public web::WebApplication {
 public:
  using Json = nlohmann::ordered_json;

  explicit LivePage(LiveSource& source);

  /// Takes the present state of the source for the viewers; at each tenth call its counts as well,
  /// which change with each frame, with the time at which they were taken.
  void look();

  std::string methods(std::string_view path) const override;
  void answer(const web::WebRequest& request, Answer done) override;
  std::unique_ptr<web::LiveClient> connect(const web::RequestTarget& target) override;

 private:
  web::WebResponse told(const ApiRoute& route, const Json& arguments);
  Json counts_at(const Json& time) const;
  Json whole_state();
  Json networks() const;
  std::string events_since(std::uint64_t since) const;
  std::string log_text() const;

  LiveSource& source_;
  LiveLook look_;
  std::uint64_t looks_ = 0;
  std::uint64_t counted_run_ = 0;  ///< run of the counts
};

}  // namespace canvoy::tools
