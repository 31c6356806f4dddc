// A device with nearly all of the services of CiA 301: two digital inputs and outputs in PDOs that
// can be mapped again, SYNC in both directions, guarding, heartbeats, emergencies, storage, further
// SDO channels, and two objects of its maker. It has no behaviour of its own.
//
//     CommunicationDevice device;
//     Check check(device.line(), device.node(), {.moves = true, .sheet = &device.sheet()});
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/formats/sheet/sheet_device.hpp"
#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia401.hpp"
#include "canvoy/text/check/testing/node_on_line.hpp"

namespace canvoy::conformance {

class CommunicationDevice : public NodeOnLine {
 public:
  CommunicationDevice() : device_(sheet(), port(), NodeId{5}), client_(device_.node(), 0) {
    start(device_.node());
  }

  static const formats::DataSheet& sheet() {
    static const formats::DataSheet made = make_sheet();
    return made;
  }

 private:
  static constexpr std::uint16_t write_only = 0x2000;
  static constexpr std::uint16_t limited = 0x2001;

  static formats::DataSheet make_sheet() {
    using namespace cia301;  // NOLINT(google-build-using-namespace): its objects
    formats::SheetMaker maker(cia401::profile, {.product_name = "Communication"});
    for (const ObjectInfo* object :
         {&sync_cob_id_object, &sync_period_object, &sync_window_object, &guard_time_object,
          &life_time_factor_object, &time_cob_id_object, &emergency_cob_id_object,
          &emergency_inhibit_object, &producer_heartbeat_object, &sync_overflow_object,
          &error_behavior_object}) {
      maker.add(Part(*object));
    }
    maker.add(Part(device_name_object).initial("communication device"));
    maker.add(Part(error_field_object).up_to(4));
    maker.add(Part(consumer_heartbeat_object).up_to(2));
    maker.add(Part(store_object).up_to(1));
    maker.add(Part(restore_object).up_to(1));
    maker.add(Part(sdo_server_object).only(0));
    maker.add(Part(sdo_client_object).only(0));
    maker.add(Part(cia401::read_input_8_bit_object).up_to(2));
    maker.add(Part(cia401::write_output_8_bit_object).up_to(2));
    static constexpr std::uint32_t inputs[] = {0x6000'0108, 0x6000'0208};
    static constexpr std::uint32_t outputs[] = {0x6200'0108, 0x6200'0208};
    maker.add(PdoInfo{.cob_id = 0x180, .plus_node_id = true, .mapping = inputs});
    maker.add(PdoInfo{.direction = PdoInfo::Direction::receive,
                      .cob_id = 0x200,
                      .plus_node_id = true,
                      .mapping = outputs});
    maker.add_basics(401);
    formats::DataSheet sheet = maker.take();
    for (const std::uint16_t mapping : {object_index::rpdo_mapping, object_index::tpdo_mapping}) {
      auto& subs = sheet.objects.at(mapping).subs;
      for (std::uint8_t sub = 3; sub <= 10; ++sub) {
        subs[sub] = subs.at(1);
        subs[sub].default_value = "0x00000000";
      }
    }
    add_own(sheet, write_only, "wo");
    add_own(sheet, limited, "rw");
    sheet.objects.at(limited).own.low_limit = "0x01";
    sheet.objects.at(limited).own.high_limit = "0x0A";
    sheet.objects.at(limited).own.default_value = "0x05";
    return sheet;
  }
  static void add_own(formats::DataSheet& sheet, std::uint16_t index, const char* access) {
    formats::SheetEntry& own = sheet.objects[index].own;
    own.name = "Own";
    own.data_type = static_cast<unsigned>(DataType::unsigned8);
    own.access = access;
    own.default_value = "0x00";
    own.pdo_mapping = false;
  }

  formats::SheetDevice device_;
  SdoClient client_;  ///< judges what is written to 1280h
};

}  // namespace canvoy::conformance
