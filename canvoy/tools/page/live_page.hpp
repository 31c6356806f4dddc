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
#include "canvoy/web/web_server.hpp"

namespace canvoy::tools {

class LivePage : public web::WebApplication {
 public:
  using Json = nlohmann::ordered_json;

  explicit LivePage(LiveSource& source);

  /// Takes the present state of the source for the viewers.
  void look();

  std::string methods(std::string_view path) const override;
  void answer(const web::WebRequest& request, Answer done) override;
  std::unique_ptr<web::LiveClient> connect(const web::RequestTarget& target) override;

 private:
  web::WebResponse told(const ApiRoute& route, const Json& arguments);
  Json networks() const;
  std::string events_since(std::uint64_t since) const;
  std::string log_text() const;

  LiveSource& source_;
  std::shared_ptr<const Json> state_;
};

}  // namespace canvoy::tools
