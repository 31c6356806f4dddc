// Reads a running node as a data sheet: by an EDS of its kind, by the EDS that it stores, or by its
// profile.
//
//     NodeReader reader(session, 10, {.bus = "can0"});
//     formats::DataSheet sheet = reader.read();
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "canvoy/formats/sheet/sheet_scan.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

struct NodeReaderOptions {
  std::string bus;
  std::string profile = {};  ///< empty: that of 1000h of the node
  std::string name = {};     ///< of the node; empty: its 1008h
  std::string out = {};      ///< output file of the sheet; may be empty
  unsigned bit_rate = 0;     ///< in kbit/s; 0: that of the interface
};

class NodeReader {
 public:
  using Bytes = formats::SheetScan::Bytes;
  NodeReader(Session& session, NodeId node, NodeReaderOptions options);

  void on_progress(std::function<void(const formats::SheetScan::Progress&)> tell) {
    scan_.on_progress(std::move(tell));
  }

  /// The sheet of the node with its values. Throws Failure if the node does not answer.
  formats::DataSheet read();
  /// Like read(), but by an EDS with this `path`.
  formats::DataSheet read_by(const formats::DataSheet& given, const std::string& path);
  void read_undescribed(formats::DataSheet& sheet, std::uint16_t first, std::uint16_t last) {
    scan_.read_undescribed(sheet, first, last);
  }
  /// Reads the domains into files of this folder.
  void read_domains(formats::DataSheet& sheet, const std::string& folder);

  const formats::SheetScan& scan() const { return scan_; }
  /// The source of the descriptions: `CiA 419`.
  const std::string& source() const { return source_; }
  /// True if a profile is the source: what the manufacturer has added is not described.
  bool is_by_profile() const { return is_by_profile_; }

 private:
  std::uint32_t number(std::uint16_t index, std::uint8_t sub);
  formats::SheetIdentity identity_of();
  std::optional<formats::DataSheet> stored_sheet();
  const Profile& profile_of(std::uint32_t device_type) const;

  NodeReaderOptions options_;
  NodeId node_;
  Session& session_;
  formats::SheetScan scan_;
  std::string source_ = "the given sheet";
  bool is_by_profile_ = false;
};

}  // namespace canvoy::tools
