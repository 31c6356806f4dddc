// Makes a table of signals of devices from their data sheets, completed by the profiles.
//
//     SignalTableMaker maker;
//     maker.add_device("charger", 5, sheet);
//     write_dbc(maker.take());
#pragma once

#include <map>
#include <string>
#include <vector>

#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/formats/signals/signal_table.hpp"

namespace canvoy::text {

class SignalTableMaker {
 public:
  /// With SDO, adds the expedited transfers of all entries as multiplexed signals; for a car (CiA
  /// 447) on each of its channels.
  explicit SignalTableMaker(bool with_sdo = false) : with_sdo_(with_sdo) {}

  /// Adds the dictionary, PDOs, emergencies and heartbeat of a device. Omits what is not in the
  /// sheet and not in a PDO. Each node-ID may be added once.
  void add_device(const std::string& name, NodeId node, const formats::DataSheet& sheet);
  /// Adds the messages with a CAN-ID assigned by a profile, for any sender.
  void add_profile(const Profile& profile);

  /// Returns the table of all that was added.
  formats::SignalTable take();

 private:
  struct Device;
  struct CarNode {
    std::string name;
    NodeId id;
  };

  void add_pdos(Device& device);
  void add_pdo(Device& device, std::uint32_t can_id, const decoder::PdoPlan& plan);
  static std::vector<formats::Signal> mapped_signals(Device& device, const decoder::PdoPlan& plan);
  static std::vector<formats::Signal> multiplexed_signals(Device& device,
                                                          const decoder::PdoPlan& plan);
  static std::vector<formats::Signal> signals_at(Device& device, unsigned index, unsigned sub);
  static std::vector<formats::DictionaryLine> dictionary_of(Device& device);
  void add_emergency(Device& device);
  void add_heartbeat(const Device& device);
  void add_sdo(Device& device);
  void add_transfers(Device& device, bool is_request);
  void add_mesh();
  void add_channel(const CarNode& client, const CarNode& server);
  formats::SignalMessage& message_at(std::uint32_t can_id);

  bool with_sdo_;
  formats::SignalTable table_;
  std::map<std::uint32_t, formats::SignalMessage> messages_;
  std::vector<CarNode> car_nodes_;
};

}  // namespace canvoy::text
