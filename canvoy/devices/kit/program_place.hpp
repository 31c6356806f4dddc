// Location of the program of a device of the catalogue that is downloaded over the network (CiA
// 302-3, 1F50h): its environment offers it.
//
//     environment.provide(Callback<ProgramPlace()>::to<&Board::program_place>(board));
#pragma once

#include "canvoy/canopen/manager/program_server.hpp"

namespace canvoy {

struct ProgramPlace {
  const Flash* flash = nullptr;  ///< null: none, and downloads are refused
  std::uint32_t size = 0;        ///< bytes from address 0 on: whole sectors
  ProgramHooks hooks = {};       ///< what the device adds to the download
};

}  // namespace canvoy
