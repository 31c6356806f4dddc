// Text of SDO messages (CiA 301, 7.2.4).
//
//     SdoWords words;
//     const decoder::SdoStep step = follower.request(frame);
//     words.append(text, step.message, frame, network, 10);  // "read 6010h:00h temperature"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/decoder/entry_cache.hpp"
#include "canvoy/profiles/model/description.hpp"
#include "canvoy/text/value_words.hpp"

namespace canvoy::text {

class SdoWords {
 public:
  /// Appends the text of a frame of eight bytes, with the profile and the units of the server. A
  /// device behind the server is unknown.
  void append(std::string& text, decoder::SdoMessage message, const Frame& frame,
              decoder::Network& network, NodeId server, decoder::SdoBehind behind = {});
  /// Appends the text of a completed transfer: `read 6010h:00h temperature = 20.000 °C`.
  void append_transfer(std::string& text, const decoder::SdoTransfer& transfer,
                       const decoder::DecodedValue& value);

 private:
  /// Size of the cache by hash: a lookup of a name takes longer than writing it.
  static constexpr std::size_t objects_max = 1024;
  struct Object {
    const EntryInfo* entry = nullptr;  ///< null: not in the profile
    std::string text;                  ///< `6010h:00h temperature`
  };

  const Object& object(const Profile& profile, sdo::Multiplexer multiplexer);
  void append_object(std::string& text, std::string_view front, const sdo::Message& message,
                     const Profile& profile);
  void append_initiate(std::string& text, const sdo::Message& message, decoder::Network& network,
                       NodeId server, const Profile& profile);
  void append_block(std::string& text, decoder::SdoMessage kind, const sdo::Message& message,
                    const Profile& profile);

  decoder::EntryCache<Object, objects_max> objects_;
  ValueWords values_;
};

}  // namespace canvoy::text
