// Indices of the objects of the communication profile; each number is written only here (CiA 301,
// 7.5.2; CiA 302 from 1F00h on).
//
//     dictionary.word(object_index::cob_id_sync, 0);
#pragma once

#include <cstdint>

namespace canvoy::object_index {

inline constexpr std::uint16_t communication_first = 0x1000;  ///< of the communication profile area
inline constexpr std::uint16_t communication_last = 0x1FFF;   ///< of the communication profile area

/// Profile number (bits 0 to 15) and what the profile adds.
inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t error_register = 0x1001;  ///< bits of error_register
inline constexpr std::uint16_t error_history = 0x1003;   ///< pre-defined error field
inline constexpr std::uint16_t cob_id_sync = 0x1005;     ///< bit 30: the node produces SYNC
/// Communication cycle period, in microseconds; 0: none.
inline constexpr std::uint16_t sync_period = 0x1006;
/// Synchronous window length, in microseconds; 0: none.
inline constexpr std::uint16_t sync_window = 0x1007;
inline constexpr std::uint16_t device_name = 0x1008;       ///< manufacturer device name, a string
inline constexpr std::uint16_t hardware_version = 0x1009;  ///< a string
inline constexpr std::uint16_t software_version = 0x100A;  ///< a string
inline constexpr std::uint16_t guard_time = 0x100C;  ///< of node guarding, in milliseconds; 0: none
/// Times the guard time: node life time; 0: none.
inline constexpr std::uint16_t life_time_factor = 0x100D;
inline constexpr std::uint16_t store_parameters = 0x1010;    ///< written `save`
inline constexpr std::uint16_t restore_parameters = 0x1011;  ///< written `load`
inline constexpr std::uint16_t cob_id_time =
    0x1012;  ///< bit 31: consumes TIME; bit 30: produces it
/// Time of the last SYNC, in microseconds.
inline constexpr std::uint16_t high_resolution_time = 0x1013;
inline constexpr std::uint16_t cob_id_emergency = 0x1014;  ///< COB-ID EMCY; bit 31: there is none
/// In units of 100 microseconds; 0: none.
inline constexpr std::uint16_t emergency_inhibit_time = 0x1015;
/// Node-ID (bits 16 to 23) and time in milliseconds.
inline constexpr std::uint16_t heartbeat_consumers = 0x1016;
inline constexpr std::uint16_t heartbeat_producer = 0x1017;  ///< period in milliseconds; 0: none
inline constexpr std::uint16_t identity = 0x1018;  ///< vendor, product, revision and serial number
/// 2 to 240, after which the counter begins again at 1; 0: none.
inline constexpr std::uint16_t sync_counter_overflow = 0x1019;
/// Date (days since 1984) and time (milliseconds of the day).
inline constexpr std::uint16_t verify_configuration = 0x1020;
inline constexpr std::uint16_t store_eds = 0x1021;         ///< the EDS of the device, a domain
inline constexpr std::uint16_t store_eds_format = 0x1022;  ///< 0: plain text
/// COB-IDs EMCY of other nodes, one for each node-ID.
inline constexpr std::uint16_t emergency_consumers = 0x1028;
inline constexpr std::uint16_t error_behaviour = 0x1029;  ///< sub-index 1: communication errors
inline constexpr std::uint16_t nmt_inhibit_time =
    0x102A;  ///< in units of 100 microseconds; 0: none

// For SDO channels and PDOs, the first index of many.
inline constexpr std::uint16_t sdo_server = 0x1200;       ///< SDO server parameter; the default SDO
inline constexpr std::uint16_t sdo_server_last = 0x127F;  ///< the 128th
inline constexpr std::uint16_t sdo_client = 0x1280;       ///< SDO client parameter
inline constexpr std::uint16_t sdo_client_last = 0x12FF;  ///< the 128th
inline constexpr std::uint16_t rpdo_parameter = 0x1400;   ///< RPDO communication parameter
inline constexpr std::uint16_t rpdo_parameter_last = 0x15FF;  ///< the 512th
inline constexpr std::uint16_t rpdo_mapping = 0x1600;         ///< RPDO mapping parameter
inline constexpr std::uint16_t rpdo_mapping_last = 0x17FF;    ///< the 512th
inline constexpr std::uint16_t tpdo_parameter = 0x1800;       ///< TPDO communication parameter
inline constexpr std::uint16_t tpdo_parameter_last = 0x19FF;  ///< the 512th
inline constexpr std::uint16_t tpdo_mapping = 0x1A00;         ///< TPDO mapping parameter
inline constexpr std::uint16_t tpdo_mapping_last = 0x1BFF;    ///< the 512th
/// Object scanner list of MPDOs, source address mode.
inline constexpr std::uint16_t scanner_list = 0x1FA0;
inline constexpr std::uint16_t scanner_list_last = 0x1FCF;  ///< the 48th
/// Object dispatching list of MPDOs, source address mode.
inline constexpr std::uint16_t dispatching_list = 0x1FD0;
inline constexpr std::uint16_t dispatching_list_last = 0x1FFF;  ///< the 48th

inline constexpr std::uint16_t sdo_cob_ids = 0x1F02;  ///< COB-IDs of dynamic SDO connections
inline constexpr std::uint16_t dcf = 0x1F20;          ///< DCFs of the slaves by node-ID, domains
/// Concise DCFs of the slaves by node-ID, domains.
inline constexpr std::uint16_t concise_dcf = 0x1F22;
inline constexpr std::uint16_t slave_eds = 0x1F23;  ///< EDSs of the slaves by node-ID, domains
/// Written `conf`: configures a slave at once.
inline constexpr std::uint16_t configure_slave = 0x1F25;
/// Of the slaves by node-ID: days since 1984.
inline constexpr std::uint16_t expected_configuration_date = 0x1F26;
/// Of the slaves by node-ID: milliseconds of the day.
inline constexpr std::uint16_t expected_configuration_time = 0x1F27;
/// NMT flying master timing parameters.
inline constexpr std::uint16_t flying_master_timing = 0x1F90;
inline constexpr std::uint16_t capable_master_timing = 0x1F91;  ///< of the detection of NMT masters

}  // namespace canvoy::object_index
