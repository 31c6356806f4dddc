// All objects of CiA 302 that are described here, for tools: NMT master and program download (parts
// 2 and 3), configuration manager (part 3), SDO manager (part 5). A device takes its objects from
// the headers of these.
//
//     find_object(cia302::profile, 0x1F22)->name  // "Concise DCF"
#pragma once

#include "canvoy/profiles/cia302/configuration.hpp"
#include "canvoy/profiles/cia302/master.hpp"
#include "canvoy/profiles/cia302/program.hpp"
#include "canvoy/profiles/cia302/sdo_manager.hpp"

namespace canvoy::cia302 {

inline constexpr auto objects = objects_of(
    nmt_inhibit_object, request_sdo_object, release_sdo_object, sdo_manager_cob_ids_object,
    sdo_connections_object, dynamic_sdo_state_object, store_dcf_object, dcf_format_object,
    concise_dcf_object, slave_eds_object, slave_eds_format_object, configure_object,
    expected_date_object, expected_time_object, program_data_object, program_control_object,
    verify_program_object, expected_program_date_object, expected_program_time_object,
    expected_identification_object, program_identification_object, flash_status_object,
    nmt_startup_object, slave_assignment_object, request_nmt_object, request_guarding_object,
    expected_device_type_object, expected_vendor_object, expected_product_object,
    expected_revision_object, expected_serial_object, boot_time_object,
    restore_configuration_object, flying_master_object, startup_capable_object);
inline constexpr Profile profile = {.number = 302,
                                    .name = "CiA 302",
                                    .title = "Additional application layer functions",
                                    .objects = objects};

}  // namespace canvoy::cia302
