// The dictionary of a running node as a tree of rows, with the values that were last read.
//
//     NodeTree tree(session, 10, sheet);
//     tree.refresh(row);                    // asks the node
//     tree.write(row, "21.5 degC");         // checks, writes, and reads again
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

namespace canvoy::tools {

class NodeTree {
 public:
  using Bytes = std::vector<std::uint8_t>;
  struct Place {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Row {
    Place place;
    bool is_folder = false;  ///< an object with entries below it
    bool is_open = false;
    unsigned depth = 0;
    std::string name;
  };
  /// An entry of a file that differs from the node.
  struct Difference {
    Place place;
    std::string name;
    std::string here;  ///< in the node
    std::string there;
  };
  /// The changes that a configuration file would make.
  struct Comparison {
    std::vector<Difference> differences;
    /// The writes for the differences, in order: all entries of a PDO, since it is mapped only
    /// while it is invalid (CiA 301, 7.5.2.36).
    std::vector<ConfigurationEntry> steps;
  };

  NodeTree(Session& session, NodeId node, formats::DataSheet sheet);

  /// The open rows; for a search, those with the text in name, index or value: objects with all of
  /// their entries, entries with their object.
  std::vector<Row> rows(const std::string& search) const;
  void toggle(const Row& row);

  /// The value that was last read; empty: none.
  std::string value(const Row& row) const;
  std::string json(const Row& row) const;
  /// True if the value has recently changed between two readings.
  bool has_changed(const Row& row) const;
  bool is_writable(const Row& row) const;
  const formats::SheetEntry* entry(const Row& row) const {
    return sheet_.find(row.place.index, row.place.sub);
  }

  /// Reads a row; true if the node was requested. Throws Failure if it does not answer.
  bool refresh(const Row& row);
  /// Throws UsageError for a text that is no value of the entry, Failure with the answer of the
  /// node.
  void write(const Row& row, const std::string& text);

  /// The sheet with the values that were last read.
  formats::DataSheet sheet() const;
  /// Compares a file with the node, which is read.
  Comparison compare(const std::string& path);
  /// Performs one of the steps.
  void write(const ConfigurationEntry& step);

 private:
  struct Known {
    Bytes bytes;
    std::string fault;  ///< reason for a missing value
    Time changed{};
    bool is_read = false;
  };

  const EntryInfo* described(const Place& place);
  std::string text_of(const Place& place, std::span<const std::uint8_t> bytes) const;
  std::string name_of(const Place& place) const;
  void learn(const Place& place, Known known);

  Session& session_;
  NodeId node_;
  formats::DataSheet sheet_;
  std::unique_ptr<decoder::SheetProfile> profile_;
  mutable decoder::Network network_;
  std::map<Place, Known> known_;
  std::set<std::uint16_t> open_;
};

}  // namespace canvoy::tools
