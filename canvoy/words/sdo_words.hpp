// What the messages of SDO say, in words (CiA 301, 7.2.4).
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
#include "canvoy/decoder/by_entry.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/description.hpp"
#include "canvoy/words/value_words.hpp"

namespace canvoy::words {

class SdoWords {
 public:
  /// Of a frame of eight bytes; the profile is that of the server, and units are as it says. Of a
  /// device behind it nothing is known.
  void append(std::string& text, decoder::SdoMessage message, const Frame& frame,
              decoder::Network& network, NodeId server, decoder::SdoBehind behind = {});
  /// The whole of a transfer that has come to its end: `read 6010h:00h temperature = 20.000 °C`.
  void append_transfer(std::string& text, const decoder::SdoTransfer& transfer,
                       const decoder::DecodedValue& value);

 private:
  /// The latest of each hash: to look for a name takes longer than to write it.
  static constexpr std::size_t objects_max = 1024;
  struct Object {
    const EntryInfo* entry = nullptr;  ///< null: the profile does not know it
    std::string text;                  ///< `6010h:00h temperature`
  };

  const Object& object(const Profile& profile, sdo::Multiplexer multiplexer);
  void append_object(std::string& text, std::string_view front, const sdo::Message& message,
                     const Profile& profile);
  void append_initiate(std::string& text, const sdo::Message& message, decoder::Network& network,
                       NodeId server, const Profile& profile);
  void append_block(std::string& text, decoder::SdoMessage kind, const sdo::Message& message,
                    const Profile& profile);

  decoder::ByEntry<Object, objects_max> objects_;
  ValueWords values_;
};

}  // namespace canvoy::words
