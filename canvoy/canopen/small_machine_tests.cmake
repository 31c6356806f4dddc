# canopen.small_machine: the tests of a small node's services, with CANVOY_SMALL_MACHINE.
file(GLOB tested CONFIGURE_DEPENDS device/device_node_test.cpp dictionary/dictionary_*_test.cpp
  emergency/emergency_producer_test.cpp nmt/error_behaviour_test.cpp device/every_frame_test.cpp nmt/heartbeat_producer_test.cpp
  node/node_test.cpp pdo/pdo_*_test.cpp service/router_test.cpp pdo/rpdo_*test.cpp sdo/sdo_server_*test.cpp sdo/sdo_state_test.cpp
  sync/sync_*test.cpp service/timer_queue_test.cpp pdo/tpdo_*test.cpp lss/lss_slave_*_test.cpp)
get_target_property(sources canvoy_canopen SOURCES)
file(GLOB can CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/canvoy/can/*.cpp" "${PROJECT_SOURCE_DIR}/canvoy/can/simulated/*.cpp")
list(FILTER can EXCLUDE REGEX "_test\\.cpp$")

add_executable(canvoy_small_machine_test ${tested} "${PROJECT_SOURCE_DIR}/tests/embed/constant_node_test.cpp" ${sources} ${can})
canvoy_warnings(canvoy_small_machine_test)
target_compile_definitions(canvoy_small_machine_test PRIVATE CANVOY_SMALL_MACHINE)
target_compile_options(canvoy_small_machine_test PRIVATE ${canvoy_test_options})
target_compile_features(canvoy_small_machine_test PRIVATE cxx_std_20)
target_include_directories(canvoy_small_machine_test PRIVATE "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/include")
set_target_properties(canvoy_small_machine_test PROPERTIES CXX_EXTENSIONS OFF)
target_link_libraries(canvoy_small_machine_test PRIVATE GTest::gmock_main rapidcheck)
target_precompile_headers(canvoy_small_machine_test REUSE_FROM canvoy_test_headers)

# Features that a small machine lacks: watchers of rows, reports of other nodes with its CAN-IDs, routes and memory of PDOs, eight bytes of buffer in an SDO server
# without one, times beyond its 55 bits, events of values that carry the bytes sent last; different refusals (a mapping
# record that the application overwrites); and a backlog that drops the frames of a PDO that has ended: they leave as soon
# as there is room.
set(absent
  DeviceNode.HasARouteForEachServiceAndAllThat1028hMayName
  DictionaryChanges.*
  FromABlock/DictionaryDefault.IsAChangeWhereItReturns/*
  DictionaryHook.IsCountedAsARevision
  DictionaryString.TellsItsWatchersOfAChangeOfLengthAsWell
  NodeValues.AreAnnouncedWhenTheNodeIsCalled
  PdoMapping.IsReadWhenItIsSetAndForNoFrame
  PdoMapping.WhichTheApplicationOverwritesPastAllHooksHoldsWhenThePdoIsSetAnew
  Rpdo.IsRefusedWhereNoRouteIsLeft
  Rpdo.WithoutMemoryForItsValuesRefusesTheirNumber
  SdoServerBlockDownload.TheBlockSizeIs127UnlessTheOwnerWantsLess
  SdoServerTest.TheTimeOutIsTheOwnersChoice
  SdoServerTest.ValuesOfEightBytesNeedNoBuffer
  TimerQueue.ServesTimesBeforeTheStartAndAtTheEndOfAllDays
  Tpdo.*EventOfAValue*
  Tpdo.ForgetsEventsOfValuesThatCameBeforeItWasAtWork
  Tpdo.IsNotSentForAChangeThatIsNoEvent*
  Tpdo.IsRefusedWhereNoRouteForItsRemoteFramesIsLeft
  Tpdo.ThatBecomesInvalidIsForgottenWithWhatWaitsForRoom
  Tpdo.WatchesItsValuesOnlyWhileItIsSentForEvents)
list(JOIN absent ":" filter)
canvoy_add_test(canopen.small_machine unit 300 $<TARGET_FILE:canvoy_small_machine_test> --gtest_brief=1 --gtest_filter=-${filter})
