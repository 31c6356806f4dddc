// Actions of viewers on the nodes of a network: SDO reads and writes, and NMT commands. Used for
// worlds and real buses.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/tools/page/recorder.hpp"
#include "canvoy/tools/page/write_permission.hpp"
#include "canvoy/tools/player/act.hpp"

namespace canvoy::tools {

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
