// What people may do with the nodes of a network that can be asked: read and write objects by SDO,
// and NMT commands. Of a world and of a real bus it is the same.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/live/live_source.hpp"
#include "canvoy/tools/live/recorder.hpp"
#include "canvoy/tools/live/sdo_desk.hpp"
#include "canvoy/tools/live/write_permission.hpp"

namespace canvoy::tools {

/// A frame, or a request, on its way to a bus.
struct BusRequest {
  enum class Kind : std::uint8_t { read, write, nmt } kind = Kind::read;
  std::string bus;
  NodeId node = 0;  ///< of NMT 0: all
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  SdoDesk::Bytes bytes{};  ///< to be written, or the command
};

class LiveNetwork : public LiveSource {
 public:
  LiveNetwork(const FramePrinterOptions& options, WritePermission permission)
      : LiveSource(options), permission_(std::move(permission)) {}

  void act(std::string_view what, const Json& arguments, const Done& done) override;
  /// As Recorder::allow() takes it.
  void allow_recording(const std::string& folder) { recorder_.allow(folder); }

 protected:
  /// Puts it on its bus. `done` may be empty. Throws Failure where it cannot be.
  virtual void request(const BusRequest& request, const SdoDesk::Done& done) = 0;
  const WritePermission& permission() const { return permission_; }
  Recorder& recorder() { return recorder_; }
  /// The wall clock at Time{}, for logs; 0 where it is the time of a run.
  virtual Duration epoch() const { return Duration::zero(); }

 private:
  ObjectAddress address_of(std::string_view bus, NodeId node, std::string_view text);
  void read(const Json& arguments, const Done& done);
  void write(const Json& arguments, const Done& done);
  void command(const Json& arguments, const Done& done);

  WritePermission permission_;
  Recorder recorder_;
};

/// A text of a request that was checked.
std::string text_of(const nlohmann::ordered_json& arguments, const char* name);

}  // namespace canvoy::tools
