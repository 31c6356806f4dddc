// Untrusted input of the server of the page: as the target of a request it is refused or split, as
// a message of a WebSocket it is answered with one line, or performed.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "canvoy/tools/page/api_routes.hpp"
#include "canvoy/tools/page/live_network.hpp"
#include "canvoy/tools/page/live_viewer.hpp"
#include "canvoy/tools/page/refusal.hpp"
#include "canvoy/tools/page/write_permission.hpp"
#include "canvoy/web/access.hpp"
#include "canvoy/web/request_target.hpp"

namespace {

using namespace canvoy;

/// Nodes of all profiles that do not answer.
class Network : public tools::LiveNetwork {
 public:
  Network()
      : LiveNetwork({.nodes = {"1=417", "2=418", "3=419", "4=447-3", "5=407", "6=852"}},
                    tools::parse_write_permission("all")) {
    feed_.add(Duration{}, "can0", Frame::data_frame(0x701, {0x05}));
  }
  Json description() override { return {{"kind", "bus"}}; }
  void advance(Time) override {}
  Json state() override { return {{"time", 0}}; }
  int finish() override { return 0; }

 protected:
  void request(const tools::BusRequest& request, const tools::SdoRequests::Done& done) override {
    if (request.node > node_id_max || request.bytes.size() > 64 * 1024) std::abort();
    if (done) done({.end = SdoEnd::no_answer()});
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto target = web::parse_target(text)) {
    if (!target->path.starts_with('/')) std::abort();
    if (target->path.find("/../") != std::string::npos) std::abort();
    const tools::ApiMatch match = tools::find_route("POST", target->path);
    try {
      if (match.route != nullptr)
        static_cast<void>(tools::arguments_of(match, target->query, text));
    } catch (const tools::NotAsDescribed&) {
    }
  }
  if (web::cookie_of(text, "a").size() > size) std::abort();
  static Network network;
  static const auto state = std::make_shared<const nlohmann::ordered_json>(network.state());
  static const tools::LiveLook look{.state = state, .counts = state};
  tools::LiveViewer viewer(network, look);
  viewer.said(text);
  const std::string told = viewer.next();
  if (!nlohmann::json::accept(told)) std::abort();
  return 0;
}
