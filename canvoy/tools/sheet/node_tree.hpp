// The dictionary of a running node as a tree of rows, with the values that were read last.
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
#include "canvoy/tools/bus/session.hpp"
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
  /// An entry of a file that is not as the node has it.
  struct Difference {
    Place place;
    std::string name;
    std::string here;  ///< in the node
    std::string there;
  };
  /// What a configuration file would change.
  struct Comparison {
    std::vector<Difference> differences;
    /// What has to be written for them, in this order: of a PDO all that the file says of it, since
    /// it is mapped only while it is not valid (CiA 301, 7.5.2.36).
    std::vector<ConfigurationEntry> steps;
  };

  NodeTree(Session& session, NodeId node, formats::DataSheet sheet);

  /// Those that are open; of a search, those that have it in their name, index or value: objects
  /// with all of their entries, entries with their object.
  std::vector<Row> rows(const std::string& search) const;
  void toggle(const Row& row);

  /// What was read last; empty: nothing yet.
  std::string value(const Row& row) const;
  std::string json(const Row& row) const;
  /// Whether the value is another one than at the last but one reading, lately.
  bool has_changed(const Row& row) const;
  bool is_writable(const Row& row) const;
  const formats::SheetEntry* entry(const Row& row) const {
    return sheet_.find(row.place.index, row.place.sub);
  }

  /// Whether the node was asked. Throws Failure where it does not answer.
  bool refresh(const Row& row);
  /// Throws UsageError for a text that is no value of the entry, Failure with what the node
  /// answered.
  void write(const Row& row, const std::string& text);

  /// The sheet with the values as they were read last.
  formats::DataSheet sheet() const;
  /// Asks the node.
  Comparison compare(const std::string& path);
  /// One of the steps.
  void write(const ConfigurationEntry& step);

 private:
  struct Known {
    Bytes bytes;
    std::string fault;  ///< why there is none
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
