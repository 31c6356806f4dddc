// Actions of viewers on the nodes of a network: SDO reads and writes, and NMT commands. Used for
// worlds and real buses.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/tools/page/recorder.hpp"
#include "canvoy/tools/page/sdo_requests.hpp"
#include "canvoy/tools/page/write_permission.hpp"

namespace canvoy::tools {

/// A frame or a request for a bus.
struct BusRequest {
  enum class Kind : std::uint8_t { read, write, nmt } kind = Kind::read;
  std::string bus;
  NodeId node = 0;  ///< for NMT, 0: all nodes
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  SdoRequests::Bytes bytes{};  ///< the value to write, or the command
};

class LiveNetwork : public LiveSource {
 public:
  LiveNetwork(const FramePrinterOptions& options, WritePermission permission)
      : LiveSource(options), permission_(std::move(permission)) {}

  void act(std::string_view what, const Json& arguments, const Done& done) override;
  /// Like Recorder::allow().
  void allow_recording(const std::string& folder) { recorder_.allow(folder); }

 protected:
  /// Sends the request on its bus. `done` may be empty. Throws Failure if this is not possible.
  virtual void request(const BusRequest& request, const SdoRequests::Done& done) = 0;
  const WritePermission& permission() const { return permission_; }
  Recorder& recorder() { return recorder_; }
  /// Wall clock at Time{}, for logs; 0 for the time of a run.
  virtual Duration epoch() const { return Duration::zero(); }

 private:
  ObjectAddress address_of(std::string_view bus, NodeId node, std::string_view text);
  void read(const Json& arguments, const Done& done);
  void write(const Json& arguments, const Done& done);
  void command(const Json& arguments, const Done& done);

  WritePermission permission_;
  Recorder recorder_;
};

/// A text member of a request that was checked.
std::string text_of(const nlohmann::ordered_json& arguments, const char* name);

}  // namespace canvoy::tools
